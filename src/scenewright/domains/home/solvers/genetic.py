"""Homes by the paper's genetic algorithm over the genes of their patches."""

from __future__ import annotations

from scenewright.core.layout import Layout
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.over_genes import over_genes
from scenewright.engine.genetic import GENERATIONS, POPULATION, Generation, PaperGenetic
from scenewright.engine.solve import Budget, Cancel, Found, Progress
from scenewright.engine.trace import tell


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
    settings = solver._replace(parents=None)
    terms = {name: weight for name, weight in problem.weights.items() if weight}
    tell(budget.hear, "begin", 0, settings=settings, weights=terms, items=problem.names)

    def on_round(state: Generation, done: int, least: float) -> None:
        tell(
            budget.hear,
            "generation",
            state.age,
            mutation="uniform" if 2 * (state.age - 1) <= rounds else "normal",
            evaluations=done,
            population=len(state.genes),
            energies=state.energies,
            best=least,
            crossed=state.crossed,
            mutated=state.mutated,
        )

    found = over_genes(solver, problem, budget, seed, progress, cancel, rounds, on_round)
    stopped = "cancelled" if cancel is not None and cancel() else "the last generation"
    tell(budget.hear, "stop", rounds, reason=stopped, evaluations=found.evaluations)
    return found
