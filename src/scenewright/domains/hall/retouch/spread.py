"""Spread: groups packed in a part of their zone take all of it, their rows as far apart as is of
use."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.columns import Columns
from scenewright.domains.hall.retouch.places import fill_floor, shift
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, GUIDE, MAIN, SPEAKER, TILL

SQUARE, STRAIGHT = 0.9, 0.02
"""The share of its bounds a zone has to fill, and by how much a group may be turned (radians), for
strips beside it to be looked at."""
SMALL_GROUP, STRIP, MORE = 1.0, 2.0, 0.6
"""Square metres the objects of a group stand on that fills floor, how wide a strip beside all of
them may be where they have no gaps, and by how much it may be wider than these; metres."""
WIDEST, MOST_OF_STRIP = 2.6, 5.0
"""How wide gaps are made, and metres beyond what a strip may have that count at most."""
BARE_STRIP = 2.0
"""Metres beyond what a strip may have from which on each counts twice: it is seen at once."""
NEAR_BORDER, LEAST_GAP = 0.6, 0.1
"""How near the border of their zone things at walls stand, and the least that is a gap; metres."""
ASIDE = (0.0, 0.5, -0.5)
"""Metres beside the middle of the strips that are tried."""


class Side(NamedTuple):
    """A zone seen along one axis: metres free ``before`` and ``behind`` all that stands free in it,
    and the widest ``gap`` among that."""

    before: float
    behind: float
    gap: float

    @property
    def fault(self) -> float:
        """Metres by which the strips are too wide."""
        most = max(self.gap, STRIP) + MORE
        wide = [min(max(strip - most, 0.0), MOST_OF_STRIP) for strip in (self.before, self.behind)]
        return sum(far + max(far - BARE_STRIP, 0.0) for far in wide)


def measure_spread(columns: Columns, kept: Kept, boxes: Floats) -> float:
    """Metres by which strips beside free-standing objects are too wide, in zones with groups
    that may move."""
    problem = columns.problem
    zones = {int(problem.units.zones[unit]) for unit in _find_movable(columns, kept)}
    sides = (side for zone in sorted(zones) for side in _look_at(problem, kept, boxes, zone))
    return float(sum(side.fault for side in sides))


def _find_movable(columns: Columns, kept: Kept) -> list[int]:
    """The units that stand free and square in zones without columns, large enough to fill floor,
    and neither serve, guide nor look at something, nor are looked at or the main exhibit."""
    problem = columns.problem
    units, roles = problem.units, problem.visitors.roles.astype(int)
    floor = np.add.reduceat(units.sizes.prod(1), units.spans[:, 0])
    square = np.abs(np.sin(2.0 * kept.pose[:, 2])) < STRAIGHT
    free = ~(roles & (FIRST | TILL | GUIDE | SPEAKER | MAIN)).astype(bool)
    good = free & square & (floor >= SMALL_GROUP) & (kept.rows[:, 0] != WALL) & (units.targets < 0)
    good[units.targets[units.targets >= 0]] = False
    return [int(unit) for unit in np.flatnonzero(good) if _is_open(columns, int(unit))]


def _is_open(columns: Columns, unit: int) -> bool:
    """Whether the zone of a unit is square and no column stands in it."""
    ground, zone = columns.problem.ground, int(columns.problem.units.zones[unit])
    low, high = ground.zone_bounds[zone].reshape(2, 2)
    inside = (columns.middles > low) & (columns.middles < high)
    square = ground.zone_areas[zone] >= SQUARE * float(np.prod(high - low))
    return bool(square) and not inside.all(1).any()


def _look_at(problem: HallProblem, kept: Kept, boxes: Floats, zone: int) -> list[Side]:
    """A zone along x and along y."""
    units = problem.units
    owner = np.repeat(np.arange(len(units.spans)), np.diff(units.spans, axis=1)[:, 0])
    mine = units.zones[owner] == zone
    free = mine & (kept.rows[owner, 0] != WALL)
    half = 0.5 * np.abs(_extend(boxes))
    low, high = boxes[:, :2] - half, boxes[:, :2] + half
    bounds = problem.ground.zone_bounds[zone].reshape(2, 2)
    return [
        _measure_side(low[:, k], high[:, k], free, mine & ~free, bounds[:, k]) for k in range(2)
    ]


def _extend(boxes: Floats) -> Floats:
    """How far boxes (n, 5) reach along x and y (n, 2)."""
    cos, sin = np.abs(np.cos(boxes[:, 2])), np.abs(np.sin(boxes[:, 2]))
    wide, deep = boxes[:, 3], boxes[:, 4]
    return np.column_stack([sin * wide + cos * deep, cos * wide + sin * deep])


def _measure_side(low: Floats, high: Floats, free: Ints, walls: Ints, bounds: Floats) -> Side:
    """The strips and the gap of what is ``free`` (n,) between ``bounds`` (2,) and the objects at
    ``walls`` (n,)."""
    first, last = float(low[free].min()), float(high[free].max())
    begin = high[walls & (low < bounds[0] + NEAR_BORDER) & (high <= first)].max(initial=bounds[0])
    end = low[walls & (high > bounds[1] - NEAR_BORDER) & (low >= last)].min(initial=bounds[1])
    order = np.argsort(low[free], kind="stable")
    reach = np.maximum.accumulate(high[free][order])
    gap = (low[free][order][1:] - reach[:-1]).max(initial=0.0)
    return Side(first - float(begin), float(end) - last, float(gap))


def propose_spread(columns: Columns, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one group, or all that may move, in the middle of the bare strips of their
    zone, and with gaps as wide as these let them be."""
    problem, movable = columns.problem, _find_movable(columns, kept)
    for zone in sorted({int(problem.units.zones[unit]) for unit in movable}):
        sides = _look_at(problem, kept, boxes, zone)
        if sum(side.fault for side in sides) <= 0.0:
            continue
        mine = [unit for unit in movable if int(problem.units.zones[unit]) == zone]
        off = np.array([0.5 * (side.behind - side.before) for side in sides])
        for part in (off, off * (1.0, 0.0), off * (0.0, 1.0)):
            yield shift(kept, mine, part)
        for unit in mine:
            yield from fill_floor(problem, kept, boxes, unit, ASIDE)
