"""The table of solvers of halls. A new one is one file and one row here; the rows drive the tests.

A solver takes a problem, a first layout in which every unit has a place, a budget, a seed, and
who hears of progress and cancels; it returns layouts, best first.
"""

from __future__ import annotations

from importlib import import_module
from typing import Literal, NamedTuple

from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.outcome import HallFound, HallRun, by_objects
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.solve import Budget, Cancel, Progress


class HallSolverRow(NamedTuple):
    """One solver: its name, what it is, where its function is (imported when first run), and
    whether it moves patterns or objects one by one."""

    name: str
    doc: str
    source: str
    module: str
    function: str
    encoding: Literal["patterns", "objects"] = "patterns"

    def run(
        self,
        problem: HallProblem,
        start: Kept,
        budget: Budget,
        seed: int = 0,
        progress: Progress | None = None,
        cancel: Cancel | None = None,
    ) -> HallFound:
        """Solve; see the module."""
        function = getattr(import_module(f"{__name__}.{self.module}"), self.function)
        if self.encoding == "objects":
            return by_objects(function, problem, start, budget, seed, progress, cancel)
        solve: HallRun = function
        return solve(problem, start, budget, seed, progress, cancel)


ROWS = (
    HallSolverRow(
        "anneal",
        "four chains over patterns, annealed, the better half cooled again (default)",
        "ours",
        "chains",
        "anneal_hall",
    ),
    HallSolverRow(
        "gd-mh",
        "the paper's graph-driven Metropolis-Hastings, 1000 iterations",
        "Cao, Cheng, Zhang 2024",
        "chains",
        "gd_mh",
    ),
    HallSolverRow(
        "merrell",
        "object by object annealing by interior design guidelines, T from 1000 by 0.99",
        "Merrell et al. 2011",
        "merrell",
        "merrell",
        "objects",
    ),
    HallSolverRow(
        "miqp",
        "blocks for groups, cells for objects, by CP-SAT (extra solve)",
        "Wu, Fan, Liu, Wonka 2018",
        "miqp",
        "miqp",
        "objects",
    ),
    HallSolverRow(
        "ga",
        "genetic algorithm over the parameters of patterns",
        "baseline",
        "genetic",
        "genetic_hall",
    ),
    HallSolverRow(
        "random",
        "patterns drawn at random, the best layout kept",
        "baseline",
        "random_search",
        "random_hall",
    ),
)
HALL_SOLVERS: dict[str, HallSolverRow] = {row.name: row for row in ROWS}
