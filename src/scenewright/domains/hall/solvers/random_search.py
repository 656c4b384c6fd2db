"""Halls drawn at random: patterns anywhere in their zones, the best kept. What all must beat."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.hall.energy import kept_of
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain, layout_of, stand_at_best
from scenewright.domains.hall.solvers.guided_metropolis import count_missed
from scenewright.domains.hall.solvers.outcome import HallFound, MeasuredLayout
from scenewright.domains.hall.solvers.start import place_units
from scenewright.domains.hall.terms.state import Ints, Kept, PreparedHall
from scenewright.domains.hall.terms.table import REACH
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress

LAYOUTS, TRIES = 1000, 60


def whole_energy(chain: HallChain, limit: float = math.inf) -> float:
    """The energy of the layout a chain's state describes, infinite if it breaks a hard rule; the
    route is left out if the rest is above ``limit`` already."""
    energy = measure_all(chain.p, chain.s, chain.work)
    if energy >= limit or not math.isfinite(energy) or chain.p.weights[REACH] == 0.0:
        return energy
    bits = chain.bits
    ways = count_missed(chain.p, chain.s, chain.grid, bits[0], bits[1], bits[2], chain.inset)
    return energy + float(chain.p.weights[REACH]) * ways


def largest_first(p: PreparedHall) -> Ints:
    """Units (g,) in the order of the floor they ask for."""
    asked = [p.sizes[a:b].prod(1).sum() + p.beta[u] for u, (a, b) in enumerate(p.spans)]
    return np.argsort(-np.array(asked), kind="stable").astype(np.int64)


def random_hall(
    problem: HallProblem,
    start: Kept,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> HallFound:
    """The best of random layouts, of 1000 without a budget; ``start`` is the first of them, and
    its partitions stay. A step is a layout; those that find no room for a unit count as well."""
    watch, stream = BudgetWatch(budget, progress, cancel), streams(seed, 1)[0]
    chain = begin_chain(problem, start, stream)
    best, least, done = start, float(chain.tally[0]), 1
    order, placed = largest_first(chain.p), np.zeros(len(chain.p.spans))
    rounds = budget.steps or (math.inf if budget.seconds else LAYOUTS)

    def layout() -> MeasuredLayout:
        return stand_at_best(chain._replace(best=best))

    while done < rounds and not watch.over(done, least, layout):
        place_units(chain.p, chain.s, chain.work, order, 0, TRIES, True, stream, placed)
        done += 1
        energy = whole_energy(chain, least) if placed.all() else math.inf
        if energy < least:
            best, least = kept_of(chain.s), energy
    return Found((layout_of(chain._replace(best=best)),), done)
