"""The floors of a Sweet Home 3D level: rooms as drawn, freed of walls and of each other."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from scenewright.core.errors import InputError
from scenewright.core.space import Points
from scenewright.formats.sh3d_xml import Home, HomeRoom, HomeWall, middle_line

LEAST_ROOM = 1.0
LEAST_WIDTH = 0.3
FINEST = 0.002
GAP = 0.15


class DrawnFloor(NamedTuple):
    """One room's floor: its name as drawn (or ''), its level and polygon."""

    name: str
    level: str
    polygon: shapely.Polygon


def floors(home: Home, level: str) -> list[DrawnFloor]:
    """Floors of a level, in the order drawn; if none is drawn, all that the walls enclose.

    Of rooms that overlap the smaller one keeps the floor. What walls or smaller rooms cut into
    several parts keeps its largest; parts narrower than 0.3 m fall off; floors of less than 1 m²
    are left out.
    """
    solid = walls_of(home, level)
    drawn = [room for room in home.rooms if room.level == level]
    if not drawn:
        return [DrawnFloor("", level, part) for part in _find_enclosed(solid)]
    shapes = [_shape(room) for room in drawn]
    order = sorted(range(len(drawn)), key=lambda i: shapes[i].area)
    taken: BaseGeometry = solid
    found: dict[int, shapely.Polygon] = {}
    for i in order:
        part = _largest(_remove_narrow_parts(shapes[i].difference(taken)))
        if part.area >= LEAST_ROOM:
            found[i] = part
            taken = taken.union(part)
    return [DrawnFloor(drawn[i].name, level, found[i]) for i in sorted(found)]


def walls_of(home: Home, level: str) -> BaseGeometry:
    """The footprint of all walls of a level, mitred where two walls are joined."""
    walls = {wall.id or str(i): wall for i, wall in enumerate(home.walls) if wall.level == level}
    parts = [
        grow_shape(shapely.LineString(middle_line(w)), w.thickness / 2, "flat")
        for w in walls.values()
    ]
    for wall in walls.values():
        for end, other in zip((0, -1), wall.joined, strict=True):
            if other in walls:
                parts.append(_joint(wall, end, walls[other]))
    return shapely.union_all(parts)


def _joint(wall: HomeWall, end: int, other: HomeWall) -> BaseGeometry:
    """Half of each of two joined walls, as one band with a mitred corner."""
    line, partner = middle_line(wall), middle_line(other)
    near = 0 if np.hypot(*(partner[0] - line[end])) < np.hypot(*(partner[-1] - line[end])) else -1
    first, second = (_half(line, end), _half(partner, near))
    band = shapely.LineString([first, line[end], second])
    return grow_shape(band, min(wall.thickness, other.thickness) / 2, "flat")


def _half(line: Points, end: int) -> Points:
    """The middle of the first or last segment of a polyline."""
    inner: Points = (line[end] + line[1 if end == 0 else -2]) / 2
    return inner


def grow_shape(
    shape: BaseGeometry, by: float, cap: Literal["round", "flat"] = "round"
) -> BaseGeometry:
    """The shape with mitred corners, grown by ``by`` metres on all sides (or shrunk)."""
    with np.errstate(all="ignore"):
        return shape.buffer(by, cap_style=cap, join_style="mitre")


def _find_enclosed(solid: BaseGeometry) -> list[shapely.Polygon]:
    """What the walls go around, in reading order (from the north-west).

    Walls that miss each other by less than GAP are taken as joined.
    """
    closed = grow_shape(grow_shape(solid, GAP / 2), -GAP / 2)
    parts = getattr(closed, "geoms", [closed])
    holes = [shapely.Polygon(ring) for part in parts for ring in getattr(part, "interiors", ())]
    inside = [_largest(_remove_narrow_parts(hole.difference(solid))) for hole in holes]
    inside = [part for part in inside if part.area >= LEAST_ROOM]
    return sorted(inside, key=lambda part: (-round(part.centroid.y), part.centroid.x))


def _shape(room: HomeRoom) -> BaseGeometry:
    if len(room.corners) > 5000:
        raise InputError("has more than 5000 corners", "draw it simpler", place=room.place)
    if len(room.corners) < 3:
        return shapely.Polygon()
    shape: BaseGeometry = shapely.make_valid(shapely.Polygon(room.corners))
    return shape


def _remove_narrow_parts(shape: BaseGeometry) -> BaseGeometry:
    """Without parts narrower than LEAST_WIDTH: shrunk and grown again, inside what it was."""
    half = LEAST_WIDTH / 2
    core = grow_shape(grow_shape(shape, -half), half * 1.001)
    return core.intersection(shape).simplify(FINEST)


def _largest(shape: BaseGeometry) -> shapely.Polygon:
    parts = [p for p in getattr(shape, "geoms", [shape]) if isinstance(p, shapely.Polygon)]
    return max(parts, key=lambda part: part.area, default=shapely.Polygon())
