"""What the rooms of a home are to hold, as the home has it: what it has once, in one room only."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.needs.household import Household, share_out
from scenewright.domains.home.programme import Wish, standing_groups
from scenewright.domains.home.wished.beds import list_wished_beds
from scenewright.domains.home.wished.wishes import list_barred_groups


def share_wishes(
    household: Household, tasks: Sequence[RoomTask], wishes: Sequence[tuple[Wish, ...]]
) -> list[tuple[Wish, ...]]:
    """The wishes of all rooms as the home has them."""
    standing = standing_groups(piece for task in tasks for piece in task.fixed)
    others = standing | {wish.group for asked in wishes for wish in asked}
    return [
        share_with_home(household, task, asked, others)
        for task, asked in zip(tasks, wishes, strict=True)
    ]


def share_with_home(
    household: Household, task: RoomTask, asked: tuple[Wish, ...], others: frozenset[str]
) -> tuple[Wish, ...]:
    """The wishes of one room as the home has them, as asked where the brief lists them all;
    ``others`` are the groups in all its rooms. A bed that is wished for stays, however many live
    there."""
    listed = task.asked is not None and task.asked.ask is not None
    room = "" if task.asked and list_wished_beds(task.asked) else task.space.id
    settled = household._replace(
        bunks=tuple(k for k in household.bunks if k == room),
        alone=tuple(k for k in household.alone if k == room),
    )
    shared = asked if listed else share_out(settled, task.space.id, asked, others)
    barred = list_barred_groups(task.asked, task.library) if task.asked else frozenset()
    return tuple(wish for wish in shared if wish in asked or wish.group not in barred)
