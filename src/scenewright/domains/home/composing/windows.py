"""What stands before a window when a home is done, or a bed adrift, moved once more.

While a room is composed a window costs what half a wardrobe does, and of each form a few places are
tried. What still stands before one is therefore tried at all places along the walls that leave it
free (:mod:`.bright_places`), by itself or together with what is in its way; a bed for two also
first, all others after it (:mod:`.bright_beds`); a hob changes places in its line
(:mod:`.kitchens.hob_places`). A change stays if nothing that is counted gets worse: no other window
or wide door, no bed adrift or with a closed side, no nightstand, no half wardrobe, no seat, nothing
lost. Where there is none, a bed's window is worth a nightstand or a hand's breadth of a wide door.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice

from scenewright.domains.home.attempt import RoomAnswer, RoomTask, bars_no_more, find_blocked
from scenewright.domains.home.bed_first import with_narrow_ways
from scenewright.domains.home.composing.bed_sides import count_closed_beds
from scenewright.domains.home.composing.bright_beds import list_around_bed
from scenewright.domains.home.composing.bright_places import list_brighter
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import Placed, count_unmet
from scenewright.domains.home.composing.kitchens.hob_places import move_hob
from scenewright.domains.home.composing.placed_faults import (
    DARK,
    list_adrift,
    list_standing,
    measure_before_doors,
    measure_before_windows,
)
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.groups.classes import BED_GROUPS, COOKING, RUNS
from scenewright.domains.home.second_try import Opened

WORTH = 30.0
"""What a room may cost more for a window that is free, or a bed along a wall."""
SIGHT_GIVEN = 4.0  # by how much the screen of a studio may be seen less well for it
TRIED = 2  # rooms that are walked through with their home
COUNTED = ("nightstand", "wardrobe", "seats", "worktop", "hob_at_sink", "hob_at_end")
"""Faults of cases that no window is worth, but the first: a bed for two with one nightstand is, if
one gets in from both of its sides."""

GIVEN = (2, 4)
"""The numbers of wide doors and nightstands among what :func:`count_faults` counts."""
SLIVER, BED_WINDOW_FROM = 0.1, 8.0
"""A bed's window is worth so much of a wide door, metres, in rooms of so many square metres."""
DOUBLE = "sleeping"

Counted = tuple[int, ...]


def clear_windows(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with what stands before a window, or a bed that is adrift,
    elsewhere, where that bars no way of the home, its ways ``opened``."""
    found = answers
    for room, task in enumerate(tasks):
        may = task.preset.settings.exact and not task.accessible
        for name in _list_faulty(task, found[room].placed) if may else ():
            if not task.cancelled():
                found = _clear(room, task, name, found, opened)
    return found


def _list_faulty(task: RoomTask, placed: Placed) -> list[str]:
    """The names of groups that may move and stand before a window or adrift, the worst first."""
    dark = {p.name: measure_before_windows(p, task.ground).max(initial=0.0) for p in placed}
    adrift = {p.name for p in placed if list_adrift((p,), task.ground)}
    own = task.library.own.keys()
    may = (p.name for p in placed if p.wish.group not in own)
    faulty = [name for name in may if dark[name] > DARK or name in adrift]
    return sorted(faulty, key=lambda name: -dark[name])


def count_faults(task: RoomTask, placed: Placed) -> Counted:
    """Of a room the windows with something before them, beds adrift, and what must not get worse
    for either: what stands before wide doors, :data:`COUNTED`, wishes that are not met."""
    cases = [find_case_faults(list_standing(p)) for p in placed]
    dark = [measure_before_windows(p, task.ground) > DARK for p in placed]
    return (
        sum(any(window) for window in zip(*dark, strict=True)),
        len(list_adrift(placed, task.ground)),
        sum(measure_before_doors(p, task.ground) > 0.0 for p in placed),
        count_closed_beds(placed, task.ground),
        *(sum(name in dict(faults) for faults in cases) for name in COUNTED),
        count_unmet(task, placed),
    )


def is_better(new: Counted, old: Counted) -> bool:
    """Whether nothing is worse, and fewer windows are taken or beds adrift."""
    return all(a <= b for a, b in zip(new, old, strict=True)) and new[:2] != old[:2]


def is_brighter(new: Counted, old: Counted) -> bool:
    """Whether fewer windows are taken and nothing is worse but that one wide door more has
    something before it, or one bed more has one nightstand."""
    least = (max(a - (k in GIVEN), 0) for k, a in enumerate(new))
    return new[0] < old[0] and is_better((*least,), old)


def _is_worth_it(task: RoomTask, new: Placed, old: Placed, counted: Counted) -> bool:
    """Whether a room is brighter and hardly more of its wide doors is stood before."""
    if not is_brighter(count_faults(task, new), counted):
        return False
    now, before = (
        sum(measure_before_doors(p, task.ground) for p in placed) for placed in (new, old)
    )
    return now <= before + (SLIVER if task.ground.area >= BED_WINDOW_FROM else 0.0)


def _clear(
    room: int, task: RoomTask, name: str, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with one group of a room elsewhere, or as they were."""
    placed = found[room].placed
    at = next((i for i, p in enumerate(placed) if p.name == name), None)
    if at is None or len(placed[at].pieces) < sum(placed[at].dressed.stands):
        return found
    for other in islice(_list_open(task, placed, at), TRIED):
        trial = [*found[:room], found[room]._replace(placed=other), *found[room + 1 :]]
        if all(a is b for a, b in zip(opened(trial), trial, strict=True)):
            return trial
    return found


def _list_open(task: RoomTask, placed: Placed, at: int) -> Iterator[Placed]:
    """The rooms with a group elsewhere that bar no further way on a grid with narrower ways: the
    better ones, then those that are brighter at a small price."""
    counted: Counted = ()
    barred: frozenset[str] = frozenset()
    narrow, dearer = with_narrow_ways(task), list[Placed]()
    is_bed = placed[at].wish.group in BED_GROUPS
    seen = _cost_of_view(task, placed) + SIGHT_GIVEN
    for other in chain(_list_moved(task, placed, at), _list_around(task, placed, at)):
        if not counted:
            counted = count_faults(task, placed)
            barred = frozenset(find_blocked(narrow, placed))
        if _cost_of_view(task, other) > seen:
            continue
        better = is_better(count_faults(task, other), counted)
        if better and bars_no_more(narrow, other, barred):
            yield other
        elif not better and is_bed and _is_worth_it(task, other, placed, counted):
            dearer.append(other)
    yield from (other for other in dearer if bars_no_more(narrow, other, barred))


def _cost_of_view(task: RoomTask, placed: Placed) -> float:
    """What is wrong with how a screen is seen, in a room one sleeps in: elsewhere no more than a
    window is worth."""
    if not any(p.wish.group in BED_GROUPS for p in placed):
        return 0.0
    return cost_of_view(placed, task.preset.settings.composing.costs, task.ground.edges)


def _list_moved(task: RoomTask, placed: Placed, at: int) -> Iterator[Placed]:
    if placed[at].wish.group in RUNS:
        yield from move_hob(task, placed, at)
    elif placed[at].wish.group not in COOKING:
        fixed = _find_fixed(task, placed)
        yield from (j.placed for j in list_brighter(task, placed, at, fixed, WORTH))


def _list_around(task: RoomTask, placed: Placed, at: int) -> list[Placed]:
    if placed[at].wish.group != DOUBLE:
        return []
    return list_around_bed(task, placed, at, _find_fixed(task, placed))


def _find_fixed(task: RoomTask, placed: Placed) -> frozenset[str]:
    """The names of the groups of a room that stay where they are."""
    own = task.library.own.keys() | COOKING
    return frozenset(p.name for p in placed if p.wish.group in own)
