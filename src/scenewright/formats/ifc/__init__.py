"""Building models: IFC (ISO 16739-1), read and written as IFC4 with the extra ``bim``.

A home or hall becomes storeys with spaces, walls with openings that doors and windows fill, slabs,
stairs and furniture; a site or village a building element a house. Furniture shares one type with
one mesh a model and size. Same solution, same bytes: identifiers follow from names.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import ifcopenshell  # noqa: F401 (a missing extra is named when the format is chosen)

if TYPE_CHECKING:
    from pathlib import Path

    from scenewright.core.brief import Brief
    from scenewright.core.plan import Plan
    from scenewright.core.solution import Solution


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a building model; ``keep`` leaves its furniture where it stands."""
    from scenewright.formats.ifc.reading import read_brief

    return read_brief(path, keep)


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path`` as IFC4; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.core.atomic_file import write_atomically
    from scenewright.domains import scene_of
    from scenewright.formats.ifc.model import encode_scene

    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    write_atomically(path, encode_scene(scene, catalog))
