"""Sight: which objects a visitor sees, and passes, on the way through a hall.

An object is seen if the middle of one of the sides it is used from (all sides, where its kind
names none) is within 15 m of the tour, turned towards it, and nothing as high as the eyes stands
between: no wall, partition or piece rising above 1.6 m. It is passed if it is seen from 3 m.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Bodies, Floats, Indices, Shape, Shapes
from scenewright.check.routes import JoinedFloor
from scenewright.core.space import Points
from scenewright.domains.hall.check.halls import JudgedHall

EYES = 1.6
"""What rises above this height, in metres, hides what is behind it."""

FAR = 15.0
"""From how far an object is seen, in metres."""

NEAR = 3.0
"""From how far it is passed by, in metres."""

STEP = 0.5
_AHEAD = 0.02
_MOST_STOPS = 4000
_SIDES = {"front": (1, 2), "left": (2, 3), "back": (3, 0), "right": (0, 1)}


class Sides(NamedTuple):
    """Points (m, 2) just before the sides objects are used from, the outward normals (m, 2) and
    the number of the object each belongs to."""

    points: Floats
    normals: Floats
    owner: Indices


def seen_from(bodies: Bodies, hall: JudgedHall, ground: JoinedFloor) -> Floats:
    """For each object of a hall the least distance in metres from which it is seen on the tour;
    infinite if it is not. The tour is looked at every 0.5 m, one over 2 km at 4000 places."""
    nearest = np.full(len(hall.objects), np.inf)
    if hall.tour is None or not len(hall.objects):
        return nearest
    length = float(shapely.length(shapely.linestrings(hall.tour)))
    stops = resample_line(hall.tour, max(STEP, length / _MOST_STOPS))[: 2 * _MOST_STOPS]
    hiding = shapely.STRtree(_hiding(bodies, hall, ground.floor))
    sides = sides_of(bodies, hall.objects)
    for reach in (NEAR + 1, FAR):  # most are seen from near by, so few have to be sought far off
        left = np.isinf(nearest[sides.owner])
        sides = Sides(sides.points[left], sides.normals[left], sides.owner[left])
        if len(sides.owner):
            np.minimum.at(nearest, sides.owner, _seen_within(sides, stops, reach, hiding))
    return nearest


def _seen_within(sides: Sides, stops: Floats, reach: float, hiding: shapely.STRtree) -> Floats:
    """Distance of the nearest stop within ``reach`` metres from which each side is seen."""
    side, stop = shapely.STRtree(shapely.points(stops)).query(
        shapely.points(sides.points), predicate="dwithin", distance=reach
    )
    towards = stops[stop] - sides.points[side]
    turned = (towards * sides.normals[side]).sum(1) > 0
    side, stop, apart = side[turned], stop[turned], np.hypot(*towards[turned].T)
    order = np.lexsort((apart, side))
    return _first_seen(sides.points, stops, side[order], stop[order], apart[order], hiding)


def _first_seen(
    points: Floats,
    stops: Floats,
    side: Indices,
    stop: Indices,
    apart: Floats,
    hiding: shapely.STRtree,
) -> Floats:
    """Distance of the nearest stop from which each side is seen; pairs come sorted by side, then
    distance, and are tried nearest first, twice as many of those left in every round."""
    found = np.full(len(points), np.inf)
    starts = np.searchsorted(side, np.arange(len(points) + 1))
    at, count = starts[:-1].copy(), 1
    while (open_ := np.flatnonzero((at < starts[1:]) & np.isinf(found))).size:
        ends = np.minimum(at[open_] + count, starts[1:][open_])
        pairs = np.concatenate([np.arange(a, b) for a, b in zip(at[open_], ends, strict=True)])
        lines = shapely.linestrings(np.stack([points[side[pairs]], stops[stop[pairs]]], 1))
        hidden = np.zeros(len(pairs), bool)
        hidden[hiding.query(lines, predicate="intersects")[0]] = True
        clear = pairs[~hidden]
        np.minimum.at(found, side[clear], apart[clear])
        at[open_], count = ends, 2 * count
    return found


def sides_of(bodies: Bodies, rows: Indices) -> Sides:
    """The middles of the sides some pieces are used from, moved 2 cm off them."""
    owner, starts = [], []
    for number, row in enumerate(rows):
        for side in bodies.kinds[row].access or _SIDES:
            owner.append(number)
            starts.append(_SIDES[side])
    held, (first, last) = np.array(owner, np.int64), np.array(starts, np.int64).T
    start, end = bodies.corners[rows[held], first], bodies.corners[rows[held], last]
    along = (end - start) / np.maximum(np.linalg.norm(end - start, axis=1, keepdims=True), 1e-12)
    normals = np.stack([along[:, 1], -along[:, 0]], -1)
    return Sides((start + end) / 2 + _AHEAD * normals, normals, held)


def resample_line(points: Points, step: float) -> Floats:
    """The corners of a line (k, 2) and points at most ``step`` metres apart between them.

    >>> resample_line(np.array([[0.0, 0.0], [1.0, 0.0]]), 0.5).tolist()
    [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0]]
    """
    line = shapely.segmentize(shapely.linestrings(points), step)
    return np.asarray(shapely.get_coordinates(line), np.float64)


def _hiding(bodies: Bodies, hall: JudgedHall, floor: Shape) -> Shapes:
    """What one cannot look through: walls, partitions, and pieces at the height of the eyes."""
    rows = np.flatnonzero(
        (bodies.room == hall.room) & ~bodies.soft & (bodies.high > EYES) & (bodies.low < EYES)
    )
    rows = np.union1d(rows, hall.partitions)
    shapes = shapely.buffer(bodies.footprints[rows], -TOLERANCE, join_style="mitre")
    rings = shapely.get_parts(shapely.get_rings(shapely.get_parts(floor)))
    corners = [shapely.get_coordinates(ring) for ring in rings]
    walls = [shapely.linestrings(np.stack([c[:-1], c[1:]], 1)) for c in corners]
    return np.concatenate([shapes, *walls])
