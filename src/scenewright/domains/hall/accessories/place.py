"""Small objects placed among the rest: each on the best spot that leaves all routes open."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.kinds import KINDS
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of, polygons_of
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
    lead_before,
    lie_open,
)
from scenewright.domains.hall.accessories.spots import NO_PAIR, Spots, spread_spots
from scenewright.domains.hall.accessories.stools import (
    STOOL,
    list_fronts,
    spread_stools,
    stand_before,
)
from scenewright.domains.hall.build_problem import MARGIN, SIDES, HallContext
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.measures import ARM
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, lacking, measure_among

NARROW_SPOT, SINGLE_LEAF, MATE = 2.0, 1.7, -2.0
"""What a spot costs with too little floor before it, one of a pair whose other is not to be had,
and one whose other is taken."""
HIDDEN, SPOT_BEHIND = 1.5, 3.0
"""What a spot costs behind a desk, where only those who serve there see it, and how many metres."""
SPOT_BEFORE = 0.6
"""Metres before a small object in which others had better not stand."""
BACK_OFF_WALL = 0.045
"""Metres from a wall to the back of what is to stand at one: the referee asks for 5 mm more."""
TRIED, SAME = 12, 0.01
"""How many of the best spots, and of the others, are tried for what bars a way on the first, and
metres between two spots that are one."""


class StandingHall(NamedTuple):
    """A hall as laid out: its problem and layout, and the demands and ``pieces`` that stand."""

    hall: HallContext
    problem: HallProblem
    layout: MeasuredLayout
    wishes: list[HallDemand]
    pieces: tuple[Piece, ...]


Placed = list[list[Floats | None]]
"""The box (5,) of each object of each demand, None without a spot."""


def place_accessories(
    there: StandingHall, small: list[HallDemand], stopped: Callable[[], bool] = lambda: False
) -> Placed:
    """Where the objects of some demands stand, each demand after those before it, those used at
    another once all the rest stands; none where it bars a way, or where no route would lead to it
    or to one set before it. Once ``stopped`` no more are placed."""
    order = sorted(range(len(small)), key=lambda k: ACCESSORIES[small[k].category].used_at)
    boxes = _place_in_order(there, [small[k] for k in order], stopped)
    return [boxes[order.index(k)] for k in range(len(small))]


def _place_in_order(
    there: StandingHall, small: list[HallDemand], stopped: Callable[[], bool]
) -> Placed:
    boxes = _place_all(there, small, lambda _: True, stopped)
    if stopped():
        return [[None] * len(wish.sizes) for wish in small]
    least = _measure_ways(there, small, [])
    if not _as_open(there, small, boxes, least):
        boxes = _place_all(
            there, small, lambda placed: _as_open(there, small, placed, least), stopped
        )
    return _spread_stools(there, small, boxes, least)


def _spread_stools(
    there: StandingHall, small: list[HallDemand], boxes: Placed, least: tuple[float, float]
) -> Placed:
    """The same with the stools before each counter and at each long side of a table evenly along
    it, where they bar nothing so."""
    for k, wish in enumerate(small):
        stools = [n for n, box in enumerate(boxes[k]) if box is not None]
        for front, served in list_fronts(there.pieces) if wish.category == STOOL else ():
            rows = _stack(boxes[k])
            own = stand_before(front, rows)
            if not own.any():
                continue
            rows[own] = spread_stools(front, rows[own], served)
            spread: list[Floats | None] = list(boxes[k])
            for n, row in zip(stools, rows, strict=True):
                spread[n] = row
            tried = [*boxes[:k], spread, *boxes[k + 1 :]]
            if _stand_free(there, wish, rows) and _as_open(there, small, tried, least):
                boxes = tried
    return boxes


def _stand_free(there: StandingHall, wish: HallDemand, boxes: Floats) -> bool:
    """Whether boxes (n, 5) of a demand stand on floor that is free."""
    ground = there.problem.ground
    free = find_floor(there.hall, wish.zones, there.pieces, there.wishes, ground.keep_free)
    return bool(find_free(free, boxes, True).all())


def _as_open(
    there: StandingHall, small: list[HallDemand], boxes: Placed, least: tuple[float, float]
) -> bool:
    """Whether the route misses no more with some boxes and no passage is narrower than asked for,
    if it is not so without."""
    found = _measure_ways(there, small, boxes)
    return found[0] <= least[0] and found[1] <= max(least[1], MARGIN) + 1e-9


def _measure_ways(
    there: StandingHall, small: list[HallDemand], boxes: Placed
) -> tuple[float, float]:
    """What the route misses past all that stands and the boxes of some demands, these among it, and
    metres passages lack."""
    own, ground = {wish.id for wish in there.wishes}, there.problem.ground
    more = [box for p in there.pieces if p.function not in own for box in boxes_of(p)]
    solid = np.concatenate([np.array(more).reshape(-1, 5), _stack(*boxes)])
    standing, access = _find_used(small, boxes)
    standing = np.concatenate([ground.standing.reshape(-1, 5), standing])
    access = np.concatenate([ground.standing_access.reshape(-1, 4), access])
    ground = ground._replace(standing=standing, standing_access=access)
    p, s, missed = measure_among(there.problem._replace(ground=ground), there.layout, solid)
    return missed + len(standing) - len(p.standing), lacking(p, s)


def _find_used(small: list[HallDemand], boxes: Placed) -> tuple[Floats, Floats]:
    """Boxes (n, 5) of the demands, and access flags (n, 4): at least one flagged side of a box must
    be reached. Any side will do if its kind is used from none; a seat at another object has no
    flag, as people reach it sideways past those who sit there."""
    access = [
        np.tile([float(_may_use(wish.category, side)) for side in SIDES], (n, 1))
        for wish, n in zip(small, (len(_stack(mine)) for mine in boxes), strict=False)
    ]
    return np.concatenate([np.zeros((0, 5)), _stack(*boxes)]), np.concatenate(
        [np.zeros((0, 4)), *access]
    )


def _may_use(category: str, side: str) -> bool:
    kind = KINDS[category]
    return not ACCESSORIES[category].used_at and side in (kind.access or SIDES)


def _place_all(
    there: StandingHall,
    small: list[HallDemand],
    accept: Callable[[Placed], bool],
    stopped: Callable[[], bool],
) -> Placed:
    """A box for each object of some demands, one after another; none once ``stopped``."""
    doorways, walls = find_doorways(there.hall.space), find_walls(there.hall)
    space, route = there.hall.space, there.problem.route
    standing = shapely.buffer(shapely.Polygon(space.outline, space.holes), -0.5 * route)
    keep_free, found = there.problem.ground.keep_free, list[list[Floats | None]]()
    for wish in small:
        if stopped():
            found.append([None] * len(wish.sizes))
            continue
        free = find_floor(there.hall, wish.zones, there.pieces, there.wishes, keep_free)
        mine = list[Floats | None]()
        found.append(mine)
        for size in wish.sizes:
            setting = Setting(doorways, walls, there.pieces, _stack(mine))
            choice = _choose_spots(free, setting, wish, size, _stack(*found))
            choice = choice[can_stand_before(choice, wish.category, standing, 0.5 * route + ARM)]
            mine.append(None)
            for row in _take_some(choice):
                mine[-1] = row
                if accept(found):
                    break
                mine[-1] = None
    return found


def can_stand_before(
    boxes: Floats, category: str, standing: shapely.Geometry, reach: float
) -> Bools:
    """Which of boxes (k, 5) of a kind a person can use: a point ``reach`` metres in front of one of
    its sides of use lies on ``standing``, the floor where a person's centre may be.

    >>> bins = np.array([[0.2, 0.2, 0.0, 0.4, 0.4], [1.0, 0.2, 1.5708, 0.4, 0.4]])
    >>> can_stand_before(bins, "litter_bin", shapely.box(0.45, 0.45, 5, 5), 0.6)
    array([False,  True])
    """
    found = np.zeros(len(boxes), bool)
    for k, side in enumerate(SIDES):
        if side in (KINDS[category].access or SIDES):
            turned = boxes.copy()
            turned[:, 2] += 0.5 * np.pi * k
            if k % 2:
                turned[:, 3:] = turned[:, :2:-1]
            before = shapely.polygons(corners(lead_before(turned, reach)))
            found |= np.asarray(shapely.intersects(before, standing), bool)
    return found


def _take_some(choice: Floats) -> Floats:
    """The first of some spots (k, 5), and as many from among the rest: those side by side bar the
    same way."""
    rest = choice[TRIED:]
    return np.concatenate([choice[:TRIED], rest[:: max(len(rest) // TRIED, 1)][:TRIED]])


def _stack(*rows: list[Floats | None]) -> Floats:
    """The boxes (n, 5) among some rows."""
    return np.array([box for row in rows for box in row if box is not None]).reshape(-1, 5)


def _choose_spots(
    free: FreeFloor, setting: Setting, wish: HallDemand, size: Size, taken: Floats
) -> Floats:
    """Boxes (k, 5) for one object of a demand, the best first; anywhere on the floor where there is
    none else and it may stand adrift. ``taken`` (n, 5) are those of small objects set before."""
    row = ACCESSORIES[wish.category]
    pairs = len(wish.sizes) - len(setting.others) > 1
    anywhere = (partial(spread_spots, free.floor.bounds),) if row.adrift else ()
    for make in (row.spots, *anywhere):
        spots = make(setting, size)
        own = row.used_at and make is row.spots
        stand = find_free(free, spots.boxes, own) & ~_overlap(spots.boxes, taken)
        if wish.at_wall:
            stand &= _have_wall(spots.boxes, setting)
        narrow = ~lie_open(free, spots.boxes, row.free, row.around)
        narrow |= _overlap(lead_before(spots.boxes, row.free), taken)
        narrow |= _overlap(spots.boxes, lead_before(taken, SPOT_BEFORE))
        costs = (
            spots.costs + NARROW_SPOT * narrow + _weigh_pairs(spots, setting.others, stand, pairs)
        )
        costs = costs + HIDDEN * _overlap(spots.boxes, _lie_behind(setting.pieces))
        if stand.any():
            order = np.argsort(costs, kind="stable")
            return spots.boxes[order[stand[order]]]
    return np.zeros((0, 5))


def _have_wall(boxes: Floats, setting: Setting) -> Bools:
    """Which of boxes (k, 5) have the middle of their back at a wall or a partition."""
    back = boxes[:, :2] - 0.5 * boxes[:, 4:] * np.column_stack(
        [np.cos(boxes[:, 2]), np.sin(boxes[:, 2])]
    )
    built = polygons_of([p for p in setting.pieces if p.category == "partition"])
    walls = np.append(shapely.linestrings(setting.walls.reshape(-1, 2, 2)), built)
    near = shapely.STRtree(walls).query(shapely.points(back), "dwithin", BACK_OFF_WALL)[0]
    return np.asarray(np.isin(np.arange(len(boxes)), near), bool)


def _lie_behind(pieces: tuple[Piece, ...]) -> Floats:
    """Boxes (k, 5) of the floor behind what one is served at."""
    desks = [piece for piece in pieces if piece.category in SERVING]
    boxes = np.array([box for desk in desks for box in boxes_of(desk)]).reshape(-1, 5)
    boxes[:, 2] += np.pi
    return lead_before(boxes, SPOT_BEHIND)


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
    return MATE * mate + SINGLE_LEAF * alone
