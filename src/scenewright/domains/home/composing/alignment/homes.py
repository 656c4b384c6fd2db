"""All rooms of a finished home aligned, where that bars no way of the home."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.composing.alignment.align import align_groups
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.walking.remove_blockers import Opened


def align_rooms(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with their groups on axes and against one another; where the ways
    of the home, these ``opened``, are not open then, room by room and move by move."""
    moved = [_align(task, answer) for task, answer in zip(tasks, answers, strict=True)]
    rooms = [k for k, (a, b) in enumerate(zip(answers, moved, strict=True)) if a is not b]
    if not rooms or _stay_open(moved, opened):
        return moved
    found = answers
    for room in rooms:
        trial = _with(found, room, moved[room])
        if not _stay_open(trial, opened):
            trial = _with(found, room, _step_by_step(tasks[room], room, found, opened))
        found = trial
    return found


def _align(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer with its groups aligned, itself where none moves."""
    if not task.preset.settings.exact or task.accessible or not answer.placed:
        return answer
    placed = align_groups(task, answer.placed)
    return answer if placed is answer.placed else answer._replace(placed=placed)


def _step_by_step(task: RoomTask, room: int, found: list[RoomAnswer], opened: Opened) -> RoomAnswer:
    """The answer for a room with those of its groups aligned that bar no way."""

    def allowed(placed: Placed) -> bool:
        return _stay_open(_with(found, room, found[room]._replace(placed=placed)), opened)

    return found[room]._replace(placed=align_groups(task, found[room].placed, allowed))


def _stay_open(answers: list[RoomAnswer], opened: Opened) -> bool:
    """Whether nothing has to give way for the ways of the home."""
    return all(a is b for a, b in zip(opened(answers), answers, strict=True))


def _with(answers: list[RoomAnswer], room: int, answer: RoomAnswer) -> list[RoomAnswer]:
    return [answer if k == room else other for k, other in enumerate(answers)]
