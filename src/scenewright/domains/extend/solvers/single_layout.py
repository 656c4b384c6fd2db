"""Shared by solvers that grow a single layout."""

from __future__ import annotations

from collections.abc import Callable

from scenewright.domains.extend.problem import ExtendFound, ExtendProblem, GrownLayout
from scenewright.domains.extend.rating import rate_layout
from scenewright.engine.growing import OnGrowth, tell_growth
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress


def grow_once(
    problem: ExtendProblem,
    make: Callable[[OnGrowth], GrownLayout],
    budget: Budget,
    progress: Progress | None,
    cancel: Cancel | None,
) -> ExtendFound:
    """The layout that ``make`` grows, rated; it is shown as it grows, and its growth ends where
    nobody waits."""
    watch = BudgetWatch(budget._replace(steps=1), progress, cancel)
    found = rate_layout(problem, make(tell_growth(watch, 0, 1)))
    watch.over(1, found.score["energy"], lambda: found)
    return Found((found,), 1)
