"""Layouts drawn at random: the floor every solver must beat, and the shortest example of one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.encodings.boxes import gene_bounds, to_boxes
from scenewright.energy import energies_of, prepare, route_grid
from scenewright.problem import Problem
from scenewright.solve import Budget, Cancel, Found, Progress, Watch, distinct, run_population

Floats = NDArray[np.float64]
BATCH = 40
ROUNDS = 100


class Bounds(NamedTuple):
    """Least and greatest genes (m,)."""

    low: Floats
    high: Floats


class RandomDraws(NamedTuple):
    """Ask draws ``batch`` genes within the bounds; tell learns nothing."""

    batch: int = BATCH

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> Bounds:  # noqa: ARG002
        """The bounds are all it keeps."""
        return Bounds(low, high)

    def ask(self, state: Bounds, rng: np.random.Generator) -> tuple[Floats, Bounds]:
        """Uniform draws."""
        return rng.uniform(state.low, state.high, (self.batch, len(state.low))), state

    def tell(self, state: Bounds, genes: Floats, energies: Floats) -> Bounds:  # noqa: ARG002
        """Nothing to learn."""
        return state


def random_search(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Found:
    """The best of random layouts; 4000 of them without a budget."""
    n = len(problem.items.low)
    low, high = gene_bounds(problem)
    p, grid = prepare(problem), route_grid(problem, 0.1)
    genes, energies, done = run_population(
        RandomDraws(),
        lambda rows: energies_of(p, grid, to_boxes(rows.reshape(-1, n, 5)))[0],
        low.ravel(),
        high.ravel(),
        np.random.default_rng(seed),
        Watch(budget, progress, cancel),
        None if budget.seconds or budget.steps else ROUNDS,
    )
    return Found(distinct(to_boxes(genes.reshape(-1, n, 5)), energies), done)
