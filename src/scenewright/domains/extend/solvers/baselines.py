"""For comparison: buildings anywhere they fit, and copies of the source side by side."""

from __future__ import annotations

from functools import partial

import numpy as np
import shapely

from scenewright.domains.extend.pattern import GapRules
from scenewright.domains.extend.problem import ExtendFound, ExtendProblem, GrownLayout
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.domains.extend.solvers.patches import patch_turns, turn_poses
from scenewright.domains.extend.solvers.single_layout import grow_once
from scenewright.engine.growing import OnGrowth
from scenewright.engine.solve import Budget, Cancel, Progress

MOST_TRIES = 400
"""Places tried in a row without success before an area counts as full."""
BATCH = 40


def scatter_area(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """Buildings of the sources at random places where they overlap nothing, turned as some
    building of the sources is."""
    make = partial(_scatter, problem, seed, GapRules(0.0, 0.0, 0.0))
    return grow_once(problem, make, budget, progress, cancel)


def space_area(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """The same, as far apart as buildings of the sources are at least."""
    make = partial(_scatter, problem, seed, problem.pattern.gaps)
    return grow_once(problem, make, budget, progress, cancel)


def tile_area(
    problem: ExtendProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> ExtendFound:
    """The first source copied in a grid of its own width and depth."""
    return grow_once(problem, partial(_tile, problem, seed), budget, progress, cancel)


def _scatter(problem: ExtendProblem, seed: int, gaps: GapRules, on_growth: OnGrowth) -> GrownLayout:
    canvas, pattern = Canvas(problem, on_growth), problem.pattern
    rng = np.random.default_rng(seed)
    west, south, east, north = problem.floor.bounds
    failed = 0
    while not canvas.full() and failed < MOST_TRIES:
        origin = rng.choice(len(pattern.boxes), BATCH, p=pattern.weight / pattern.weight.sum())
        at = rng.uniform((west, south), (east, north), (BATCH, 2))
        heading = pattern.boxes[rng.choice(len(pattern.boxes), BATCH), 2]
        poses = np.concatenate([at, heading[:, None]], 1)
        wanted = [k for k in range(BATCH) if canvas.room_for(int(origin[k]))]
        good = np.array(wanted, np.int64)
        good = good[canvas.legal(poses[good], origin[good], gaps=gaps)] if wanted else good
        failed = 0 if len(good) else failed + BATCH
        if not wanted:
            canvas.loosen(1.0)
        for k in good[:1].tolist():
            canvas.add(poses[k], int(origin[k]), "random")
    return canvas.layout()


def _tile(problem: ExtendProblem, seed: int, on_growth: OnGrowth) -> GrownLayout:
    canvas, pattern = Canvas(problem, on_growth), problem.pattern
    rng = np.random.default_rng(seed)
    turn = float(patch_turns(canvas)[0])
    rows = np.flatnonzero(pattern.source == 0)
    middle = pattern.boxes[rows, :2].mean(0)
    bounds = np.array(shapely.total_bounds(pattern.shapes[rows]))
    wide, deep = bounds[2:] - bounds[:2] + max(pattern.gaps)
    west, south, east, north = problem.floor.bounds
    start = np.array([west, south]) + rng.uniform(0, 1, 2) * (wide, deep)
    for x in np.arange(start[0] - wide, east + wide, wide):
        for y in np.arange(start[1] - deep, north + deep, deep):
            poses = turn_poses(pattern.boxes[rows, :3], middle, np.array([x, y]), turn)
            for k in np.flatnonzero(canvas.legal(poses, rows)).tolist():
                still = canvas.legal(poses[k][None], rows[k : k + 1])[0]
                if still and canvas.room_for(int(rows[k])):
                    canvas.add(poses[k], int(rows[k]), "copy")
    return canvas.layout()
