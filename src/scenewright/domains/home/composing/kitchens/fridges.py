"""Kitchens of a finished home whose fridge stands apart from them, made to measure once more.

While a room is composed a fridge by itself is weighed against all else and against the ways on a
grid, so that one may end up across the room though a kitchen in one piece has a place. Such a
kitchen is looked for when the ways of the home are open: beside the rest, else before all others,
which follow it; what is merely welcome may give way. It stays if nothing that is counted gets worse
(:mod:`..no_worse`) and no way of the home is barred.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice
from math import inf

from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import Missing, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.case_faults import RAISED, RUN
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.kitchens.fridge_places import list_traded
from scenewright.domains.home.composing.kitchens.mend import (
    KITCHEN,
    Place,
    follow_kitchen,
    measure_kitchen,
    take_place,
)
from scenewright.domains.home.composing.kitchens.reform import KitchenStep, list_fitted
from scenewright.domains.home.composing.moving import with_margin
from scenewright.domains.home.composing.no_worse import is_no_worse
from scenewright.domains.home.composing.settling import try_in_home
from scenewright.domains.home.second_try import Opened
from scenewright.geometry.boxes import common_area, make_frame

FAR = 0.7  # a fridge farther than this from all other units is apart from its kitchen, metres
WORTH = 30.0  # what a room may cost more for a kitchen in one piece
WALKED = 2  # kitchens of one make-up that are walked to through the whole home
MAKE_UPS = {0: FAR, 2: FAR, 3: 1.0}
"""Steps of the kitchens made to measure that have their fridge in a line with other units, each for
fridges farther than so much: the last has them under the worktop."""
HAIR = 1e-6


def join_fridges(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with each kitchen whose fridge stands apart in one piece, where
    that bars no way of the home, its ways ``opened``."""
    found = answers
    for room, task in enumerate(tasks):
        may = task.preset.settings.exact and not task.accessible and not task.cancelled()
        if may and has_far_fridge(found[room].placed):
            place = take_place(task, found[room])
            found = found if place is None else _join(room, task, place, found, opened)
    return found


def has_far_fridge(placed: Placed, far: float = FAR) -> bool:
    """Whether a fridge is so ``far`` and more from all other units of its kitchen, metres.

    >>> has_far_fridge(())
    False
    """
    units = [p for g in placed for p in g.pieces if p.category in RUN and p.pose.z < RAISED]
    others = [p for p in units if p.category != "fridge"]
    cold = (p for p in units if p.category == "fridge")
    return bool(others) and any(not any(_are_near(f, p, far) for p in others) for f in cold)


def _are_near(fridge: Piece, unit: Piece, far: float) -> bool:
    """Whether a unit reaches into the floor so ``far`` round a fridge."""
    (x, y, _, turn), size = fridge.pose, fridge.size
    (a, b, _, heading), other = unit.pose, unit.size
    round_it = make_frame(x, y, turn, size.width + 2 * far, size.depth + 2 * far)
    return bool(common_area(round_it, make_frame(a, b, heading, other.width, other.depth)) > HAIR)


def _join(
    room: int, task: RoomTask, place: Place, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with one kitchen in one piece, or as they were."""
    before = found[room]
    for answers in chain((_list_traded(task, before),), _list_make_ups(task, place, before)):
        sound = (a for a in answers if _is_sound(task, before.placed, a.placed))
        for answer in islice(sound, WALKED):
            trial = try_in_home(room, answer, found, opened)
            if trial is not None:
                return trial
    return found


def _list_traded(task: RoomTask, before: RoomAnswer) -> Iterator[RoomAnswer]:
    """The room with the fridge at an end of its run, the cheapest first."""
    most = judge_of(task, before.placed).cost_of(before.placed).cost + WORTH
    found = list[tuple[float, RoomAnswer]]()
    for placed, gone in list_traded(task, before.placed, most):
        cost = judge_of(task, placed).cost_of(placed).cost
        missing = (*before.missing, *gone)
        found.append((cost, before._replace(placed=placed, missing=missing)))
    yield from (answer for _, answer in sorted(found, key=lambda row: row[0]))


def _list_make_ups(
    task: RoomTask, place: Place, before: RoomAnswer
) -> Iterator[Iterator[RoomAnswer]]:
    """The room with kitchens of one make-up after the other, beside the rest and before it."""
    barred = frozenset(find_blocked(with_margin(task), before.placed))
    beside = list_fitted(task, place.rest, place.run, barred)
    first = list_fitted(task, (), place.run, frozenset(), likeness=measure_kitchen)
    for number, steps in enumerate(zip(beside, first, strict=False)):
        if number in MAKE_UPS and has_far_fridge(before.placed, MAKE_UPS[number]):
            yield _list_beside(before, steps[0])
            yield _list_first(task, place, before, steps[1], barred)


def _list_beside(before: RoomAnswer, step: KitchenStep) -> Iterator[RoomAnswer]:
    """The room with kitchens beside the rest."""
    for judged in step(inf):
        yield _with(before, judged.placed, ())


def _list_first(
    task: RoomTask, place: Place, before: RoomAnswer, step: KitchenStep, barred: frozenset[str]
) -> Iterator[RoomAnswer]:
    """The room with kitchens and all others after them, the cheapest first."""
    found = list[tuple[float, RoomAnswer]]()
    for start in step(inf):
        if has_far_fridge(start.placed):
            continue
        followed = follow_kitchen(task, start, place, barred)
        if followed is not None:
            cost = judge_of(task, followed[0]).cost_of(followed[0]).cost
            found.append((cost, _with(before, *followed)))
    yield from (answer for _, answer in sorted(found, key=lambda row: row[0]))


def _with(before: RoomAnswer, placed: Placed, gone: tuple[Missing, ...]) -> RoomAnswer:
    missing = tuple(m for m in before.missing if m.wish.group not in KITCHEN)
    stays = tuple(g for g in before.gone if g.category not in RUN)
    return before._replace(placed=placed, missing=(*missing, *gone), gone=stays)


def _is_sound(task: RoomTask, before: Placed, after: Placed) -> bool:
    """Whether no fridge stands apart ``after`` and nothing else is worse."""
    return not has_far_fridge(after) and is_no_worse(task, before, after, WORTH)
