"""Seats and what they look at, placed together: the sofa before the screen, wherever that is, or
before the fireplace that stands in the room.

Along the walls of a room a sofa and a screen are either far apart or in one corner of it. So of the
pairs of places at which they face one another (:mod:`.lounge_places`) those that leave every way
open are taken; what they are not in the way of stays, all other groups follow. What is merely
welcome and in their way is given up: it is added again where it finds another place.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.composing.anew import follow, judge_in_order
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of, sum_faults
from scenewright.domains.home.composing.places.moving import with_margin
from scenewright.domains.home.composing.places.pairs import do_overlap
from scenewright.domains.home.composing.places.trials import take_best
from scenewright.domains.home.composing.seats.lounge_places import list_lounges
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.programme import WELCOME

Floats = NDArray[np.float64]

LOUNGE_FROM = 9.0  # area from which seats and screen are placed together, m²
WALKED = 60  # pairs of places that are walked past
MOVED, ESSENTIAL, KITCHEN = 6.0, 25.0, 60.0
"""What a pair of places costs for each group it is in the way of, one the room fails without, and a
kitchen."""
ONE_WAY = 2  # pairs followed with the screen at one place
GIVEN_UP = frozenset(("plant", "shelf", "sideboard"))
"""What gives up its place where it is merely welcome: it finds another, or none is missed."""
PLACE = 6.0  # what a place at a table is worth that is given up for the view
PLACES = {"dining_chair": 1.0, "stool": 0.5}
SCREENS_APART = 0.8  # nearer places of a screen are one, metres


def gather_seats(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with seats and screen placed together where either has a fault or something is
    between them, or the seats before a fireplace that they do not look at, or as they were."""
    rule = task.preset.settings.composing
    pair = _find_pair(task, best.placed)
    if not pair or task.ground.area < LOUNGE_FROM or task.cancelled():
        return best
    view = (
        0.0
        if len(task.ground.hearths)
        else cost_of_view(best.placed, rule.costs, task.ground.edges)
    )
    if sum_faults(task, pair) + view < rule.least or any(
        p.wish.group in task.library.own for p in pair
    ):
        return best
    rest = [p for p in best.placed if p not in pair]
    most = sum_faults(task, best.placed)
    found = [
        _charge_given_up(task, best, whole)
        for start in _list_starts(task, pair, rest, barred)
        if (whole := _follow_first(task, start, rest, barred, most)) is not None
    ]
    taken = take_best(task, best, found, barred)
    return taken if taken is best else judge_of(task, taken.placed).cost_of(taken.placed)


def list_given_up(before: Placed, after: Placed) -> tuple[Missing, ...]:
    """What was merely welcome, stood before and is not there now that the seats see the screen."""
    there = {p.name for p in after}
    gone = (p for p in before if _may_give_up(p) and p.name not in there)
    return tuple(Missing(p.wish, "seats and screen take its place") for p in gone)


def _find_pair(task: RoomTask, placed: Placed) -> Placed:
    """The screen and the seats of a room, or the seats alone before a fireplace; none where either
    is lacking."""
    names = ("seating",) if len(task.ground.hearths) else ("media", "seating")
    pair = tuple(p for name in names for p in placed if p.wish.group == name)
    return pair if len(pair) == len(names) else ()


def _may_give_up(group: FurnishedGroup) -> bool:
    wish = group.wish
    return wish.group in GIVEN_UP and wish.rank >= WELCOME and not wish.required


def _charge_given_up(task: RoomTask, before: JudgedRoom, after: JudgedRoom) -> JudgedRoom:
    """The room after, at its cost and that of what it gives up: groups, and places at tables."""
    gone = list_given_up(before.placed, after.placed)
    lost = max(_count_places(before.placed) - _count_places(after.placed), 0.0)
    price = task.costs.missing[WELCOME] * len(gone) + PLACE * lost
    return after._replace(cost=after.cost + price)


def _count_places(placed: Placed) -> float:
    """Places at the tables of a room; one on a stool is half of one."""
    return sum(PLACES.get(p.category, 0.0) for group in placed for p in group.pieces)


def _list_starts(
    task: RoomTask, pair: Placed, rest: Sequence[FurnishedGroup], barred: frozenset[str]
) -> Iterator[JudgedRoom]:
    """Seats and screen at the pairs of places that bar no way, those first that cost least with
    what they are in the way of; of those with one place of the screen not all."""
    listed = list(list_lounges(judge_of(task, pair), pair))
    costs = [start.cost for start in listed] + _price_moved(listed, rest)
    order = np.argsort(costs, kind="stable")[:WALKED].tolist()
    margin, kept = with_margin(task), list[tuple[float, float]]()
    for start in (listed[k] for k in order):
        x, y = start.placed[0].dressed.box[:2].tolist()
        like = sum(hypot(x - a, y - b) < SCREENS_APART for a, b in kept)
        if like < ONE_WAY and bars_no_more(margin, start.placed, barred):
            yield start
            kept.append((x, y))
            if len(kept) == task.preset.settings.composing.starts:
                return


def _price_moved(starts: Sequence[JudgedRoom], rest: Sequence[FurnishedGroup]) -> Floats:
    """What the groups in whose way seats and screen are cost each of the ``starts`` (n,)."""
    total = np.zeros(len(starts))
    if not starts:
        return total
    boxes = np.array([[p.dressed.box for p in start.placed] for start in starts])
    for group in rest:
        meet = do_overlap(boxes.reshape(-1, 5), _floor_of(group)).any(axis=1)
        price = ESSENTIAL if group.wish.rank == 0 else MOVED
        price = KITCHEN if group.wish.group in RUNS else price
        total[meet.reshape(len(starts), -1).any(axis=1)] += price
    return total


def _follow_first(
    task: RoomTask,
    start: JudgedRoom,
    rest: Sequence[FurnishedGroup],
    barred: frozenset[str],
    most: float,
) -> JudgedRoom | None:
    """The room with as many of the rest as can stay where they are, all others that are not merely
    welcome after them, or with the essential ones, or with none; the first in which every way is
    open."""
    stay = _list_staying(start, rest)
    essential = tuple(p.name for p in rest if p.name in stay and p.wish.rank == 0)
    cooked = any(p.wish.group in RUNS for p in rest)
    for there in dict.fromkeys((stay, essential) if cooked else (stay, essential, ())):
        whole = _follow_beside(task, start, there, rest, barred, most)
        if whole is not None and bars_no_more(with_margin(task), whole.placed, barred):
            return whole
    return None


def _list_staying(start: JudgedRoom, rest: Sequence[FurnishedGroup]) -> tuple[str, ...]:
    """The names of the others that neither seats nor screen are in the way of."""
    if not rest:
        return ()
    new = np.array([p.dressed.box for p in start.placed])
    return tuple(p.name for p in rest if not do_overlap(new, _floor_of(p)).any())


def _floor_of(group: FurnishedGroup) -> Floats:
    """The floor a group takes, as boxes (n, 5): its patch, and of a kitchen each unit as well, as
    its further lines reach out of the patch."""
    units = group.pieces if group.wish.group in RUNS else ()
    low = [p for p in units if p.pose.z < RAISED]
    boxes = [(p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth) for p in low]
    return np.array([tuple(group.dressed.box.tolist()), *boxes])


def _follow_beside(
    task: RoomTask,
    start: JudgedRoom,
    there: tuple[str, ...],
    rest: Sequence[FurnishedGroup],
    barred: frozenset[str],
    most: float,
) -> JudgedRoom | None:
    """The room with those of the rest that stay ``there``, by name, and the others after them."""
    stay = tuple(p for p in rest if p.name in there)
    others = [p for p in rest if p.name not in there and not _may_give_up(p)]
    order = sorted(others, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod())))
    standing = (*start.placed, *stay)
    judges = judge_in_order(task, (*standing, *order))
    begun = judges(len(standing)).cost_of(standing)
    return follow(task, judges, begun, order, barred, most, eats=True)
