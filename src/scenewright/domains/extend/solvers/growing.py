"""Ours: several layouts grown one after the other, and the best of them."""

from __future__ import annotations

from functools import partial

import numpy as np

from scenewright.domains.extend.problem import ExtendFound, ExtendProblem, GrownLayout
from scenewright.domains.extend.rating import rate_layout
from scenewright.domains.extend.solvers.anneal import anneal
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.continued_rows import continue_rows
from scenewright.domains.extend.solvers.laid_rows import lay_rows
from scenewright.domains.extend.solvers.neighbours import grow_neighbours
from scenewright.domains.extend.solvers.patches import lay_patch
from scenewright.domains.extend.solvers.repair import fill_free, take_away
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress

LAYOUTS = 4
"""Layouts grown where no budget is given."""
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
    layout."""
    if budget.steps is None and budget.seconds is None:
        budget = budget._replace(steps=LAYOUTS)
    watch = BudgetWatch(budget, progress, cancel)
    found: list[GrownLayout] = []
    while True:
        rng = np.random.default_rng([seed, len(found)])
        made = grow_once(problem, rng, cancel if found else None)
        found.append(rate_layout(problem, made))
        found.sort(key=lambda layout: layout.score["energy"])
        if watch.over(len(found), found[0].score["energy"], partial(_first, found)):
            polished = polish(problem, found[0], np.random.default_rng([seed, 1, 1]))
            return Found((polished, *found), len(found))


def _first(found: list[GrownLayout]) -> GrownLayout:
    return found[0]


def grow_once(
    problem: ExtendProblem, rng: np.random.Generator, cancel: Cancel | None = None
) -> GrownLayout:
    """One layout: rows of the brief and of the sources, neighbours, then patches and their
    neighbours until enough is built, then coverage repaired."""
    canvas = Canvas(problem)
    lay_rows(canvas)
    continue_rows(canvas, rng)
    grow_neighbours(canvas, rng, cancel)
    for _ in range(ROUNDS):
        if canvas.full() or not lay_patch(canvas, rng, problem.settings.patches):
            break
        grow_neighbours(canvas, rng, cancel)
    if problem.settings.relaxed:
        fill_free(canvas, rng)
    take_away(canvas)
    return canvas.layout()


def polish(problem: ExtendProblem, layout: GrownLayout, rng: np.random.Generator) -> GrownLayout:
    """The layout annealed, if that is better."""
    if not problem.settings.polish:
        return layout
    canvas = Canvas(problem)
    for pose, origin, how in zip(layout.poses, layout.origin.tolist(), layout.how, strict=True):
        canvas.add(pose, origin, how)
    made = rate_layout(problem, anneal(canvas, rng, problem.settings.polish))
    return made if made.score["energy"] < layout.score["energy"] else layout
