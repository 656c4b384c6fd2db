"""What the rooms of a home are to hold, as the home has it: what it has once, in one room only."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from scenewright.domains.home.attempt import RoomTask
from scenewright.domains.home.household import Household, share_out
from scenewright.domains.home.programme import STANDS_FOR, Wish
from scenewright.domains.home.wished.wishes import list_barred_groups


def share_wishes(
    household: Household, tasks: Sequence[RoomTask], wishes: Sequence[tuple[Wish, ...]]
) -> list[tuple[Wish, ...]]:
    """The wishes of all rooms as the home has them."""
    standing = find_groups(piece.category for task in tasks for piece in task.fixed)
    others = standing | {wish.group for asked in wishes for wish in asked}
    return [
        share_with_home(household, task, asked, others)
        for task, asked in zip(tasks, wishes, strict=True)
    ]


def share_with_home(
    household: Household, task: RoomTask, asked: tuple[Wish, ...], others: frozenset[str]
) -> tuple[Wish, ...]:
    """The wishes of one room as the home has them, those of a room of which all is listed as asked;
    ``others`` are the groups in all its rooms."""
    listed = task.asked is not None and task.asked.ask is not None
    shared = asked if listed else share_out(household, task.space.id, asked, others)
    barred = list_barred_groups(task.asked, task.library) if task.asked else frozenset()
    return tuple(wish for wish in shared if wish in asked or wish.group not in barred)


def find_groups(categories: Iterable[str]) -> frozenset[str]:
    """The groups for which pieces of such categories stand."""
    there = frozenset(categories)
    return frozenset(group for group, kinds in STANDS_FOR.items() if there.intersection(kinds))
