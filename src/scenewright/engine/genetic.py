"""The paper's genetic algorithm (Liu et al. 2017), as ask / tell over a compiled energy.

Real coding, 40 layouts, 100 generations; arithmetic crossover with probability 0.9; mutation
with probability 0.85, of one gene, uniform in its range in the first half, then by a normal step.
The best is selected, the others are drawn by roulette on fitness C_max - C; then all are crossed
and mutated, the best too, as algorithm 1 prints it. The answer is the best that ever was.

The paper leaves open what a generation of 40 is made of, and where early ends and late begins;
here parents are paired as drawn, children replace them, and half the generations are early. σ = 0.3
is the same for every gene, in metres or radians, to the end.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.asked import Asked, join, lead_with

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
POPULATION = 40
GENERATIONS = 100


class Generation(NamedTuple):
    """Genes (P, m) with their energies (P,), their bounds (m,), the number of generations, all that
    was asked, the generation that waits to be rated, and how many of its pairs were ``crossed`` and
    of its layouts ``mutated``."""

    genes: Floats
    energies: Floats
    low: Floats
    high: Floats
    age: int
    asked: Asked
    waiting: Floats
    crossed: int = 0
    mutated: int = 0


def roulette(energies: Floats, count: int, rng: np.random.Generator) -> NDArray[np.int64]:
    """Indices drawn in proportion to C_max - C of those rated; evenly if all are the same.

    ``energies`` (n,), infinite where not rated; indices (count,).
    """
    rated = np.isfinite(energies)
    if not rated.any():
        return rng.integers(0, len(energies), count)
    fitness = np.where(rated, energies[rated].max() - energies, 0.0)
    total = float(fitness.sum())
    if total <= 0.0:
        return rated.nonzero()[0][rng.integers(0, int(rated.sum()), count)]
    wheel = fitness.cumsum()
    return wheel.searchsorted(rng.random(count) * wheel[-1], side="right")


def cross(genes: Floats, crossed: Flags, rng: np.random.Generator) -> Floats:
    """Arithmetic crossover of rows 0 and 1, 2 and 3 …: αA + (1 - α)B and αB + (1 - α)A, of the
    pairs that are ``crossed`` (n // 2,).

    ``genes`` (n, k).
    """
    half = len(genes) // 2
    a, b = genes[0 : 2 * half : 2], genes[1 : 2 * half : 2]
    share = rng.random((half, 1))
    share[~crossed] = 1.0
    shift = (1.0 - share) * (b - a)
    children = genes.copy()
    children[0 : 2 * half : 2] += shift
    children[1 : 2 * half : 2] -= shift
    return children


class PaperGenetic(NamedTuple):
    """The parameters as printed, and genes (k, m) to begin with, if any are given as ``parents``;
    ask / tell of :class:`scenewright.engine.solve.PopulationSolver`."""

    population: int = POPULATION
    generations: int = GENERATIONS
    crossover: float = 0.9
    mutation: float = 0.85
    step: float = 0.3
    parents: Floats | None = None

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> Generation:  # noqa: ARG002
        """Nothing judged yet."""
        none = np.empty((0, len(low)))
        return Generation(none, np.empty(0), low, high, 0, Asked(), none)

    def ask(self, state: Generation, rng: np.random.Generator) -> tuple[Floats, Generation]:
        """The first generation at random but for given parents, each later one bred from the best
        and others of the last. Those asked before are known, and not asked again."""
        if state.age == 0:
            drawn = rng.uniform(state.low, state.high, (self.population, len(state.low)))
            children = lead_with(self.parents, drawn, state.low, state.high)
        else:
            others = roulette(state.energies, self.population - 1, rng)
            parents = state.genes[[int(state.energies.argmin()), *others.tolist()]]
            crossed = rng.random(len(parents) // 2) < self.crossover
            mutated = rng.random(len(parents)) < self.mutation
            children = self.mutate(cross(parents, crossed, rng), mutated, state, rng)
            state = state._replace(crossed=int(crossed.sum()), mutated=int(mutated.sum()))
        if state.asked.is_known(children).all():
            children[-1] = rng.uniform(state.low, state.high)
        return state.asked.new_among(children), state._replace(waiting=children)

    def mutate(
        self, genes: Floats, mutated: Flags, state: Generation, rng: np.random.Generator
    ) -> Floats:
        """One gene of each row that is ``mutated``: drawn anew early, moved by a normal step
        later."""
        rows = mutated.nonzero()[0]
        columns = rng.integers(0, genes.shape[1], len(rows))
        low, high = state.low[columns], state.high[columns]
        if state.age <= self.generations // 2:
            genes[rows, columns] = low + (high - low) * rng.random(len(rows))
        else:
            moved = genes[rows, columns] + rng.normal(0.0, self.step, len(rows))
            genes[rows, columns] = np.minimum(np.maximum(moved, low), high)
        return genes

    def tell(self, state: Generation, genes: Floats, energies: Floats) -> Generation:
        """The next generation's parents: what is rated now, and what was known."""
        asked = state.asked.record(genes, energies)
        every = join(state.waiting, genes)
        return state._replace(
            genes=every, energies=asked.energies(every), age=state.age + 1, asked=asked
        )
