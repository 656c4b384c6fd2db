"""What a solution tells about a room: its patches, what each term says, what was left out."""

from __future__ import annotations

import numpy as np

from scenewright.core.solution import LeftOut, Patch, TermValue
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask, build_task_problem
from scenewright.domains.home.energy import explain


def patches(task: RoomTask, answer: RoomAnswer) -> list[Patch]:
    """The patches as drawn in to their groups."""
    return [
        Patch(
            f"{task.space.id}/{p.name}",
            task.space.id,
            p.wish.group,
            tuple(float(v) for v in p.dressed.box),  # type: ignore[arg-type]
        )
        for p in answer.placed
    ]


def terms(task: RoomTask, answer: RoomAnswer) -> list[TermValue]:
    """Every term's value by item, on the patches as they stand."""
    if not answer.placed:
        return []
    problem = build_task_problem(task, tuple(p.wish for p in answer.placed), task.ground)
    boxes = np.array([p.dressed.box for p in answer.placed])
    return [
        TermValue(task.space.id, part.item, part.term, part.value, part.weight, part.cost)
        for part in explain(problem, boxes)
    ]


def left_out(task: RoomTask, answer: RoomAnswer) -> list[LeftOut]:
    """What was wished for and is not there, the essential first."""
    area = task.ground.area
    return [
        LeftOut(
            task.space.id,
            missing.wish.group,
            f"{missing.reason} ({area:.1f} m² of floor)",
            missing.wish.required or missing.wish.rank == 0,
        )
        for missing in sorted(answer.missing, key=lambda m: m.wish.rank)
    ]
