"""Hui houses round a court that their roofs drain into (Anhui, China)."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.buildings.house_fronts import openings
from scenewright.catalog.assets.buildings.house_looks import HouseForm, HouseLook
from scenewright.catalog.assets.buildings.house_parts import join_parts
from scenewright.catalog.assets.buildings.house_shapes import stepped_gable
from scenewright.catalog.assets.model import Parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import block

COURT = 9.5
"""Metres on both sides from which a Hui house has a court."""
PARAPET, YARD = 0.3, 0.12
"""Thickness of walls that stand above a roof, height of the ground of a court, in metres."""


def build_court_house(size: Size, look: HouseLook, form: HouseForm) -> Parts:
    """Four roofs that drain into a court, behind high white walls with stepped ends."""
    w, d = size.width / 2, size.depth / 2
    court_x, court_y, low, high = court_heights(size)
    rings = [(w - PARAPET, d - PARAPET, high), (court_x, court_y, low)]
    roofs = _court_roofs(rings)
    inner = [
        block((-w, w), (-d, -d + PARAPET), (0, high + 0.35)),
        block((-w, w), (d - PARAPET, d), (0, high + 0.35)),
    ]
    caps = [
        block(
            (-w - 0.1, w + 0.1),
            (s * (d - PARAPET / 2) - 0.25, s * (d - PARAPET / 2) + 0.25),
            (high + 0.35, high + 0.47),
        )
        for s in (-1, 1)
    ]
    for s in (-1, 1):
        at = (w - PARAPET, w) if s > 0 else (-w, -w + PARAPET)
        wall, copings = stepped_gable((-d, d), at, high - 0.2, size.height - 0.14, "x", 3)
        inner.append(wall)
        caps += copings
    yard = [block((-court_x, court_x), (-court_y, court_y), (0, YARD))]
    wood = [
        block(
            (-court_x - 0.15, court_x + 0.15),
            (s * court_y - 0.08, s * court_y + 0.08),
            (0, low - 0.1),
        )
        for s in (-1, 1)
    ] + [
        block((x - 0.08, x + 0.08), (-court_y, court_y), (0, low - 0.1))
        for x in (-court_x, court_x)
    ]
    outline = ((-w, -d), (w, -d), (w, d), (-w, d))
    shown = openings(outline, high, look, form)
    shown.stones.extend(yard)
    shown.doors.extend(wood)
    return join_parts(size, look, outline, high, inner, [*roofs, *caps], shown, [])


def court_heights(size: Size) -> tuple[float, float, float, float]:
    """Half the width and depth of a court, and the heights of the roofs over it and outside."""
    court_x, court_y = 0.15 * size.width, 0.15 * size.depth
    low = 0.55 * size.height
    return court_x, court_y, low, low + min(0.5 * (size.depth / 2 - court_y), 0.28 * size.height)


def _court_roofs(rings: list[tuple[float, float, float]]) -> list[Mesh]:
    """Four slopes between an outer and an inner rectangle, each a closed slab."""
    corners = [np.array([(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]) for x, y, z in rings]
    made = []
    for k in range(4):
        after = (k + 1) % 4
        quad = np.array([corners[0][k], corners[0][after], corners[1][after], corners[1][k]])
        vertices = np.concatenate([quad - (0, 0, 0.15), quad])
        base = extrude([(0, 0), (1, 0), (1, 1), (0, 1)], 0.0, 1.0)
        made.append(Mesh(vertices, base.faces))
    return made
