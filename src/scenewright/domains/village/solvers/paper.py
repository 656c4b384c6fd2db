"""The method of Zhu, Jiang and Li (2022) as a solver of villages."""

from __future__ import annotations

from functools import partial

import numpy as np

from scenewright.domains.village.grow import layout_of
from scenewright.domains.village.paper.filling import MOST, PaperFilling, fill_as_paper
from scenewright.domains.village.paper.nets_file import PaperNets, shipped_nets
from scenewright.domains.village.problem import VillageFound, VillageLayout, VillageProblem
from scenewright.domains.village.solvers.growing import grow_several
from scenewright.engine.growing import OnGrowth
from scenewright.engine.solve import Budget, Cancel, Progress
from scenewright.engine.trace import Hear


def fill_by_paper(
    problem: VillageProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> VillageFound:
    """Houses by *continue*, *category*, *location*, *orientation* and retrieval, one by one; those
    that no way leads to are taken away. One step is one layout."""
    make = partial(_fill, problem, problem.nets or shipped_nets(), budget.hear)
    return grow_several(problem, make, budget, seed, progress, cancel)


def _fill(
    problem: VillageProblem,
    nets: PaperNets,
    hear: Hear | None,
    rng: np.random.Generator,
    on_growth: OnGrowth,
) -> VillageLayout:
    def goes_on(filled: PaperFilling) -> bool:
        share = len(filled.houses) / max(problem.asked or MOST, 1)
        return not on_growth(share, partial(layout_of, problem, filled.houses, filled.poses))

    found = fill_as_paper(nets, problem, rng, goes_on, hear)
    return layout_of(problem, found.houses, found.poses)
