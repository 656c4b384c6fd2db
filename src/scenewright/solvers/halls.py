"""The table of solvers of halls. A new one is one file and one row here; the rows drive the tests.

A solver takes a problem, a first layout in which every unit has a place, a budget, a seed, and
who hears of progress and cancels; it returns layouts, best first.
"""

from __future__ import annotations

from importlib import import_module
from typing import NamedTuple

from scenewright.hall_problem import HallProblem
from scenewright.solve import Budget, Cancel, Progress
from scenewright.solvers.hall_chains import HallFound, HallRun
from scenewright.terms.hall_state import Kept


class HallSolverRow(NamedTuple):
    """One solver: its name, what it is, and where its function is (imported when first run)."""

    name: str
    doc: str
    source: str
    module: str
    function: str

    def run(
        self, problem: HallProblem, start: Kept, budget: Budget, seed: int = 0,
        progress: Progress | None = None, cancel: Cancel | None = None,
    ) -> HallFound:  # fmt: skip
        """Solve; see the module."""
        module = import_module(f"scenewright.solvers.{self.module}")
        solve: HallRun = getattr(module, self.function)
        return solve(problem, start, budget, seed, progress, cancel)


ROWS = (
    HallSolverRow("anneal", "four chains over patterns, annealed, the better half cooled again "
                  "(default)", "ours", "hall_chains", "anneal_hall"),
    HallSolverRow("gd-mh", "the paper's graph-driven Metropolis-Hastings, 1000 iterations",
                  "Cao, Cheng, Zhang 2024", "hall_chains", "gd_mh"),
)  # fmt: skip
HALL_SOLVERS: dict[str, HallSolverRow] = {row.name: row for row in ROWS}
