"""Universal Scene Description (OpenUSD): ``.usda`` as text, ``.usdc`` as binary, ``.usdz`` packed.

Needs the extra ``usd``. Metres, z up; one prim ``Scene`` with levels, rooms and pieces, what
encloses them, lamps, sun and sky, a camera a room. Pieces of one model and size are instances of
one prototype. Only a package holds textures; files alone are in plain colours. Same solution,
same bytes: the package is packed by us, without times.
Pixar Animation Studios and Alliance for OpenUSD, *AOUSD Core Specification 1.0* (2025).
"""

from __future__ import annotations

import os
from pathlib import Path
from tempfile import TemporaryDirectory

from scenewright.core.extras import require
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution

require("pxr")


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path`` in the form its suffix names; the file appears
    whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.core.atomic_file import atomic_write
    from scenewright.domains import scene_of
    from scenewright.formats.usd.package import pack_files
    from scenewright.formats.usd.stage import build_stage

    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    packed = Path(path).suffix.lower() == ".usdz"
    pictures: dict[str, bytes] = {}
    stage = build_stage(scene, catalog, pictures if packed else None)
    suffix = ".usdc" if packed else Path(path).suffix.lower()
    with TemporaryDirectory() as folder, atomic_write(path) as partial:
        plain = Path(folder, f"scene{suffix}")
        if not stage.GetRootLayer().Export(str(plain)):
            raise OSError("the USD library could not write it")
        data = plain.read_bytes()
        partial.write_bytes(pack_files({plain.name: data} | pictures) if packed else data)
