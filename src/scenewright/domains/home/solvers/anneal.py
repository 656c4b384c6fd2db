"""The default solver: many short annealing chains, then longer ones from the best.

Chains run compiled in :mod:`scenewright.domains.home.solvers.metropolis`, in slices so that the
clock, the caller's progress and cancelling are served. Budgets go by successive halving (Jamieson
and Talwalkar 2016): restarts win in small rooms, length in big ones.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import Layout
from scenewright.domains.home.energy import costs_of, empty_layout, energies_of, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.settings import ChainSettings
from scenewright.domains.home.solvers.chain import make_chains
from scenewright.domains.home.solvers.kept_route import make_route
from scenewright.domains.home.solvers.metropolis import REFRESH, run_chains
from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.engine.draws import Stream, streams
from scenewright.engine.pace import pace_by_clock, pace_by_steps
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress, distinct
from scenewright.geometry.boxes import frames_of
from scenewright.geometry.paths import RouteGrid

Floats = NDArray[np.float64]
SLICE, CALL = 16384, 8192
"""Steps of all chains between two reports, and of a call between two looks at cancelling."""


class AnnealingStage(NamedTuple):
    """One stage: how many chains, its share of all steps, and where the schedule starts (0 hot,
    1 cold)."""

    chains: int
    share: float
    first: float


class Chains(NamedTuple):
    """Chains side by side: frames now and at their best (c, n, 8), both energies (c, 2), random
    streams (c, 1)."""

    now: Floats
    bests: Floats
    energies: Floats
    draws: Stream


class Heat(NamedTuple):
    """Temperatures at the start and end of the whole schedule."""

    hot: float
    cold: float


class Setup(NamedTuple):
    """What stays the same during a run."""

    p: PreparedHome
    grid: RouteGrid
    heat: Heat
    watch: BudgetWatch
    pool: ThreadPoolExecutor | None
    threads: int
    settings: ChainSettings


def plan(steps: int, n: int) -> tuple[AnnealingStage, ...]:
    """Stages for a budget of steps: as many chains as leave each enough to settle.

    >>> [stage.chains for stage in plan(200_000, 3)], [stage.chains for stage in plan(200_000, 20)]
    ([32, 8, 2], [2, 1])
    """
    chains = int(min(max(0.5 * steps / max(500 * n, 100 * n * n), 1), 32))
    if chains >= 4:
        return (
            AnnealingStage(chains, 0.5, 0.0),
            AnnealingStage(chains // 4, 0.25, 0.35),
            AnnealingStage(max(chains // 16, 1), 0.25, 0.5),
        )
    return (
        (AnnealingStage(chains, 0.7, 0.0), AnnealingStage(1, 0.3, 0.5))
        if chains > 1
        else (AnnealingStage(1, 1.0, 0.0),)
    )


def scatter_boxes(p: PreparedHome, count: int, rng: np.random.Generator) -> Floats:
    """Boxes ``(count, n, 5)`` drawn anywhere within the bounds, sizes within their limits."""
    shape, low, high = (count, len(p.limits)), p.limits[:, :2], p.limits[:, 2:]
    boxes = np.empty((*shape, 5))
    boxes[..., :2] = p.bounds[:2] + (p.bounds[2:] - p.bounds[:2]) * rng.random((*shape, 2))
    boxes[..., 2] = 2.0 * math.pi * rng.random(shape)
    boxes[..., 3:] = low + (high - low) * rng.random((*shape, 2))
    return boxes


def _begin(p: PreparedHome, grid: RouteGrid, count: int, seed: int) -> Chains:
    boxes = scatter_boxes(p, count, np.random.default_rng(seed))
    frames = frames_of(boxes.reshape(-1, 5)).reshape(count, -1, 8)
    energies = np.repeat(energies_of(p, grid, boxes)[0][:, None], 2, axis=1)
    return Chains(frames, frames.copy(), energies, streams(seed, count))


def _select(chains: Chains, count: int) -> Chains:
    """The best chains, to go on from their best layouts."""
    chosen = np.argsort(chains.energies[:, 1], kind="stable")[:count]
    bests, energies = chains.bests[chosen], chains.energies[chosen]
    energies[:, 0] = energies[:, 1]
    return Chains(bests.copy(), bests, energies, chains.draws[chosen])


def _advance(setup: Setup, chains: Chains, steps: int, first: float, last: float) -> None:
    """Run every chain on for some steps; the result does not depend on the number of threads."""
    schedule = np.array([setup.heat.hot, setup.heat.cold, first, last])
    p, grid, count = setup.p, setup.grid, len(chains.now)

    def run(part: slice) -> None:
        route = make_route(len(p.limits), grid)
        for few, ends in _cut(part, steps):
            if setup.watch.cancelled():
                break
            now = make_chains(chains.now[few], costs_of(p, grid, chains.now[few]))
            some = (chains.bests[few], chains.energies[few], chains.draws[few])
            run_chains(now, p, grid, route, *some, *ends, steps, schedule)

    many = min(setup.threads, count)
    cuts = np.linspace(0, count, many + 1).astype(int).tolist() if many > 1 else [0, count]
    parts = [slice(a, b) for a, b in pairwise(cuts)]
    list(setup.pool.map(run, parts) if setup.pool and len(parts) > 1 else map(run, parts))


def _cut(part: slice, steps: int) -> Iterator[tuple[slice, tuple[int, int]]]:
    """The steps of some chains cut into calls so short that cancelling works at once: chains,
    and the steps (from, to). Sums are renewed where calls begin, so the cuts change nothing."""
    count = max(CALL // min(steps, REFRESH), 1)
    for begin in range(0, steps, REFRESH):
        for first in range(part.start, part.stop, count):
            few = slice(first, min(first + count, part.stop))
            yield few, (begin, min(begin + REFRESH, steps))


def _run_stage(
    setup: Setup, chains: Chains, first: float, pace: Iterable[tuple[int, float]], spent: int
) -> tuple[int, bool]:
    """Anneal all chains of a stage; steps spent so far in the run, and whether to stop it."""
    before = 0.0
    for steps, share in pace:
        _advance(
            setup, chains, steps, first + (1.0 - first) * before, first + (1.0 - first) * share
        )
        before, spent = share, spent + steps * len(chains.energies)
        if _is_over(setup, chains, spent) and share < 1.0:
            return spent, True
    return spent, _is_over(setup, chains, spent)


def _is_over(setup: Setup, chains: Chains, spent: int) -> bool:
    first = int(chains.energies[:, 1].argmin())
    energy = float(chains.energies[first, 1])
    return setup.watch.over(spent, energy, lambda: Layout(boxes_of(chains.bests[first]), energy))


def _run_stages(setup: Setup, chains: Chains, budget: Budget) -> tuple[list[Chains], int]:
    """All stages; the chains of each as they ended, and the steps spent."""
    begun, samples, pilot = time.perf_counter(), setup.settings.samples, setup.settings.pilot
    _advance(setup, chains, pilot, 0.0, 0.0)
    spent = samples * (pilot + 1)
    rate = samples * pilot / (time.perf_counter() - begun)
    left = math.inf if budget.seconds is None else budget.seconds - setup.watch.seconds()
    steps = min(rate * max(left, 0.0), math.inf if budget.steps is None else budget.steps - spent)
    ended = [chains]
    for stage in plan(max(int(steps), 1), len(setup.p.limits)):
        chains = _select(ended[-1], stage.chains)
        ended.append(chains)
        if budget.seconds is None:
            length = max(int(steps * stage.share) // stage.chains, 1)
            pace = pace_by_steps(length, max(SLICE // stage.chains, 512))
        else:
            pace = pace_by_clock(left * stage.share, rate / max(stage.chains, setup.threads))
        spent, stop = _run_stage(setup, chains, stage.first, pace, spent)
        if stop or (budget.seconds is None and have_agreed(chains.energies[:, 1], setup.settings)):
            break
    return ended, spent


def have_agreed(energies: Floats, settings: ChainSettings) -> bool:
    """Whether three of the chains (c,) came to the same lowest energy independently: more work
    would find nothing better, so in small rooms half of it is saved.

    >>> usual = ChainSettings()
    >>> have_agreed(np.array([250.3, 310.0, 250.0, 250.9]), usual)
    True
    >>> have_agreed(np.array([250.0, 250.1]), usual)
    False
    """
    agreed, least = settings.agreed, np.sort(energies)[: settings.agreed]
    alike = settings.alike * abs(least[0])
    return len(least) == agreed and bool(least[-1] - least[0] <= alike)


def boxes_of(frames: Floats) -> Floats:
    """Boxes ``(..., n, 5)`` of frames ``(..., n, 8)``, headings in [0, 2π)."""
    boxes = frames[..., [0, 1, 7, 4, 5]] * np.array([1.0, 1.0, 1.0, 2.0, 2.0])
    boxes[..., 2] %= 2.0 * math.pi
    return boxes


def _heat(energies: Floats, settings: ChainSettings) -> Heat:
    """From the spread of random layouts' energies."""
    ranked, middle = np.sort(energies), len(energies) // 2
    median = float(ranked[middle] + ranked[~middle]) / 2  # of numbers np.median takes far longer
    scale = median - float(ranked[0]) + 1e-3 * float(abs(ranked[0])) + 1e-6
    return Heat(settings.hot * scale, settings.cold * scale)


def anneal(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    threads: int | None = None,
) -> Found[Layout]:
    """Lay out the items of a problem; several distinct layouts, best first.

    Without a budget it takes 0.1 s. With steps and no seconds the result depends on the seed
    alone.
    """
    if budget.seconds is None and budget.steps is None:
        budget = budget._replace(seconds=problem.settings.chains.seconds)
    watch = BudgetWatch(budget, progress, cancel)
    p, grid = prepare(problem), route_grid(problem, 0.1)
    if not len(p.limits):
        return Found((empty_layout(problem),), 1)
    chains = _begin(p, grid, problem.settings.chains.samples, seed)
    threads = threads or budget.threads or min(os.cpu_count() or 1, 16)
    with ThreadPoolExecutor(threads) if threads > 1 else nullcontext() as pool:
        settings = problem.settings.chains
        heat = _heat(chains.energies[:, 0], settings)
        setup = Setup(p, grid, heat, watch, pool, threads, settings)
        ended, spent = _run_stages(setup, chains, budget)
    bests = boxes_of(np.concatenate([part.bests for part in ended]))
    return Found(distinct(bests, energies_of(p, grid, bests)[0]), spent)
