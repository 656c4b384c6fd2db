"""The paper's search: ants lay out matrices of plots, a genetic algorithm breeds them.

Equations (13) to (23) and tables 1 and 2 of Zhang and Fei (2017). ``printed`` keeps every equation
as it stands; ``repaired`` has an elite deposit: every iteration the best ant leaves pheromone, for
(15) leaves none where all trails are equal, which they are at the start.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from scenewright.domains.extend.printed import (
    Floats,
    Genes,
    PlotGrid,
    allele_values,
    attract,
    fitness,
    next_evaporation,
)

ELITES = 20
"""Past elites that allele values are taken of."""

HOT = 5e-4
"""F that annealing gives up at the start about as often as not."""


class ColonySettings(NamedTuple):
    """Tables 1 and 2: ants, α and β of (13), evaporation ρ and ρ*, τ₀, weights of two attractors,
    iterations, q₀ of (18), a, b and ρ_min of (16) and (17); chances of crossover and mutation, the
    population, generations and share of elites. ``elite`` is the repair; ``printed`` takes (15)
    to (17) and (23) as printed."""

    ants: int = 300
    alpha: float = 1.5
    beta: float = 4.2
    local: float = 0.5
    evaporation: float = 0.3
    start: float = 0.05
    pulls: tuple[float, float] = (0.3, 0.7)
    iterations: int = 20
    choice: float = 0.5
    a: float = 0.6
    b: float = 1.0
    least: float = 0.1
    crossover: float = 0.56
    mutation: float = 0.028
    population: int = 8
    generations: int = 30
    elites: float = 0.4
    elite: bool = False
    printed: bool = True


class BredPlots(NamedTuple):
    """The best matrix (m, n), its fitness, and the best after each evaluation."""

    genes: Genes
    value: float
    history: tuple[float, ...]


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

    def spent(self) -> bool:
        """Whether as much has been looked at as may be."""
        return self.stopped or len(self.history) >= self.most

    def rate(self, genes: Genes) -> float:
        """The fitness of a matrix."""
        value = fitness(self.grid, genes, self.weights)
        if value > self.value:
            self.best, self.value = genes.copy(), value
        self.history.append(self.value)
        if self.on_plots is not None:
            self.stopped = self.on_plots(len(self.history) / self.most, self.best)
        return value

    def found(self) -> BredPlots:
        """What was found."""
        return BredPlots(self.best, self.value, tuple(self.history))


def run_ants(
    grid: PlotGrid,
    weights: Floats,
    evaluations: int,
    rng: np.random.Generator,
    settings: ColonySettings | None = None,
    on_plots: OnPlots | None = None,
) -> BredPlots:
    """Ant colony (13) to (19): each ant walks from plot to plot and builds on those it visits,
    until enough is built."""
    chosen = settings or ColonySettings()
    judge = PlotJudge(grid, weights, evaluations, on_plots)
    plots = grid.middles.reshape(-1, 2)[grid.free.ravel()]
    count = len(plots)
    trails = np.full((count, count), chosen.start)
    rate = chosen.evaporation
    sight = _sight(plots, chosen)
    for step in range(1, chosen.iterations * 1000):
        ants = max(min(chosen.ants, evaluations // chosen.iterations), 1)
        best: tuple[float, list[int]] | None = None
        for _ in range(ants):
            if judge.spent():
                return judge.found()
            walk, genes = _walk(grid, plots, trails, sight, chosen, rng)
            value = judge.rate(genes)
            if best is None or value > best[0]:
                best = (value, walk)
        if best is None:
            break
        trails = update_trails(trails, best[1], best[0], rate, chosen)
        if chosen.printed:
            rate = min(next_evaporation(rate, step, chosen.a, chosen.b, chosen.least), 1e6)
    return judge.found()


def _sight(plots: Floats, settings: ColonySettings) -> Floats:
    """η^β with η = 1 / d (13), drawn to two attractors (14): the middle and the first plot."""
    away = np.hypot(*(plots[:, None] - plots[None]).transpose(2, 0, 1))
    np.fill_diagonal(away, np.inf)
    spots = np.zeros((2, 3))
    spots[0, :2], spots[1, :2] = plots.mean(0), plots[0]
    points = np.concatenate([plots, np.zeros((len(plots), 1))], 1)
    pull = attract(points, spots, np.array(settings.pulls), np.array([0.5, 0.5, 0.0]))
    return np.asarray((1.0 / (away + 0.05 * pull[None])) ** settings.beta)


def update_trails(
    trails: Floats, walk: list[int], value: float, rate: float, settings: ColonySettings
) -> Floats:
    """(15): τ ← (1 − ρ) τ + ρ Fit(best) on the way of the best ant *where τ differs from the mean*
    (printed: an ant that is far from the best; with equal τ nothing is, and nothing is updated).
    The repair deposits always, and trails evaporate at ρ*.

    >>> flat = np.full((3, 3), 0.05)
    >>> after = update_trails(flat, [0, 1, 2], 0.9, 0.3, ColonySettings())
    >>> bool((after == flat).all())
    True
    >>> repaired = ColonySettings(elite=True, printed=False)
    >>> bool((update_trails(flat, [0, 1, 2], 0.9, 0.3, repaired) == flat).all())
    False
    """
    found = trails.copy()
    mean = float(trails.mean())
    pairs = list(pairwise(walk))
    if not settings.printed:
        found *= 1 - settings.evaporation * 0.1
    for a, b in pairs:
        far = abs(float(trails[a, b]) - mean) > 1e-9
        if settings.elite or far:
            share = min(rate, 1.0) if settings.elite else rate
            found[a, b] = found[b, a] = (1 - share) * trails[a, b] + share * value
    return np.asarray(np.clip(found, 1e-6, 1e6))


def _walk(
    grid: PlotGrid,
    plots: Floats,
    trails: Floats,
    sight: Floats,
    settings: ColonySettings,
    rng: np.random.Generator,
) -> tuple[list[int], Genes]:
    """One ant: plots in order, and the matrix it builds."""
    kinds = len(grid.areas)
    at = int(rng.integers(len(plots)))
    walk, taken, area = [at], np.zeros(len(plots), np.bool_), 0.0
    built = np.zeros(len(plots), np.int64)
    while area < grid.wanted and not taken.all():
        taken[at] = True
        built[at] = 1 + int(rng.integers(kinds))
        area += float(grid.areas[built[at] - 1])
        weight = np.where(taken, 0.0, trails[at] ** settings.alpha * sight[at])
        if weight.sum() <= 0:
            break
        greedy = rng.random() <= settings.choice
        at = (
            int(np.argmax(weight))
            if greedy
            else int(rng.choice(len(weight), p=weight / weight.sum()))
        )
        walk.append(at)
    genes = np.zeros(grid.free.shape, np.int64)
    genes[grid.free] = built
    return walk, genes


def breed(
    grid: PlotGrid,
    weights: Floats,
    evaluations: int,
    rng: np.random.Generator,
    settings: ColonySettings | None = None,
    score: Callable[[Genes], float] | None = None,
    on_plots: OnPlots | None = None,
) -> BredPlots:
    """The genetic algorithm of section 5: blocks of matrices are swapped with chance φ, single
    genes mutate, drawn by their allele value (23); the best replaces the worst; local search once
    the genes of the population hardly differ. ``score`` rates in place of F (a person)."""
    chosen = settings or ColonySettings()
    judge = PlotJudge(grid, weights, evaluations, on_plots)
    rate = judge.rate if score is None else _both(judge, score)
    kinds = len(grid.areas)
    people = [_random(grid, kinds, rng) for _ in range(chosen.population)]
    values = [rate(genes) for genes in people]
    elites: list[tuple[float, Genes]] = []
    while not judge.spent():
        order = np.argsort(values)[::-1]
        keep = max(round(chosen.elites * len(people)), 1)
        elites = [*((values[k], people[k]) for k in order[:keep].tolist()), *elites][:ELITES]
        worth = allele_values(
            np.array([genes for _, genes in elites]),
            np.array([value for value, _ in elites]),
            kinds,
            chosen.printed,
        )
        a, b = (people[k] for k in rng.choice(order[: max(keep, 2)], 2).tolist())
        child = mutate(swap_blocks(a, b, chosen.crossover, rng), worth, chosen.mutation, rng)
        child[~grid.free] = 0
        if np.array([genes == people[0] for genes in people]).mean() > 0.95:
            child = _step(grid, people[int(order[0])], kinds, rng)
        worst = int(order[-1])
        people[worst], values[worst] = child, rate(child)
    return judge.found()


def _both(judge: PlotJudge, score: Callable[[Genes], float]) -> Callable[[Genes], float]:
    def rate(genes: Genes) -> float:
        judge.rate(genes)
        return score(genes)

    return rate


def _random(grid: PlotGrid, kinds: int, rng: np.random.Generator) -> Genes:
    """A matrix with about as much built as is wanted."""
    share = grid.wanted / max(float(grid.areas.mean()) * float(grid.free.sum()), 1e-9)
    genes = np.where(rng.random(grid.free.shape) < share, 0, -1)
    genes = np.where(genes == 0, rng.integers(1, kinds + 1, grid.free.shape), 0)
    return np.where(grid.free, genes, 0)


def swap_blocks(one: Genes, other: Genes, chance: float, rng: np.random.Generator) -> Genes:
    """A matrix with a random block of another, with some chance.

    >>> none, all_ = np.zeros((3, 3), int), np.ones((3, 3), int)
    >>> int(swap_blocks(none, all_, 0.0, np.random.default_rng(0)).sum())
    0
    """
    child = one.copy()
    if rng.random() < chance:
        rows, columns = (np.sort(rng.integers(0, n + 1, 2)) for n in one.shape)
        child[rows[0] : rows[1], columns[0] : columns[1]] = other[
            rows[0] : rows[1], columns[0] : columns[1]
        ]
    return child


def mutate(genes: Genes, worth: Floats, chance: float, rng: np.random.Generator) -> Genes:
    """Single genes drawn anew by the values (m, n, k) of their alleles; at least one."""
    child = genes.copy()
    hit = rng.random(genes.shape) < chance
    if not hit.any():
        hit[int(rng.integers(genes.shape[0])), int(rng.integers(genes.shape[1]))] = True
    for i, j in np.argwhere(hit).tolist():
        weight = worth[i, j] + 0.05
        child[i, j] = int(rng.choice(len(weight), p=weight / weight.sum()))
    return child


def _step(grid: PlotGrid, genes: Genes, kinds: int, rng: np.random.Generator) -> Genes:
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
    now = _random(grid, kinds, rng)
    value = judge.rate(now)
    while not judge.spent():
        heat = HOT * (1 - len(judge.history) / evaluations) ** 2 + 1e-9
        made = _step(grid, now, kinds, rng)
        other = judge.rate(made)
        if other >= value or rng.random() < np.exp((other - value) / heat):
            now, value = made, other
    return judge.found()


def climb_plots(
    grid: PlotGrid, weights: Floats, evaluations: int, rng: np.random.Generator
) -> BredPlots:
    """For comparison: greedy steps uphill."""
    judge = PlotJudge(grid, weights, evaluations)
    now = _random(grid, len(grid.areas), rng)
    value = judge.rate(now)
    while not judge.spent():
        made = _step(grid, now, len(grid.areas), rng)
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
        judge.rate(_random(grid, len(grid.areas), rng))
    return judge.found()
