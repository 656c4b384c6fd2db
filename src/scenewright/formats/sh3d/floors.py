"""The floors of a Sweet Home 3D level: rooms as drawn, freed of walls and of each other."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from scenewright.core.errors import InputError
from scenewright.core.space import Points
from scenewright.formats.sh3d.gaps import MISSING, PASSAGE, find_gaps
from scenewright.formats.sh3d.xml import Home, HomeRoom, HomeWall, middle_line

LEAST_ROOM = 0.6
"""A room that is drawn is one from here on, m²; less is a shaft or a slip of the pen."""
LEAST_ENCLOSED = 1.0
"""Area in m² from which walls enclose a room where none is drawn."""
LEAST_UNDRAWN = 2.0
"""Area in m² from which walls enclose a room beside drawn ones: less is a shaft."""
LEAST_WIDTH = 0.3
FINEST = 0.002
GAP = 0.15


class DrawnFloor(NamedTuple):
    """One room's floor: its name as drawn (or ''), its level and polygon, and the number of the
    element that draws it (-1: none does, walls enclose it)."""

    name: str
    level: str
    polygon: shapely.Polygon
    number: int = -1


def floors(home: Home, level: str) -> list[DrawnFloor]:
    """Floors of a level: of the rooms in the order drawn, then all else that the walls enclose.

    Of rooms that overlap the smaller one keeps the floor. What walls or smaller rooms cut into
    several parts keeps its largest; parts narrower than 0.3 m fall off; floors of less than 0.6 m²
    are left out, and what walls enclose if it is less than 1 m², or 2 m² beside drawn rooms.
    """
    solid = walls_of(home, level)
    drawn = [room for room in home.rooms if room.level == level]
    shapes = [_shape(room) for room in drawn]
    order = sorted(range(len(drawn)), key=lambda i: shapes[i].area)
    taken: BaseGeometry = solid
    found: dict[int, shapely.Polygon] = {}
    for i in order:
        part = _largest(_remove_narrow_parts(shapes[i].difference(taken)))
        if part.area >= LEAST_ROOM:
            found[i] = part
            taken = taken.union(part)
    rooms = [DrawnFloor(drawn[i].name, level, found[i], drawn[i].number) for i in sorted(found)]
    return rooms + [DrawnFloor("", level, part) for part in _undrawn(home, level, solid, shapes)]


def drawn_area(home: Home, level: str) -> float:
    """The floor drawn on a level, m²: under the rooms, and all else that walls enclose across gaps
    of up to 4 m; without the floor under walls and in gaps."""
    solid = walls_of(home, level)
    shapes = [_shape(room) for room in home.rooms if room.level == level]
    rooms = shapely.union_all(shapes).difference(solid)
    rest = _undrawn(home, level, solid, shapes, MISSING)
    return float(rooms.area + sum(part.area for part in rest))


def _undrawn(
    home: Home, level: str, solid: BaseGeometry, drawn: list[BaseGeometry], widest: float = PASSAGE
) -> list[shapely.Polygon]:
    """The floor that walls enclose, across gaps up to ``widest``, and no room covers."""
    walls = [wall for wall in home.walls if wall.level == level]
    bands = [gap.band() for gap in find_gaps(walls, widest)]
    rooms = shapely.union_all(drawn)
    least = LEAST_UNDRAWN if drawn else LEAST_ENCLOSED
    return [
        part
        for whole in _find_enclosed(shapely.union_all([solid, *bands]))
        for part in shapely.get_parts(_remove_narrow_parts(whole.difference(rooms)))
        if isinstance(part, shapely.Polygon) and part.area >= least
    ]


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
    """The areas the walls go around, in reading order (from the north-west).

    Walls that miss each other by less than GAP are taken as joined.
    """
    closed = grow_shape(grow_shape(solid, GAP / 2), -GAP / 2)
    parts = getattr(closed, "geoms", [closed])
    holes = [shapely.Polygon(ring) for part in parts for ring in getattr(part, "interiors", ())]
    inside = [_largest(_remove_narrow_parts(hole.difference(solid))) for hole in holes]
    inside = [part for part in inside if part.area >= LEAST_ENCLOSED]
    return sorted(inside, key=lambda part: (-round(part.centroid.y), part.centroid.x))


def area_of(room: HomeRoom) -> float:
    """The floor inside the corners of a room, m²."""
    return float(_shape(room).area)


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
