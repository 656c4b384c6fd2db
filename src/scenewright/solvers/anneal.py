"""The default solver: many short annealing chains, then longer ones from the best.

Chains run compiled in :mod:`scenewright.solvers.metropolis`, in slices so that the clock, the
caller's progress and cancelling are heard. Budgets go by successive halving (Jamieson and
Talwalkar 2016): restarts win in small rooms, length in big ones.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.energy import energies_of, prepare, route_grid
from scenewright.geometry.paths import Grid
from scenewright.problem import Problem
from scenewright.solve import Budget, Cancel, Found, Progress, Watch, distinct
from scenewright.solvers.draws import Stream, streams
from scenewright.solvers.metropolis import anneal_chains
from scenewright.terms.assemble import Prepared

Floats = NDArray[np.float64]
SLICE = 16384
SECONDS = 0.1
SAMPLES = 32
PILOT = 16


class Stage(NamedTuple):
    """One stage: how many chains, its share of all steps, and where the schedule starts (0 hot,
    1 cold)."""

    chains: int
    share: float
    first: float


class Chains(NamedTuple):
    """Chains side by side: frames now and at their best (c, n, 8), best energies (c,), streams."""

    frames: Floats
    bests: Floats
    energies: Floats
    draws: Stream


class Heat(NamedTuple):
    """Temperatures at the start and end of the whole schedule."""

    hot: float
    cold: float


class Setup(NamedTuple):
    """What stays the same during a run."""

    p: Prepared
    grid: Grid
    heat: Heat
    watch: Watch
    pool: ThreadPoolExecutor
    threads: int


def plan(steps: int, n: int) -> tuple[Stage, ...]:
    """Stages for a budget of steps: as many chains as leave each enough to settle.

    >>> [stage.chains for stage in plan(200_000, 3)], [stage.chains for stage in plan(200_000, 20)]
    ([32, 8, 2], [2, 1])
    """
    chains = int(np.clip(0.5 * steps / (1000 * n), 1, 32))
    if chains >= 4:
        return (
            Stage(chains, 0.5, 0.0),
            Stage(chains // 4, 0.25, 0.35),
            Stage(max(chains // 16, 1), 0.25, 0.5),
        )
    return (Stage(chains, 0.7, 0.0), Stage(1, 0.3, 0.5)) if chains > 1 else (Stage(1, 1.0, 0.0),)


def _begin(p: Prepared, grid: Grid, count: int, seed: int) -> Chains:
    n = len(p.limits)
    chains = Chains(np.zeros((count, n, 8)), np.zeros((count, n, 8)), np.full(count, np.inf),
                    streams(seed, count))  # fmt: skip
    found = anneal_chains(p, grid, chains.frames, chains.bests, chains.draws, True, 0,
                          1.0, 1.0, 0.0, 1.0)  # fmt: skip
    chains.energies[:] = found
    return chains


def _select(chains: Chains, count: int) -> Chains:
    """The best chains, to go on from their best layouts."""
    chosen = np.argsort(chains.energies, kind="stable")[:count]
    bests = chains.bests[chosen]
    return Chains(bests.copy(), bests, chains.energies[chosen], chains.draws[chosen].copy())


def _advance(setup: Setup, chains: Chains, steps: int, first: float, last: float) -> None:
    """Run every chain on for some steps; the result does not depend on the number of threads."""
    bests = np.empty_like(chains.bests)

    def run(part: slice) -> Floats:
        return anneal_chains(
            setup.p, setup.grid, chains.frames[part], bests[part], chains.draws[part], False,
            steps, setup.heat.hot, setup.heat.cold, first, last,
        )  # fmt: skip

    cuts = np.linspace(0, len(bests), min(setup.threads, len(bests)) + 1).astype(int)
    parts = [slice(int(a), int(b)) for a, b in zip(cuts[:-1], cuts[1:], strict=True)]
    energies = np.concatenate(
        list(setup.pool.map(run, parts) if len(parts) > 1 else map(run, parts))
    )
    better = energies < chains.energies
    chains.energies[better], chains.bests[better] = energies[better], bests[better]


def pace_by_steps(steps: int, most: int) -> Iterator[tuple[int, float]]:
    """Slices of at most ``most`` steps and the share of all steps made after each.

    >>> list(pace_by_steps(10, 4))
    [(4, 0.4), (4, 0.8), (2, 1.0)]
    """
    for made in range(0, steps, most):
        yield min(most, steps - made), min(made + most, steps) / steps


def pace_by_clock(seconds: float, rate: float) -> Iterator[tuple[int, float]]:
    """Twelve slices in the given time, or fewer if they take longer than ``rate`` foretells.

    The share follows the clock, so that a schedule always ends cold and in time.
    """
    begun, made, share = time.perf_counter(), 0, 0.0
    while share < 1.0:
        elapsed = time.perf_counter() - begun
        rate = made / elapsed if made else rate
        share = min(max(share, elapsed / max(seconds, 1e-6)) + 1.0 / 12.0, 1.0)
        steps = max(int(rate * seconds / 12.0), 16)
        made += steps
        yield steps, share


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
        if setup.watch.over(spent, float(chains.energies.min())) and share < 1.0:
            return spent, True
    return spent, setup.watch.over(spent, float(chains.energies.min()))


def _run_stages(setup: Setup, chains: Chains, budget: Budget) -> tuple[list[Chains], int]:
    """All stages; the chains of each as they ended, and the steps spent."""
    begun = time.perf_counter()
    _advance(setup, chains, PILOT, 0.0, 0.0)
    spent = SAMPLES * (PILOT + 1)
    rate = SAMPLES * PILOT / (time.perf_counter() - begun)
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
        if stop:
            break
    return ended, spent


def boxes_of(frames: Floats) -> Floats:
    """Boxes ``(..., n, 5)`` of frames ``(..., n, 8)``, headings in [0, 2π)."""
    boxes = frames[..., [0, 1, 7, 4, 5]] * np.array([1.0, 1.0, 1.0, 2.0, 2.0])
    boxes[..., 2] %= 2.0 * math.pi
    return boxes


def _heat(energies: Floats) -> Heat:
    """From the spread of random layouts' energies."""
    scale = float(np.median(energies) - energies.min()) + 1e-3 * float(abs(energies.min())) + 1e-6
    return Heat(0.2 * scale, 2e-5 * scale)


def anneal(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    threads: int | None = None,
) -> Found:
    """Lay out the items of a problem; several distinct layouts, best first.

    Without a budget it takes 0.1 s. With steps and no seconds the result depends on the seed
    alone.
    """
    if budget.seconds is None and budget.steps is None:
        budget = budget._replace(seconds=SECONDS)
    watch = Watch(budget, progress, cancel)
    p, grid = prepare(problem), route_grid(problem, 0.1)
    chains = _begin(p, grid, SAMPLES, seed)
    threads = threads or min(os.cpu_count() or 1, 16)
    with ThreadPoolExecutor(threads) as pool:
        setup = Setup(p, grid, _heat(chains.energies), watch, pool, threads)
        ended, spent = _run_stages(setup, chains, budget)
    bests = boxes_of(np.concatenate([part.bests for part in ended]))
    return Found(distinct(bests, energies_of(p, grid, bests)), spent)
