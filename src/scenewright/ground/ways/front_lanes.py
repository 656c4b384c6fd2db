"""Lanes before fronts: whose house stands by a way but looks at none gets one before its door.

A lane goes on from the street or lane it is quickest reached from and runs before the front; the
farthest doors come first, so that a row has one lane along its fronts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.ground.streetside.fronts import find_fronting
from scenewright.ground.ways.lanes import LaneGround, Laying, begin_laying, lay_lane
from scenewright.ground.ways.walks import Doors, find_doors

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]
Shapes = NDArray[np.object_]

AHEAD = (2.0, 3.5, 5.0, 7.0, 0.7)
"""Metres between a door and the edge of the lane before it, tried in turn."""


def lay_front_lanes(
    ground: LaneGround, streets: Shapes, shapes: Shapes, doors: Doors, laying: Laying | None
) -> Laying | None:
    """Lanes before the ``doors`` (n,) of buildings of some ``shapes`` (n,) that stand by a way and
    look at none of ``streets`` (s,) and of the lanes of a ``laying``."""
    lanes = shapely.buffer(np.array(laying.laid if laying else [], object), ground.radius)
    by, fronting = find_fronting(np.array([*streets, *lanes], object), shapes, doors)
    waiting = np.flatnonzero(by & ~fronting)
    if not len(waiting):
        return laying
    laying = laying or begin_laying(ground)
    places, ways = doors.places[waiting], doors.ways[waiting]
    goals, far = find_goals(ground, laying, places, ways)
    reach = max(AHEAD) + 2.0 * ground.radius
    rays = shapely.STRtree(shapely.linestrings(np.stack([places, places + reach * ways], 1)))
    left = np.isfinite(far)
    for k in np.argsort(np.where(left, -far, np.inf), kind="stable").tolist():
        if left[k]:
            lane = lay_lane(ground, laying, int(goals[k]))
            left[k] = False
            if lane is not None:
                laying.laid.append(lane)
                left[rays.query(lane, predicate="intersects")] = False
    return laying


def turn_fronts(
    ways: Shapes, shapes: Shapes, footprints: Sequence[Points], headings: Floats, free: Flags
) -> Floats:
    """Headings (n,) of buildings on ``footprints``, corners (k, 2), and ``shapes``, those turned
    round that are ``free`` to, stand by one of the ``ways`` and so look at it."""
    shapes = shapes[: len(footprints)]
    by, fronting = find_fronting(ways, shapes, find_doors(footprints, headings))
    rows = np.flatnonzero(by & ~fronting & free)
    if not len(rows):
        return headings
    doors = find_doors([footprints[k] for k in rows.tolist()], headings[rows] + math.pi)
    turned = rows[find_fronting(ways, shapes[rows], doors)[1]]
    found = headings.copy()
    found[turned] += math.pi
    return found


def find_goals(
    ground: LaneGround, laying: Laying, places: Floats, ways: Floats
) -> tuple[Ints, Floats]:
    """The cell ahead of each door (n,) at which a lane is to end, and when it is reached (infinite:
    never): the nearest of :data:`AHEAD`."""
    goals, far = np.zeros(len(places), np.int32), np.full(len(places), np.inf)
    for ahead in AHEAD:
        cells = ground.raster.cells_of(places + (ahead + ground.radius) * ways)
        fresh = ~np.isfinite(far) & np.isfinite(laying.tree.times[cells])
        goals[fresh], far[fresh] = cells[fresh], laying.tree.times[cells[fresh]]
    return goals, far
