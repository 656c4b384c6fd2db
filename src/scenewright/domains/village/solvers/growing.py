"""Several layouts of a block grown one after the other, and the best of them."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
import shapely

from scenewright.domains.village.choosing import choose_houses
from scenewright.domains.village.grow import grow, weigh_by_tables
from scenewright.domains.village.house import House
from scenewright.domains.village.learned.surroundings import Surroundings
from scenewright.domains.village.measures import excess_void
from scenewright.domains.village.problem import VillageFound, VillageLayout, VillageProblem
from scenewright.domains.village.standing import Floats, Shapes, StandingHouses, add, place
from scenewright.engine.growing import tell_growth
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress

Making = Callable[..., VillageLayout]
"""Makes a layout of random numbers; ``on_growth`` gets how far it is, and may end it."""
LAYOUTS = 3
"""Layouts grown where no budget is given."""


def grow_block(
    problem: VillageProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> VillageFound:
    """Layouts weighed by the learned net; of those the one that lacks fewest houses and
    leaves the least void beyond the usual. One step is one layout. All are of the same houses, or
    the choice would prefer few and large ones, which leave least missing."""
    make = partial(grow, problem, _choose(problem, seed))
    return grow_several(problem, make, budget, seed, progress, cancel)


def fill_by_tables(
    problem: VillageProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> VillageFound:
    """The same weighed by the tables of single relations."""
    make = partial(grow, problem, _choose(problem, seed), weighing=weigh_by_tables)
    return grow_several(problem, make, budget, seed, progress, cancel)


def fill_unweighed(
    problem: VillageProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> VillageFound:
    """The same with all legal proposals alike."""
    make = partial(grow, problem, _choose(problem, seed), weighing=_alike)
    return grow_several(problem, make, budget, seed, progress, cancel)


def _choose(problem: VillageProblem, seed: int) -> list[int]:
    return choose_houses(problem, np.random.default_rng([seed, 1]))


def _alike(
    problem: VillageProblem, seen: Surroundings, house: House, shapes: Shapes, poses: Floats
) -> Floats:
    del problem, seen, house, shapes
    return np.zeros(len(poses))


def grow_several(
    problem: VillageProblem,
    make: Making,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
) -> VillageFound:
    """Layouts by ``make`` until the budget is spent, the best first."""
    if budget.steps is None and budget.seconds is None:
        budget = budget._replace(steps=LAYOUTS)
    watch = BudgetWatch(budget, progress, cancel)
    rng = np.random.default_rng(seed)
    found: list[VillageLayout] = []
    while True:
        made = make(rng, on_growth=tell_growth(watch, len(found), budget.steps))
        found.append(made._replace(score=rate(problem, made)))
        found.sort(key=lambda layout: layout.score["energy"])
        best = found[0]
        if watch.over(len(found), best.score["energy"], partial(_first, found)):
            return Found(tuple(found), len(found))


def _first(found: list[VillageLayout]) -> VillageLayout:
    return found[0]


def rate(problem: VillageProblem, layout: VillageLayout) -> dict[str, float]:
    """The energy of a layout, 0 at best: houses missing, and voids beyond the usual."""
    standing = standing_of(problem, layout)
    missing = float(layout.asked - len(layout.houses))
    share = excess_void(problem.floor, standing)
    return {"energy": missing + share, "missing": missing, "void": share}


def standing_of(problem: VillageProblem, layout: VillageLayout) -> StandingHouses:
    """All that stands on a block, houses that stay first."""
    standing = problem.fixed
    for number, pose in zip(layout.houses.tolist(), layout.poses, strict=True):
        house = problem.houses[number]
        ring = place(house.outline, pose[None])[0]
        frame = np.array([*pose, *house.extent])
        standing = add(standing, shapely.Polygon(ring), frame, house.size)
    return standing
