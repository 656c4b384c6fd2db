"""What a pass changed in a room: by how much its cost fell, its faults, and pieces more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from scenewright.core.passes import PassChange
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, RoomTask, penalty
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of, sum_faults


class RoomMeasure(NamedTuple):
    """What a room costs, what is missing included, what is wrong with it, and its pieces."""

    cost: float
    faults: float
    pieces: int


def compare_judged(task: RoomTask, before: JudgedRoom, after: JudgedRoom) -> Iterator[PassChange]:
    """The change of the groups of a room, none where they are the same."""
    yield from _compare(task, (before.placed, ()), (after.placed, ()))


def compare_answers(task: RoomTask, before: RoomAnswer, after: RoomAnswer) -> Iterator[PassChange]:
    """The change of an answer for a room, none where groups and what is missing are the same."""
    yield from _compare(task, (before.placed, before.missing), (after.placed, after.missing))


def compare_homes(
    tasks: Sequence[RoomTask], before: Sequence[RoomAnswer], after: Sequence[RoomAnswer]
) -> Iterator[PassChange]:
    """The changes of the answers for all rooms of a home."""
    for task, old, new in zip(tasks, before, after, strict=True):
        yield from compare_answers(task, old, new) if old is not new else ()


Standing = tuple[Placed, tuple[Missing, ...]]


def _compare(task: RoomTask, before: Standing, after: Standing) -> Iterator[PassChange]:
    (placed, missing), (now, lost) = before, after
    alike = len(placed) == len(now) and all(a is b for a, b in zip(placed, now, strict=True))
    if alike and len(missing) == len(lost):
        return
    old, new = measure_room(task, placed, missing), measure_room(task, now, lost)
    gain, faults = old.cost - new.cost, old.faults - new.faults
    yield PassChange(task.space.id, gain, faults, new.pieces - old.pieces)


def measure_room(task: RoomTask, placed: Placed, missing: Sequence[Missing] = ()) -> RoomMeasure:
    """What a room costs as the passes weigh it: its energy, what is wrong with its groups and
    together, wishes that are not met, and what is missing for which nothing else stands."""
    cost = judge_of(task, placed).cost_of(placed).cost if placed else 0.0
    cost += sum(penalty(m.wish, task.costs) for m in missing if not m.replaced)
    faults = sum_faults(task, placed) if placed else 0.0
    return RoomMeasure(cost, faults, sum(len(group.pieces) for group in placed))
