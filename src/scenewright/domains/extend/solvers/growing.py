"""Ours: several layouts grown one after the other, and the best of them."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.extend.prepared import prepare_sources
from scenewright.domains.extend.problem import ExtendFound, ExtendProblem, GrownLayout
from scenewright.domains.extend.rating import rate_layout
from scenewright.domains.extend.solvers.anneal import anneal
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.continued_rows import (
    RowsToContinue,
    continue_rows,
    read_rows,
)
from scenewright.domains.extend.solvers.edges import EdgeGround, lay_edges, read_edges
from scenewright.domains.extend.solvers.fronts import turn_fronts
from scenewright.domains.extend.solvers.laid_rows import lay_rows
from scenewright.domains.extend.solvers.neighbours import grow_neighbours
from scenewright.domains.extend.solvers.patches import lay_patch
from scenewright.domains.extend.solvers.repair import repair_coverage, take_away
from scenewright.domains.extend.solvers.settling import SettlingRules, read_settling, settle
from scenewright.engine.growing import OnGrowth, tell_growth
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress, Report

LAYOUTS = 4
"""Layouts grown where no budget is given."""
BUILDINGS, MOST_LAYOUTS = 60.0, 6
"""Buildings of the layouts of one step together, and layouts of one step at most."""
STARTS = 6
"""Ways in which a layout begins: with neighbours, edges or a patch, and together."""
ANNEALED, MOST_TIMES = 60.0, 8.0
"""Buildings below which a layout is annealed by more moves, and times as many at most."""
POLISHED = 2
"""Layouts that are annealed where they are small."""
ROUNDS = 12
"""Times that growing is taken up again from a patch laid in what is left."""


def grow_area(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """Layouts grown one after the other; of those the one of least energy. One step is one
    layout, or several where the area is small: about :data:`BUILDINGS` together."""
    if budget.steps is None and budget.seconds is None:
        budget = budget._replace(steps=LAYOUTS)
    watch = BudgetWatch(budget, progress, cancel)
    found: list[GrownLayout] = []
    problem = problem if problem.prepared else prepare_sources(problem)
    order = read_order(problem)
    steps, each = 0, layouts_of_step(problem)
    whole = None if budget.steps is None else budget.steps * each
    while True:
        for number in range(steps * each, (steps + 1) * each):
            if found and cancel is not None and cancel():
                break
            rng = np.random.default_rng([seed, number])
            made = grow_once(problem, order, rng, number, tell_growth(watch, len(found), whole))
            if found and watch.cancelled():
                break
            found.append(rate_layout(problem, turn_fronts(problem, made)))
        found.sort(key=lambda layout: layout.score["energy"])
        steps += 1
        if watch.over(steps, found[0].score["energy"], partial(_first, found)):
            if watch.cancelled():
                return Found(tuple(found), len(found))
            hear = partial(_tell, progress, found[0].score["energy"])
            best = [
                polish(
                    problem, layout, np.random.default_rng([seed, 1, 1 + k]), watch.cancelled, hear
                )
                for k, layout in enumerate(found[: 1 if each == 1 else POLISHED])
            ]
            best.sort(key=lambda layout: layout.score["energy"])
            settled = finish(problem, order, best[0], np.random.default_rng([seed, 2]))
            return Found((settled, *found), len(found))


def finish(
    problem: ExtendProblem, order: SourceOrder, layout: GrownLayout, rng: np.random.Generator
) -> GrownLayout:
    """The layout with its buildings settled, rated."""
    return rate_layout(problem, settle(problem, order.settling, layout, rng))


def layouts_of_step(problem: ExtendProblem) -> int:
    """How many layouts are one step."""
    return int(np.clip(round(BUILDINGS / max(expected_count(problem), 1.0)), 1, MOST_LAYOUTS))


def expected_count(problem: ExtendProblem) -> float:
    """About how many buildings the area will hold."""
    if problem.number is not None:
        return float(problem.number)
    pattern = problem.pattern
    area = float(np.average(np.asarray(shapely.area(pattern.shapes)), weights=pattern.weight))
    return problem.coverage * problem.outline.area / max(area, 1.0)


def _tell(progress: Progress | None, energy: float, layout: GrownLayout) -> None:
    """Show a layout that is being annealed, while the search is over."""
    if progress is not None:
        progress(Report(1.0, energy, lambda: layout))


def _first(found: list[GrownLayout]) -> GrownLayout:
    return found[0]


class SourceOrder(NamedTuple):
    """What growing goes on with in every layout of an area: rows, buildings along edges, and how
    the buildings are settled at the end."""

    rows: RowsToContinue
    edges: tuple[EdgeGround, ...]
    settling: SettlingRules


def read_order(problem: ExtendProblem) -> SourceOrder:
    """The order of the sources of a problem. It stays right for another weight or coverage."""
    edges = read_edges(problem) if problem.settings.edges else ()
    return SourceOrder(read_rows(problem), edges, read_settling(problem))


def grow_once(
    problem: ExtendProblem,
    order: SourceOrder,
    rng: np.random.Generator,
    number: int = 0,
    on_growth: OnGrowth | None = None,
) -> GrownLayout:
    """One layout: rows of the brief and of the sources, neighbours, then patches and their
    neighbours until enough is built, then coverage repaired. Every other ``number`` begins with
    the buildings along edges, every third with a patch. ``on_growth`` is called for each."""
    canvas = Canvas(problem, on_growth)
    lay_rows(canvas)
    if number % 2:
        lay_edges(canvas, order.edges, rng)
    continue_rows(canvas, order.rows, rng)
    if number % 3 == 2 and not canvas.full():
        lay_patch(canvas, rng, problem.settings.patches)
    grow_neighbours(canvas, rng)
    for _ in range(ROUNDS):
        if canvas.full() or not lay_patch(canvas, rng, problem.settings.patches):
            break
        grow_neighbours(canvas, rng)
    if problem.settings.relaxed and not canvas.stopped:
        repair_coverage(canvas, rng)
    if not canvas.stopped:
        take_away(canvas)
    return canvas.layout()


def polish(
    problem: ExtendProblem,
    layout: GrownLayout,
    rng: np.random.Generator,
    cancelled: Cancel = lambda: False,
    hear: Callable[[GrownLayout], None] = lambda _: None,
) -> GrownLayout:
    """The layout annealed, if that is better and was not ``cancelled``; ``hear`` is given better
    and better ones meanwhile."""
    if not problem.settings.polish or cancelled():
        return layout
    canvas = Canvas(problem)
    for pose, origin, how in zip(layout.poses, layout.origin.tolist(), layout.how, strict=True):
        canvas.add(pose, origin, how)
    many = max(len(layout.poses), 1)
    moves = round(problem.settings.polish * np.clip((ANNEALED / many) ** 1.5, 1.0, MOST_TIMES))
    annealed = anneal(canvas, rng, moves, cancelled, hear)
    if cancelled():
        return layout
    made = rate_layout(problem, turn_fronts(problem, annealed))
    return made if made.score["energy"] < layout.score["energy"] else layout
