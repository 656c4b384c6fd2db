"""Halls by a genetic algorithm over the parameters of the patterns, as ask / tell.

Six genes in [0, 1] a unit: pattern, its form, its gaps, x and y in the zone, heading. The operators
are those of :mod:`.genetic`. A layout that breaks hard rules is no energy's business; it costs more
than any that does not, and the more the greater the area by which it breaks them.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.hall.energy import kept_of
from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain, layout_of, stand_at_best
from scenewright.domains.hall.solvers.moves import reseed, wall_angle
from scenewright.domains.hall.solvers.outcome import HallFound, MeasuredLayout
from scenewright.domains.hall.solvers.random_search import whole_energy
from scenewright.domains.hall.terms.place import unfold
from scenewright.domains.hall.terms.state import Kept, PreparedHall, Scratch, State
from scenewright.engine.draws import streams
from scenewright.engine.genetic import GENERATIONS, POPULATION, PaperGenetic
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress, run_population
from scenewright.geometry.boxes import Floats, area_in_polygon, common_area, read_frame
from scenewright.geometry.compiled import compiled

GENES = 6
BROKEN = 1e5
"""Cost of a layout that breaks a hard rule, and of each square metre by which it does."""


@compiled
def decode(p: PreparedHall, s: State, genes: Floats) -> None:
    """Write the patterns and poses that genes (g, 6) stand for."""
    for unit in range(p.spans.shape[0]):
        zone, total = p.zones[unit], 0
        for code in range(p.choices.shape[1]):
            total += p.choices[unit, code]
        rest, chosen = min(int(genes[unit, 0] * total), total - 1), 0
        for code in range(p.choices.shape[1]):
            if p.choices[unit, code]:
                if rest == 0:
                    chosen = code
                rest -= 1
        reseed(p, s, unit, chosen, min(genes[unit, 1], 0.999), 1.5 * genes[unit, 2])
        x, y, b = genes[unit, 3], genes[unit, 4], p.zone_bounds
        if chosen == WALL:
            s.pose[unit, 0], s.pose[unit, 1] = 1000.0 * x, 2.0 * y - 1.0
            continue
        s.pose[unit, 0] = b[zone, 0] + x * (b[zone, 2] - b[zone, 0])
        s.pose[unit, 1] = b[zone, 1] + y * (b[zone, 3] - b[zone, 1])
        angle = wall_angle(p, zone, s.pose[unit, 0], s.pose[unit, 1])
        s.pose[unit, 2] = angle + 0.5 * math.pi * min(int(4.0 * genes[unit, 5]), 3)


@compiled
def violation(p: PreparedHall, s: State, work: Scratch) -> float:
    """Area in square metres by which all objects of a layout break hard rules; a wall row that
    finds no room counts with all its area."""
    total = 0.0
    for unit in range(p.spans.shape[0]):
        first, last = p.spans[unit, 0], p.spans[unit, 1]
        placed, zone = unfold(p, s, work, unit), p.zones[unit]
        edges = p.zone_edges[p.zone_spans[zone, 0] : p.zone_spans[zone, 1]]
        for i in range(first, last):
            frame = read_frame(s.frames, i)
            area = p.sizes[i, 0] * p.sizes[i, 1]
            if not placed:
                total += area
                continue
            total += area - area_in_polygon(frame, edges)
            for solids in (p.obstacles, p.keep_free, s.walls):
                for k in range(solids.shape[0]):
                    if solids[k, 4] > 0.0:
                        total += common_area(frame, read_frame(solids, k))
            for j in range(i):
                total += common_area(frame, read_frame(s.frames, j))
    return total


def evaluate_genes(chain: HallChain, genes: Floats) -> Floats:
    """Costs (P,) of genes (P, m)."""
    costs, units = np.empty(len(genes)), len(chain.p.spans)
    for k, row in enumerate(genes):
        decode(chain.p, chain.s, np.ascontiguousarray(row.reshape(units, GENES)))
        costs[k] = whole_energy(chain)
        if not math.isfinite(costs[k]):
            costs[k] = BROKEN * (1.0 + violation(chain.p, chain.s, chain.work))
    return costs


def genetic_hall(
    problem: HallProblem,
    start: Kept,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> HallFound:
    """Evolve patterns: 40 layouts, 100 generations without a budget. The partitions of ``start``
    stay; it is returned itself if nothing better was bred."""
    watch, chain = (
        BudgetWatch(budget, progress, cancel),
        begin_chain(problem, start, streams(seed, 1)[0]),
    )
    width = len(chain.p.spans) * GENES
    rounds = max(budget.steps // POPULATION, 1) if budget.steps else GENERATIONS
    genes, costs, done = run_population(
        PaperGenetic(generations=rounds),
        lambda rows: evaluate_genes(chain, rows),
        np.zeros(width),
        np.ones(width),
        np.random.default_rng(seed),
        watch,
        lambda row: _layout_of(chain, row),
        None if budget.seconds and not budget.steps else rounds,
    )
    best = start
    if costs[0] < chain.tally[0]:
        best = _decoded(chain, genes[0])
    return Found((layout_of(chain._replace(best=best)),), done)


def _decoded(chain: HallChain, genes: Floats) -> Kept:
    """The meaning of genes (m,)."""
    decode(chain.p, chain.s, np.ascontiguousarray(genes.reshape(-1, GENES)))
    return kept_of(chain.s)


def _layout_of(chain: HallChain, genes: Floats) -> MeasuredLayout:
    """The layout of genes (m,); that of the start while none is better."""
    better = evaluate_genes(chain, genes[None])[0] < chain.tally[0]
    return stand_at_best(chain._replace(best=_decoded(chain, genes)) if better else chain)
