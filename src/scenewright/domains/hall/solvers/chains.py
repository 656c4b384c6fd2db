"""Solvers of halls by chains: the paper's GD-MH, and ours: several annealed chains, best kept.

A run starts from a layout in which every unit found a place (:func:`begin_chain`); units that
find none are named, for the domain to split or leave out.
"""

from __future__ import annotations

import os
import time
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.energy import kept_of, make_state, prepare, route_grid
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.solvers.guided_metropolis import bring_back, count_missed, run
from scenewright.domains.hall.solvers.outcome import HallFound, MeasuredLayout, lacking
from scenewright.domains.hall.solvers.printed_metropolis import run_printed
from scenewright.domains.hall.solvers.start import copy_frames, leave_refused_walls, place_units
from scenewright.domains.hall.terms.place import build
from scenewright.domains.hall.terms.state import Kept, PreparedHall, Scratch, State, make_scratch
from scenewright.domains.hall.terms.table import HALL_TERMS, PRINTED, REACH
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import Stream, streams
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress
from scenewright.engine.trace import tell
from scenewright.geometry.flood import Bits
from scenewright.geometry.paths import RouteGrid

SLICE, MOST = 256, 512
"""Steps of a chain between two reports: at first, and at most where the steps are stated."""
TOLD = 50
"""Iterations of the paper's chain told at once."""
BREATH = 0.05
"""Seconds between two reports at most."""


class HallChain(NamedTuple):
    """One chain with all it needs; ``tally`` (5,) energy now, of the route in it, of the best,
    moves accepted, energy of ``last``, the layout last looked at whole; ``best`` the best."""

    problem: HallProblem
    p: PreparedHall
    s: State
    work: Scratch
    grid: RouteGrid
    bits: Bits
    inset: Floats
    stream: Stream
    tally: Floats
    last: Kept
    best: Kept


def first_layout(
    problem: HallProblem, walls: Floats, seed: int, tries: int | None = None
) -> tuple[Kept, tuple[int, ...]]:
    """A layout without overlap, of finite energy unless units are lost, and the units that found
    no place in it: wall rows first, which can stand nowhere else, then the largest. ``walls``
    (p, 2) are the partitions to start with, less those that may not stand there; ``tries`` is how
    often a place is drawn for each unit (what the settings say)."""
    tries = problem.settings.chains.tries if tries is None else tries
    p = prepare(problem)
    s, work = make_state(p), make_scratch(p)
    s.partitions[:] = walls
    for host in range(len(walls)):
        build(p, s, host)
    leave_refused_walls(p, s)
    need = np.array([p.sizes[a:b].prod(1).sum() + p.beta[u] for u, (a, b) in enumerate(p.spans)])
    order = np.lexsort([-need, -p.wall_bound]).astype(np.int64)
    placed = np.zeros(len(need))
    place_units(p, s, work, order, 0, tries, True, streams(seed, 1)[0], placed)
    start, lost = kept_of(s), tuple(int(u) for u in order if not placed[u])
    return start, lost or _find_refused(p, s, work, start)


def _find_refused(p: PreparedHall, s: State, work: Scratch, start: Kept) -> tuple[int, ...]:
    """The units of a layout that break a hard rule beside those before them; none where its energy
    is finite."""
    if np.isfinite(bring_back(p, s, work, start)):
        return ()
    order, placed = np.arange(len(p.spans)), np.zeros(len(p.spans))
    place_units(p, s, work, order, len(order), 0, False, streams(0, 1)[0], placed)
    return tuple(np.flatnonzero(placed == 0.0).tolist())


def begin_chain(problem: HallProblem, start: Kept, stream: Stream) -> HallChain:
    """A chain that stands at a layout."""
    p = prepare(problem)
    s, work, grid = make_state(p), make_scratch(p), route_grid(problem, p)
    bits, inset = np.zeros((3, *grid.free.shape), np.uint64), np.zeros((len(p.sizes), 4))
    last, best = (Kept(*(array.copy() for array in start)) for _ in range(2))
    energy = bring_back(p, s, work, start)
    ways = p.weights[REACH] * count_missed(p, s, grid, bits[0], bits[1], bits[2], inset)
    tally = np.array([energy + ways, ways, energy + ways, 0.0, 0.0])
    return HallChain(problem, p, s, work, grid, bits, inset, stream, tally, last, best)


def advance(chain: HallChain, schedule: Floats, first: int, steps: int) -> None:
    """Run a chain on; energies are measured afresh before, so that no rounding adds up."""
    bare = measure_all(chain.p, chain.s, chain.work)
    chain.tally[0] = bare + chain.tally[1]
    run(
        chain.p,
        chain.s,
        chain.work,
        chain.grid,
        chain.bits,
        chain.inset,
        chain.stream,
        chain.tally,
        schedule,
        chain.problem.settings.moves,
        first,
        steps,
        chain.last,
        chain.best,
    )


def layout_of(chain: HallChain) -> MeasuredLayout:
    """The best layout of a chain, measured afresh."""
    energy = bring_back(chain.p, chain.s, chain.work, chain.best)
    count = count_missed(
        chain.p, chain.s, chain.grid, chain.bits[0], chain.bits[1], chain.bits[2], chain.inset
    )
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    total = energy + chain.p.weights[REACH] * count
    return MeasuredLayout(kept_of(chain.s), boxes, total, count, lacking(chain.p, chain.s))


def _advance_printed(
    chain: HallChain, schedule: Floats, stuck: Ints, first: int, steps: int
) -> None:
    """Run a chain on by the printed guidance; energies are measured afresh before."""
    chain.tally[0] = measure_all(chain.p, chain.s, chain.work) + chain.tally[1]
    run_printed(
        chain.p,
        chain.s,
        chain.work,
        chain.grid,
        chain.bits,
        chain.inset,
        chain.stream,
        chain.tally,
        schedule,
        chain.problem.settings.guided,
        stuck,
        first,
        steps,
        chain.last,
        chain.best,
    )


def gd_mh(
    problem: HallProblem,
    start: Kept,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> HallFound:
    """GD-MH as printed (:mod:`.printed_metropolis`): one chain, λ = 0.1, 1000 iterations.

    The paper keeps the last state; this keeps the best on the way, which is never worse.
    """
    watch = BudgetWatch(budget, progress, cancel)
    steps = budget.steps or problem.settings.guided.steps
    chain = begin_chain(problem, start, streams(seed, 1)[0])
    rate = problem.settings.guided.rate
    schedule = np.array([rate, rate, float(steps), 0.0])
    made, stuck, block = 0, np.zeros(len(chain.p.spans), np.int64), 0
    weights = {row.name: float(chain.p.weights[row.number]) for row in HALL_TERMS}
    named = {name: weight for name, weight in weights.items() if weight}
    tell(budget.hear, "begin", 0, settings=problem.settings.guided, weights=named, budget=steps)
    while made < steps and not _is_over(watch, [chain], made):
        length = min(TOLD, steps - made)
        _advance_printed(chain, schedule, stuck, made, length)
        made, block = made + length, block + 1
        tell_chain(budget, chain, block, made, steps)
    reason = "the last iteration" if made >= steps else "cancelled, or out of time"
    tell(budget.hear, "stop", block, reason=reason, iterations=made)
    return Found((layout_of(chain),), max(made, 1))


def tell_chain(budget: Budget, chain: HallChain, block: int, made: int, steps: int) -> None:
    """Tell a block of iterations of the paper's chain: iterations and acceptances so far, the
    energy of its layout now and of its best, the four energies now as measured, the greatest step
    in metres, and the partitions that stand."""
    if budget.hear is None:
        return
    measured = {row.name: chain.s.costs[row.number] for row in HALL_TERMS if row.name in PRINTED}
    tell(
        budget.hear,
        "iterations",
        block,
        iterations=made,
        accepted=int(chain.tally[3]),
        energy=chain.tally[0],
        best=chain.tally[2],
        step=max(1.0 - (made - 1) / steps, 0.5),
        walls=int((chain.s.partitions[:, 1] > chain.s.partitions[:, 0]).sum()),
        **{name: float(costs[np.isfinite(costs)].sum()) for name, costs in measured.items()},
    )


def anneal_hall(
    problem: HallProblem,
    start: Kept,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> HallFound:
    """Several chains, λ rising geometrically; then the better half goes on, cold.

    Chains run on all threads; without ``seconds`` the result depends on the seed alone.
    """
    settings = problem.settings.chains
    if budget.seconds is None and budget.steps is None:
        budget = budget._replace(seconds=settings.seconds)
    watch = BudgetWatch(budget, progress, cancel)
    threads = min(budget.threads or os.cpu_count() or 1, settings.chains)
    starts = _starts(problem, start, seed)
    chains = [
        begin_chain(problem, first, stream)
        for first, stream in zip(starts, streams(seed, settings.chains), strict=True)
    ]
    made = 0
    with ThreadPoolExecutor(threads) as pool:
        half = max(settings.chains // 2, 1)
        for first, share, kept in ((0.0, 0.6, settings.chains), (0.45, 1.0, half)):
            chains = sorted(chains, key=lambda c: float(c.tally[2]))[:kept]
            if first:
                chains = [_restart_from_best(problem, chain) for chain in chains]
            made += _stage(chains, pool, watch, first, share, made)
    found = sorted((layout_of(chain) for chain in chains), key=lambda layout: layout.energy)
    return Found(tuple(found), made)


def cooled_hall(
    problem: HallProblem,
    start: Kept,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> HallFound:
    """Two chains from a layout that is good already, annealed from the middle of the schedule."""
    watch = BudgetWatch(budget, progress, cancel)
    settings = problem.settings.chains
    half = max(settings.chains // 2, 1)
    chains = [begin_chain(problem, start, stream) for stream in streams(seed, half)]
    threads = min(budget.threads or os.cpu_count() or 1, len(chains))
    with ThreadPoolExecutor(threads) as pool:
        made = _stage(chains, pool, watch, settings.tepid, 1.0, 0)
    found = sorted((layout_of(chain) for chain in chains), key=lambda layout: layout.energy)
    return Found(tuple(found), made)


def _starts(problem: HallProblem, start: Kept, seed: int) -> list[Kept]:
    """A first layout for every chain: the given one, and others where they hold as much; only
    the given one in halls so large that finding one takes longer than improving it."""
    count = problem.settings.chains.chains
    if len(problem.names) > problem.settings.chains.many:
        return [start] * count
    found = [start]
    for k in range(1, count):
        other, lost = first_layout(problem, start.walls, seed + 7919 * k)
        found.append(start if lost else other)
    return found


def _restart_from_best(problem: HallProblem, chain: HallChain) -> HallChain:
    """A chain that goes on from its best layout."""
    return begin_chain(problem, chain.best, chain.stream)


def _is_over(watch: BudgetWatch, chains: list[HallChain], made: int) -> bool:
    """Report the best of some chains; true if the run should end."""
    first = min(chains, key=lambda chain: float(chain.tally[2]))
    return watch.over(made, float(first.tally[2]), lambda: stand_at_best(first))


def stand_at_best(chain: HallChain) -> MeasuredLayout:
    """The best layout of a chain that goes on: measured by a chain of its own."""
    return layout_of(begin_chain(chain.problem, chain.best, chain.stream))


def _stage(
    chains: list[HallChain],
    pool: ThreadPoolExecutor,
    watch: BudgetWatch,
    first: float,
    until: float,
    before: int,
) -> int:
    """Anneal chains side by side until a share of the budget is spent; the steps made.

    The schedule is a hundredth at a time, each as many steps as the clock (or the number of
    steps) leaves.
    """
    made, share = 0, watch.share(before)
    begun, opened = time.perf_counter(), share
    parts = 1_000_000
    settings = chains[0].problem.settings.chains
    schedule = np.array([settings.low, settings.high, float(parts), settings.free])
    steps = SLICE
    if watch.budget.steps is not None:
        steps = int(np.clip(watch.budget.steps // 400, 16, MOST))
    while share < until:
        done = (share - opened) / max(until - opened, 1e-9)
        at = int(parts * (first + (1.0 - first) * min(done, 0.999)))
        list(pool.map(partial(advance, schedule=schedule, first=at, steps=steps), chains))
        made += steps * len(chains)
        if _is_over(watch, chains, before + made):
            break
        share = watch.share(before + made)
        if watch.budget.steps is None:
            rate = steps / max(time.perf_counter() - begun, 1e-6)
            begun = time.perf_counter()
            left = min(max((watch.budget.seconds or 0.0) / 60.0, 1e-3), BREATH)
            steps = int(np.clip(rate * left, 16, 100_000))
    return made
