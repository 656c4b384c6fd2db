"""Sites by annealing over boxes, as the paper's local templates and its comparison "SA".

Kirkpatrick, Gelatt, Vecchi 1983. A move looks only at the building that moved and its
neighbours. The energy is the repaired sum, or f_cost of (6) with the ratio (5) where the problem's
form is ``printed``. Buildings may overlap on the way; what still cannot stand in the end is left
out."""

from __future__ import annotations

import math
import time
from itertools import pairwise

import numpy as np

from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.settings import BuildingMoveSettings
from scenewright.domains.site.solvers.answer import Measure, answer, make_measure, stand
from scenewright.domains.site.solvers.moves import propose
from scenewright.domains.site.solvers.outcome import SiteFound
from scenewright.domains.site.solvers.random_search import drop_buildings, lines_of
from scenewright.domains.site.terms.measure import (
    SitePrepared,
    SiteState,
    change,
    change_of_fitness,
    commit,
    energy_of,
    fitness,
    lay,
)
from scenewright.engine.draws import Stream, below, streams, uniform
from scenewright.engine.pace import pace_by_clock, pace_by_steps
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Progress
from scenewright.geometry.compiled import compiled

SLICE = 20_000
PILOT = 500


@compiled
def run_site_chain(
    p: SitePrepared,
    s: SiteState,
    lines: Floats,
    schedule: Floats,
    steps: int,
    stream: Stream,
    best: Floats,
    tally: Floats,
) -> None:
    """Anneal the layout a state holds by ``steps`` moves. Temperature falls geometrically over a
    schedule (12,): hot and cold end, where this part starts and stops (0 to 1), E_max of (6) if
    the energy is -f_cost as printed (0: our sum), and how moves are drawn. ``tally`` (2,) energy
    now and of the best, whose frames are kept in ``best`` (n, 8)."""
    n, temperature, heat = s.frames.shape[0], schedule[0], 1.0
    for step in range(steps):
        if step % 32 == 0:
            share = schedule[2] + (schedule[3] - schedule[2]) * step / steps
            temperature = schedule[0] * (schedule[1] / schedule[0]) ** share
            heat = 1.0 - share
        i = below(stream, n)
        frame = propose(p, s, i, heat, lines, schedule[5:], stream)
        if schedule[4] > 0.0:
            more = change_of_fitness(p, s, i, frame, schedule[4])
        else:
            more = change(p, s, i, frame)
        if more > -temperature * math.log(1.0 - uniform(stream)):
            continue
        commit(p, s, i, frame)
        tally[0] += more
        if tally[0] < tally[1] - 1e-9:
            tally[1] = tally[0]
            for row in range(n):
                for k in range(8):
                    best[row, k] = s.frames[row, k]


def boxes_of_frames(frames: Floats) -> Floats:
    """Boxes (n, 5) of frames (n, 8)."""
    boxes: Floats = frames[:, [0, 1, 7, 4, 5]] * np.array([1.0, 1.0, 1.0, 2.0, 2.0])
    return boxes


def anneal_from(
    problem: SiteProblem,
    start: Floats,
    budget: Budget,
    seed: int,
    watch: BudgetWatch,
    lines: Floats,
    first: float = 0.0,
) -> tuple[Floats, int]:
    """Anneal boxes (n, 5), of no width: left out; the best (n, 5) and the moves made.
    ``first`` is where its schedule starts, from 0 hot to 1 cold."""
    measure, stream, rule = make_measure(problem), streams(seed, 1)[0], problem.settings.chain
    lay(measure.p, measure.s, np.ascontiguousarray(start))
    most_cost = rule.most if problem.form == "printed" else 0.0
    energy = energy_of(measure.p, measure.s)
    if most_cost:
        energy = -fitness(measure.p, measure.s, most_cost, 0.0)
    tally, best = np.array([energy, energy]), measure.s.frames.copy()
    if not len(problem.ground.block_areas) or not len(start):
        return start, 1
    most = budget.steps or (10**12 if budget.seconds else rule.moves * len(start))
    if budget.seconds:
        rate = _rate(measure, lines, rule.drawn, stream, best)
        pace = pace_by_clock(max(budget.seconds - watch.seconds(), 0.01), rate)
    else:
        pace = pace_by_steps(most, SLICE)
    before, done = 0.0, 0
    for steps, share in pace:
        wanted = min(steps, most - done)
        ends = np.append(np.arange(0, wanted, SLICE), wanted)
        for begin, end in pairwise(ends.tolist()):
            part = before + (share - before) * np.array([begin, end]) / steps
            ways = *(first + (1.0 - first) * part), most_cost, *rule.drawn
            schedule = np.array([rule.hot, rule.cold, *ways])
            run_site_chain(measure.p, measure.s, lines, schedule, end - begin, stream, best, tally)
            done += end - begin
            if watch.over(done, float(tally[1]), lambda: stand(problem, boxes_of_frames(best))):
                return boxes_of_frames(best), done
        before = share
    return boxes_of_frames(best), done


def _rate(
    measure: Measure, lines: Floats, drawn: BuildingMoveSettings, stream: Stream, best: Floats
) -> float:
    """Moves a second, by making a few that cannot be accepted."""
    schedule, tally = np.array([1e-300, 1e-300, 0.0, 0.0, 0.0, *drawn]), np.array([0.0, -math.inf])
    run_site_chain(measure.p, measure.s, lines, schedule, 1, stream, best, tally)
    begun = time.perf_counter()
    run_site_chain(measure.p, measure.s, lines, schedule, PILOT, stream, best, tally)
    return PILOT / max(time.perf_counter() - begun, 1e-6)


def _anneal(
    problem: SiteProblem,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
    free: bool,
) -> SiteFound:
    watch, lines = BudgetWatch(budget, progress, cancel), lines_of(problem, free)
    measure, stream = make_measure(problem), streams(seed, 2)[1]
    boxes = np.zeros((len(problem.buildings.sizes), 5))
    order = np.argsort(-problem.buildings.sizes[:, :2].prod(1), kind="stable")
    drop_buildings(measure.p, measure.s, order, problem.settings.random.tries, lines, stream, boxes)
    boxes, done = anneal_from(problem, boxes, budget, seed, watch, lines)
    return answer(problem, boxes, done, 0)


def anneal_site(
    problem: SiteProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """Anneal with four headings; a step is a move, 4000 a building without a budget."""
    return _anneal(problem, budget, seed, progress, cancel, False)


def anneal_site_free(
    problem: SiteProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """Anneal with any heading."""
    return _anneal(problem, budget, seed, progress, cancel, True)
