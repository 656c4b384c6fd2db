"""What a household states it needs, once all rooms are furnished: beds and places for its
residents, and what it requires by name.

Rooms are furnished one by one, each with all that becomes it, and a small room may then hold a bed
for one, or a chair too few, beside a bookcase nobody asked for. So where the finished home falls
short of what was stated, the rooms it falls short in are furnished again: single beds give way
to bunks, and what is merely usual or welcome waits until what was stated stands.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask
from scenewright.domains.home.attempts.second_try import lacks_essentials, try_otherwise
from scenewright.domains.home.composing.compose import compose
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.needs.counting import count_sleepers
from scenewright.domains.home.needs.household import LEAST_BUNK, SEATED, Household, count_places
from scenewright.domains.home.programme import FALLBACK, WELCOME, Wish
from scenewright.domains.home.walking.remove_blockers import Opened
from scenewright.domains.home.wheelchair import count_shut, furnish_by_use
from scenewright.engine.solve import Budget

RANKS = ((WELCOME, 0.0), (WELCOME, 0.08), (1, 0.02), (1, 0.08))
"""Further tries of a room: groups ranked before the first number and required ones, with ways wider
by the second on the grid, metres, so that chairs in the way of an exact walk give way."""
FEWER_SEATS = 3
"""Tries of a room in which sofas may seat fewer than there are residents."""
SLEEPING_PLACES = 2
"""The most that sleep in a room while other rooms have fewer."""
SLEEPER = 3.5
"""The least floor for each who sleeps in a room where beds are short, square metres: two bunks with
a way between them."""
REQUIRED, BED = 6, 4
"""What a thing required by name, and a bed, weigh."""
PLACES = ((("dining", "dining_wall"), 2), (("seating", "reading"), 1))
"""What is sat on, and what a place there weighs."""


class AskedRooms(NamedTuple):
    """The rooms of a home as they were to be furnished: tasks, wishes and budgets of equal
    length."""

    tasks: Sequence[RoomTask]
    wishes: Sequence[tuple[Wish, ...]]
    budgets: Sequence[Budget]


def meet_stated_needs(
    household: Household, rooms: AskedRooms, answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers after further tries of the rooms in which stated needs are not met; an answer
    is taken where less is short and no room loses what makes it."""
    found = answers
    changes: tuple[tuple[ListChanges, Callable[..., int]], ...] = (
        (_list_beds, _lack_beds),
        (_list_further_beds, _lack_beds),
        (_list_fewer, measure_shortage),
    )
    for change, short in changes:
        for room, task, wishes in change(household, rooms, found):
            if not short(household, found) or task.cancelled():
                break
            trial = opened(_furnish_again(room, task, wishes, rooms, found))
            if _worth(household, trial, rooms) < _worth(household, found, rooms):
                found = trial
    return found


def _worth(
    household: Household, answers: Sequence[RoomAnswer], rooms: AskedRooms
) -> tuple[int, int, float, float]:
    """What makes rooms what they are and is missing, or out of a wheelchair's reach; what is
    short; other essentials that are missing; the scores of all rooms. The less the better, in this
    order: beds for all come before a wardrobe, a piano somebody requires before a television."""
    lost = sum(
        lacks_essentials(answer, task.costs)
        for answer, task in zip(answers, rooms.tasks, strict=True)
    )
    core = sum(m.wish.core and not m.wish.required for a in answers for m in a.missing)
    core += sum(map(count_shut, rooms.tasks, answers))
    return core, measure_shortage(household, answers), lost, sum(a.score for a in answers)


def measure_shortage(household: Household, answers: Sequence[RoomAnswer]) -> int:
    """What is short in a furnished home: things required, beds, chairs at a table, sofa seats."""
    short = sum(REQUIRED * m.wish.required for answer in answers for m in answer.missing)
    short += sum(REQUIRED * _is_substitute(g.wish) for answer in answers for g in answer.placed)
    if not household.stated:
        return short
    short += BED * _lack_beds(household, answers)
    for groups, weight in PLACES:
        asked = [w for answer in answers for w in _wishes_of(answer) if w.group in groups]
        most = max((SEATED[w.group][1] for w in asked if w.group in SEATED), default=0)
        best = max(_seat(answer, groups) for answer in answers)
        short += weight * max(min(household.residents, most) - best, 0)
    return short


def _is_substitute(wish: Wish) -> bool:
    """Whether only something smaller of its use stands in for what is required."""
    return wish.required and wish.small and wish.group in FALLBACK.values()


def _wishes_of(answer: RoomAnswer) -> list[Wish]:
    return [*(g.wish for g in answer.placed), *(m.wish for m in answer.missing)]


def _seat(answer: RoomAnswer, groups: tuple[str, ...]) -> int:
    """How many sit in a room on what some groups brought."""
    return count_places(
        p for group in answer.placed if group.wish.group in groups for p in group.pieces
    )


def _furnish_again(
    room: int, task: RoomTask, wishes: tuple[Wish, ...], rooms: AskedRooms, found: list[RoomAnswer]
) -> list[RoomAnswer]:
    """The answers with one room furnished anew from some of its wishes; the others come after."""
    answer = furnish_by_use(task, wishes, rooms.budgets[room])
    later = [w for w in rooms.wishes[room] if w.group not in {o.group for o in wishes}]
    gone = tuple(
        Missing(w, "no room is left beside the rest") for w in later if w.group not in BED_GROUPS
    )
    composed = compose(task, answer._replace(missing=(*answer.missing, *gone)))
    stand = {group.wish.group for group in composed.placed}
    still = tuple(m for m in composed.missing if m.wish.required or m.wish.group not in stand)
    answer = composed._replace(missing=still)
    return [answer if k == room else other for k, other in enumerate(found)]


Change = Iterator[tuple[int, RoomTask, tuple[Wish, ...]]]
ListChanges = Callable[[Household, AskedRooms, Sequence[RoomAnswer]], Change]


def _list_beds(household: Household, rooms: AskedRooms, found: Sequence[RoomAnswer]) -> Change:
    """Rooms with fewer beds than they were to have or could, the largest first: with the bed before
    all else, then with bunks."""
    del household
    for room in sorted(range(len(found)), key=lambda k: -rooms.tasks[k].ground.area):
        task, wishes = rooms.tasks[room], rooms.wishes[room]
        bed = next((w for w in wishes if w.group in BED_GROUPS), None)
        held = _count_beds([found[room]])
        if bed is None or held >= SLEEPING_PLACES:
            continue
        if held < (1 if bed.group == "single" else SLEEPING_PLACES):
            yield room, task, tuple(w for w in wishes if w == bed or w.required)
        if task.accessible or bed.required or task.ground.area < LEAST_BUNK:
            continue
        bunks = tuple(w._replace(group="bunk") if w == bed else w for w in wishes)
        yield room, task, bunks
        yield room, task, tuple(w for w in bunks if w.group == "bunk" or w.required)


def _list_further_beds(
    household: Household, rooms: AskedRooms, found: Sequence[RoomAnswer]
) -> Change:
    """Bedrooms with ever more beds beside the first, as many as their floor is for, the largest
    room first; of all else what is essential."""
    del household
    for room in sorted(range(len(found)), key=lambda k: -rooms.tasks[k].ground.area):
        task, held = rooms.tasks[room], _count_beds([found[room]])
        stands = [g.wish for g in found[room].placed if g.wish.group in BED_GROUPS]
        if not stands:
            continue
        needed = (w for w in rooms.wishes[room] if w.rank == 0 or w.required)
        first = (*stands, *(w for w in needed if w.group not in BED_GROUPS))
        for more in _list_bunks(task, int(task.ground.area / SLEEPER) - held):
            yield room, task, (*first, *(Wish(group, 0, small=True) for group in more))


def _list_bunks(task: RoomTask, sleepers: int) -> list[tuple[str, ...]]:
    """Ever more bunks, or single beds where bunks are ruled out, for up to ``sleepers``."""
    if task.accessible or task.ground.area < LEAST_BUNK:
        return [("single",) * k for k in range(1, sleepers + 1)]
    return [("bunk",) * (k // 2) + ("single",) * (k % 2) for k in range(1, sleepers + 1)]


def _lack_beds(household: Household, answers: Sequence[RoomAnswer]) -> int:
    """How many of the stated residents have no bed."""
    return max(household.residents - _count_beds(answers), 0) if household.stated else 0


def _count_beds(answers: Sequence[RoomAnswer]) -> int:
    """How many sleep in the beds of rooms."""
    return int(count_sleepers([p for a in answers for group in a.placed for p in group.pieces]))


def _list_fewer(household: Household, rooms: AskedRooms, found: Sequence[RoomAnswer]) -> Change:
    """Rooms in which something is short, with ever fewer of their wishes and other numbers, at
    last with fewer seats on sofas than residents."""
    for room, answer in enumerate(found):
        if not _falls_short(household, answer):
            continue
        task, wishes = rooms.tasks[room], rooms.wishes[room]
        for number, (rank, wider) in enumerate(RANKS, 1):
            fewer = tuple(w for w in wishes if w.rank < rank or w.required)
            if fewer:
                yield room, try_otherwise(task, number, wider), fewer
        own = {name: known for name, known in task.library.own.items() if name != "seating"}
        if "seating" in task.library.seated and any(w.group == "seating" for w in wishes):
            fewer = tuple(w for w in wishes if w.rank < 1 or w.required)
            alone = task._replace(library=task.library._replace(own=own))
            for number in range(FEWER_SEATS):
                yield room, try_otherwise(alone, number, RANKS[number][1]), fewer


def _falls_short(household: Household, answer: RoomAnswer) -> bool:
    """Whether something required is missing in a room, or it seats too few."""
    if any(m.wish.required for m in answer.missing):
        return True
    if any(_is_substitute(group.wish) for group in answer.placed):
        return True
    wished = {w.group for w in _wishes_of(answer)}
    return household.stated and any(
        min(household.residents, SEATED[name][1]) - _seat(answer, groups) > 0
        for groups, _ in PLACES
        for name in wished.intersection(groups).intersection(SEATED)
    )
