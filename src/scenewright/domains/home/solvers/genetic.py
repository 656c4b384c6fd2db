"""Homes by the paper's genetic algorithm over the genes of their patches."""

from __future__ import annotations

from scenewright.core.layout import Layout
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.over_genes import over_genes
from scenewright.engine.genetic import GENERATIONS, POPULATION, PaperGenetic
from scenewright.engine.solve import Budget, Cancel, Found, Progress


def paper_ga(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Found[Layout]:
    """Solve by the paper's genetic algorithm; without a budget, its 100 generations.

    Steps are looked-at layouts, 40 a generation; its schedule is spread over the budget's steps.
    """
    rounds = max(budget.steps // POPULATION, 1) if budget.steps else GENERATIONS
    solver = PaperGenetic(generations=rounds)
    return over_genes(solver, problem, budget, seed, progress, cancel, rounds)
