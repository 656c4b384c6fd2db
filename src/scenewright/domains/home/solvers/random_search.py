"""Layouts drawn at random: the floor every solver must beat, and the shortest example of one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import Layout
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.over_genes import over_genes
from scenewright.engine.solve import Budget, Cancel, Found, Progress

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
) -> Found[Layout]:
    """The best of random layouts; 4000 of them without a budget."""
    rounds = None if budget.seconds or budget.steps else ROUNDS
    return over_genes(RandomDraws(), problem, budget, seed, progress, cancel, rounds)
