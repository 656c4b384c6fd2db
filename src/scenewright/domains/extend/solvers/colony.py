"""Matrices of plots bred by a genetic algorithm: section 5 and tables of Zhang and Fei (2017).

A generation of 8 is bred from the elites of the one before: blocks of matrices are swapped, each
gene mutates with its chance, then the best of the last generation replaces the worst of the new.
:mod:`.ants` lay out what it starts from.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.extend.printed import Floats, Genes, PlotGrid, allele_values, fitness
from scenewright.engine.trace import Hear, tell

Flags = NDArray[np.bool_]
ELITES = 20
"""Past elites that allele values are taken of."""

FEW = 32
"""Best matrices that are kept of a search."""
ALIKE = 0.95
"""Share of equal genes from which on a population hardly differs."""
HOT = 5e-4
"""F that annealing gives up at the start about as often as not."""


class ColonySettings(NamedTuple):
    """Tables 1 and 2: ants, α and β of (13), ρ of (15) at the start (``local``) and ρ*
    (``overall``), τ₀, weights of two attractors, iterations; q₀ of (18), p₀ of (15), a, b and ρ_min
    of (16) and (17); chances of crossover and of a gene's mutation, the population, generations and
    share of elites. ``printed`` takes (15) to (17) and (23) as printed."""

    ants: int = 300
    alpha: float = 1.5
    beta: float = 4.2
    local: float = 0.5
    overall: float = 0.3
    start: float = 0.05
    pulls: tuple[float, float] = (0.3, 0.7)
    iterations: int = 20
    choice: float = 0.5
    far: float = 0.1
    a: float = 1.0
    b: float = 2.0
    least: float = 0.1
    crossover: float = 0.56
    mutation: float = 0.028
    population: int = 8
    generations: int = 30
    elites: float = 0.4
    printed: bool = True


class BredPlots(NamedTuple):
    """The best matrix (m, n), its fitness, the best after each evaluation, and the best few that
    differ, the best first."""

    genes: Genes
    value: float
    history: tuple[float, ...]
    few: tuple[Genes, ...] = ()


OnPlots = Callable[[float, Genes], bool]
"""Gets the share of the evaluations made and the best matrix; whether to stop."""


class PlotJudge:
    """Counts and keeps the best of what is looked at, up to a number of evaluations; ``on_plots``
    gets how far it is and the best, and may end it."""

    def __init__(
        self, grid: PlotGrid, weights: Floats, most: int, on_plots: OnPlots | None = None
    ) -> None:
        self.grid, self.weights, self.most = grid, weights, most
        self.on_plots, self.stopped = on_plots, False
        self.best = np.zeros(grid.free.shape, np.int64)
        self.value, self.history = -1.0, list[float]()
        self._few = dict[bytes, tuple[float, Genes]]()

    def spent(self) -> bool:
        """Whether as much has been looked at as may be."""
        return self.stopped or len(self.history) >= self.most

    def left(self) -> int:
        """How many more may be looked at."""
        return self.most - len(self.history)

    def reason(self, what: str) -> str:
        """Why it ended, if not for its number of ``what``."""
        return "cancelled" if self.stopped else f"the last of its {what}"

    def rate(self, genes: Genes) -> float:
        """The fitness of a matrix."""
        value = fitness(self.grid, genes, self.weights)
        if value > self.value:
            self.best, self.value = genes.copy(), value
        self.history.append(self.value)
        self._few[genes.tobytes()] = value, genes
        if len(self._few) > 8 * FEW:
            self._few = self._best_few()
        if self.on_plots is not None:
            self.stopped = self.on_plots(len(self.history) / self.most, self.best)
        return value

    def found(self) -> BredPlots:
        """The layouts found."""
        few = tuple(genes for _, genes in self._best_few().values())
        return BredPlots(self.best, self.value, tuple(self.history), few)

    def _best_few(self) -> dict[bytes, tuple[float, Genes]]:
        ranked = sorted(self._few.items(), key=lambda one: -one[1][0])
        return dict(ranked[:FEW])


class PlotBrood(NamedTuple):
    """Children of a generation and what made them: whether the best was searched around
    (``local``), how many were crossed, genes drawn anew (``mutated``) of how many."""

    children: tuple[Genes, ...]
    local: bool
    crossed: int
    mutated: int
    genes: int


def breed(
    grid: PlotGrid,
    weights: Floats,
    evaluations: int | None,
    rng: np.random.Generator,
    settings: ColonySettings | None = None,
    score: Callable[[Genes], float] | None = None,
    on_plots: OnPlots | None = None,
    hear: Hear | None = None,
) -> BredPlots:
    """The genetic algorithm of section 5: blocks of matrices are swapped with chance φ, single
    genes mutate, drawn by their allele value (23); the best replaces the worst; local search once
    the genes of the population hardly differ. Without a number of ``evaluations`` as many
    generations as printed. ``score`` rates in place of F (a person)."""
    chosen = settings or ColonySettings()
    judge = PlotJudge(
        grid, weights, evaluations or chosen.population * chosen.generations, on_plots
    )
    rate = judge.rate if score is None else _both(judge, score)
    people = [draw_plot_matrix(grid, len(grid.areas), rng) for _ in range(chosen.population)]
    values, elites, age = [rate(genes) for genes in people], list[tuple[float, Genes]](), 1
    tell(hear, "begin", 0, method="breeding", settings=chosen, budget=judge.most)
    _tell(hear, age, judge, values, PlotBrood((), False, 0, 0, 0))
    while not judge.spent():
        order, age = np.argsort(values)[::-1], age + 1
        keep = max(round(chosen.elites * len(people)), 1)
        elites = [*((values[k], people[k]) for k in order[:keep].tolist()), *elites][:ELITES]
        parents = [people[k] for k in order[: max(keep, 2)].tolist()]
        brood = _bear(grid, people, parents, elites, chosen, rng)
        best, most = people[int(order[0])], values[int(order[0])]
        people, values = list(brood.children[: judge.left()]), []
        for genes in people:
            values.append(rate(genes))
        worst = int(np.argmin(values))
        people[worst], values[worst] = best, most
        _tell(hear, age, judge, values, brood)
    tell(hear, "stop", age, reason=judge.reason("generations"), evaluations=len(judge.history))
    return judge.found()


def _bear(
    grid: PlotGrid,
    people: list[Genes],
    parents: list[Genes],
    elites: list[tuple[float, Genes]],
    chosen: ColonySettings,
    rng: np.random.Generator,
) -> PlotBrood:
    """The next generation, of parents best first."""
    kinds, many = len(grid.areas), chosen.population
    if np.array([genes == people[0] for genes in people]).mean() > ALIKE:
        around = tuple(step_plots(grid, parents[0], kinds, rng) for _ in range(many))
        return PlotBrood(around, True, 0, 0, 0)
    carriers, fits = np.array([genes for _, genes in elites]), np.array([v for v, _ in elites])
    worth = allele_values(carriers, fits, kinds, chosen.printed)
    children, crossed, mutated = list[Genes](), 0, 0
    for _ in range(many):
        one, other = (parents[k] for k in rng.choice(len(parents), 2).tolist())
        if rng.random() < chosen.crossover:
            one, crossed = swap_blocks(one, other, rng), crossed + 1
        hit = (rng.random(one.shape) < chosen.mutation) & grid.free
        children.append(np.where(grid.free, mutate(one, worth, hit, rng), 0))
        mutated += int(hit.sum())
    return PlotBrood(tuple(children), False, crossed, mutated, many * int(grid.free.sum()))


def _tell(
    hear: Hear | None, age: int, judge: PlotJudge, values: list[float], brood: PlotBrood
) -> None:
    tell(
        hear,
        "generation",
        age,
        stage="local" if brood.local else "global",
        evaluations=len(judge.history),
        population=len(values),
        values=values,
        best=judge.value,
        crossed=brood.crossed,
        mutated=brood.mutated,
        genes=brood.genes,
    )


def _both(judge: PlotJudge, score: Callable[[Genes], float]) -> Callable[[Genes], float]:
    def rate(genes: Genes) -> float:
        judge.rate(genes)
        return score(genes)

    return rate


def draw_plot_matrix(grid: PlotGrid, kinds: int, rng: np.random.Generator) -> Genes:
    """A matrix with about as much built as is wanted."""
    share = grid.wanted / max(float(grid.areas.mean()) * float(grid.free.sum()), 1e-9)
    genes = np.where(rng.random(grid.free.shape) < share, 0, -1)
    genes = np.where(genes == 0, rng.integers(1, kinds + 1, grid.free.shape), 0)
    return np.where(grid.free, genes, 0)


def swap_blocks(one: Genes, other: Genes, rng: np.random.Generator) -> Genes:
    """A matrix with a random block of another.

    >>> none, all_ = np.zeros((3, 3), int), np.ones((3, 3), int)
    >>> child = swap_blocks(none, all_, np.random.default_rng(0))
    >>> rows, columns = child.any(axis=1), child.any(axis=0)
    >>> (child == np.outer(rows, columns)).all().item()
    True
    """
    child = one.copy()
    rows, columns = (np.sort(rng.integers(0, n + 1, 2)) for n in one.shape)
    child[rows[0] : rows[1], columns[0] : columns[1]] = other[
        rows[0] : rows[1], columns[0] : columns[1]
    ]
    return child


def mutate(genes: Genes, worth: Floats, hit: Flags, rng: np.random.Generator) -> Genes:
    """The genes that are ``hit`` (m, n) drawn anew by the values (m, n, k) of their alleles."""
    child = genes.copy()
    for i, j in np.argwhere(hit).tolist():
        weight = worth[i, j] + 0.05
        child[i, j] = int(rng.choice(len(weight), p=weight / weight.sum()))
    return child


def step_plots(grid: PlotGrid, genes: Genes, kinds: int, rng: np.random.Generator) -> Genes:
    """Local search: one free plot changed, or two exchanged."""
    child, free = genes.copy(), np.argwhere(grid.free)
    (i, j), (k, n) = free[rng.integers(len(free), size=2)].tolist()
    if rng.random() < 0.5:
        child[i, j], child[k, n] = child[k, n], child[i, j]
    else:
        child[i, j] = int(rng.integers(kinds + 1))
    return child


def anneal_plots(
    grid: PlotGrid, weights: Floats, evaluations: int, rng: np.random.Generator
) -> BredPlots:
    """For comparison: annealing of the same matrices by the same steps, from :data:`HOT`, which
    gives up about what one step changes, down by the square of what is left."""
    judge = PlotJudge(grid, weights, evaluations)
    kinds = len(grid.areas)
    now = draw_plot_matrix(grid, kinds, rng)
    value = judge.rate(now)
    while not judge.spent():
        heat = HOT * (1 - len(judge.history) / evaluations) ** 2 + 1e-9
        made = step_plots(grid, now, kinds, rng)
        other = judge.rate(made)
        if other >= value or rng.random() < np.exp((other - value) / heat):
            now, value = made, other
    return judge.found()


def climb_plots(
    grid: PlotGrid, weights: Floats, evaluations: int, rng: np.random.Generator
) -> BredPlots:
    """For comparison: greedy steps uphill."""
    judge = PlotJudge(grid, weights, evaluations)
    now = draw_plot_matrix(grid, len(grid.areas), rng)
    value = judge.rate(now)
    while not judge.spent():
        made = step_plots(grid, now, len(grid.areas), rng)
        other = judge.rate(made)
        if other > value:
            now, value = made, other
    return judge.found()


def draw_plots(
    grid: PlotGrid, weights: Floats, evaluations: int, rng: np.random.Generator
) -> BredPlots:
    """For comparison: matrices at random."""
    judge = PlotJudge(grid, weights, evaluations)
    while not judge.spent():
        judge.rate(draw_plot_matrix(grid, len(grid.areas), rng))
    return judge.found()
