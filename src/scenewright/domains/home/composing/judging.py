"""What the groups of a room cost as they stand, beside what is missing."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempt import FurnishedGroup, RoomTask, build_task_problem
from scenewright.domains.home.composing.placed_faults import cost_of_group, cost_of_shelves
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.domains.home.wished.unmet import count_unmet_wishes
from scenewright.geometry.paths import RouteGrid

Floats = NDArray[np.float64]
Placed = tuple[FurnishedGroup, ...]

RUNS = ("kitchen", "kitchenette")
"""Groups one cooks at."""
LEFT_OUT = {"route": 0.0, "wish": 0.0}
"""Terms that do not count while composing: ways are walked, and sizes are what is looked for."""


class JudgedRoom(NamedTuple):
    """Groups as they stand and what they cost."""

    placed: Placed
    cost: float


class RoomJudge(NamedTuple):
    """What the groups of one room are judged by, wherever they stand and in whichever form."""

    task: RoomTask
    prepared: PreparedHome
    grid: RouteGrid

    def energies_of(self, layouts: Floats) -> Floats:
        """Energies ``(P,)`` of boxes ``(P, n, 5)`` of the groups in their order."""
        return energies_of(self.prepared, self.grid, layouts)[0]

    def cost_of(self, placed: Placed) -> JudgedRoom:
        """The groups with what they cost: energy, lost pieces, and faults of composition."""
        task, rule = self.task, self.task.preset.settings.composing
        energy = float(self.energies_of(np.array([[p.dressed.box for p in placed]]))[0])
        each = sum(cost_of_group(p, task.ground, rule) for p in placed)
        lost = task.costs.piece * sum(p.dressed.lost for p in placed)
        shelves = cost_of_shelves(placed, task.ground, rule.costs.shelves)
        unmet = task.costs.unmet * count_unmet(task, placed)
        return JudgedRoom(placed, task.costs.energy * energy + each + lost + shelves + unmet)


def count_unmet(task: RoomTask, placed: Placed) -> int:
    """The wishes for places, and the outlets, that groups as they stand do not meet."""
    if not task.space.outlets and not (task.asked and task.asked.wishes):
        return 0
    standing = (*task.fixed, *(p for item in placed for p in item.pieces))
    return count_unmet_wishes(task.asked, task.space, standing, task.catalog)


def judge_of(task: RoomTask, placed: Placed) -> RoomJudge:
    """The judge of groups of these wishes, in this order."""
    problem = build_task_problem(task, tuple(p.wish for p in placed), task.ground)
    problem = problem._replace(weights={**problem.weights, **LEFT_OUT})
    return RoomJudge(task, prepare(problem), route_grid(problem, 0.1))
