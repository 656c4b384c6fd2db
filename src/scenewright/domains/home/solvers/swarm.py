"""Homes by a particle swarm over the genes of their patches."""

from __future__ import annotations

import numpy as np

from scenewright.core.layout import Layout
from scenewright.domains.home.encodings.boxes import gene_bounds
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.over_genes import over_genes
from scenewright.engine.solve import Budget, Cancel, Found, Progress
from scenewright.engine.swarm import PARTICLES, ROUNDS, Swarm


def swarm(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Found[Layout]:
    """Solve by 40 particles over (x, y, θ, lx, ly) of every patch, 100 rounds without a budget."""
    low, high = (bound.ravel() for bound in gene_bounds(problem))
    count = min(PARTICLES, budget.steps) if budget.steps else PARTICLES
    first = np.random.default_rng([seed, 1]).uniform(low, high, (count, len(low)))
    rounds = max(budget.steps // count, 1) if budget.steps else None if budget.seconds else ROUNDS
    return over_genes(Swarm(first), problem, budget, seed, progress, cancel, rounds)
