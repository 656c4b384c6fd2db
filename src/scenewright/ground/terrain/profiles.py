"""Heights of ways along their middle lines, cut and filled until none is steeper than it may be.

Of all profiles that rise by at most g a metre along the net of ways the one that departs least
from the ground, z, is the middle of two envelopes (McShane 1934):

    (max_u (z(u) - g d(u, v)) + min_u (z(u) + g d(u, v))) / 2,

d the distance along the net; each is one search from all stations at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from heapq import heapify, heappop, heappush
from typing import NamedTuple

import numpy as np
import shapely
import shapely.affinity
from numpy.typing import NDArray

from scenewright.core.heights import HeightGrid, heights_at
from scenewright.core.space import Points
from scenewright.ground.buildings.built import BuiltRoad

Floats = NDArray[np.float64]
STEEPEST = 0.10
"""The steepest a way for cars may be, in metres a metre."""
PACE = 2.0
"""Metres between stations of a way."""
AREA, FLATTER, STRIP = "area", 0.4, 3.0
"""The kind of strips of squares and car parks, how steep they may be of what ways may, and about
how wide they are, in metres."""
KEPT = 0.95
"""The share of the steepest that profiles use: heights between stations are bilinear."""


class WayStations(NamedTuple):
    """Points (n, 2) along ways, their heights (n,), half the width there (n,), the number of the
    way each belongs to, and how far along it is (n,), in metres."""

    points: Points
    heights: Floats
    half: Floats
    way: NDArray[np.int64]
    along: Floats


class WayLinks(NamedTuple):
    """Pairs of stations ``ends`` (m, 2) and how far apart they are (m,), in metres."""

    ends: NDArray[np.int64]
    lengths: Floats


def grade_ways(ways: Sequence[BuiltRoad], natural: HeightGrid) -> WayStations:
    """The stations of ways with heights by which no way for cars rises more than
    :data:`STEEPEST`; footpaths follow the ground."""
    found = _place_stations(ways)
    heights = heights_at(natural, found.points)
    driven = np.array([ways[k].kind != "path" for k in found.way], bool)
    if driven.any():
        flat = np.array([way.kind == AREA for way in ways])[found.way]
        graph = _link(WayStations(*(column[driven] for column in found)), flat[driven])
        heights[driven] = limit_slope(heights[driven], graph, STEEPEST * KEPT)
    return found._replace(heights=heights)


def rule_area(outline: Points) -> list[BuiltRoad]:
    """A paved area as strips side by side, along its longest side: graded with the ways they
    touch, and flatter than these.

    >>> [round(float(strip.line[0, 1]), 1) for strip in rule_area(np.array([[0, 0], [9, 0], [9, 6],
    ...     [0, 6.0]]))]
    [1.5, 4.5]
    """
    shape = shapely.Polygon(outline)
    sides = np.roll(outline, -1, axis=0) - outline
    long = sides[int(np.argmax(np.hypot(*sides.T)))]
    turn = float(np.arctan2(long[1], long[0]))
    level = shapely.affinity.rotate(shape, -turn, origin=(0, 0), use_radians=True)
    left, low, right, high = level.bounds
    count = max(round((high - low) / STRIP), 1)
    wide, strips = (high - low) / count, []
    for y in low + wide * (np.arange(count) + 0.5):
        across = shapely.intersection(level, shapely.LineString([(left, y), (right, y)]))
        for part in shapely.get_parts(across):
            if part.length > 1.0:
                line = shapely.affinity.rotate(part, turn, origin=(0, 0), use_radians=True)
                strips.append(BuiltRoad(shapely.get_coordinates(line), wide, AREA))
    return strips


def limit_slope(heights: Floats, links: WayLinks, slope: float) -> Floats:
    """The heights (n,) nearest to given ones that differ by at most ``slope`` times the lengths
    of ``links`` between points.

    >>> links = WayLinks(np.array([[0, 1], [1, 2]]), np.array([10.0, 10.0]))
    >>> limit_slope(np.array([0.0, 2.0, 4.0]), links, 0.1).tolist()
    [1.0, 2.0, 3.0]
    """
    rises: list[list[tuple[int, float]]] = [[] for _ in heights]
    steps = slope * links.lengths
    for (i, j), step in zip(links.ends.tolist(), steps.tolist(), strict=True):
        rises[i].append((j, step))
        rises[j].append((i, step))
    low = -np.array(_spread_lowest((-heights).tolist(), rises))
    return np.asarray((low + _spread_lowest(heights.tolist(), rises)) / 2)


def _spread_lowest(heights: list[float], rises: list[list[tuple[int, float]]]) -> list[float]:
    """min_u (z(u) + slope d(u, v)): one search from all points, the lowest first."""
    found, waiting = list(heights), [(z, k) for k, z in enumerate(heights)]
    heapify(waiting)
    while waiting:
        z, k = heappop(waiting)
        if z > found[k]:
            continue
        for other, step in rises[k]:
            if z + step < found[other]:
                found[other] = z + step
                heappush(waiting, (z + step, other))
    return found


def _place_stations(ways: Sequence[BuiltRoad]) -> WayStations:
    rows = []
    for number, way in enumerate(ways):
        line = shapely.LineString(way.line)
        along = np.linspace(0.0, line.length, max(int(np.ceil(line.length / PACE)), 1) + 1)
        points = shapely.get_coordinates(shapely.line_interpolate_point(line, along))
        facts = np.broadcast_to([0.0, way.width / 2, number], (len(points), 3))
        rows.append(np.column_stack([points, facts, along]))
    found = np.concatenate(rows)
    heights, half, way_of, along = found.T[2:]
    return WayStations(found[:, :2], heights, half, way_of.astype(np.int64), along)


def _link(stations: WayStations, flat: NDArray[np.bool_]) -> WayLinks:
    """Neighbours along each way, and stations of ways that meet: where their edges touch.
    What lies on a wider way is level with it."""
    points, way, half = stations.points, stations.way, stations.half
    one = np.flatnonzero(way[1:] == way[:-1])
    spots = shapely.points(points)
    reach = float(max(2 * half.max(), PACE))
    near = shapely.STRtree(spots).query(spots, predicate="dwithin", distance=reach).T
    near = near[(near[:, 0] < near[:, 1]) & (way[near[:, 0]] != way[near[:, 1]])]
    away = np.hypot(*(points[near[:, 0]] - points[near[:, 1]]).T)
    met = near[away <= np.maximum(half[near].sum(1) + 0.1, PACE)]
    ends = np.concatenate([np.stack([one, one + 1], 1), met])
    i, j = ends.T
    length = np.hypot(*(points[i] - points[j]).T)
    wide = np.where((way[i] == way[j]) | flat[i] | flat[j], 0.0, np.maximum(half[i], half[j]))
    length = np.maximum(length - wide, 1e-3)
    return WayLinks(ends, np.where(flat[i] & flat[j], FLATTER * length, length))
