"""Passages: how wide a person can walk from one zone of a hall to another.

The *clear width* between two zones is the diameter of the largest disc that can be moved from
wholly inside the one to wholly inside the other, through the floor of both and the floor that
belongs to no zone, and meets no wall, partition or piece on its way. Its centre may be where a
disc of that diameter has room: the free floor shrunk by half of it (Minkowski; discs as 32-gons),
exact but for the 3 mm by which a 32-gon falls short of its disc at corners. While the disc is
wholly in neither zone it meets their border or floor of no zone, so only what lies within its
diameter of these has to be looked at. Cao, Cheng and Zhang
(2024) ask for d_min between connected zones and do not say how they measure it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Bodies, Flags, Indices, Shape, Shapes
from scenewright.core.report import Finding
from scenewright.domains.hall.check.halls import JudgedHall, JudgedLink

MOST = 3.0
"""Widths above this, or above 1.5 times what was asked for, are reported as that, in metres."""

_SEAM = 0.005  # zones that share a border may be written a hair apart
_LEAST = 0.02
_ABOUT = 0.15


class MeasuredPassage(NamedTuple):
    """A link as it is: the clear ``width`` in metres (0: closed), where it is narrowest (none if it
    is as wide as is measured), and the rows of the pieces there (-1: a wall)."""

    link: JudgedLink
    width: float
    at: tuple[float, float] | None
    between: tuple[int, ...]


class _Pair(NamedTuple):
    """Two zones and the free floor about their border through which one may walk."""

    first: Shape
    second: Shape
    free: Shape


def passages_of(bodies: Bodies, hall: JudgedHall) -> list[MeasuredPassage]:
    """The clear width of every link of a hall."""
    return [_passage(bodies, hall, link) for link in hall.links]


def find_narrow(bodies: Bodies, hall: JudgedHall, passages: list[MeasuredPassage]) -> list[Finding]:
    """A finding for each passage 1 cm or more narrower than asked for.

    It is *given* if fixed pieces alone leave it as narrow and the brief drew both zones.
    """
    found = []
    for passage in passages:
        if passage.width >= passage.link.width:
            continue
        pair = _pair(bodies, hall, passage.link, hall.solids)
        if not _passes(pair, passage.link.width - TOLERANCE + 1e-6):
            found.append(_finding(bodies, hall, passage))
    return found


def clear_width(first: Shape, second: Shape, free: Shape, most: float = MOST) -> float:
    """Diameter in metres, to 1 cm below and at ``most``, of the largest disc that gets from wholly
    inside the ``first`` area to wholly inside the ``second`` through the ``free`` floor.

    >>> west, east = shapely.box(0, 0, 4, 3), shapely.box(4, 0, 8, 3)
    >>> wall = shapely.box(3.9, 1.0, 4.1, 3)
    >>> round(clear_width(west, east, shapely.union(west, east) - wall), 1)
    1.0
    """
    pair = _Pair(first, second, free)
    if not _passes(pair, _LEAST):
        return 0.0
    low, high = _LEAST, most
    if _passes(pair, most):
        return most
    while high - low > TOLERANCE:
        middle = (low + high) / 2
        low, high = (middle, high) if _passes(pair, middle) else (low, middle)
    return low


def _passage(bodies: Bodies, hall: JudgedHall, link: JudgedLink) -> MeasuredPassage:
    pair = _pair(bodies, hall, link, hall.solids)
    width = clear_width(*pair, most=_most(link))
    if width >= _most(link):
        return MeasuredPassage(link, width, None, ())
    at = _narrowest(pair, width)
    return MeasuredPassage(link, width, at, _beside(bodies, hall, at, width))


def _most(link: JudgedLink) -> float:
    return max(MOST, 1.5 * link.width)


def _pair(bodies: Bodies, hall: JudgedHall, link: JudgedLink, solids: Indices) -> _Pair:
    first, second = hall.areas[link.first], hall.areas[link.second]
    border = shapely.intersection(first.buffer(2 * _SEAM), second.buffer(2 * _SEAM))
    nobody = shapely.difference(hall.shape, shapely.union_all(hall.areas))
    nobody = nobody.buffer(-_SEAM, join_style="mitre").buffer(2 * _SEAM, join_style="mitre")
    about = shapely.buffer(shapely.union(border, nobody), _most(link) + _ABOUT)
    own = shapely.buffer(shapely.union_all([first, second]), _SEAM, join_style="mitre")
    floor = shapely.intersection(
        shapely.union(own, nobody), shapely.intersection(hall.shape, about)
    )
    near = solids[shapely.intersects(bodies.footprints[solids], floor)]
    free = shapely.difference(floor, shapely.union_all(bodies.footprints[near]))
    return _Pair(first, second, free)


def _shrunk(pair: _Pair, width: float) -> tuple[Shapes, Flags, Flags]:
    """The connected parts where the disc's centre may be, and which reach either zone."""
    parts = shapely.get_parts(shapely.buffer(pair.free, -width / 2, quad_segs=8))
    inside = [shapely.buffer(zone, -width / 2, quad_segs=8) for zone in (pair.first, pair.second)]
    for zone in inside:
        shapely.prepare(zone)
    return parts, shapely.intersects(inside[0], parts), shapely.intersects(inside[1], parts)


def _passes(pair: _Pair, width: float) -> bool:
    _, first, second = _shrunk(pair, width)
    return bool((first & second).any())


def _narrowest(pair: _Pair, width: float) -> tuple[float, float]:
    """Where a disc a little wider gets stuck: midway between what it reaches from both sides, or
    where the disc just fits into the zone that no wider one fits into."""
    parts, first, second = _shrunk(pair, width + 2 * TOLERANCE)
    if first.any() and second.any():
        line = shapely.shortest_line(
            shapely.multipolygons(parts[first]), shapely.multipolygons(parts[second])
        )
        place = shapely.line_interpolate_point(line, 0.5, normalized=True)
    else:
        place = shapely.point_on_surface(_tight_spot(pair, width, not first.any()))
    return round(float(place.x), 3), round(float(place.y), 3)


def _tight_spot(pair: _Pair, width: float, in_first: bool) -> Shape:
    """Where in a zone the centre of the disc that gets through may be; the zone if none does."""
    zone = pair.first if in_first else pair.second
    parts, first, second = _shrunk(pair, max(width - TOLERANCE, 0.0))
    through = shapely.multipolygons(parts[first & second])
    spot = shapely.intersection(through, shapely.buffer(zone, -width / 2, quad_segs=8))
    return zone if spot.is_empty else spot


def _beside(
    bodies: Bodies, hall: JudgedHall, at: tuple[float, float], width: float
) -> tuple[int, ...]:
    """Rows of the two things nearest to a point, as far as they bound the passage; -1 a wall."""
    here, within = shapely.Point(at), width / 2 + _ABOUT
    apart = shapely.distance(bodies.footprints[hall.solids], here)
    near = [(float(apart[k]), int(hall.solids[k])) for k in np.flatnonzero(apart <= within)]
    wall = float(shapely.distance(shapely.boundary(hall.shape), here))
    near += [(wall, -1)] * (wall <= within)
    return tuple(row for _, row in sorted(near)[:2])


def describe_neighbours(bodies: Bodies, rows: tuple[int, ...]) -> str:
    """What stands there, for a message: ``between a and the wall``.

    >>> describe_neighbours(None, (-1,))
    'at the wall'
    """
    names = ["the wall" if row < 0 else bodies.pieces[row].id for row in rows]
    if len(names) == 2:
        return f"between {names[0]} and {names[1]}"
    return f"at {names[0]}" if names else ""


def _finding(bodies: Bodies, hall: JudgedHall, passage: MeasuredPassage) -> Finding:
    link, wide = passage.link, passage.width
    a, b = hall.zones[link.first], hall.zones[link.second]
    how = f"{wide:.2f} m wide" if wide > 0 else "closed"
    where = describe_neighbours(bodies, passage.between)
    message = f"the passage from {a} to {b} is {how}, not {link.width:.2f} m"
    message += f": {where}" if where else ""
    message += " at ({:.2f}, {:.2f})".format(*passage.at) if passage.at else ""
    fixed = np.array([bodies.pieces[row].fixed for row in hall.solids], bool)
    alone = _pair(bodies, hall, link, hall.solids[fixed])
    drawn = hall.given[link.first] and hall.given[link.second]
    given = drawn and not _passes(alone, link.width - TOLERANCE + 1e-6)
    others = ",".join(bodies.pieces[row].id for row in passage.between if row >= 0)
    return Finding(
        "narrow_passage",
        hall.space.level,
        hall.space.id,
        "",
        others,
        message,
        round(link.width - wide, 4),
        given=given,
    )
