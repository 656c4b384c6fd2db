"""Whole patches of a source laid into an area where most of it fits."""

from __future__ import annotations

import numpy as np

from scenewright.domains.extend.problem import Floats, Indices
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.ground.fit import main_direction

LEAST = 2
"""Buildings that must fit for a patch to be laid."""


def lay_patch(canvas: Canvas, rng: np.random.Generator, tries: int) -> int:
    """Lay the best of ``tries`` random placements of a source, or of its mirror turned round;
    how many buildings were added."""
    problem, pattern = canvas.problem, canvas.problem.pattern
    turns = patch_turns(canvas)
    best: tuple[float, Floats, Indices] | None = None
    west, south, east, north = problem.floor.bounds
    sources = np.unique(pattern.source)
    weights = np.array([pattern.weight[pattern.source == s].sum() for s in sources])
    for _ in range(tries):
        source = int(rng.choice(sources, p=weights / weights.sum()))
        rows = np.flatnonzero(pattern.source == source)
        turn = float(rng.choice(turns))
        middle = pattern.boxes[rng.choice(rows), :2]
        at = np.array([rng.uniform(west, east), rng.uniform(south, north)])
        poses = turn_poses(pattern.boxes[rows, :3], middle, at, turn)
        good = canvas.legal(poses, rows)
        area = float(np.prod(pattern.boxes[rows[good], 3:], axis=1).sum())
        if int(good.sum()) >= LEAST and (best is None or area > best[0]):
            best = (area, poses[good], rows[good])
    if best is None:
        return 0
    made = 0
    for pose, origin in zip(best[1], best[2].tolist(), strict=True):
        one = np.array([origin])
        if canvas.room_for(origin) and (canvas.legal(pose[None], one)[0]):
            canvas.add(pose, origin, "patch")
            made += 1
    return made


def patch_turns(canvas: Canvas) -> Floats:
    """Angles by which a source may be turned: not at all where it stands beside, and round; else
    so that its main direction is that of the area."""
    problem = canvas.problem
    if (canvas.origin[: canvas.first] >= 0).any():
        return np.array([0.0, 0.0, np.pi])
    ring = np.array(problem.outline.exterior.coords)[:-1]
    own = main_direction([ring])
    theirs = problem.pattern.boxes[:, 2]
    usual = float(np.angle(np.exp(4j * theirs).mean())) / 4
    return np.asarray(own - usual + np.arange(4) * np.pi / 2)


def turn_poses(poses: Floats, middle: Floats, at: Floats, turn: float) -> Floats:
    """Poses (n, 3) turned about ``middle`` (2,) and moved so that it comes to ``at`` (2,).

    >>> turn_poses(np.array([[2.0, 0.0, 0.0]]), np.zeros(2), np.ones(2), np.pi).round(6).tolist()
    [[-1.0, 1.0, 3.141593]]
    """
    cos, sin = np.cos(turn), np.sin(turn)
    step = poses[:, :2] - middle
    x = at[0] + cos * step[:, 0] - sin * step[:, 1]
    y = at[1] + sin * step[:, 0] + cos * step[:, 1]
    return np.stack([x, y, poses[:, 2] + turn], 1)
