"""Run a population solver over the genes of a problem's patches."""

from __future__ import annotations

import numpy as np

from scenewright.core.layout import Layout
from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.engine.solve import (
    Budget,
    BudgetWatch,
    Cancel,
    Floats,
    Found,
    OnRound,
    PopulationSolver,
    Progress,
    distinct,
    run_population,
)


def over_genes(
    solver: PopulationSolver,
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
    rounds: int | None,
    on_round: OnRound | None = None,
) -> Found[Layout]:
    """Ask and tell over genes (P, 5 n) with the compiled energy, ``rounds`` times at most;
    ``on_round`` as of :func:`scenewright.engine.solve.run_population`."""
    n = len(problem.items.low)
    low, high = gene_bounds(problem)
    p, grid = prepare(problem), route_grid(problem, 0.1)

    def rate(rows: Floats) -> Floats:
        return energies_of(p, grid, to_boxes(rows.reshape(-1, n, 5)))[0]

    def layout_of(row: Floats) -> Layout:
        return Layout(to_boxes(row.reshape(1, n, 5))[0], float(rate(row)[0]))

    genes, energies, done = run_population(
        solver,
        rate,
        low.ravel(),
        high.ravel(),
        np.random.default_rng(seed),
        BudgetWatch(budget, progress, cancel),
        layout_of,
        rounds,
        on_round,
    )
    return Found(distinct(to_boxes(genes.reshape(-1, n, 5)), energies), done)
