"""Extensions bred area by area: a genome says how each begins, and what it has more of."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.extend.pattern import GapRules, SourcePattern
from scenewright.domains.extend.presets import PRESETS
from scenewright.domains.extend.problem import ExtendProblem, GrownLayout
from scenewright.domains.extend.solvers.canvas import size_classes
from scenewright.domains.extend.solvers.growing import STARTS, finish, grow_once, read_order
from scenewright.domains.extend.solving import assemble_solution, furnish_area
from scenewright.domains.extend.staging import stage_extension

SPACINGS = (1.0, 1.4, 2.0)
"""Times the least distances of the sources."""
AMOUNTS = (1.0, 0.85, 1.15)
"""Times the ground to be covered, where no number of buildings is asked for."""
FAVOURED, TIMES = 4, 3.0
"""Mixes: that of the sources, then :data:`TIMES` as many small, usual and large buildings."""
CHANCES = 24
EACH = 12
"""Candidates of a later sheet: growing one takes as long as all else of it."""
MOST_AREAS = 8
"""Areas that have genes of their own; all further ones share the last."""


class AreaWish(NamedTuple):
    """How one area is grown: what it begins with, the mix, spacing, amount, and chance."""

    start: int
    mix: int
    spacing: int
    amount: int
    chance: int


def make_breeder(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """Genes of an extension, for each area: what growing begins with, which sizes it has more of,
    times the sources' distances and ground covered, and the draw of chance."""
    areas = plan.detail.areas
    own = min(max(len(areas), 1), MOST_AREAS)
    parts = {
        "start": STARTS,
        "mix": FAVOURED,
        "spacing": len(SPACINGS),
        "amount": len(AMOUNTS),
        "chance": CHANCES,
    }
    genes = tuple(Gene(f"{part} {k + 1}", n) for k in range(own) for part, n in parts.items())
    stage = stage_extension(brief, plan, PRESETS["quick"].settings)
    posed = [one.problem for one in stage.areas]
    orders = [read_order(problem) for problem in posed]

    @cache
    def grown(place: int, wish: AreaWish) -> GrownLayout:
        problem = vary_problem(posed[place], wish)
        rng = np.random.default_rng([seed, wish.chance, place])
        layout = grow_once(problem, orders[place], rng, wish.start)
        return finish(posed[place], orders[place], layout, rng)

    def layouts(genome: Genome) -> list[GrownLayout]:
        wishes = read_genome(genome)
        return [grown(k, wishes[min(k, own - 1)]) for k in range(len(areas))]

    def develop(genome: Genome) -> Solution:
        filled = zip(stage.areas, layouts(genome), strict=True)
        found = [furnish_area(staged, layout, 1) for staged, layout in filled]
        return assemble_solution(stage, found, "quick", "grow", seed, 0.0)

    return Breeder(genes, develop, each=EACH)


def read_genome(genome: Genome) -> list[AreaWish]:
    """How a genome says that each area is to be grown.

    >>> read_genome((1, 0, 2, 0, 7))[0].spacing
    2
    """
    return [AreaWish(*genome[k : k + 5]) for k in range(0, len(genome), 5)]


def vary_problem(problem: ExtendProblem, wish: AreaWish) -> ExtendProblem:
    """The problem of an area as one wishes it: distances, amount and mix."""
    pattern = problem.pattern
    gaps = GapRules(*(SPACINGS[wish.spacing] * gap for gap in pattern.gaps))
    varied = pattern._replace(gaps=gaps, weight=_favour(pattern, wish.mix))
    amount = 1.0 if problem.number is not None else AMOUNTS[wish.amount]
    return problem._replace(pattern=varied, coverage=problem.coverage * amount)


def _favour(pattern: SourcePattern, mix: int) -> np.ndarray:
    """The weights (n,) of the sources' buildings with more of one class of size."""
    if mix == 0:
        return pattern.weight
    more = np.where(size_classes(pattern) == mix - 1, TIMES, 1.0) * pattern.weight
    return np.asarray(more / more.sum() * pattern.weight.sum())
