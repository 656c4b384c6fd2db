"""The scene for CAD in 3D: DXF with meshes in metres, z up, by ezdxf (extra ``dxf``).

Things of equal shape share a block of meshes, one a material in its colour; levels lie above each
other as they are built. Objects carry the attributes ID and KIND.
"""

from __future__ import annotations

import os
from collections.abc import Hashable
from typing import Any

import numpy as np

from scenewright.core.atomic_file import atomic_write
from scenewright.core.catalog import Part
from scenewright.core.plan import Plan
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.drawing.dxf.document import UNITS, new_document
from scenewright.drawing.dxf.placed_entities import name_part
from scenewright.render.items import RenderItem, things

LAYERS = {
    "slab": "A-FLOR-SLAB",
    "space": "A-FLOR",
    "surface": "L-SITE",
    "wall": "A-WALL",
    "opening": "A-DOOR",
    "stairs": "A-FLOR-STRS",
    "piece": "A-FURN",
}


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of

    document = new_document(UNITS["m"])
    for layer in LAYERS.values():
        if layer not in document.layers:
            document.layers.add(layer)
    scene = scene_of(solution, plan)
    found = things(scene, catalog_of(solution.brief.catalogs))
    _place_all(document, scene, found)
    with atomic_write(path) as partial:
        document.saveas(partial)


def _place_all(document: Any, scene: Scene, found: tuple[RenderItem, ...]) -> None:
    elevations = {level.id: level.elevation for level in scene.levels}
    blocks: dict[Hashable, str] = {}
    for item in found:
        if not item.parts:
            continue
        if item.key not in blocks:
            blocks[item.key] = _define(document, item, len(blocks))
        x, y, z = item.at
        place = (x, y, z + elevations.get(item.level, 0.0))
        turn = round(float(np.degrees(item.turn)) % 360.0, 9)
        look = {"layer": LAYERS[item.kind], "rotation": turn}
        insert = document.modelspace().add_blockref(blocks[item.key], place, dxfattribs=look)
        kind = str(item.extras.get("category", item.kind))
        insert.add_auto_attribs({"ID": item.name, "KIND": kind})


def _define(document: Any, item: RenderItem, number: int) -> str:
    """The block of a shape, named by its model."""
    words = item.extras.get("asset") if item.kind == "piece" else item.name
    name = f"{name_part(str(words or item.name))} {number + 1}"
    block = document.blocks.new(name)
    for part in item.parts:
        _add_mesh(block, part)
    for row, tag in enumerate(("ID", "KIND")):
        definition = block.add_attdef(tag, (0, -0.1 * row), "", dxfattribs={"height": 0.05})
        definition.is_invisible = True
    return name


def _add_mesh(block: Any, part: Part) -> None:
    red, green, blue = (round(255 * min(max(c, 0.0), 1.0)) for c in part.material.color)
    colour = {"layer": "0", "true_color": (red << 16) + (green << 8) + blue}
    mesh = block.add_mesh(dxfattribs=colour)
    mesh.transparency = 1.0 - part.material.opacity
    with mesh.edit_data() as data:
        data.vertices = np.round(part.vertices, 6).tolist()
        data.faces = part.faces.tolist()
