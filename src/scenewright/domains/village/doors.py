"""Where the doors are: on the most street-ward side of each house that a way leads to.

No plan of villages tells doors, so they are assumed: the side whose middle looks towards the
nearest street and has a free forecourt that people reach from the street on a way of
1.2 m between the houses.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.standing import Flags, Floats, Indices, Shapes

WAY = 0.65
"""Half the width of a way, and what it keeps from houses, in metres."""
FORECOURT = (1.3, 1.4)
"""Width and depth in metres of what is free before a door."""
LEAST_SIDE = 1.8
"""Metres a side must have for a door."""
FAR, LONG = 40.0, 6.0
"""Metres to the street that count as much as looking the other way; a side long enough."""
EVEN = 0.05
"""Metres by which two sides must differ for one to be farther ahead."""
START = 1.3
"""How far from a street side, in metres, ways begin."""


class DoorSides(NamedTuple):
    """Of each house (n,) the number of the side with the door, -1 if no way leads to one."""

    side: Indices

    @property
    def reached(self) -> Flags:
        """Which houses (n,) have a door that a way leads to."""
        return self.side >= 0


class _Sides(NamedTuple):
    """All sides of all houses: the house and number of each, its middle (m, 2), the direction out
    (m, 2), its length (m,), and whether nothing else of the house is as far ahead, so that it is
    the front of the house if the door is in it."""

    house: Indices
    number: Indices
    middle: Floats
    out: Floats
    length: Floats
    ahead: Flags


def assign_doors(
    walkable: shapely.Geometry, streets: Points, rings: Sequence[Points], fronts: Sequence[int]
) -> DoorSides:
    """The sides with doors of houses by their corners in the plan, counter-clockwise; ``fronts``
    (n,) are sides that alone may have it, -1: any."""
    if not rings:
        return DoorSides(np.zeros(0, np.int64))
    shapes = np.empty(len(rings), object)
    shapes[:] = [shapely.Polygon(ring) for ring in rings]
    sides = _sides(rings)
    fixed = np.array(fronts)[sides.house]
    open_ = sides.ahead & (sides.length >= LEAST_SIDE)
    open_ &= (fixed < 0) | (fixed == sides.number)
    open_ &= _has_forecourt(walkable, shapes, sides)
    reached = reach(walkable, streets, shapes)
    spots = sides.middle + sides.out * (WAY + 0.1)
    open_ &= shapely.dwithin(reached, shapely.points(spots), 0.05)
    worth = np.where(open_, _worth(streets, sides), -np.inf)
    found = np.full(len(rings), -1)
    for k in range(len(rings)):
        mine = np.flatnonzero(sides.house == k)
        best = mine[np.argmax(worth[mine])]
        found[k] = sides.number[best] if np.isfinite(worth[best]) else -1
    return DoorSides(found)


def reach(walkable: shapely.Geometry, streets: Points, shapes: Shapes) -> shapely.Geometry:
    """Where the middle of a way may go that starts on a street; prepared."""
    around = shapely.union_all(shapely.buffer(shapes, WAY, quad_segs=4))
    free = shapely.get_parts(shapely.difference(walkable, around))
    start = shapely.union_all(shapely.buffer(shapely.linestrings(streets), START))
    joined = shapely.union_all(free[shapely.intersects(start, free)])
    shapely.prepare(joined)
    return joined


def _sides(rings: Sequence[Points]) -> _Sides:
    counts = [len(ring) for ring in rings]
    starts = np.concatenate(rings)
    ends = np.concatenate([np.roll(ring, -1, axis=0) for ring in rings])
    along = ends - starts
    length = np.hypot(along[:, 0], along[:, 1])
    out = np.stack([along[:, 1], -along[:, 0]], 1) / np.maximum(length, 1e-9)[:, None]
    house = np.repeat(np.arange(len(rings)), counts)
    number = np.concatenate([np.arange(count) for count in counts])
    middle = (starts + ends) / 2
    reach = np.einsum("jk,ik->ij", middle, out)
    own = np.einsum("ik,ik->i", middle, out)
    as_far = (reach > own[:, None] - EVEN) & (house[:, None] == house[None])
    return _Sides(house, number, middle, out, length, as_far.sum(1) == 1)


def _has_forecourt(walkable: shapely.Geometry, shapes: Shapes, sides: _Sides) -> Flags:
    """Whether the ground before the middle of each side is free and may be walked on."""
    half, deep = FORECOURT[0] / 2, FORECOURT[1]
    along = np.stack([-sides.out[:, 1], sides.out[:, 0]], 1)
    corners = [
        sides.middle + s * half * along + d * sides.out
        for s, d in ((-1, 0.02), (-1, deep), (1, deep), (1, 0.02))
    ]
    courts = shapely.polygons(np.stack(corners, 1))
    shapely.prepare(walkable)
    free = shapely.covers(walkable, courts)
    court, other = shapely.STRtree(shapes).query(courts, predicate="intersects")
    free[court[shapely.area(shapely.intersection(courts[court], shapes[other])) > 1e-3]] = False
    return np.asarray(free)


def _worth(streets: Points, sides: _Sides) -> Floats:
    """How good each side is for a door: it looks to the nearest street, is near it, and long."""
    lines = shapely.union_all(shapely.linestrings(streets))
    ways = shapely.get_coordinates(shapely.shortest_line(shapely.points(sides.middle), lines))
    step = ways[1::2] - ways[::2]
    away = np.hypot(step[:, 0], step[:, 1])
    facing = (step * sides.out).sum(1) / np.maximum(away, 1e-9)
    facing = np.where(away < 1e-6, 1.0, facing)
    return facing - away / FAR + 0.3 * np.minimum(sides.length / LONG, 1.0)
