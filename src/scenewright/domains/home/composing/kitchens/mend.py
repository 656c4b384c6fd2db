"""Kitchens of a finished home that lack worktop, or are missing, tried again beside its ways.

Rooms are furnished one by one on a grid; the walk through the whole home is exact, and what it
takes away comes back in the least forms. So once all rooms stand, a kitchen with a fault is made to
measure again: beside the rest, else before all others, which follow it; something merely welcome
may give way. A change stays if the whole home, its ways opened, costs less.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from itertools import chain, islice
from math import inf
from typing import NamedTuple

from scenewright.catalog.classes import RUN
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
    penalty,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of, sum_faults
from scenewright.domains.home.composing.kitchens.reform import list_fitted, may_reform, parts_of
from scenewright.domains.home.composing.kitchens.second_runs import is_spare
from scenewright.domains.home.composing.placed_faults import list_standing, measure_before_doors
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import make_unplaced, with_margin
from scenewright.domains.home.composing.places.trials import try_forms
from scenewright.domains.home.furnishing.furnish import pieces_of
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.groups.fitted_kitchen import FittedKitchen, width_of
from scenewright.domains.home.programme import WELCOME, is_essential
from scenewright.domains.home.walking.remove_blockers import Opened

BESIDE = 8
"""Kitchens beside the rest that are walked to through the whole home."""
FORMS, PLACES = 8, 16
"""Forms and places in which each of the rest is tried beside a kitchen that stands first."""
FAULTS = frozenset(("worktop", "hob_at_sink", "hob_at_end"))
"""What makes a kitchen one to be tried again."""
BEFORE = 0.05
"""Metres of a wide door before which a kitchen may stand."""
KITCHEN = (*RUNS, "fridge")


class Place(NamedTuple):
    """A kitchen to be made to measure, the groups it takes the place of, and all others."""

    run: FurnishedGroup
    parts: Placed
    rest: Placed


def mend_kitchens(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with kitchens at fault made to measure, their ways ``opened``."""
    found = answers
    for room, task in enumerate(tasks):
        place = find_place(task, _see_gone(task, found[room]))
        if place is not None and not task.cancelled():
            found = _mend(room, task, place, found, opened)
    return found


def find_place(task: RoomTask, answer: RoomAnswer) -> Place | None:
    """What a kitchen of a room that has a fault, or is missing, is to take the place of; None where
    there is none or it may not be changed, as where an island stands before it."""
    lost = [m.wish for m in answer.missing if m.wish.group in KITCHEN]
    run = next((p for p in answer.placed if p.wish.group in RUNS), None)
    islands = any(p.wish.group == "island" for p in answer.placed)
    if task.accessible or not task.preset.settings.exact or task.library.own or islands:
        return None
    if run is not None and not lost:
        return take_place(task, answer) if _is_at_fault(task, answer) else None
    if not lost or lost[0].most or lost[0].required:
        return None
    parts = tuple(p for p in answer.placed if p.wish.group in KITCHEN)
    rest = tuple(p for p in answer.placed if p.wish.group not in KITCHEN)
    core = lost[0].core or any(p.wish.core for p in parts)
    wish = lost[0]._replace(group="kitchen", rank=0, core=core)
    return Place(make_unplaced(task, rest, wish, cases("kitchen").groups[0]), parts, rest)


def take_place(task: RoomTask, answer: RoomAnswer) -> Place | None:
    """What another kitchen takes the place of in a room that has one; None where that may not be
    changed."""
    run = next((p for p in answer.placed if p.wish.group in RUNS), None)
    islands = any(p.wish.group == "island" for p in answer.placed)
    if run is None or islands or not may_reform(task, answer.placed):
        return None
    parts = tuple(p for p in parts_of(answer.placed, run) if p.wish.group in KITCHEN)
    rest = tuple(p for p in answer.placed if all(p is not part for part in parts))
    return Place(run, parts, rest)


def _see_gone(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer with its kitchen run without the members whose pieces gave way to a route."""
    placed = tuple(_as_it_stands(task, p) if p.wish.group in RUNS else p for p in answer.placed)
    return answer._replace(placed=placed)


def _as_it_stands(task: RoomTask, group: FurnishedGroup) -> FurnishedGroup:
    dressed, kept = group.dressed, {piece.id for piece in group.pieces}
    name = f"{task.space.id}/{group.name}"
    full = iter(pieces_of(dressed, task.space.id, name, group.wish.group, task.catalog))
    stands = tuple(there and next(full).id in kept for there in dressed.stands)
    return group._replace(dressed=dressed._replace(stands=stands))


def _is_at_fault(task: RoomTask, answer: RoomAnswer) -> bool:
    """Whether a kitchen has too little worktop, none beside its hob, or stands before a wide
    door."""
    parts = [p for p in answer.placed if p.wish.group in KITCHEN]
    before = any(measure_before_doors(p, task.ground) > BEFORE for p in parts)
    return before or _lacks_worktop(answer.placed)


def _lacks_worktop(placed: Placed) -> bool:
    """Whether a kitchen has too little worktop, or none beside its hob."""
    runs = (p for p in placed if p.wish.group in RUNS)
    return any(FAULTS & {name for name, _ in find_case_faults(list_standing(r))} for r in runs)


def _mend(
    room: int, task: RoomTask, place: Place, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    best, worth = found, cost_of_home(room, task, found) - task.preset.settings.composing.least
    for answer in _list_answers(task, place, found[room]):
        sound = best is not found and not _is_at_fault(task, _see_gone(task, best[room]))
        if sound or task.cancelled():
            break
        trial = [answer if k == room else other for k, other in enumerate(found)]
        if cost_of_home(room, task, trial) >= worth:
            continue
        trial = opened(trial)
        if (cost := cost_of_home(room, task, trial)) < worth:
            best, worth = trial, cost
    return best


def cost_of_home(room: int, task: RoomTask, answers: Sequence[RoomAnswer]) -> float:
    """What is missing from a home, what gave way, and what one room costs as it stands."""
    lost = sum(penalty(m.wish, task.costs) for answer in answers for m in answer.missing)
    gone = task.costs.piece * sum(len(answer.gone) for answer in answers)
    placed = _see_gone(task, answers[room]).placed
    return lost + gone + (judge_of(task, placed).cost_of(placed).cost if placed else 0.0)


def _list_answers(task: RoomTask, place: Place, before: RoomAnswer) -> Iterator[RoomAnswer]:
    """The room with other kitchens: beside the rest, then before it, unless there is nothing wrong
    with the one it has but that it stands before a door."""
    missing = tuple(m for m in before.missing if m.wish.group not in KITCHEN)
    before = before._replace(gone=tuple(g for g in before.gone if g.category not in RUN))
    barred = frozenset(find_blocked(with_margin(task), (*place.rest, *place.parts)))
    steps = list_fitted(task, place.rest, place.run, barred)
    beside = chain.from_iterable(step(inf) for step in steps)
    for judged in islice(beside, BESIDE):
        yield before._replace(placed=judged.placed, missing=missing)
    if place.parts and not _lacks_worktop(place.parts):
        return
    most = sum_faults(task, place.parts) if place.parts else inf
    for step in list_fitted(task, (), place.run, frozenset(), likeness=measure_kitchen):
        for start in step(inf):
            if sum_faults(task, start.placed) >= most:
                continue
            followed = follow_kitchen(task, start, place, barred)
            if followed is not None:
                placed, gone = followed
                yield before._replace(placed=placed, missing=(*missing, *gone))


def measure_kitchen(kitchen: FittedKitchen) -> Hashable:
    """The walls along which a kitchen stands, and for how many metres of each."""
    return tuple((line.wall, round(width_of(line.units), 1)) for line in kitchen.lines)


def follow_kitchen(
    task: RoomTask, start: JudgedRoom, place: Place, barred: frozenset[str]
) -> tuple[Placed, tuple[Missing, ...]] | None:
    """The rest beside a kitchen, the essential and the largest first, and what of it had to give
    way; None where that is more than the kitchen is worth."""
    best, gone = start, list[Missing]()
    for other in sorted(place.rest, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod()))):
        following = _set_beside(task, best.placed, other, barred)
        if following is not None:
            best = following
        elif place.parts and not may_go(other):
            return None
        else:
            gone.append(Missing(other.wish, "it makes room for the kitchen"))
    return best.placed, tuple(gone)


def _set_beside(
    task: RoomTask, placed: Placed, other: FurnishedGroup, barred: frozenset[str]
) -> JudgedRoom | None:
    """One more group beside those placed; None where it would bar a way."""
    whole, forms = (*placed, other), list_forms(task, other)
    tried = islice(try_forms(judge_of(task, whole), whole, len(placed), forms, FORMS), PLACES)
    open_ = (j for j in tried if bars_no_more(task, j.placed, barred))
    return next(open_, None)


def may_go(group: FurnishedGroup) -> bool:
    """Whether a group is merely welcome, or a second run."""
    wish = group.wish
    welcome = wish.rank == WELCOME and not wish.required and not is_essential(wish)
    return welcome or is_spare(group)
