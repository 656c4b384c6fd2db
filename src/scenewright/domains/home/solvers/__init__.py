"""The table of solvers. A new one is one file and one row here; the rows drive the tests."""

from __future__ import annotations

from importlib import import_module
from typing import Literal, NamedTuple

from scenewright.domains.home.problem import Problem
from scenewright.engine.solve import Budget, Cancel, Found, Progress, Run


class SolverRow(NamedTuple):
    """One solver: its name, what it is, where its function is (imported when first run), and
    whether homes pose it their patches or the single pieces of their groups."""

    name: str
    doc: str
    source: str
    module: str
    function: str
    encoding: Literal["patches", "pieces"] = "patches"

    def run(
        self,
        problem: Problem,
        budget: Budget,
        seed: int = 0,
        progress: Progress | None = None,
        cancel: Cancel | None = None,
    ) -> Found:
        """Solve; see :data:`scenewright.engine.solve.Run`."""
        if not problem.names:
            from scenewright.domains.home.energy import empty_layout

            return Found((empty_layout(problem),), 1)
        solve: Run = getattr(import_module(f"{__name__}.{self.module}"), self.function)
        return solve(problem, budget, seed, progress, cancel)


ROWS = (
    SolverRow(
        "anneal",
        "compiled annealing, a designer's moves, adaptive restarts (default)",
        "ours, after Kirkpatrick et al. 1983",
        "anneal",
        "anneal",
    ),
    SolverRow(
        "paper-ga",
        "the paper's genetic algorithm, 40 layouts, 100 generations",
        "Liu et al. 2017",
        "genetic",
        "paper_ga",
    ),
    SolverRow(
        "paper-sa",
        "the paper's comparison: annealing over patches, 500 iterations",
        "Liu et al. 2017",
        "paper_annealing",
        "paper_sa",
    ),
    SolverRow(
        "merrell",
        "single pieces annealed by interior design guidelines, T from 100 by 0.99",
        "Merrell et al. 2011",
        "merrell",
        "merrell",
        "pieces",
    ),
    SolverRow(
        "pso",
        "particle swarm over patches, 40 particles, 100 rounds",
        "Kennedy, Eberhart 1995",
        "swarm",
        "swarm",
    ),
    SolverRow(
        "greedy",
        "largest patch first, each at its best corner, wall or partner",
        "Feo, Resende 1995",
        "greedy",
        "greedy",
    ),
    SolverRow(
        "random",
        "layouts drawn at random, the best kept",
        "baseline",
        "random_search",
        "random_search",
    ),
)
SOLVERS: dict[str, SolverRow] = {row.name: row for row in ROWS}
