"""A solver: the best of a handful of layouts drawn at random."""

from __future__ import annotations

from typing import Any

from scenewright.core.layout import Layout
from scenewright.domains.home.solvers.over_genes import over_genes
from scenewright.domains.home.solvers.random_search import RandomDraws
from scenewright.engine.rows import SolverRow
from scenewright.engine.solve import Budget, Found


def handful(problem: Any, budget: Budget, seed: int, *watched: Any) -> Found[Layout]:
    """Three rounds of 40."""
    return over_genes(RandomDraws(), problem, budget, seed, *watched, 3)


ADAPTER = "scenewright.domains.home.solvers.no_items:solve_items"
ROW = SolverRow(
    "handful", "the best of 120 random layouts", "loft", f"{__name__}:handful", "patches", ADAPTER
)
