"""Walls under sloped ceilings: knee walls end low, gable walls follow the slope.

A wall reaches the highest ceiling of the rooms beside it. Each room's ceiling is the least of some
planes, so lines where two planes are equally high, and those of the knee walls, part a wall in plan
into cells with one plane over each: prisms with a tilted top.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from scenewright.ceiling import planes
from scenewright.scene import Prism
from scenewright.space import Points, Space

BESIDE = 0.08
"""How near a room must be to a wall to say how high it is, in metres."""
CRUMB = 1e-6
_FAR = 1e3


class Roof(NamedTuple):
    """The ceiling of one room as planes ``(k, 3)``: height a + b x + c y; the first is flat, and
    beyond the wall of each of ``knees`` (k, 3) (negative there) a slope stays at its knee."""

    floor: Polygon
    sloped: bool
    planes: Points
    knees: Points


def roof_of(space: Space) -> Roof:
    """The ceiling over a space."""
    rows = planes(space)
    inwards = np.column_stack([-(rows[:, :2] * rows[:, 2:4]).sum(1), rows[:, 2:4]])
    slopes = inwards * rows[:, 5:]
    slopes[:, 0] += rows[:, 4]
    flat = np.array([[space.height, 0.0, 0.0]])
    shape = Polygon(space.outline, space.holes)
    return Roof(shape, bool(len(rows)), np.vstack([flat, slopes]), inwards)


def under_roofs(prisms: Sequence[Prism], roofs: Sequence[Roof]) -> list[Prism]:
    """The prisms of a wall cut by the ceilings beside it; as they are where none is sloped."""
    found: list[Prism] = []
    for solid in prisms:
        shape = Polygon(solid.outline, solid.holes)
        beside = [roof for roof in roofs if roof.floor.distance(shape) < BESIDE]
        if any(roof.sloped for roof in beside):
            for cell in _cells(shape, _lines(beside)):
                found += _raised(cell, _plane_at(cell, beside), solid)
        else:
            found.append(solid)
    return found


def cut_off(solid: Prism, height: float) -> list[Prism]:
    """What is left of a tilted prism below a height."""
    if solid.tilt is None or solid.top <= height:
        return [solid]
    shape, over = Polygon(solid.outline, solid.holes), solid.tilt - np.array([height, 0.0, 0.0])
    low, high = _clip(shape, -over), _clip(shape, over)
    level = np.array([height, 0.0, 0.0])
    return [
        *(p for cell in low for p in _raised(cell, solid.tilt, solid)),
        *(p for cell in high for p in _raised(cell, level, solid)),
    ]


def height_at(tilt: Points, points: Points) -> Points:
    """Heights ``(n,)`` of a plane a + b x + c y at points ``(n, 2)``."""
    return np.asarray(tilt[0] + points @ tilt[1:])


def _lines(beside: Sequence[Roof]) -> list[Points]:
    """Where planes meet, as a + b x + c y = 0."""
    every = np.vstack([roof.planes for roof in beside])
    meetings = [a - b for a, b in combinations(every, 2)]
    knees = [row for roof in beside for row in roof.knees]
    return [row for row in (*meetings, *knees) if np.hypot(*row[1:]) > 1e-9]


def _cells(shape: Polygon, lines: Sequence[Points]) -> list[Polygon]:
    cells = [shape]
    for line in lines:
        cells = [part for cell in cells for side in (line, -line) for part in _clip(cell, side)]
    return cells


def _clip(shape: Polygon, side: Points) -> list[Polygon]:
    """The parts of a polygon where a + b x + c y > 0."""
    heights = height_at(side, shapely.get_coordinates(shape))
    if heights.min() >= -1e-9:
        return [shape]
    if heights.max() <= 1e-9:
        return []
    normal = side[1:] / np.hypot(*side[1:])
    foot = -side[0] / np.hypot(*side[1:]) * normal
    along = np.array([-normal[1], normal[0]]) * _FAR
    middle = np.array(shape.centroid.coords[0])
    foot = middle - normal * ((middle - foot) @ normal)
    half = Polygon([foot - along, foot - along + normal * _FAR, foot + along + normal * _FAR,
                    foot + along])  # fmt: skip
    parts = shapely.get_parts(shape.intersection(half))
    return [part for part in parts if isinstance(part, Polygon) and part.area > CRUMB]


def _plane_at(cell: Polygon, beside: Sequence[Roof]) -> Points:
    """The plane over a cell: the highest of the rooms' ceilings, each the lowest of its planes."""
    point = np.array(cell.representative_point().coords[0])
    lowest = []
    for roof in beside:
        beyond = roof.knees @ np.array([1.0, *point])
        low = roof.planes.copy()
        at_knee = np.flatnonzero(beyond < 0) + 1
        low[at_knee] = _knee(roof, at_knee)
        lowest.append(low[int(np.argmin(low @ np.array([1.0, *point])))])
    return max(lowest, key=lambda plane: float(plane @ np.array([1.0, *point])))


def _knee(roof: Roof, numbers: NDArray[np.intp]) -> Points:
    """Flat planes at the knees of some slopes: their planes less what they rise inwards."""
    slopes, inwards = roof.planes[numbers], roof.knees[numbers - 1]
    rises = np.hypot(slopes[:, 1], slopes[:, 2])[:, None]
    return slopes - rises * inwards


def _raised(cell: Polygon, tilt: Points, solid: Prism) -> list[Prism]:
    """Prisms over a cell, from the solid's base to a plane or the solid's own top."""
    if np.hypot(*tilt[1:]) < 1e-12:
        tilt = np.array([min(float(tilt[0]), solid.top), 0.0, 0.0])
    above = _clip(cell, tilt - np.array([solid.base + 0.005, 0.0, 0.0]))
    found = []
    for part in above:
        ordered = shapely.orient_polygons(part)
        rings = [shapely.get_coordinates(r)[:-1] for r in (ordered.exterior, *ordered.interiors)]
        top = float(height_at(tilt, rings[0]).max())
        found.append(Prism(rings[0], solid.base, top, tuple(rings[1:]), tilt))
    return found
