"""Small objects set among what stands: each on the best spot that leaves all ways open."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.accessories import ACCESSORIES
from scenewright.domains.hall.accessories.setting import (
    Bools,
    FreeFloor,
    Setting,
    find_doorways,
    find_floor,
    find_free,
    find_walls,
    lie_open,
)
from scenewright.domains.hall.accessories.spots import NO_PAIR, Spots, spread_spots
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.holdings import HallDemand
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, lacking, measure_layout

NARROW, SINGLE, MATE = 2.0, 1.7, -2.0
"""What a spot costs with too little floor before it, one of a pair whose other is not to be had,
and one whose other is taken."""
TRIED, SAME = 12, 0.01
"""How many spots are tried for what bars a way on the first, and metres between two spots that are
one."""


class StandingHall(NamedTuple):
    """A hall as laid out: its problem and layout, and the demands and ``pieces`` that stand."""

    hall: HallContext
    problem: HallProblem
    layout: MeasuredLayout
    wishes: list[HallDemand]
    pieces: tuple[Piece, ...]


Placed = list[list[Floats | None]]
"""The box (5,) of each object of each demand, None without a spot."""


def place_accessories(there: StandingHall, small: list[HallDemand]) -> Placed:
    """Where the objects of some demands stand, each demand after those before it; those used at
    another once all the rest stands."""
    found: Placed = []
    for used in (False, True):
        mine = [wish for wish in small if ACCESSORIES[wish.category].used_at == used]
        found = [*found, *_place_some(there, mine, found)] if mine else found
    return found


def _place_some(there: StandingHall, small: list[HallDemand], before: Placed) -> Placed:
    """Where the objects of some demands stand beside those set ``before``."""
    boxes = _place_all(there, small, before, lambda _: True)
    least = _measure_ways(there, _stack(*before))
    if _as_open(there, [*before, *boxes], least):
        return boxes
    return _place_all(there, small, before, lambda placed: _as_open(there, placed, least))


def _as_open(there: StandingHall, boxes: Placed, least: tuple[float, float]) -> bool:
    """Whether the route misses no more with some boxes and no passage is narrower."""
    found = _measure_ways(there, _stack(*boxes))
    return found[0] <= least[0] and found[1] <= least[1] + 1e-9


def _measure_ways(there: StandingHall, boxes: Floats) -> tuple[float, float]:
    """What the route misses past all that stands and boxes (n, 5), and metres passages lack."""
    own = {wish.id for wish in there.wishes}
    more = [box for p in there.pieces if p.function not in own for box in boxes_of(p)]
    ground = there.problem.ground
    solid = np.concatenate([ground.obstacles, np.array(more).reshape(-1, 5), boxes])
    problem = there.problem._replace(ground=ground._replace(obstacles=solid))
    p, s, missed = measure_layout(problem, there.layout)
    return missed, lacking(p, s)


def _place_all(
    there: StandingHall, small: list[HallDemand], before: Placed, accept: Callable[[Placed], bool]
) -> Placed:
    """A box for each object of some demands, one after another, beside those set ``before``."""
    doorways, walls = find_doorways(there.hall.space), find_walls(there.hall)
    keep_free, found = there.problem.ground.keep_free, list[list[Floats | None]]()
    for wish in small:
        free = find_floor(there.hall, wish.zones, there.pieces, there.wishes, keep_free)
        mine = list[Floats | None]()
        found.append(mine)
        for size in wish.sizes:
            setting = Setting(doorways, walls, there.pieces, _stack(mine))
            choice = _choose_spots(free, setting, wish, size, _stack(*before, *found))
            mine.append(None)
            for row in choice[:TRIED]:
                mine[-1] = row
                if accept([*before, *found]):
                    break
                mine[-1] = None
    return found


def _stack(*rows: list[Floats | None]) -> Floats:
    """The boxes (n, 5) among some rows."""
    return np.array([box for row in rows for box in row if box is not None]).reshape(-1, 5)


def _choose_spots(
    free: FreeFloor, setting: Setting, wish: HallDemand, size: Size, taken: Floats
) -> Floats:
    """Boxes (k, 5) for one object of a demand, the best first; anywhere on the floor where there is
    none else. ``taken`` (n, 5) are those of small objects set before."""
    row = ACCESSORIES[wish.category]
    pairs = len(wish.sizes) - len(setting.others) > 1
    for make in (row.spots, partial(spread_spots, free.floor.bounds)):
        spots = make(setting, size)
        own = row.used_at and make is row.spots
        stand = find_free(free, spots.boxes, own) & ~_overlap(spots.boxes, taken)
        narrow = ~lie_open(free, spots.boxes, row.free, row.around)
        costs = spots.costs + NARROW * narrow + _weigh_pairs(spots, setting.others, stand, pairs)
        if stand.any():
            order = np.argsort(costs, kind="stable")
            return spots.boxes[order[stand[order]]]
    return np.zeros((0, 5))


def _overlap(boxes: Floats, taken: Floats) -> Bools:
    """Which of boxes (k, 5) overlap one of those taken (n, 5)."""
    shapes, others = shapely.polygons(corners(boxes)), shapely.polygons(corners(taken))
    return np.asarray(shapely.intersects(shapes[:, None], others[None, :]).any(1), bool)


def _weigh_pairs(spots: Spots, others: Floats, stand: Bools, more: bool) -> Floats:
    """What each of some spots (k,) costs as one of a pair: little where one of ``others`` (n, 5)
    stands on the other, much where nothing does or will; ``more`` are left to be set."""
    paired = spots.pairs != NO_PAIR
    off = spots.boxes[:, None, :2] - others[None, :, :2]
    taken = (np.hypot(off[..., 0], off[..., 1]) < SAME).any(1) & paired
    mate = np.isin(spots.pairs, spots.pairs[taken]) & paired
    pairs, count = np.unique(spots.pairs[stand], return_counts=True)
    both = np.isin(spots.pairs, pairs[count > 1])
    alone = paired & ~mate & ~(both & more)
    return MATE * mate + SINGLE * alone
