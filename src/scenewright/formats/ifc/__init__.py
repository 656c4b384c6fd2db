"""Building models: IFC (ISO 16739-1), read and written as IFC4 with the extra ``bim``.

A home or hall becomes storeys with spaces, walls with openings that doors and windows fill, slabs,
stairs and furniture; a site or village a building element a house. Furniture shares one type with
one mesh a model and size. Same solution, same bytes: identifiers follow from names. What was read
from a model is written into a copy of it: the furniture is added, nothing else changes.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from scenewright.core.extras import require

if TYPE_CHECKING:
    from pathlib import Path

    from scenewright.core.brief import Brief
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution

require("ifcopenshell")


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a building model; ``keep`` leaves its furniture where it stands."""
    from scenewright.formats.ifc.reading import read_brief

    return read_brief(path, keep)


def check(brief: Brief) -> None:
    """Raise :class:`InputError` where furniture cannot be added to the model a brief was read
    from."""
    from scenewright.formats.ifc.furnishing import find_end
    from scenewright.formats.ifc.source import open_source_file

    if brief.source_file is not None:
        find_end(open_source_file(brief.source_file))


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path`` as IFC4, or what it places into a copy of the model
    its brief was read from; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.core.atomic_file import atomic_write, identity_of
    from scenewright.core.errors import InputError
    from scenewright.domains import scene_of
    from scenewright.formats.ifc.furnishing import furnish
    from scenewright.formats.ifc.model import encode_scene
    from scenewright.formats.ifc.source import open_source_file

    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    source = solution.brief.source_file
    if source is None:
        data = encode_scene(scene, catalog).encode()
    else:
        model = open_source_file(source)
        if identity_of(path) == identity_of(source.file):
            raise InputError("is the model that was read", "give the new one another name")
        data = furnish(scene, catalog, source, model)
    with atomic_write(path) as partial:
        partial.write_bytes(data)
