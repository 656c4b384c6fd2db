"""What a solution tells about a room: its patches, what each term says, what was left out."""

from __future__ import annotations

import numpy as np

from scenewright.domains.home.attempt import Furnished, Task, posed
from scenewright.energy import explain
from scenewright.solution import LeftOut, Patch, TermValue


def patches(task: Task, answer: Furnished) -> list[Patch]:
    """The patches as drawn in to their groups."""
    return [
        Patch(
            f"{task.space.id}/{p.name}", task.space.id, p.wish.group,
            tuple(float(v) for v in p.dressed.box),  # type: ignore[arg-type]
        )
        for p in answer.placed
    ]  # fmt: skip


def terms(task: Task, answer: Furnished) -> list[TermValue]:
    """Every term's value by item, on the patches as they stand."""
    if not answer.placed:
        return []
    problem = posed(task, tuple(p.wish for p in answer.placed), task.ground)
    boxes = np.array([p.dressed.box for p in answer.placed])
    return [
        TermValue(task.space.id, part.item, part.term, part.value, part.weight, part.cost)
        for part in explain(problem, boxes)
    ]


def left_out(task: Task, answer: Furnished) -> list[LeftOut]:
    """What was wished for and is not there, the essential first."""
    area = task.ground.area
    return [
        LeftOut(
            task.space.id, missing.wish.group,
            f"{missing.reason} ({area:.1f} m² of floor)",
            missing.wish.required or missing.wish.rank == 0,
        )
        for missing in sorted(answer.missing, key=lambda m: m.wish.rank)
    ]  # fmt: skip
