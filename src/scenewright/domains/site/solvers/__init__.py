"""The table of solvers of sites. A new one is one file and one row; the rows drive the tests."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import NamedTuple

from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.outcome import SiteFound
from scenewright.engine.solve import Budget, Cancel, Progress

SiteRun = Callable[[SiteProblem, Budget, int, Progress | None, Cancel | None], SiteFound]


class SiteSolverRow(NamedTuple):
    """One solver: its name, what it is, and where its function is (imported when first run)."""

    name: str
    doc: str
    source: str
    module: str
    function: str

    def run(
        self,
        problem: SiteProblem,
        budget: Budget,
        seed: int = 0,
        progress: Progress | None = None,
        cancel: Cancel | None = None,
    ) -> SiteFound:
        """Solve; see the module."""
        solve: SiteRun = getattr(import_module(f"{__name__}.{self.module}"), self.function)
        return solve(problem, budget, seed, progress, cancel)


ROWS = (
    SiteSolverRow(
        "fill",
        "blocks filled row by row, the form of each chosen (default)",
        "ours",
        "fill",
        "fill_site",
    ),
    SiteSolverRow(
        "vp",
        "the paper's genetic algorithm over a matrix of cells, led by visual "
        "quality, 10 layouts, at most 200 generations",
        "Zhang, Yang 2023",
        "genetic",
        "viewpoint_site",
    ),
    SiteSolverRow(
        "sga",
        "simple genetic algorithm over the same matrix",
        "Goldberg 1989",
        "genetic",
        "simple_site",
    ),
    SiteSolverRow(
        "sa",
        "annealing of boxes with four headings",
        "Kirkpatrick et al. 1983",
        "anneal",
        "anneal_site",
    ),
    SiteSolverRow(
        "sa-free", "annealing of boxes at any angle", "ours", "anneal", "anneal_site_free"
    ),
    SiteSolverRow(
        "pso", "particle swarm over poses", "Kennedy, Eberhart 1995", "swarm", "swarm_site"
    ),
    SiteSolverRow(
        "random",
        "buildings dropped at random, the best layout kept",
        "baseline",
        "random_search",
        "random_site",
    ),
)
SITE_SOLVERS: dict[str, SiteSolverRow] = {row.name: row for row in ROWS}
