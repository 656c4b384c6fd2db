"""One group of a room tried in other forms and places, furnished only as far as anybody looks.

What a room costs with a group in one place is known at least before it is furnished: its energy,
the faults of all others and of the form itself. So places are furnished in the order of that, and
the cheapest room is handed out once no other can cost less.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from heapq import heappop, heappush
from itertools import islice
from math import hypot, inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import RoomTask, bars_no_more
from scenewright.domains.home.composing.bed_places import are_adrift
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, RoomJudge
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.composing.places.moving import dress_group, find_places, with_margin
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.measures import ROUNDING

Floats = NDArray[np.float64]


class FormTrial(NamedTuple):
    """A form of a group on a box (5,), the energy of the room with it there, and what that room
    costs at least."""

    case: Group
    box: Floats
    energy: float
    least: float


def take_best(
    task: RoomTask,
    best: JudgedRoom,
    found: Iterable[JudgedRoom],
    barred: frozenset[str],
    price: float = 0.0,
) -> JudgedRoom:
    """The cheapest of those found that bar no way and cost less than the best, by what they give
    up for it (``price``) as well."""
    return take_first(task, best, sorted(found, key=lambda j: j.cost), barred, price)


def take_first(
    task: RoomTask,
    best: JudgedRoom,
    found: Iterable[JudgedRoom],
    barred: frozenset[str],
    price: float = 0.0,
) -> JudgedRoom:
    """:func:`take_best` of what is found with the cheapest first."""
    for judged in found:
        if judged.cost > best.cost - price - task.preset.settings.composing.least:
            break
        if bars_no_more(with_margin(task), judged.placed, barred):
            return judged
    return best


def try_forms(
    judge: RoomJudge, placed: Placed, at: int, cases: Iterable[Group], forms: int, most: float = inf
) -> Iterator[JudgedRoom]:
    """The groups with one of them in the first ``forms`` cases that have a free place, the cheapest
    first; of those that would cost over ``most`` not all."""
    task, group = judge.task, placed[at]
    rest = (p for i, p in enumerate(placed) if i != at)
    others = (*task.fixed, *task.beside, *(q for p in rest for q in p.pieces))
    standing = standing_of(others, flat_kinds(task.catalog))
    places = list(islice(find_places(task, cases, standing, group), forms))

    def furnish(trial: FormTrial) -> JudgedRoom | None:
        dressed = dress_group(task, group, trial.case, trial.box, standing)
        if dressed is None:
            return None
        return judge.cost_of((*placed[:at], dressed, *placed[at + 1 :]), trial.energy)

    rule = task.preset.settings.composing
    faults = sum(cost_of_group(p, task.ground, rule) for i, p in enumerate(placed) if i != at)
    trials = _list_trials(judge, placed, at, places, faults) if places else []
    return furnish_by_cost([t for t in trials if t.least <= most + ROUNDING], furnish)


def furnish_by_cost(
    trials: Iterable[FormTrial], furnish: Callable[[FormTrial], JudgedRoom | None]
) -> Iterator[JudgedRoom]:
    """The rooms of trials, the cheapest first, of two that cost the same the earlier; none is
    furnished before it may be the next."""
    found: list[tuple[float, int, JudgedRoom]] = []
    for number, trial in sorted(enumerate(trials), key=lambda pair: pair[1].least):
        while found and found[0][0] < trial.least - ROUNDING:
            yield heappop(found)[2]
        judged = furnish(trial)
        if judged is not None:
            heappush(found, (judged.cost, number, judged))
    while found:
        yield heappop(found)[2]


def _list_trials(
    judge: RoomJudge, placed: Placed, at: int, places: list[tuple[Group, Floats]], faults: float
) -> Iterator[FormTrial]:
    """Of each form the places at which the room costs least; ``faults`` is what is wrong with the
    others."""
    task, rule = judge.task, judge.task.preset.settings.composing
    free = np.concatenate([boxes for _, boxes in places])
    layouts = np.repeat(np.array([[p.dressed.box for p in placed]]), len(free), axis=0)
    layouts[:, at] = free
    energies = judge.energies_of(layouts)
    start = 0
    for case, boxes in places:
        own, end = cost_of_case(case, task.ground.area, rule), start + len(boxes)
        for box, energy in _least_cost(task, case, boxes, energies[start:end]):
            yield FormTrial(case, box, energy, faults + own + task.costs.energy * energy)
        start = end


def _least_cost(
    task: RoomTask, case: Group, free: Floats, energies: Floats
) -> Iterator[tuple[Floats, float]]:
    """Of the boxes ``(n, 5)`` for one group those at which the whole room costs least, each with
    the room's energy, of ``energies`` (n,); of neighbours only one: where one bars a way, the other
    most often does."""
    rule, costs = task.preset.settings.composing, task.costs.energy * energies
    if case.function == "single":
        costs += rule.costs.adrift * are_adrift(case, free, task.ground.walls)
    order = np.argsort(costs, kind="stable")
    for k in _pick_apart(free[order], rule.places, rule.apart):
        yield free[order[k]], float(energies[order[k]])


def _pick_apart(boxes: Floats, most: int, apart: float) -> list[int]:
    """The first ``most`` of boxes ``(n, 5)`` that are ``apart`` metres from one another, or turned
    otherwise."""
    kept: list[int] = []
    near: list[list[float]] = []
    for i, (x, y, turn) in enumerate(boxes[:, :3].tolist()):
        if all(hypot(x - a, y - b) >= apart or abs(turn - c) > 0.1 for a, b, c in near):
            kept.append(i)
            near.append([x, y, turn])
            if len(kept) == most:
                break
    return kept
