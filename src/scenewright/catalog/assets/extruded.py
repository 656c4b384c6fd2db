"""Models over a polygon: what a thing looks like that covers another footprint than its model.

The materials are those of the model; buildings get windows along every side that is long enough.
"""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.buildings.facades import bays, storeys
from scenewright.catalog.assets.materials import PANE, TIMBER
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.catalog import Material
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block

STOREY, BAY, OUT = 3.0, 3.2, 0.06
"""Height of a storey, width of a bay, and how far panes stand out, in metres."""
TOP = 0.04
"""The share of the height that is roof or table top."""


def extrude_model(footprint: Footprint, size: Size, model: Parts, building: bool) -> Parts:
    """A prism over a footprint in the materials of a model, its top in that of the model's."""
    wall, roof = main_materials(model)
    level = size.height * (1 - TOP)
    meshes = {wall: [extrude(footprint, 0.0, level)]}
    meshes.setdefault(roof, []).append(extrude(footprint, level, size.height))
    if building:
        panes, doors = _openings(footprint, level)
        meshes.setdefault(PANE, []).extend(panes)
        meshes.setdefault(TIMBER, []).extend(doors)
    return parts(size, meshes)


def main_materials(model: Parts) -> tuple[Material, Material]:
    """The materials that most upright and most upward faces of a model have."""
    upright, upward = [], []
    for part in model:
        a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a) / 2
        upright.append(float(np.hypot(normals[:, 0], normals[:, 1]).sum()))
        upward.append(float(np.maximum(normals[:, 2], 0.0).sum()))
    return model[int(np.argmax(upright))].material, model[int(np.argmax(upward))].material


def _openings(footprint: Footprint, level: float) -> tuple[list[Mesh], list[Mesh]]:
    """Panes in every bay of every storey of every side, and a door in the side farthest ahead."""
    corners = np.array(footprint)
    ends = np.roll(corners, -1, axis=0)
    entrance = int(np.argmax((corners + ends)[:, 1]))
    panes: list[Mesh] = []
    doors: list[Mesh] = []
    for number, (start, end) in enumerate(zip(corners, ends, strict=True)):
        length = float(np.hypot(*(end - start)))
        spots = [(a + b) / 2 for a, b in bays((-length / 2, length / 2), BAY)]
        door = len(spots) // 2 if number == entrance else -1
        for bay, middle in enumerate(spots if length > BAY or door >= 0 else []):
            for floor, (low, high) in enumerate(storeys((0.0, level), STOREY)):
                tall = high - low
                half, sill = (0.6, 0.0) if bay == door and not floor else (0.75, 0.3 * tall)
                half = min(half, 0.4 * length)
                pane = block(
                    (middle - half, middle + half), (-OUT, OUT), (low + sill, low + 0.8 * tall)
                )
                where = doors if bay == door and not floor else panes
                where.append(_on_side(pane, start, end))
    return panes, doors


def _on_side(mesh: Mesh, start: np.ndarray, end: np.ndarray) -> Mesh:
    """What is built on a wall at y = 0 looking to +y, set on one side of a footprint."""
    along, middle = end - start, (start + end) / 2
    turned = rotate_mesh(mesh, "z", float(np.arctan2(-along[0], along[1]) - np.pi / 2))
    return translate_mesh(turned, float(middle[0]), float(middle[1]))
