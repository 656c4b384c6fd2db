"""What a room lacks after a change by hand: what it lacked before, and what was moved away."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.changes.edits import EditedHome, leads
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.tasks import wishes_of


def still_missing(solution: Solution, space: str, answer: RoomAnswer) -> list[LeftOut]:
    """Groups that were left out before and still are: neither placed nor reported anew."""
    now = {p.wish.group for p in answer.placed} | {m.wish.group for m in answer.missing}
    lacking = GROUPS.keys() - now
    return [out for out in solution.left_out if out.space == space and out.what in lacking]


def moved_out(
    task: RoomTask,
    rooms: Sequence[Space],
    standing: tuple[Piece, ...],
    before: Sequence[Piece],
    change: EditedHome,
) -> list[LeftOut]:
    """What a room is to hold and lacks because its group was moved into another room; ``standing``
    is what is there now, ``before`` all pieces of the home as they were."""
    if task.asked is None:
        return []
    room, present = task.space.id, {p.id: p for p in change.pieces}
    was = {p.id: p for p in before}
    away = {
        was[former].function: present[now].space
        for now, former in change.moved.items()
        if leads(was[former]) and was[former].space == room != present[now].space
    }
    names = {space.id: space.name or space.id for space in rooms}
    return [
        LeftOut(
            room,
            wish.group,
            f"moved into '{names[away[wish.group]]}' by hand",
            wish.required or wish.rank == 0,
        )
        for wish in wishes_of(task.asked, task, tuple(rooms), standing)
        if wish.group in away
    ]
