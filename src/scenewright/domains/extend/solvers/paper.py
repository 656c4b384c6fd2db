"""The paper's growth of an area: plots on a grid, ants and breeding; built where it fits."""

from __future__ import annotations

from functools import partial

import numpy as np
import shapely

from scenewright.domains.extend.printed import PlotGrid
from scenewright.domains.extend.problem import ExtendFound, ExtendProblem, GrownLayout
from scenewright.domains.extend.rating import rate_layout
from scenewright.domains.extend.solvers.ants import run_ants
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.colony import ColonySettings, breed
from scenewright.engine.growing import tell_growth
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress

WEIGHTS = np.full(4, 0.25)
"""ω of (22) where nobody says."""
PRINTED = ColonySettings()
REPAIRED = ColonySettings(printed=False)


def grow_printed(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """Equations as printed."""
    return _grow(problem, budget, seed, progress, cancel, PRINTED)


def grow_repaired(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """With an elite deposit, evaporation that stays, and allele values of those who carry them."""
    return _grow(problem, budget, seed, progress, cancel, REPAIRED)


def grid_of(problem: ExtendProblem) -> PlotGrid:
    """Plots of the size of the largest building and a gap, turned as most buildings are; free are
    those whose middle lies on the floor."""
    pattern = problem.pattern
    turn = float(np.angle(np.exp(4j * pattern.boxes[:, 2]).mean())) / 4
    pitch = float(np.quantile(pattern.boxes[:, 3:].max(1), 0.8)) + pattern.gaps.side + 1.0
    middle = np.array(problem.floor.centroid.coords[0])
    corners = shapely.get_coordinates(problem.floor) - middle
    way, across = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    spans = [
        np.arange((corners @ v).min() + pitch / 2, (corners @ v).max(), pitch)
        for v in (way, across)
    ]
    x, y = np.meshgrid(*(span if len(span) else np.zeros(1) for span in spans))
    middles = middle + x[..., None] * way + y[..., None] * across
    free = shapely.contains_xy(problem.floor, middles[..., 0], middles[..., 1])
    areas = np.array([shapely.Polygon(kind.local).area for kind in pattern.kinds])
    wanted = problem.coverage * problem.outline.area
    if problem.number is not None:
        wanted = problem.number * float(areas.mean())
    return PlotGrid(middles, free, areas, float(wanted))


def share_work(steps: int | None, settings: ColonySettings) -> tuple[int, int]:
    """Matrices that ants and breeding look at: as printed, or each half of what is stated.

    >>> share_work(None, PRINTED), share_work(121, PRINTED)
    ((6000, 240), (60, 61))
    """
    if steps is None:
        return (settings.ants * settings.iterations, settings.population * settings.generations)
    return max(steps // 2, 1), max(steps - steps // 2, 1)


def _grow(
    problem: ExtendProblem,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
    settings: ColonySettings,
) -> ExtendFound:
    grid, rng = grid_of(problem), np.random.default_rng(seed)
    parts = share_work(budget.steps, settings)
    most = sum(parts)
    watch = BudgetWatch(budget._replace(steps=most), progress, cancel)
    growth = tell_growth(watch, 0, 1)

    def on_plots(before: int, own: int, share: float, best: np.ndarray) -> bool:
        return growth((before + own * share) / most, partial(build_plots, problem, grid, best))

    genes = np.zeros(grid.free.shape, np.int64)
    if grid.free.any():
        first, second = partial(on_plots, 0, parts[0]), partial(on_plots, *parts)
        ants = run_ants(grid, WEIGHTS, parts[0], rng, settings, first, budget.hear)
        bred = breed(grid, WEIGHTS, parts[1], rng, settings, on_plots=second, hear=budget.hear)
        genes = max(ants, bred, key=lambda one: one.value).genes
    found = rate_layout(problem, build_plots(problem, grid, genes))
    watch.over(most, found.score["energy"], lambda: found)
    return Found((found,), most)


def build_plots(problem: ExtendProblem, grid: PlotGrid, genes: np.ndarray) -> GrownLayout:
    """The buildings of a matrix on their plots, turned as their originals; what does not fit is
    left away."""
    canvas, pattern = Canvas(problem), problem.pattern
    for i, j in np.argwhere((genes > 0) & grid.free).tolist():
        origin = int(np.flatnonzero(pattern.kind == genes[i, j] - 1)[0])
        pose = np.array([*grid.middles[i, j], pattern.boxes[origin, 2]])
        if canvas.full():
            break
        if canvas.legal(pose[None], np.array([origin]))[0]:
            canvas.add(pose, origin, "plot")
    return canvas.layout()
