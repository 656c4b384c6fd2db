"""Photographs of all rooms of a home or hall on one sheet."""

from __future__ import annotations

import os
from pathlib import Path

from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.formats.png import OPEN

SIZE, SAMPLES = (640, 400), 8


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the sheet to ``path``; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of
    from scenewright.render.contact_sheet import SheetEntry, draw_sheet, write_sheet
    from scenewright.render.observations.world import build_world
    from scenewright.render.photo.photograph import photograph, shut_doors

    scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
    if not scene.spaces or any(OPEN & set(space.functions) for space in scene.spaces):
        fault = f"there are no rooms to photograph in a {solution.brief.domain}"
        raise InputError(fault, "write a .street.png or .png instead", file=str(path))
    photos = photograph(
        build_world(shut_doors(scene), catalog), catalog, size=SIZE, samples=SAMPLES
    )
    shown = {one.space.id: one.pixels for one in photos}
    names = {space.id: space.name or space.id for space in scene.spaces}
    left = ", ".join(name for key, name in names.items() if key not in shown)
    entries = [SheetEntry(pixels, names[key], "") for key, pixels in shown.items()]
    words = "late afternoon" + f"; no free place to stand: {left[:200]}" * bool(left)
    write_sheet(draw_sheet(entries, scene.name or "Rooms", words), Path(path))
