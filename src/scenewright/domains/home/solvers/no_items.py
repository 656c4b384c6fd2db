"""Rooms with nothing to place, which no solver need know of."""

from __future__ import annotations

from scenewright.core.layout import Layout
from scenewright.domains.home.energy import empty_layout
from scenewright.domains.home.problem import Problem
from scenewright.engine.solve import Budget, Cancel, Found, Progress, Run


def solve_items(
    solve: Run,
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
) -> Found[Layout]:
    """The adapter of all solvers of homes: the empty layout where there is nothing to place."""
    if not problem.names:
        return Found((empty_layout(problem),), 1)
    return solve(problem, budget, seed, progress, cancel)
