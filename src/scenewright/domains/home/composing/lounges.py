"""Seats and what they look at, placed together: the sofa before the screen, wherever that is, or
before the fireplace that stands in the room.

Along the walls of a room a sofa and a screen are either far apart or in one corner of it. So of the
pairs of places at which they face one another (:mod:`.lounge_places`) those that leave every way
open are taken; what they are not in the way of stays, all other groups follow.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempt import FurnishedGroup, RoomTask, find_blocked
from scenewright.domains.home.composing.anew import follow, judge_in_order
from scenewright.domains.home.composing.judging import RUNS, JudgedRoom, judge_of, sum_faults
from scenewright.domains.home.composing.lounge_places import list_lounges
from scenewright.domains.home.composing.moving import with_margin
from scenewright.domains.home.composing.pairs import do_overlap
from scenewright.domains.home.composing.trials import take_best
from scenewright.domains.home.furnishing.whole import RAISED

LEAST = 9.0  # rooms of so many square metres have seats and screen placed together
WALKED = 60  # pairs of places that are walked past


def gather_seats(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with seats and screen placed together where either has a fault, or the seats
    before a fireplace that they do not look at, or as they were."""
    rule = task.preset.settings.composing
    names = ("seating",) if len(task.ground.hearths) else ("media", "seating")
    pair = tuple(p for name in names for p in best.placed if p.wish.group == name)
    if len(pair) != len(names) or task.ground.area < LEAST or task.cancelled():
        return best
    if not sum_faults(task, pair) or any(p.wish.group in task.library.own for p in pair):
        return best
    rest = [p for p in best.placed if p not in pair]
    most, found = sum_faults(task, best.placed), []
    starts = islice(list_lounges(judge_of(task, pair), pair), WALKED)
    margin = with_margin(task)
    open_ = (s for s in starts if barred.issuperset(find_blocked(margin, s.placed)))
    for start in islice(open_, rule.starts):
        stay = _list_staying(start, rest)
        for there in dict.fromkeys((stay, ())):
            whole = _follow_beside(task, start, there, rest, barred, most)
            if whole is not None:
                found.append(whole)
                break
    return take_best(task, best, found, barred)


def _list_staying(start: JudgedRoom, rest: Sequence[FurnishedGroup]) -> tuple[str, ...]:
    """The names of the others that neither seats nor screen are in the way of."""
    if not rest:
        return ()
    new = np.array([p.dressed.box for p in start.placed])
    return tuple(p.name for p in rest if not do_overlap(new, _floor_of(p)).any())


def _floor_of(group: FurnishedGroup) -> NDArray[np.float64]:
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
    others = [p for p in rest if p.name not in there]
    order = sorted(others, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod())))
    standing = (*start.placed, *stay)
    judges = judge_in_order(task, (*standing, *order))
    begun = judges(len(standing)).cost_of(standing)
    return follow(task, judges, begun, order, barred, most)
