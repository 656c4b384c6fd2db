"""Groups of a room shown to who watches, after the search: what changed them, and why."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from scenewright.core.layout import SETTLED, NamedBox, name_rows
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.engine.watched import show

Placed = tuple[FurnishedGroup, ...]


def show_groups(task: RoomTask, placed: Placed, stage: str, reason: str = "") -> None:
    """Show groups of a room as they stand to who watches, if anybody does."""
    show(task.watch, task.space.id, lambda: _rows(placed), stage, reason)


def show_change(task: RoomTask, before: Placed, after: Placed, stage: str, reason: str) -> None:
    """Show the groups of a room if they are others than before: nothing is measured for it."""
    alike = len(before) == len(after) and all(a is b for a, b in zip(before, after, strict=True))
    if not alike:
        show_groups(task, after, stage, reason)


def show_home(
    tasks: Sequence[RoomTask],
    before: Sequence[RoomAnswer],
    after: Sequence[RoomAnswer],
    stage: str,
    reason: str,
) -> None:
    """Show the rooms of a home whose groups are others than before."""
    for task, old, new in zip(tasks, before, after, strict=True):
        show_change(task, old.placed, new.placed, stage, reason)


def show_settled(tasks: Sequence[RoomTask], answers: Sequence[RoomAnswer]) -> None:
    """Show every room as it stays."""
    for task, answer in zip(tasks, answers, strict=True):
        show_groups(task, answer.placed, SETTLED)


def _rows(placed: Placed) -> tuple[NamedBox, ...]:
    boxes = np.array([one.dressed.box for one in placed])
    return name_rows([one.wish.group for one in placed], boxes)
