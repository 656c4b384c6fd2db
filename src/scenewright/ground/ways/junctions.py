"""Where ways meet: corners drawn round, and zebra crossings on the arms of a junction of streets
and where a path leads over a street."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.plan import Way

Floats = NDArray[np.float64]

STREET_RADIUS, LANE_RADIUS = 6.0, 4.0
"""Radius in metres of the corners of streets and of lanes (RASt 06, 6.3.1: 6 to 8 m on residential
streets, less where only cars turn)."""
SLOT, APART = 1.0, 0.3
"""Half the width in metres of slots between ways that are paved over; metres kept from walls."""
STRIPE, DEEP, OFF = 0.5, 3.0, 0.5
"""Metres of a stripe of a crossing and of the gap after it (StVO, Zeichen 293), of its length, and
between a crossing and the street crossed."""
TOUCH, SHARPEST = 0.05, 0.5
"""Metres that a crossing may reach beyond its street; sine of the least angle between streets for
there to be crossings on their arms."""


class Crossing(NamedTuple):
    """A zebra crossing: its middle (2,), the direction (2,) of the street, and the metres across it
    and along it that are painted."""

    at: Floats
    along: Floats
    wide: float
    deep: float = DEEP

    def area(self) -> shapely.Polygon:
        """The ground of the crossing.

        >>> Crossing(np.zeros(2), np.array([1.0, 0.0]), 6.0).area().area
        18.0
        """
        return _rectangle(self.at, self.along, self.deep, self.wide)


def round_corners(
    shape: shapely.Geometry, radius: float, solids: shapely.STRtree
) -> shapely.Geometry:
    """The ground of ways with the corners between them filled to a ``radius``, and narrow slots,
    where nothing of ``solids`` stands.

    >>> cross = shapely.union(shapely.box(-30, -2, 30, 2), shapely.box(-2, -30, 2, 30))
    >>> round(round_corners(cross, 4.0, shapely.STRtree([])).area - cross.area)
    14
    """
    closed = shapely.buffer(shapely.buffer(shape, radius, quad_segs=6), -radius, quad_segs=6)
    parts = shapely.get_parts(shapely.difference(closed, shape))
    small = shapely.area(parts) <= 1.3 * radius**2
    small |= shapely.is_empty(shapely.buffer(parts, -SLOT))
    parts = parts[small & (shapely.area(parts) > 0.01)]
    met = solids.query(parts, predicate="dwithin", distance=APART)[0]
    return shapely.union_all([shape, *np.delete(parts, np.unique(met))])


def list_crossings(ways: Sequence[Way], carriageways: Sequence[float]) -> list[Crossing]:
    """The crossings of some ways of a site; ``carriageways`` (n,) are the metres of each between
    its pavements, 0 of those without and of paths."""
    found: list[Crossing] = []
    drawn: list[shapely.Polygon] = []
    roads = [shapely.Polygon(a.outline, a.holes) for w in ways if w.kind == "road" for a in w.areas]
    floor = shapely.buffer(shapely.union_all(roads), TOUCH)
    shapely.prepare(floor)
    for one in _candidates(ways, carriageways):
        area = one.area()
        if shapely.covers(floor, area) and not any(area.intersects(o) for o in drawn):
            found.append(one)
            drawn.append(area)
    return found


def paint(crossings: Sequence[Crossing]) -> shapely.Geometry:
    """The stripes of some crossings.

    >>> len(paint([Crossing(np.zeros(2), np.array([1.0, 0.0]), 6.0)]).geoms)
    6
    """
    rows = []
    for one in crossings:
        across = np.array([-one.along[1], one.along[0]])
        count = int(one.wide // (2.0 * STRIPE))
        for step in (np.arange(count) - 0.5 * (count - 1)) * 2.0 * STRIPE:
            rows.append(_rectangle(one.at + step * across, one.along, one.deep, STRIPE))
    return shapely.multipolygons(np.array(rows, object))


def _rectangle(at: Floats, along: Floats, deep: float, wide: float) -> shapely.Polygon:
    """The rectangle ``deep`` metres along a direction and ``wide`` across it."""
    u, v = 0.5 * deep * along, 0.5 * wide * np.array([-along[1], along[0]])
    return shapely.Polygon([at - u - v, at + u - v, at + u + v, at - u + v])


def _candidates(ways: Sequence[Way], carriageways: Sequence[float]) -> Iterator[Crossing]:
    """Crossings on every arm of every meeting of streets, and in line with paths over streets."""
    lines = np.array([shapely.LineString(way.line) for way in ways], object)
    tree = shapely.STRtree(lines)
    for one, other in tree.query(lines, predicate="intersects").T.tolist():
        street = ways[one].kind == "road" and carriageways[one] > 0.0
        if one == other or not street:
            continue
        for point in _points(shapely.intersection(lines[one], lines[other])):
            along, across = _direction(lines[one], point), _direction(lines[other], point)
            sine = abs(float(along[0] * across[1] - along[1] * across[0]))
            if sine < SHARPEST:
                continue
            if ways[other].kind == "path":
                yield Crossing(point, along, carriageways[one], max(DEEP, ways[other].width))
                continue
            slant = 0.5 * ways[one].width * abs(float(along @ across)) / sine
            off = 0.5 * ways[other].width / sine + slant + OFF + 0.5 * DEEP
            at = lines[one].project(shapely.Point(point))
            for place in (at - off, at + off):
                if DEEP < place < lines[one].length - DEEP:
                    middle = np.array(lines[one].interpolate(place).coords[0])
                    way = _direction(lines[one], middle)
                    yield Crossing(middle, way, carriageways[one])


def _points(shape: shapely.Geometry) -> Floats:
    """The points (n, 2) of a meeting of lines, none of stretches they share."""
    parts = [part for part in shapely.get_parts(shape) if part.geom_type == "Point"]
    return shapely.get_coordinates(np.array(parts, object)).reshape(-1, 2)


def _direction(line: shapely.LineString, point: Floats) -> Floats:
    """The direction of a line at a point on it."""
    at = line.project(shapely.Point(point))
    ends = line.interpolate([max(at - 0.5, 0.0), min(at + 0.5, line.length)])
    step = np.diff(shapely.get_coordinates(ends), axis=0)[0]
    found: Floats = step / max(float(np.hypot(*step)), 1e-9)
    return found
