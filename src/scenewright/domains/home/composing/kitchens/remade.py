"""Kitchens of a finished home with their fridge apart or their hob before a window, made anew.

While a room is composed both are weighed against all else and against the ways on a grid, so that a
fridge may end up across the room, or a hob before a window, though there is a place for a kitchen
without either. It is looked for when the ways of the home are open: the fridge at an end of its
run, where need be in place of the pieces there (:mod:`.fridge_places`); a kitchen made to
measure beside the rest; one before all others, which follow it. What is merely welcome may
give way.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import chain, islice
from math import inf

from scenewright.catalog.classes import RUN
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.kitchens.far_fridges import has_far_fridge, has_low_fridge
from scenewright.domains.home.composing.kitchens.fridge_places import list_fridge_moves
from scenewright.domains.home.composing.kitchens.mend import (
    KITCHEN,
    Place,
    follow_kitchen,
    measure_kitchen,
    take_place,
)
from scenewright.domains.home.composing.kitchens.reform import KitchenStep, list_fitted
from scenewright.domains.home.composing.kitchens.trades import list_traded
from scenewright.domains.home.composing.placed_faults import (
    DARK,
    list_standing,
    measure_before_windows,
)
from scenewright.domains.home.composing.places.moving import with_margin

WORTH = 30.0  # what a room may cost more for a kitchen without such a fault
FOLLOWED = 3  # kitchens of one make-up that stand first and are followed by all others
APART, LOW = 1, 3
"""Steps of the kitchens made to measure that have their fridge apart, or under the worktop."""
ACROSS = 1.0
"""A fridge farther than this from its kitchen may go under the worktop, metres."""

Faults = tuple[int, ...]


def list_remade(task: RoomTask, before: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with other kitchens: the fridge at an end of its run, then kitchens made to
    measure; for a window only where the kitchen itself stands before one."""
    _, taken, _ = find_faults(task, before.placed)
    place = take_place(task, before) if taken or row != "window" else None
    if place is not None:
        yield from chain.from_iterable(_list_traded(task, before))
        yield from chain.from_iterable(_list_make_ups(task, place, before))


def find_faults(task: RoomTask, placed: Placed) -> Faults:
    """Whether the fridge of a room stands apart, how many windows its kitchen stands before, and
    whether hob and sink are apart."""
    units = [p for p in placed if p.wish.group in KITCHEN]
    windows = (measure_before_windows(p, task.ground) > DARK for p in units)
    split = any("split" in dict(find_case_faults(list_standing(p))) for p in units)
    taken = sum(any(w) for w in zip(*windows, strict=True))
    return int(has_far_fridge(placed)), taken, int(split)


def _list_traded(task: RoomTask, before: RoomAnswer) -> Iterator[Iterable[RoomAnswer]]:
    """The room with a fridge that stands apart at an end of its run, the cheapest first."""
    if has_far_fridge(before.placed):
        most = judge_of(task, before.placed).cost_of(before.placed).cost + WORTH
        moves = list_fridge_moves(task, before.placed)
        rooms = list_traded(task, before.placed, moves, most)
        missing = before.missing
        yield _sort(task, (before._replace(placed=p, missing=(*missing, *m)) for p, m in rooms))


def _list_make_ups(
    task: RoomTask, place: Place, before: RoomAnswer
) -> Iterator[Iterable[RoomAnswer]]:
    """The room with kitchens of one make-up after the other, beside the rest and before it."""
    barred = frozenset(find_blocked(with_margin(task), before.placed))
    most = judge_of(task, before.placed).cost_of(before.placed).cost + WORTH
    beside = list_fitted(task, place.rest, place.run, barred)
    first = list_fitted(task, (), place.run, frozenset(), likeness=measure_kitchen)
    for number, (step, free) in enumerate(zip(beside, first, strict=False)):
        if _may_be(number, before.placed):
            yield (_with(before, judged.placed, ()) for judged in step(most))
            yield _sort(task, _list_first(task, place, before, free, barred))


def _may_be(number: int, placed: Placed) -> bool:
    """Whether kitchens of one step come in question."""
    if number == LOW:
        return has_low_fridge(placed) or has_far_fridge(placed, ACROSS)
    return number != APART


def _list_first(
    task: RoomTask, place: Place, before: RoomAnswer, step: KitchenStep, barred: frozenset[str]
) -> Iterator[RoomAnswer]:
    """The room with kitchens that have fewer faults and all others after them."""
    faults = sum(find_faults(task, before.placed))
    starts = (start for start in step(inf) if sum(find_faults(task, start.placed)) < faults)
    for start in islice(starts, FOLLOWED):
        followed = follow_kitchen(task, start, place, barred)
        if followed is not None:
            yield _with(before, *followed)


def _sort(task: RoomTask, answers: Iterable[RoomAnswer]) -> list[RoomAnswer]:
    """The answers for a room, the cheapest first."""
    return sorted(answers, key=lambda a: judge_of(task, a.placed).cost_of(a.placed).cost)


def _with(before: RoomAnswer, placed: Placed, gone: tuple[Missing, ...]) -> RoomAnswer:
    missing = tuple(m for m in before.missing if m.wish.group not in KITCHEN)
    stays = tuple(g for g in before.gone if g.category not in RUN)
    return before._replace(placed=placed, missing=(*missing, *gone), gone=stays)
