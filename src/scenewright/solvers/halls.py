"""The table of solvers of halls. A new one is one file and one row here; the rows drive the tests.

A solver takes a problem, a first layout in which every unit has a place, a budget, a seed, and
who hears of progress and cancels; it returns layouts, best first.
"""

from __future__ import annotations

from importlib import import_module
from typing import Literal, NamedTuple

from scenewright.hall_problem import HallProblem
from scenewright.solve import Budget, Cancel, Progress
from scenewright.solvers.hall_found import HallFound, HallRun, by_objects
from scenewright.terms.hall_state import Kept


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
        self, problem: HallProblem, start: Kept, budget: Budget, seed: int = 0,
        progress: Progress | None = None, cancel: Cancel | None = None,
    ) -> HallFound:  # fmt: skip
        """Solve; see the module."""
        function = getattr(import_module(f"scenewright.solvers.{self.module}"), self.function)
        if self.encoding == "objects":
            return by_objects(function, problem, start, budget, seed, progress, cancel)
        solve: HallRun = function
        return solve(problem, start, budget, seed, progress, cancel)


ROWS = (
    HallSolverRow("anneal", "four chains over patterns, annealed, the better half cooled again "
                  "(default)", "ours", "hall_chains", "anneal_hall"),
    HallSolverRow("gd-mh", "the paper's graph-driven Metropolis-Hastings, 1000 iterations",
                  "Cao, Cheng, Zhang 2024", "hall_chains", "gd_mh"),
    HallSolverRow("merrell", "object by object annealing by interior design guidelines, T from "
                  "1000 by 0.99", "Merrell et al. 2011", "hall_merrell", "merrell", "objects"),
    HallSolverRow("miqp", "blocks for groups, cells for objects, by CP-SAT (extra solve)",
                  "Wu, Fan, Liu, Wonka 2018", "hall_miqp", "miqp", "objects"),
    HallSolverRow("ga", "genetic algorithm over the parameters of patterns", "baseline",
                  "hall_genetic", "genetic_hall"),
    HallSolverRow("random", "patterns drawn at random, the best layout kept", "baseline",
                  "hall_random", "random_hall"),
)  # fmt: skip
HALL_SOLVERS: dict[str, HallSolverRow] = {row.name: row for row in ROWS}
