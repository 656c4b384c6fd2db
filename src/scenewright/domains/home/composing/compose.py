"""A furnished room composed: every pass of the table over its groups, one after the other."""

from __future__ import annotations

from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.habitual import keep_habits
from scenewright.domains.home.composing.improve import list_worst_first
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, count_unmet, judge_of
from scenewright.domains.home.composing.kitchens.second_runs import list_given_up
from scenewright.domains.home.composing.places.moving import with_margin
from scenewright.domains.home.composing.room_passes import (
    FILLING,
    LACKING,
    MENDING,
    OPENING,
    RESTORING,
    Barred,
    complete_room,
    mend_room,
)
from scenewright.domains.home.composing.seats.lounges import list_given_up as list_yielded


def compose(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer with its groups better composed where that bars no way and takes nothing away.

    Rooms of wheelchair users keep the room to turn they were furnished with, rooms of learned
    groups what was learned (of learned habits: :mod:`.habitual`); presets that are not exact are
    left as they are.
    """
    habits = task.library.habits
    learned = bool(habits.clearances or habits.shares)
    if task.accessible or not answer.placed or not task.preset.settings.exact:
        return answer
    if task.library.own.keys() - task.library.seated and not learned:
        return answer
    if learned:
        barred = frozenset(find_blocked(with_margin(task), answer.placed))
        return keep_habits(task, answer, barred)
    answer = complete_room(task, answer, OPENING, frozenset())
    barred = frozenset(find_blocked(with_margin(task), answer.placed))
    before = complete_room(task, answer, LACKING, barred)
    mended = _mend(task, judge_of(task, before.placed).cost_of(before.placed), barred).placed
    gone = _list_given_up(before.placed, mended)
    before = before._replace(placed=mended, missing=(*before.missing, *gone))
    better = complete_room(task, before, FILLING, barred)
    kept = count_unmet(task, better.placed) <= count_unmet(task, answer.placed)
    return better if kept else answer


def _mend(task: RoomTask, best: JudgedRoom, barred: Barred) -> JudgedRoom:
    """The groups with their faults mended, if there are any."""
    best = mend_room(task, best, RESTORING, barred)
    if list_worst_first(task, best.placed):
        best = mend_room(task, best, MENDING, barred)
    return best


def _list_given_up(before: Placed, after: Placed) -> tuple[Missing, ...]:
    """What was given up for what was mended, and why."""
    return (
        *list_given_up(before, after, "the kitchen takes its wall"),
        *list_yielded(before, after),
    )
