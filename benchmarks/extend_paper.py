"""The paper's growth measured: searches at equal evaluations, and its claim with simulated raters.

*Searches*: F (22) on the plots of the terrace sample's area after 1,000 evaluations, five seeds
(3,000 and ten with ``--full``).
*Raters*: a person with hidden weights and noise rates layouts; a standard interactive genetic
algorithm (SGA) has every layout rated, SIGA every other one and guesses the rest from the nearest
rated, the paper's has the elite share rated and values the rest by alleles (23). How many ratings
and generations until the person's own score is within 10 % of the best annealing finds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

import scenewright as sw
from scenewright.domains import problems
from scenewright.domains.extend.printed import PlotGrid, allele_values, fitness, fitness_of_alleles
from scenewright.domains.extend.solvers.colony import (
    BredPlots,
    ColonySettings,
    anneal_plots,
    breed,
    climb_plots,
    draw_plots,
    mutate,
    run_ants,
    swap_blocks,
)
from scenewright.domains.extend.solvers.paper import PRINTED, REPAIRED, WEIGHTS, grid_of

Record = dict[str, Any]
EVALUATIONS, SEEDS = 3000, 10
USUAL = (1000, 5)
"""Evaluations and seeds unless ``full``."""
GENERATIONS, POPULATION = 30, 8
NEAR = 0.9
SEARCHES: dict[str, Callable[..., BredPlots]] = {
    "ants, printed": partial(run_ants, settings=PRINTED),
    "ants, elite deposit": partial(run_ants, settings=REPAIRED),
    "breeding, printed": partial(breed, settings=PRINTED),
    "breeding, repaired": partial(breed, settings=REPAIRED),
    "annealing": anneal_plots,
    "greedy": climb_plots,
    "random": draw_plots,
}
METHODS = ("SGA", "SIGA", "the paper's")


def records(
    quick: bool, progress: Callable[[float, str], None] | None = None, full: bool = False
) -> Iterator[Record]:
    """Records of all searches and raters."""
    grid = grid_of(problems(sw.read("sample:extend-terrace"))[0])
    seeds = 2 if quick else SEEDS if full else USUAL[1]
    evaluations = 200 if quick else EVALUATIONS if full else USUAL[0]
    found = {}
    for number, (name, search) in enumerate(SEARCHES.items()):
        runs = [
            search(grid, WEIGHTS, evaluations, np.random.default_rng(seed)) for seed in range(seeds)
        ]
        found[name] = float(np.median([run.value for run in runs]))
        if progress is not None:
            progress(0.7 * (number + 1) / len(SEARCHES), name)
    for name, value in found.items():
        case = f"F after {evaluations} evaluations, {grid.free.sum()} plots"
        yield _record(case, name, value, found["random"], "random", seeds)
    yield from rater_records(grid, seeds)


def rater_records(grid: PlotGrid, seeds: int) -> Iterator[Record]:
    """Ratings and generations of the three interactive methods; those that never come near count
    as 30 generations."""
    told: dict[str, list[tuple[int, int, bool]]] = {name: [] for name in METHODS}
    for seed in range(seeds):
        rng = np.random.default_rng([seed, 7])
        weights = rng.dirichlet(np.full(4, 2.0))
        best = anneal_plots(grid, weights, 2000, rng).value
        for name in METHODS:
            told[name].append(rate_with(grid, weights, best, name, np.random.default_rng(seed)))
    for name in METHODS:
        ratings, generations, near = zip(*told[name], strict=True)
        case = f"{name} with simulated raters, until {NEAR:.0%} of the best"
        base = [row[0] for row in told["SGA"]]
        yield _record(case, "ratings", float(np.mean(ratings)), float(np.mean(base)), "SGA", seeds)
        base = [row[1] for row in told["SGA"]]
        mean = float(np.mean(generations))
        yield _record(case, "generations", mean, float(np.mean(base)), "SGA", seeds)
        yield _record(case, "converged", float(np.mean(near)), None, "", seeds)


def rate_with(
    grid: PlotGrid, weights: np.ndarray, best: float, method: str, rng: np.random.Generator
) -> tuple[int, int, bool]:
    """Ratings, generations and whether a method comes near the best a rater could be shown."""
    kinds, settings = len(grid.areas), ColonySettings(printed=False)
    people = [_some(grid, kinds, rng) for _ in range(POPULATION)]
    elites: list[tuple[float, np.ndarray]] = []
    ratings = 0
    for generation in range(1, GENERATIONS + 1):
        shown = _shown(method, people, elites, kinds)
        rated = {k: fitness(grid, people[k], weights) + float(rng.normal(0, 0.03)) for k in shown}
        ratings += len(rated)
        values = [_value(k, rated, people, elites, kinds, method) for k in range(POPULATION)]
        order = np.argsort(values)[::-1]
        if max(fitness(grid, people[k], weights) for k in shown) >= NEAR * best:
            return ratings, generation, True
        elites = [*((values[k], people[k]) for k in order[:3].tolist()), *elites][:20]
        worth = allele_values(
            np.array([g for _, g in elites]), np.array([v for v, _ in elites]), kinds
        )
        flat = worth if method == "the paper's" else np.ones_like(worth)
        parents = [people[k] for k in order[: POPULATION // 2].tolist()]
        children: list[np.ndarray] = []
        while len(children) < POPULATION - 2:
            a, b = rng.integers(len(parents), size=2)
            child = swap_blocks(parents[a], parents[b], settings.crossover, rng)
            child = mutate(child, flat, settings.mutation, rng)
            children.append(np.where(grid.free, child, 0))
        people = [*parents[:2], *children]
    return ratings, GENERATIONS, False


def _shown(
    method: str, people: list[np.ndarray], elites: list[tuple[float, np.ndarray]], kinds: int
) -> list[int]:
    """Which layouts the person rates."""
    if method == "SGA" or not elites:
        return list(range(POPULATION))
    if method == "SIGA":
        return list(range(0, POPULATION, 2))
    guesses = [_by_alleles(genes, elites, kinds) for genes in people]
    count = max(round(0.4 * POPULATION), 1)
    return np.argsort(guesses)[::-1][:count].tolist()


def _value(
    k: int,
    rated: dict[int, float],
    people: list[np.ndarray],
    elites: list[tuple[float, np.ndarray]],
    kinds: int,
    method: str,
) -> float:
    if k in rated:
        return rated[k]
    if method == "SIGA":
        near = max(rated, key=lambda n: float((people[n] == people[k]).mean()))
        return rated[near] - 0.01
    return _by_alleles(people[k], elites, kinds)


def _by_alleles(genes: np.ndarray, elites: list[tuple[float, np.ndarray]], kinds: int) -> float:
    worth = allele_values(np.array([g for _, g in elites]), np.array([v for v, _ in elites]), kinds)
    return fitness_of_alleles(genes, worth, np.full(genes.shape, 1.0 / genes.size))


def _some(grid: PlotGrid, kinds: int, rng: np.random.Generator) -> np.ndarray:
    share = grid.wanted / max(float(grid.areas.mean()) * float(grid.free.sum()), 1e-9)
    genes = np.where(
        rng.random(grid.free.shape) < share, rng.integers(1, kinds + 1, grid.free.shape), 0
    )
    return np.where(grid.free, genes, 0)


def _record(case: str, metric: str, ours: float, base: float | None, by: str, runs: int) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": round(ours, 4),
        "baseline": None if base is None else round(base, 4),
        "baseline_name": by,
        "ratio": None if not base else round(ours / base, 3),
        "runs": runs,
    }
