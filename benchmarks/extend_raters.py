"""The paper's claim with simulated raters: fewer ratings and generations than SGA and SIGA.

Persons are those of ``bench person`` (hidden tastes over features by ``engine/preference``, things
they like that no feature tells, noise that grows as they tire, a drifting scale, anchoring), here
of matrices of plots. SGA has all eight of a generation rated, SIGA every other one and takes the
rest for what the nearest rated is, the paper's the share of elites and values the rest by alleles
(23); ``taste`` is ours: the same breeding, but of the children only those are rated that the taste
learned from the stars (a Gaussian process of ``engine/preference``) likes best. 0 is the mean by
chance, 1 the best of a search that knows the truth.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.person_raters import SimulatedPerson
from benchmarks.person_world import FIRST, SeenLayout, World
from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.domains.extend.printed import PlotGrid, aims_of, allele_values, fitness_of_alleles
from scenewright.domains.extend.solvers.colony import ColonySettings, mutate, swap_blocks
from scenewright.engine.preference.events import Stars
from scenewright.engine.preference.taste import PersonTaste, judge, learn_taste, measure_scale
from scenewright.workflow.evolution.population import draw_genomes

Floats = NDArray[np.float64]
Record = dict[str, Any]
GENERATIONS, POPULATION, ELITES, REMEMBERED = 30, 8, 3, 20
FEW = max(round(ColonySettings().elites * POPULATION), 1)
"""Layouts of a generation that are rated where the others are valued without."""
CHILDREN = 48
"""Children of a generation that a taste chooses from."""
MARK = 0.2
"""How much of what can be liked counts as converged."""
KNOWING = 2000
"""Layouts that the search which knows the truth looks at."""
METHODS = ("SGA", "SIGA", "the paper's", "taste")
Table = dict[int, tuple[Genome, float]]


class PlotsWorld(NamedTuple):
    """Matrices of plots as a world of persons, the grid, and how a genome reads: allele ``a`` is
    gene a up to the number of kinds, else none."""

    world: World
    grid: PlotGrid


class RatedRun(NamedTuple):
    """Ratings and generations until a fifth is liked (all where it never is), whether it ever was,
    and the satisfaction in the end."""

    ratings: int
    generations: int
    converged: bool
    satisfaction: float


def plots_world(grid: PlotGrid) -> PlotsWorld:
    """The world of a grid: the four aims, how much is built of each kind, and where."""
    kinds = len(grid.areas)
    share = grid.wanted / (float(grid.areas.mean()) * float(grid.free.sum()))
    genes = tuple(Gene(f"plot {k}", round(kinds / share)) for k in range(int(grid.free.sum())))
    known: dict[Genome, SeenLayout] = {}

    def look(genome: Genome) -> SeenLayout:
        if genome not in known:
            known[genome] = SeenLayout(*_see(grid, matrix_of(grid, genome)), 0)
        return known[genome]

    drawn = draw_genomes(genes, 99, FIRST, np.random.default_rng(1))
    values = np.array([look(genome).values for genome in drawn])
    names = [f"feature {k}" for k in range(values.shape[1])]
    world = World("plots", genes, look, measure_scale(names, values), {}, Breeder(genes, _refuse))
    return PlotsWorld(world, grid)


def _refuse(genome: Genome) -> Any:
    """Plots are judged as matrices: no method that is compared on them asks for a scene."""
    raise TypeError(f"plots are not developed into scenes: {genome}")


def matrix_of(grid: PlotGrid, genome: Genome) -> NDArray[np.int64]:
    """The matrix that a genome stands for."""
    made = np.zeros(grid.free.shape, np.int64)
    made[grid.free] = [allele if allele <= len(grid.areas) else 0 for allele in genome]
    return made


def _see(grid: PlotGrid, genes: NDArray[np.int64]) -> tuple[Floats, Floats]:
    built = genes > 0
    middle = grid.middles - grid.middles.reshape(-1, 2).mean(0)
    unit = float(np.abs(middle).max())
    x, y = (middle[..., k] / unit for k in (0, 1))
    shares = [(genes == k + 1).mean() for k in range(len(grid.areas))]
    at = [np.where(built, v, 0.0).sum() / max(built.sum(), 1) for v in (x, y, np.hypot(x, y))]
    beside = [(built[1:] & built[:-1]).mean(), (built[:, 1:] & built[:, :-1]).mean()]
    waves = (np.sin(6 * x + 4 * y), np.sin(5 * y - 2 * x + 1), np.cos(8 * x - 6 * y + 2))
    unseen = [np.where(built, wave, 0.0).mean() for wave in waves]
    return np.array([*aims_of(grid, genes), *shares, *at, *beside]), np.array(unseen)


def rate_with(plots: PlotsWorld, person: SimulatedPerson, method: str, seed: int) -> RatedRun:
    """One person and one method."""
    rng, top = np.random.default_rng([seed, 3]), find_top(plots, person, seed)
    people = draw_genomes(plots.world.genes, 99, POPULATION, rng)
    elites: list[tuple[float, Genome]] = []
    table: Table = {}
    reached, liked = (0, 0), -np.inf
    for generation in range(1, GENERATIONS + 1):
        worth = _worth(plots, elites)
        shown = _choose_shown(plots, method, people, worth, table)
        stars = dict(zip(shown, person.rate([people[k] for k in shown]).tolist(), strict=True))
        for k, value in stars.items():
            table[len(table)] = (people[k], value)
        champion = _rank(plots, table, method)[0]
        liked = person.truth(champion) / top
        if liked >= MARK and not reached[0]:
            reached = len(table), generation
        values = [_value(k, stars, people, worth, method) for k in range(len(people))]
        order = np.argsort(values)[::-1].tolist()
        elites = [*((values[k], people[k]) for k in order[:ELITES]), *elites][:REMEMBERED]
        parents = [people[k] for k in order[: POPULATION // 2]]
        if method == "taste":
            parents = _rank(plots, table, method)[: POPULATION // 2]
        many = CHILDREN if method == "taste" else POPULATION
        flat = method != "the paper's"
        people = [champion, parents[0], *_breed(plots, parents, worth, flat, many - 2, rng)]
    ratings, generations = reached if reached[0] else (len(table), GENERATIONS)
    return RatedRun(ratings, generations, bool(reached[0]), liked)


def find_top(plots: PlotsWorld, person: SimulatedPerson, seed: int) -> float:
    """How much the best is liked that a search finds which knows the truth: greedy steps."""
    rng = np.random.default_rng([seed, 6])
    (now,) = draw_genomes(plots.world.genes, 99, 1, rng)
    best = person.truth(now)
    for _ in range(KNOWING):
        k = int(rng.integers(len(now)))
        allele = int(rng.integers(plots.world.genes[k].alleles))
        made = (*now[:k], allele, *now[k + 1 :])
        if person.truth(made) >= best:
            now, best = made, person.truth(made)
    return best


def _worth(plots: PlotsWorld, elites: list[tuple[float, Genome]]) -> Floats:
    """The value (plots, alleles) of each allele (23) as the elites of the past tell."""
    alleles = plots.world.genes[0].alleles
    if not elites:
        return np.zeros((1, len(plots.world.genes), alleles))
    genes = np.array([genome for _, genome in elites])[:, None]
    return allele_values(genes, np.array([value for value, _ in elites]), alleles - 1)


def _by_alleles(genome: Genome, worth: Floats) -> float:
    genes = np.array(genome)[None]
    return fitness_of_alleles(genes, worth, np.full(genes.shape, 1.0 / genes.size))


def _learn(plots: PlotsWorld, table: Table) -> PersonTaste:
    return learn_taste(
        plots.world.scale,
        [Stars(k, round(value), k // FEW) for k, (_, value) in table.items()],
        {k: plots.world.look(genome).values for k, (genome, _) in table.items()},
        {},
    )


def _rank(plots: PlotsWorld, table: Table, method: str) -> list[Genome]:
    """What was rated, the best first: by stars, of as many the latest; with a taste by that."""
    rows = list(table.values())
    worth = np.array([value for _, value in rows]) + 1e-6 * np.arange(len(rows))
    if method == "taste":
        values = np.array([plots.world.look(genome).values for genome, _ in rows])
        worth = judge(_learn(plots, table), values).mean
    return list(dict.fromkeys(rows[k][0] for k in np.argsort(-worth, kind="stable").tolist()))


def _choose_shown(
    plots: PlotsWorld, method: str, people: list[Genome], worth: Floats, table: Table
) -> list[int]:
    """Which layouts the person rates."""
    if method == "SGA" or not table:
        return list(range(POPULATION))
    if method == "SIGA":
        return list(range(0, POPULATION, 2))
    if method == "the paper's":
        guesses = [_by_alleles(genome, worth) for genome in people]
        return np.argsort(guesses)[::-1][:FEW].tolist()
    taste = _learn(plots, table)
    seen = {genome for genome, _ in table.values()}
    new = [k for k, genome in enumerate(people) if genome not in seen]
    liked = judge(taste, np.array([plots.world.look(people[k]).values for k in new])).mean
    return [new[k] for k in np.argsort(liked)[::-1][:FEW].tolist()]


def _value(
    k: int, stars: dict[int, float], people: list[Genome], worth: Floats, method: str
) -> float:
    """What breeding takes a layout to be worth."""
    if k in stars:
        return stars[k]
    if method == "SIGA":
        mine = np.array(people[k])
        return stars[max(stars, key=lambda n: float((np.array(people[n]) == mine).mean()))] - 0.01
    return _by_alleles(people[k], worth) if method == "the paper's" else 0.0


def _breed(
    plots: PlotsWorld,
    parents: list[Genome],
    worth: Floats,
    flat: bool,
    many: int,
    rng: np.random.Generator,
) -> list[Genome]:
    """Children by blocks of the matrix and single genes, as the paper breeds."""
    free, settings = plots.grid.free, ColonySettings()
    alleles = plots.world.genes[0].alleles
    values = np.zeros((*free.shape, alleles))
    values[free] = np.ones_like(worth[0]) if flat else worth[0]
    made = []
    for _ in range(many):
        a, b = (np.zeros(free.shape, np.int64) for _ in range(2))
        for matrix, k in zip((a, b), rng.integers(len(parents), size=2).tolist(), strict=True):
            matrix[free] = parents[k]
        child = swap_blocks(a, b, rng) if rng.random() < settings.crossover else a
        child = mutate(child, values, rng.random(child.shape) < settings.mutation, rng)
        made.append(tuple(child[free].tolist()))
    return made


def rater_records(grid: PlotGrid, seeds: int) -> Iterator[Record]:
    """Records of all methods over persons."""
    plots = plots_world(grid)
    runs: dict[str, list[RatedRun]] = {name: [] for name in METHODS}
    for seed in range(seeds):
        for name in METHODS:
            person = SimulatedPerson(plots.world, seed)
            runs[name].append(rate_with(plots, person, name, seed))
    for name in METHODS:
        for metric in RatedRun._fields:
            mean, base = (
                float(np.mean([getattr(run, metric) for run in runs[key]])) for key in (name, "SGA")
            )
            yield {
                "case": f"{name} with simulated persons, until a fifth is liked",
                "metric": metric,
                "unit": "1",
                "ours": round(mean, 4),
                "baseline": round(base, 4),
                "baseline_name": "SGA",
                "ratio": round(mean / base, 3) if base else None,
                "runs": seeds,
            }
