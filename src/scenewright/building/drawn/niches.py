"""Openings that a threshold on the far face of their wall closes: cut off the room, and gaps."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Point, Polygon, STRtree
from shapely.geometry.polygon import orient

from scenewright.building.drawn.bridges import NARROW, THICK, WIDE, Gap

BESIDE = 0.03
"""Metres beside a face of a wall at which it is looked for what lies there."""
ASKEW = 0.1
"""The greatest sine between the mouth of an opening and its threshold."""
Vector = NDArray[np.float64]


def cut_niches(rooms: list[Polygon], walls: list[Polygon]) -> tuple[list[Polygon], list[Gap]]:
    """Rooms without the openings that are as deep as their wall, and a gap for each: the ends of a
    wall left and right, no wall behind the line that joins them."""
    tree = STRtree(walls)
    cut, gaps = [], []
    for room in rooms:
        plain, found = _cut_room(orient(room), walls, tree)
        cut.append(plain if plain.is_valid else room)
        gaps += found if plain.is_valid else []
    return cut, gaps


def _cut_room(room: Polygon, walls: list[Polygon], tree: STRtree) -> tuple[Polygon, list[Gap]]:
    ring = shapely.get_coordinates(room.exterior)[:-1]
    gaps: list[Gap] = []
    corner = 0
    while corner < len(ring) and len(ring) > 6:
        ring = np.roll(ring, -corner, axis=0)
        gap = _niche(ring[:4], walls, tree)
        ring = np.roll(np.delete(ring, (1, 2), axis=0) if gap else ring, corner, axis=0)
        gaps += [gap] if gap else []
        corner += 1
    return (Polygon(ring, room.interiors), gaps) if gaps else (room, [])


def _niche(points: Vector, walls: list[Polygon], tree: STRtree) -> Gap | None:
    """The gap that four corners of an outline are, counter-clockwise: out, along, and back."""
    out, along, back = np.diff(points, axis=0)
    depths, width = np.hypot(*np.stack([out, back], 1)), float(np.hypot(*along))
    if not (NARROW <= width <= WIDE and depths.min() >= BESIDE and depths.max() <= THICK):
        return None
    unit = along / width
    normal = np.array([unit[1], -unit[0]])
    mouth = points[3] - points[0]
    askew = abs(mouth @ normal) > ASKEW * np.hypot(*mouth)
    if askew or out @ normal < 0.99 * depths[0] or -(back @ normal) < 0.99 * depths[1]:
        return None
    sides = [points[:2].mean(0) - BESIDE * unit, points[2:].mean(0) + BESIDE * unit]
    behind = points[1:3].mean(0) + BESIDE * normal
    if not all(_in_wall(side, walls, tree) for side in sides) or _in_wall(behind, walls, tree):
        return None
    corners = points[[1, 0, 3, 2]]
    return Gap(corners, points.mean(0), unit, width, float(depths.max()))


def _in_wall(point: Vector, walls: list[Polygon], tree: STRtree) -> bool:
    here = Point(point)
    return any(walls[k].contains(here) for k in tree.query(here).tolist())
