"""Walls under sloped ceilings: knee walls end low, gable walls follow the slope.

A wall reaches the highest ceiling of the rooms beside it. Each room's ceiling is the least of some
planes. So a wall in plan is parted by the lines of the knee walls, then into the cells over which
each plane is the lowest, and these where another room's ceiling is as high: prisms with a tilted
top.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from scenewright.building.ceiling import planes
from scenewright.core.scene import Prism
from scenewright.core.space import Points, Space

BESIDE = 0.08
"""How near a room must be to a wall to say how high it is, in metres."""
CRUMB = 1e-6
SAME = 1e-9
"""Planes whose coefficients all differ by at most this are one."""
_FAR = 1e3


Cell = tuple[Polygon, Points]


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
            for cell, plane in _highest(shape, beside):
                found += _raise_cell(cell, plane, solid)
        else:
            found.append(solid)
    return found


def cut_off(solid: Prism, height: float) -> list[Prism]:
    """The part of a tilted prism below a height."""
    if solid.tilt is None or solid.top <= height:
        return [solid]
    shape, over = Polygon(solid.outline, solid.holes), solid.tilt - np.array([height, 0.0, 0.0])
    low, high = _clip(shape, -over), _clip(shape, over)
    level = np.array([height, 0.0, 0.0])
    return [
        *(p for cell in low for p in _raise_cell(cell, solid.tilt, solid)),
        *(p for cell in high for p in _raise_cell(cell, level, solid)),
    ]


def height_at(tilt: Points, points: Points) -> Points:
    """Heights ``(n,)`` of a plane a + b x + c y at points ``(n, 2)``."""
    return np.asarray(tilt[0] + points @ tilt[1:])


def _highest(shape: Polygon, beside: Sequence[Roof]) -> list[Cell]:
    """A shape in cells with the plane over each: the highest of the rooms' ceilings."""
    first, *others = beside
    cells = _lowest(shape, first)
    for roof in others:
        both = [(part, one, other) for cell, one in cells for part, other in _lowest(cell, roof)]
        cells = [found for part, one, other in both for found in _higher(part, one, other)]
    return cells


def _higher(shape: Polygon, one: Points, other: Points) -> list[Cell]:
    if np.abs(one - other).max() < SAME:
        return [(shape, one)]
    return [
        (part, plane)
        for plane, side in ((one, one - other), (other, other - one))
        for part in _clip(shape, side)
    ]


def _lowest(shape: Polygon, roof: Roof) -> list[Cell]:
    """A shape in cells with the plane of one roof that is the lowest over each."""
    cells = [shape]
    for line in _distinct(roof.knees):
        cells = [part for cell in cells for side in (line, -line) for part in _clip(cell, side)]
    found = []
    for cell in cells:
        planes = _distinct(_planes_over(cell, roof))
        for plane in planes:
            parts = [cell]
            for other in planes:
                if other is not plane:
                    parts = [left for part in parts for left in _clip(part, other - plane)]
            found += [(part, plane) for part in parts]
    return found


def _planes_over(cell: Polygon, roof: Roof) -> Points:
    """The planes of a roof over a cell that no line of a knee wall parts."""
    point = np.array([1.0, *cell.representative_point().coords[0]])
    low, at_knee = roof.planes.copy(), np.flatnonzero(roof.knees @ point < 0) + 1
    low[at_knee] = _knee(roof, at_knee)
    return low


def _distinct(rows: Points) -> list[Points]:
    """Rows without those equal to an earlier one."""
    found: list[Points] = []
    for row in rows:
        if all(np.abs(row - other).max() >= SAME for other in found):
            found.append(row)
    return found


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
    half = Polygon(
        [foot - along, foot - along + normal * _FAR, foot + along + normal * _FAR, foot + along]
    )
    parts = shapely.get_parts(shape.intersection(half))
    return [part for part in parts if isinstance(part, Polygon) and part.area > CRUMB]


def _knee(roof: Roof, numbers: NDArray[np.intp]) -> Points:
    """Flat planes at the knees of some slopes: their planes less what they rise inwards."""
    slopes, inwards = roof.planes[numbers], roof.knees[numbers - 1]
    rises = np.hypot(slopes[:, 1], slopes[:, 2])[:, None]
    return slopes - rises * inwards


def _raise_cell(cell: Polygon, tilt: Points, solid: Prism) -> list[Prism]:
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
