"""Moving borders of zones: which straight lines of borders may move, and the zones once one has.

Zones meet along straight lines. A line moves as a whole, parallel to itself: what it sweeps goes
from the zones it moves into to those on its other side, each as far as its own border reached.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points, Space
from scenewright.domains.hall.hall_layout import Zone
from scenewright.domains.hall.zoning.borders import BORDERS_TOUCH, Border, floor_of, zone_of
from scenewright.domains.hall.zoning.cuts import GRID

SAME_WAY = 1e-3
BEYOND_ANY = 1e3
"""Longer than any hall, in metres."""
LOST = 1e-3
"""Square metres by which zones may differ from the floor they had, for rounding."""
LEAST_KEPT = 0.6
"""Least share of its floor that a zone keeps."""


class BorderLine(NamedTuple):
    """A straight line of borders: ``start`` and unit direction ``way`` (2,), its ``length``, the
    numbers of the zones on its left and right, and for each piece of it (metres from the start, to)
    the zones to its left and right (``pieces``)."""

    start: Points
    way: Points
    length: float
    left: frozenset[int]
    right: frozenset[int]
    pieces: tuple[tuple[float, float, int, int], ...]

    @property
    def zones(self) -> frozenset[int]:
        """All zones that meet here."""
        return self.left | self.right


def border_lines(borders: tuple[Border, ...]) -> tuple[BorderLine, ...]:
    """Borders strung together where they follow one another in one line.

    >>> lines = border_lines((Border(0, 1, (2.0, 0.0), (2.0, 3.0)),
    ...                       Border(0, 2, (2.0, 3.0), (2.0, 5.0))))
    >>> [(line.length, sorted(line.left), sorted(line.right)) for line in lines]
    [(5.0, [0], [1, 2])]
    """
    lines: list[BorderLine] = []
    for border in borders:
        new, apart = _line_of(border), list[BorderLine]()
        for line in lines:
            if _joins(line, new):
                new = _join(line, new)
            else:
                apart.append(line)
        lines = [*apart, new]
    return tuple(lines)


def _line_of(border: Border) -> BorderLine:
    start, end = np.array(border.start), np.array(border.end)
    length = float(np.hypot(*(end - start)))
    sides = frozenset([border.first]), frozenset([border.second])
    pieces = ((0.0, length, border.first, border.second),)
    return BorderLine(start, (end - start) / length, length, *sides, pieces)


def _joins(one: BorderLine, other: BorderLine) -> bool:
    """Whether two lines lie in one and touch."""
    step = other.start - one.start
    across = abs(one.way[0] * step[1] - one.way[1] * step[0])
    turn = abs(one.way[0] * other.way[1] - one.way[1] * other.way[0])
    ends = sorted(float((p - one.start) @ one.way) for p in _ends(other))
    touch = ends[0] <= one.length + BORDERS_TOUCH and ends[1] >= -BORDERS_TOUCH
    return bool(turn < SAME_WAY and across < BORDERS_TOUCH and touch)


def _ends(line: BorderLine) -> tuple[Points, Points]:
    return line.start, line.start + line.length * line.way


def _join(one: BorderLine, other: BorderLine) -> BorderLine:
    pieces = [*one.pieces]
    same = bool(one.way @ other.way > 0.0)
    for first, last, left, right in other.pieces:
        ends = [float((other.start + t * other.way - one.start) @ one.way) for t in (first, last)]
        pieces.append((min(ends), max(ends), *((left, right) if same else (right, left))))
    low, high = min(piece[0] for piece in pieces), max(piece[1] for piece in pieces)
    moved = tuple((a - low, b - low, left, right) for a, b, left, right in sorted(pieces))
    lefts, rights = frozenset(piece[2] for piece in moved), frozenset(piece[3] for piece in moved)
    return BorderLine(one.start + low * one.way, one.way, high - low, lefts, rights, moved)


def shift_zones(
    zones: tuple[Zone, ...], line: BorderLine, metres: float, space: Space
) -> tuple[Zone, ...] | None:
    """The zones once a line has moved ``metres`` to its left; None where they would not fill the
    same floor, or one lose more than two fifths of its own.

    >>> west = Zone("a", "", "hall", np.array([[0, 0], [2, 0], [2, 3], [0, 3]], float))
    >>> east = Zone("b", "", "hall", np.array([[2, 0], [5, 0], [5, 3], [2, 3]], float))
    >>> space = Space("hall", "Hall", ("hall",), "0", np.array([[0, 0], [5, 0], [5, 3], [0, 3.0]]))
    >>> line = border_lines((Border(0, 1, (2.0, 0.0), (2.0, 3.0)),))[0]
    >>> moved = shift_zones((west, east), line, 0.5, space)
    >>> [round(float(shapely.Polygon(zone.outline).area), 6) for zone in moved]
    [4.5, 10.5]
    """
    shapes = [_shape(zone) for zone in zones]
    for low, high, left, right in _widen(line):
        strip = _strip(line, (low, high), metres)
        winner = right if metres > 0.0 else left
        for loser in line.left if metres > 0.0 else line.right:
            part = _touching(shapes[loser].intersection(strip, grid_size=GRID), line)
            shapes[loser] = shapes[loser].difference(part, grid_size=GRID)
            shapes[winner] = shapes[winner].union(part, grid_size=GRID)
    if any(not isinstance(shape, shapely.Polygon) or shape.is_empty for shape in shapes):
        return None
    moved = tuple(
        zone_of(shapes[k], (zone.id, zone.name), space) if k in line.zones else zone
        for k, zone in enumerate(zones)
    )
    return moved if _fill_alike(zones, moved, space) else None


def _widen(line: BorderLine) -> list[tuple[float, float, int, int]]:
    """The pieces of a line, the first and the last drawn out beyond its ends."""
    found = list(line.pieces)
    found[0] = (found[0][0] - BEYOND_ANY, *found[0][1:])
    found[-1] = (found[-1][0], found[-1][1] + BEYOND_ANY, *found[-1][2:])
    return found


def _strip(line: BorderLine, span: tuple[float, float], metres: float) -> shapely.Polygon:
    """What a piece of a line sweeps as it moves ``metres`` to its left."""
    normal = metres * np.array([-line.way[1], line.way[0]])
    start, end = (line.start + t * line.way for t in span)
    return shapely.Polygon([start, end, end + normal, start + normal])


def _touching(shape: shapely.Geometry, line: BorderLine) -> shapely.Geometry:
    """The parts of a shape along a line, not those beyond its ends."""
    lies = shapely.LineString([line.start, line.start + line.length * line.way])
    near = [
        part
        for part in shapely.get_parts(shape).tolist()
        if part.area > 0.0
        and part.intersection(lies.buffer(BORDERS_TOUCH)).area > 0.5 * BORDERS_TOUCH**2
    ]
    return shapely.union_all(near)


def _fill_alike(zones: tuple[Zone, ...], moved: tuple[Zone, ...], space: Space) -> bool:
    """Whether moved zones are sound, apart, within the hall, as large together and none too
    small."""
    before, after = (np.array([_shape(zone) for zone in some]) for some in (zones, moved))
    if not shapely.is_valid(after).all():
        return False
    areas, kept = shapely.area(before), shapely.area(after)
    if (kept < LEAST_KEPT * areas).any() or abs(kept.sum() - areas.sum()) > LOST:
        return False
    whole = shapely.union_all(after)
    outside = whole.difference(floor_of(space).buffer(BORDERS_TOUCH)).area
    return bool(abs(whole.area - areas.sum()) < LOST and outside < LOST)


def _shape(zone: Zone) -> shapely.Polygon:
    return shapely.Polygon(zone.outline, zone.holes)
