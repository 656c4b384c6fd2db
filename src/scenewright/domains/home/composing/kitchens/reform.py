"""Kitchens that are put together otherwise: made to measure, round corners, in several lines."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator
from functools import partial
from heapq import heappop, heappush
from itertools import islice
from math import inf

import numpy as np

from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, RoomJudge, judge_of
from scenewright.domains.home.composing.kitchens.fitted import (
    LIVED_IN_TOP,
    MORE,
    FreeWalls,
    list_bare_steps,
    list_steps,
)
from scenewright.domains.home.composing.kitchens.foreseen import foresee_cost
from scenewright.domains.home.composing.kitchens.free_walls import list_stretches
from scenewright.domains.home.composing.kitchens.second_runs import price_of_spare, without_spare
from scenewright.domains.home.composing.kitchens.sound import is_sound
from scenewright.domains.home.composing.kitchens.ways import is_walked, trim_to_ways, ways_of
from scenewright.domains.home.composing.places.forms import is_mere_kitchen
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.composing.places.trials import take_best
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.groups.fitted_kitchen import (
    SLIM_FRIDGE,
    Box,
    FittedKitchen,
    assemble,
    box_of,
    overlap,
)
from scenewright.domains.home.groups.kitchen import FRIDGE, UNIT_DEPTH, WORKTOP_HEIGHT

Likeness = Callable[[FittedKitchen], Hashable]
Dressed = FurnishedGroup | None
KitchenStep = Callable[[float], list[JudgedRoom]]
"""Looks for kitchens of one make-up that cost less than a bound, the cheapest first."""

LISTED, TRIED, KEPT = 900, 250, 4
"""Kitchens of one step that are listed, tried, and kept; of those twice as many in a room of
:data:`MORE_FROM` square metres, where what follows tells more than what they cost by themselves."""
MORE_FROM = 14.0
SOUGHT = ((UNIT_DEPTH, WORKTOP_HEIGHT, 0.45), (FRIDGE.depth, FRIDGE.height, SLIM_FRIDGE))
"""Depth, height and least width of what stretches of wall are looked for, metres."""


def reform_kitchen(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with a faulty kitchen put together otherwise, or as they were; beside all others,
    then in the place of a second run as well."""
    run = next((p for p in best.placed if p.wish.group in RUNS), None)
    if run is None or not may_reform(task, best.placed):
        return best
    parts = parts_of(best.placed, run)
    rest = tuple(p for p in best.placed if all(p is not part for part in parts))
    best = _reform_beside(task, best, rest, run, barred)
    fewer = without_spare(rest)
    return _reform_beside(task, best, fewer, run, barred) if len(fewer) < len(rest) else best


def _reform_beside(
    task: RoomTask, best: JudgedRoom, rest: Placed, run: FurnishedGroup, barred: frozenset[str]
) -> JudgedRoom:
    """The groups with a kitchen made to measure beside the ``rest`` in the place of a faulty one,
    or as they were."""
    rule = task.preset.settings.composing
    for step in list_fitted(task, rest, run, barred):
        now = next(p for p in best.placed if p.wish.group in RUNS)
        if is_sound(task, now, best.placed) or task.cancelled():
            break
        price = price_of_spare(best.placed, rest, rule)
        best = take_best(task, best, step(best.cost - price), barred, price)
    return best


def may_reform(task: RoomTask, placed: Placed) -> bool:
    """Whether the kitchen of a room may be put together as is best."""
    parts = [p for p in placed if p.wish.group in (*RUNS, "fridge")]
    given = any(p.wish.most for p in parts if p.wish.group in RUNS)
    return bool(parts) and len(parts) <= 2 and not given and not task.library.own


def parts_of(placed: Placed, run: FurnishedGroup) -> Placed:
    """The groups that a kitchen in the place of a run stands for: its fridge as well, unless
    somebody asked for the run alone."""
    apart = run.wish.required
    return tuple(p for p in placed if p is run or (p.wish.group in (*RUNS, "fridge") and not apart))


def as_whole(run: FurnishedGroup) -> FurnishedGroup:
    """A kitchen with its fridge, in the place of a run with or without one; a run somebody asked
    for as it is."""
    if run.wish.required:
        return run
    return run._replace(wish=run.wish._replace(group="kitchen"), name="kitchen")


def list_fitted(
    task: RoomTask,
    rest: Placed,
    run: FurnishedGroup,
    barred: frozenset[str],
    likeness: Likeness | None = None,
    machine: float = 0.0,
    longest: float = inf,
) -> Iterator[KitchenStep]:
    """The steps of the kitchens made to measure beside the ``rest``, those that bar no more than is
    ``barred``; of those with the same ``likeness`` one; some leave ``machine`` metres of their wall
    to a washing machine that follows; none has more than ``longest`` metres of front."""
    standing = standing_of(
        (*task.fixed, *task.beside, *(q for p in rest for q in p.pieces)), flat_kinds(task.catalog)
    )
    ways = ways_of(task, rest, barred)
    low, tall = (
        trim_to_ways(ways, list_stretches(task.ground, standing, depth, height, least), least)
        for depth, height, least in SOUGHT
    )
    if not low:
        return
    whole = as_whole(run)
    judge = judge_of(task, (*rest, whole))
    steps = list_steps if whole.wish.group == "kitchen" else list_bare_steps
    more = MORE if is_mere_kitchen(task) else LIVED_IN_TOP
    for kitchens in steps(FreeWalls(low, tall, task.ground.area, more, longest, machine)):
        known: dict[FittedKitchen, bool] = {}

        def dress(fitted: FittedKitchen, known: dict[FittedKitchen, bool] = known) -> Dressed:
            if overlap(fitted) or not is_walked(ways, fitted, known):
                return None
            return dress_group(task, whole, *assemble(fitted), standing)

        yield partial(_take_step, judge, rest, kitchens, dress, likeness)


def _take_step(
    judge: RoomJudge,
    rest: Placed,
    kitchens: Callable[[], Iterator[FittedKitchen]],
    dress: Callable[[FittedKitchen], Dressed],
    likeness: Likeness | None,
    most: float,
) -> list[JudgedRoom]:
    """The kitchens of one step that cost less than ``most``, the cheapest first."""
    found: list[JudgedRoom] = []
    seen: set[Hashable] = set()
    kept = KEPT if judge.task.ground.area < MORE_FROM else 2 * KEPT
    for fitted in islice(_pick(judge, rest, islice(kitchens(), LISTED), most), TRIED):
        alike = likeness(fitted) if likeness else fitted
        if len(found) == kept or judge.task.cancelled():
            break
        if alike in seen or (dressed := dress(fitted)) is None:
            continue
        seen.add(alike)
        found.append(judge.cost_of((*rest, dressed)))
    return sorted(found, key=lambda judged: judged.cost)


def _boxes_of(listed: Iterable[FittedKitchen]) -> list[Box]:
    """The floor that the first line of each kitchen takes; most share it with the one before."""
    found, before = list[Box](), None
    for fitted in listed:
        first = fitted.lines[0]
        found.append(found[-1] if first is before else box_of(first))
        before = first
    return found


def _pick(
    judge: RoomJudge, rest: Placed, kitchens: Iterable[FittedKitchen], most: float
) -> Iterator[FittedKitchen]:
    """The kitchens that cost least by their case and place, and less than ``most``, the cheapest
    first; what the case of one costs is asked only once it may be the next by its place."""
    task, listed = judge.task, list(kitchens)
    if not listed:
        return
    rule = task.preset.settings.composing
    layouts = np.empty((len(listed), len(rest) + 1, 5))
    layouts[:, :-1] = np.array([p.dressed.box for p in rest]).reshape(-1, 5)
    layouts[:, -1] = _boxes_of(listed)
    costs = (task.costs.energy * judge.energies_of(layouts)).tolist()
    found: list[tuple[float, int]] = []
    for i in np.argsort(costs, kind="stable").tolist():
        if costs[i] >= most:
            break
        while found and found[0][0] < costs[i]:
            yield listed[heappop(found)[1]]
        foreseen = foresee_cost(listed[i], task.ground.area, rule, most - costs[i])
        if costs[i] + foreseen < most:
            heappush(found, (costs[i] + foreseen, i))
    while found:
        yield listed[heappop(found)[1]]
