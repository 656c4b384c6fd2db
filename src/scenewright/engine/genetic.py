"""The paper's genetic algorithm (Liu et al. 2017), as ask / tell over a compiled energy.

Real coding, 40 layouts, 100 generations; arithmetic crossover with probability 0.9; mutation
with probability 0.85, of one gene, uniform in its range in the first half, then by a normal step;
the best survives, the others are drawn by roulette on fitness C_max - C.

The paper leaves open what a generation of 40 is made of and how large a step of σ = 0.3 is for a
gene in radians or metres; here parents are paired as drawn, children replace them, and σ shrinks
linearly to nothing, as in the measured baseline.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
POPULATION = 40
GENERATIONS = 100


class Generation(NamedTuple):
    """Genes (P, m) with their energies (P,), their bounds (m,) and the number of generations."""

    genes: Floats
    energies: Floats
    low: Floats
    high: Floats
    age: int


def roulette(energies: Floats, count: int, rng: np.random.Generator) -> NDArray[np.int64]:
    """Indices drawn in proportion to C_max - C; evenly if all are the same.

    ``energies`` (n,); indices (count,).
    """
    fitness = energies.max() - energies
    total = float(fitness.sum())
    if total <= 0.0:
        return rng.integers(0, len(energies), count)
    wheel = fitness.cumsum()
    return wheel.searchsorted(rng.random(count) * wheel[-1], side="right")


def cross(genes: Floats, rate: float, rng: np.random.Generator) -> Floats:
    """Arithmetic crossover of rows 0 and 1, 2 and 3 …: αA + (1 - α)B and αB + (1 - α)A.

    ``genes`` (n, k).
    """
    half = len(genes) // 2
    a, b = genes[0 : 2 * half : 2], genes[1 : 2 * half : 2]
    share = rng.random((half, 1))
    share[rng.random(half) >= rate] = 1.0
    shift = (1.0 - share) * (b - a)
    children = genes.copy()
    children[0 : 2 * half : 2] += shift
    children[1 : 2 * half : 2] -= shift
    return children


class PaperGenetic(NamedTuple):
    """The parameters as printed; ask / tell of
    :class:`scenewright.engine.solve.PopulationSolver`."""

    population: int = POPULATION
    generations: int = GENERATIONS
    crossover: float = 0.9
    mutation: float = 0.85
    step: float = 0.3

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> Generation:  # noqa: ARG002
        """Nothing judged yet."""
        return Generation(np.empty((0, len(low))), np.empty(0), low, high, 0)

    def ask(self, state: Generation, rng: np.random.Generator) -> tuple[Floats, Generation]:
        """The first generation at random, each later one bred from the last; the best stays."""
        if state.age == 0:
            return rng.uniform(state.low, state.high, (self.population, len(state.low))), state
        parents = state.genes[roulette(state.energies, self.population, rng)]
        children = self.mutate(cross(parents, self.crossover, rng), state, rng)
        children[0] = state.genes[state.energies.argmin()]
        return children, state

    def mutate(self, genes: Floats, state: Generation, rng: np.random.Generator) -> Floats:
        """One gene of each mutated row: drawn anew early, moved by a normal step later."""
        rows = (rng.random(len(genes)) < self.mutation).nonzero()[0]
        columns = rng.integers(0, genes.shape[1], len(rows))
        low, high = state.low[columns], state.high[columns]
        if state.age <= self.generations // 2:
            genes[rows, columns] = low + (high - low) * rng.random(len(rows))
        else:
            spread = self.step * max(1.0 - state.age / self.generations, 0.0)
            moved = genes[rows, columns] + rng.normal(0.0, spread, len(rows))
            genes[rows, columns] = np.minimum(np.maximum(moved, low), high)
        return genes

    def tell(self, state: Generation, genes: Floats, energies: Floats) -> Generation:
        """The next generation's parents."""
        return state._replace(genes=genes, energies=energies, age=state.age + 1)
