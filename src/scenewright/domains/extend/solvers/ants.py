"""Ants that walk from plot to plot and build: (13) to (19) of Zhang and Fei (2017).

*Printed*: an ant carries its fitness times the mean pheromone of its way; how far it is from the
best ant is p = |τ(best) − τ| / τ(best); where p ≥ p₀, (15) is applied to the trails of its way,
with ρ from table 1 on and evaporating by (16) and (17). Table 1 states ρ*, a factor of global
update, without an equation: here, as Dorigo and Gambardella (1997) have it, the way of the best ant
so far is drawn to its fitness by ρ*. (15) draws the ways of ants *far from the best* to the fitness
of the best, so the repair has none of it: trails evaporate, the best ant of an iteration deposits.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.extend.printed import Floats, Genes, PlotGrid, attract, next_evaporation
from scenewright.domains.extend.solvers.colony import BredPlots, ColonySettings, OnPlots, PlotJudge
from scenewright.engine.trace import Hear, tell

LASTING = 0.1
"""Share of ρ* by which all trails evaporate in an iteration, where repaired."""
BOUNDS = 1e-6, 1e6
"""Between which trails are kept."""


class AntWalks(NamedTuple):
    """Ways of ants: the plots of each in order, the matrices (k, m, n) they built, and the share
    of the steps that went to the best plot instead of one drawn by (18) and (19)."""

    ways: tuple[NDArray[np.int64], ...]
    genes: Genes
    greedy: float


class BestAnt(NamedTuple):
    """The best ant so far: its way and its fitness."""

    way: NDArray[np.int64]
    value: float


def run_ants(
    grid: PlotGrid,
    weights: Floats,
    evaluations: int | None,
    rng: np.random.Generator,
    settings: ColonySettings | None = None,
    on_plots: OnPlots | None = None,
    hear: Hear | None = None,
) -> BredPlots:
    """Ant colony (13) to (19): each ant walks from plot to plot and builds on those it visits,
    until enough is built. Without a number of ``evaluations`` as many ants and iterations as
    printed; with one, fewer ants, and as many iterations as it takes."""
    chosen = settings or ColonySettings()
    most = evaluations or chosen.ants * chosen.iterations
    judge = PlotJudge(grid, weights, most, on_plots)
    plots = grid.middles.reshape(-1, 2)[grid.free.ravel()]
    trails, rate = np.full((len(plots), len(plots)), chosen.start), chosen.local
    sight, best, step = look_ahead(plots, chosen), None, 0
    ants = max(min(chosen.ants, most // chosen.iterations), 1)
    tell(hear, "begin", 0, method="ants", settings=chosen, plots=len(plots), budget=most)
    while not judge.spent():
        step += 1
        walked = walk_ants(grid, plots, trails, sight, chosen, min(ants, judge.left()), rng)
        values = np.array([judge.rate(genes) for genes in walked.genes if not judge.spent()])
        first = int(values.argmax())
        leader = BestAnt(walked.ways[first], float(values[first]))
        best = leader if best is None or leader.value > best.value or not chosen.printed else best
        ways = walked.ways[: len(values)]
        after, far = update_trails(trails, ways, values, best, rate, chosen)
        tell(
            hear,
            "ants",
            step,
            ants=len(values),
            evaluations=len(judge.history),
            values=(values.min(), values.mean(), values.max()),
            best=judge.value,
            far=far,
            rho=rate if chosen.printed else None,
            overall=chosen.overall,
            greedy=walked.greedy,
            moved=int((after != trails).sum()),
            trails=(after.min(), after.mean(), after.max()),
        )
        trails = after
        if chosen.printed:
            rate = min(next_evaporation(rate, step, chosen.a, chosen.b, chosen.least), BOUNDS[1])
    tell(hear, "stop", step, reason=judge.reason("iterations"), evaluations=len(judge.history))
    return judge.found()


def look_ahead(plots: Floats, settings: ColonySettings) -> Floats:
    """η^β with η = 1 / d (13), drawn to two attractors (14): the middle and the first plot."""
    away = np.hypot(*(plots[:, None] - plots[None]).transpose(2, 0, 1))
    np.fill_diagonal(away, np.inf)
    spots = np.zeros((2, 3))
    spots[0, :2], spots[1, :2] = plots.mean(0), plots[0]
    points = np.concatenate([plots, np.zeros((len(plots), 1))], 1)
    pull = attract(points, spots, np.array(settings.pulls), np.array([0.5, 0.5, 0.0]))
    return np.asarray((1.0 / (away + 0.05 * pull[None])) ** settings.beta)


def walk_ants(
    grid: PlotGrid,
    plots: Floats,
    trails: Floats,
    sight: Floats,
    settings: ColonySettings,
    ants: int,
    rng: np.random.Generator,
) -> AntWalks:
    """The ways of some ants, side by side, from plots at random; what each builds is drawn."""
    pull, count, every = trails**settings.alpha * sight, len(plots), np.arange(ants)
    at, area = rng.integers(count, size=ants), np.zeros(ants)
    taken, built = np.zeros((ants, count), np.bool_), np.zeros((ants, count), np.int64)
    ways: list[list[int]] = [[] for _ in range(ants)]
    walking, steps, greedy = np.ones(ants, np.bool_), 0, 0
    while walking.any():
        here = every[walking]
        for ant in here.tolist():
            ways[ant].append(int(at[ant]))
        taken[here, at[here]] = True
        kind = rng.integers(len(grid.areas), size=len(here))
        built[here, at[here]] = kind + 1
        area[here] += grid.areas[kind]
        weight = np.where(taken, 0.0, pull[at])
        total = weight.sum(1)
        walking &= (area < grid.wanted) & (total > 0.0)
        best = rng.random(ants) <= settings.choice
        drawn = (weight.cumsum(1) <= (rng.random(ants) * total)[:, None]).sum(1)
        at = np.where(best, weight.argmax(1), np.minimum(drawn, count - 1))
        steps, greedy = steps + int(walking.sum()), greedy + int((walking & best).sum())
    genes = np.zeros((ants, *grid.free.shape), np.int64)
    genes[:, grid.free] = built
    found = tuple(np.array(way, np.int64) for way in ways)
    return AntWalks(found, genes, greedy / max(steps, 1))


def update_trails(
    trails: Floats,
    ways: tuple[NDArray[np.int64], ...],
    values: Floats,
    best: BestAnt,
    rate: float,
    settings: ColonySettings,
) -> tuple[Floats, int]:
    """Trails (n, n) after an iteration, and how many ants were far from the best. (15), for the
    ways of ants with p ≥ p₀: τ ← (1 − ρ) τ + ρ Fit(best), once for every ant that walked there;
    then the way of the best by ρ*. The repair: all trails evaporate, the best ant deposits.

    >>> flat, ways = np.full((3, 3), 0.05), (np.array([0, 1]), np.array([0, 2]))
    >>> best = BestAnt(ways[0], 0.9)
    >>> after, far = update_trails(flat, ways, np.array([0.9, 0.4]), best, 0.5, ColonySettings())
    >>> far, after[0].round(3).tolist(), float(after[1, 2])
    (1, [0.05, 0.305, 0.475], 0.05)
    """
    found, far = trails.copy(), 0
    if settings.printed:
        carried = np.array([v * _carry(trails, way) for v, way in zip(values, ways, strict=True)])
        leader = best.value * _carry(trails, best.way)
        apart = np.abs(leader - carried) / max(leader, BOUNDS[0]) >= settings.far
        walked, far = _count_walks(len(trails), ways, apart), int(apart.sum())
        left = (1.0 - rate) ** walked
        found = np.where(walked > 0, left * trails + (1.0 - left) * best.value, trails)
    else:
        found *= 1.0 - LASTING * settings.overall
    for a, b in pairwise(best.way.tolist()):
        before = (found if settings.printed else trails)[a, b]
        found[a, b] = found[b, a] = before + settings.overall * (best.value - before)
    return np.asarray(np.clip(found, *BOUNDS)), far


def _carry(trails: Floats, way: NDArray[np.int64]) -> float:
    """The mean pheromone of a way; of a way of one plot that of all."""
    return float(trails[way[:-1], way[1:]].mean() if len(way) > 1 else trails.mean())


def _count_walks(
    plots: int, ways: tuple[NDArray[np.int64], ...], counted: NDArray[np.bool_]
) -> NDArray[np.int64]:
    """How often each trail (n, n) was walked, either way, by the ants that are ``counted``."""
    found = np.zeros((plots, plots), np.int64)
    for way, counts in zip(ways, counted.tolist(), strict=True):
        if counts:
            np.add.at(found, (way[:-1], way[1:]), 1)
    return found + found.T
