"""The rest of a room after some of it was moved: as little as possible is placed anew.

What the moved pieces do not touch stays as it is. Groups they run into, and groups that now bar a
way or cannot be reached, are placed anew around all that stays; only if that fails is the whole
room laid out again.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    build_task_problem,
    furnish_layout,
    out_of_reach,
    penalty,
)
from scenewright.domains.home.changes.regroup import as_standing, newly_misplaced
from scenewright.domains.home.room import furnish
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget


class Rest(NamedTuple):
    """Groups that stayed as they were, and the answer for the others."""

    stay: tuple[FurnishedGroup, ...]
    answer: RoomAnswer


def rearrange_groups(task: RoomTask, groups: Sequence[FurnishedGroup], budget: Budget) -> Rest:
    """The groups of a room about the fixed pieces of a task, with the least change."""
    if not task.preset.settings.exact or SOLVERS[task.solver].encoding == "pieces":
        return Rest((), furnish(task, tuple(g.wish for g in groups), budget))
    stay = _unhurt(task, groups)
    stay = _open(task, stay)
    freed = [g for g in groups if g not in stay]
    share = task.preset.settings.rearrange.share
    part = budget.steps and max(1, int(share * budget.steps * len(freed) / max(len(groups), 1)))
    answer = _anew(task, freed, stay, budget._replace(steps=part))
    if not _trouble(task, answer):
        return Rest(stay, answer)
    whole = furnish_by_use(task, tuple(g.wish for g in groups), budget)
    evaluations = answer.evaluations + whole.evaluations
    if _trouble(task, whole) < _trouble(task, answer):
        return Rest((), whole._replace(evaluations=evaluations))
    return Rest(stay, answer._replace(evaluations=evaluations))


def _trouble(task: RoomTask, answer: RoomAnswer) -> float:
    """What is wrong with an answer apart from its energy."""
    missing = sum(penalty(m.wish, task.costs) for m in answer.missing)
    return missing + task.costs.unreached * len(answer.unreached)


def _unhurt(task: RoomTask, groups: Sequence[FurnishedGroup]) -> tuple[FurnishedGroup, ...]:
    """The groups none of whose pieces runs into what is fixed."""
    fixed = as_standing((*task.fixed, *task.beside), task.catalog)
    return tuple(g for g in groups if not newly_misplaced(task, g.pieces, fixed))


def _open(task: RoomTask, stay: tuple[FurnishedGroup, ...]) -> tuple[FurnishedGroup, ...]:
    """The groups that can be reached and bar nothing else's way."""
    while far := _far(task, stay):
        cut = [g for g in stay if any(p.id in far for p in g.pieces)]
        if not cut:
            gains = [
                (len(_far(task, [o for o in stay if o is not g])), k) for k, g in enumerate(stay)
            ]
            left, k = min(gains, default=(len(far), 0))
            cut = [stay[k]] if left < len(far) else []
        if not cut:
            break
        stay = tuple(g for g in stay if g not in cut)
    return stay


def _far(task: RoomTask, groups: Sequence[FurnishedGroup]) -> frozenset[str]:
    pieces = tuple(p for g in groups for p in g.pieces)
    return out_of_reach(task, pieces) - task.tight


def _anew(
    task: RoomTask,
    freed: Sequence[FurnishedGroup],
    stay: tuple[FurnishedGroup, ...],
    budget: Budget,
) -> RoomAnswer:
    """The freed groups placed around all others: where they were if they can stand there, smaller
    or not, else as the solver finds, the nearer the better."""
    if not freed:
        return RoomAnswer(0.0, (), (), (), None, 0.0, 0)
    wishes = tuple(g.wish for g in freed)
    kept: tuple[Piece, ...] = tuple(p for g in stay for p in g.pieces)
    firm = task._replace(fixed=(*task.fixed, *kept))
    boxes = np.array([g.dressed.box for g in stay]).reshape(-1, 5)
    ground = task.ground._replace(obstacles=np.concatenate([task.ground.obstacles, boxes]))
    problem = build_task_problem(task, wishes, ground)
    found = SOLVERS[task.solver].run(problem, budget, task.seed, cancel=task.cancel)
    before, rule = np.array([g.dressed.box for g in freed]), task.preset.settings.rearrange
    layouts = [before, *(layout.boxes for layout in found.layouts[: rule.layouts])]
    energy = found.layouts[0].energy
    answers = [furnish_layout(firm, wishes, problem, layout, energy) for layout in layouts]
    best = min(answers, key=lambda a: a.score + rule.shift * _measure_displacement(a, freed))
    return best._replace(evaluations=found.evaluations)


def _measure_displacement(answer: RoomAnswer, before: Sequence[FurnishedGroup]) -> float:
    """How far groups lie from where they were, metres; a quarter turn counts as one."""
    was = {id(g.wish): g.dressed.box for g in before}
    total = 0.0
    for item in answer.placed:
        box, old = item.dressed.box, was.get(id(item.wish), item.dressed.box)
        turn = abs((box[2] - old[2] + np.pi) % (2 * np.pi) - np.pi) / (np.pi / 2)
        total += float(np.hypot(*(box[:2] - old[:2]))) + float(turn)
    return total
