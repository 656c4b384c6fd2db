"""Rooms of a finished home repaired: the worst row, the moves it names, what is better kept.

While a room is composed all is weighed against all else, and few places of each group are tried.
What an eye still finds when the home stands is tried once more beside all else, at places nearer
together, as long as no way of the home is barred.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from functools import partial

from scenewright.arranging.repair import Repair, repair
from scenewright.domains.home.attempts.attempt import (
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.composing.homewide.settling import try_in_home
from scenewright.domains.home.composing.room_moves import MOVES
from scenewright.domains.home.composing.seats.unseen import leave_out_unseen_screen
from scenewright.domains.home.composing.spacing.leave_out import leave_out_near
from scenewright.domains.home.composing.verdict import finds_more, judge_room
from scenewright.domains.home.walking.remove_blockers import Opened

LEAST = 3.0  # by how much a room is to cost less, where nothing is found less
BUDGET = 150  # rooms that are weighed
MOVES_OF = {
    "near": ("elsewhere", "swap", "amid", "other table", "pair", "lounge", "fewer"),
    "far fridge": ("remake",),
    "loose cabinet": ("join",),
    "window": ("elsewhere", "pair", "amid", "remake"),
    "adrift": ("elsewhere", "pair"),
    "door": ("elsewhere", "exchange", "leave out"),
    "wardrobe": ("elsewhere", "pair", "exchange", "spare"),
    "seats": ("elsewhere",),
    "unseen": ("lounge", "swap", "elsewhere", "amid"),
    "off axis": ("lounge", "swap", "elsewhere"),
    "one_side": ("elsewhere", "pair"),
    "closed bed": ("elsewhere", "pair"),
}
"""The moves that each row names; other rows are mended while a room is composed."""


def mend_rooms(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms repaired, the ways of the home ``opened``; what is too near or
    unseen even so, and merely welcome, is left out by name."""
    found = answers
    for room, task in enumerate(tasks):
        if task.preset.settings.exact and not task.accessible and found[room].placed:
            found = _mend(room, task, found, opened)
            less = leave_out_near(task, found[room])
            found = [less if k == room else other for k, other in enumerate(found)]
            unseen = leave_out_unseen_screen(task, less)
            trial = None if unseen is less else try_in_home(room, unseen, found, opened)
            found = found if trial is None else trial
    return found


def _mend(room: int, task: RoomTask, found: list[RoomAnswer], opened: Opened) -> list[RoomAnswer]:
    start, narrow = found[room], with_narrow_ways(task)
    barred: list[frozenset[str]] = []

    def holds(answer: RoomAnswer) -> bool:
        if not barred:
            barred.append(frozenset(find_blocked(narrow, start.placed)))
        is_open = bars_no_more(narrow, answer.placed, barred[0])
        return is_open and try_in_home(room, answer, found, opened) is not None

    by = Repair[RoomAnswer](
        judge=lambda answer: judge_room(task, answer, start.placed),
        moves={name: partial(move, task) for name, move in MOVES.items()},
        by_row=MOVES_OF,
        key=_key_of,
        least=LEAST,
        holds=holds,
        worse=lambda answer, now: finds_more(task, answer, start.placed, now.findings),
    )
    done = repair(by, start, BUDGET, task.cancelled)
    return [done.state if k == room else other for k, other in enumerate(found)]


def _key_of(answer: RoomAnswer) -> Hashable:
    """What tells rooms apart: their groups, in which form and where."""
    return tuple((p.name, p.dressed.case, p.dressed.box.tobytes()) for p in answer.placed)
