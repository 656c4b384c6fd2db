"""Whole patches of a source laid into an area where most of it fits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.extend.problem import Floats, Indices
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.ground.fit import main_direction

TOGETHER = 24
"""Placements tried at once."""
FAR = 60.0
"""Metres beyond the reach of neighbours at which a patch counts half."""
NOWHERE = np.zeros((0, 2))
LEAST = 2
"""Buildings that must fit for a patch to be laid."""


def lay_patch(canvas: Canvas, rng: np.random.Generator, tries: int) -> int:
    """Lay the best of ``tries`` random placements of a source, or of its mirror turned round;
    how many buildings were added."""
    pattern = canvas.problem.pattern
    turns = patch_turns(canvas)
    sources = np.unique(pattern.source)
    weights = np.array([pattern.weight[pattern.source == s].sum() for s in sources])
    shifts = canvas.shifts()
    best: tuple[float, Floats, Indices] | None = None
    for _ in range(max(tries // TOGETHER, 1)):
        source = int(rng.choice(sources, p=weights / weights.sum()))
        rows = np.flatnonzero(pattern.source == source)
        poses = _place_patches(canvas, rng, rows, turns, shifts.get(source, NOWHERE))
        many = np.tile(rows, TOGETHER)
        good = canvas.legal(poses.reshape(-1, 3), many).reshape(TOGETHER, len(rows))
        area = good @ np.prod(pattern.boxes[rows, 3:], axis=1)
        area = area * _nearness(canvas, poses, good)
        area[good.sum(1) < LEAST] = 0.0
        k = int(area.argmax())
        if area[k] > 0 and (best is None or area[k] > best[0]):
            best = (float(area[k]), poses[k][good[k]], rows[good[k]])
    if best is None:
        return 0
    made = 0
    for pose, origin in zip(best[1], best[2].tolist(), strict=True):
        one = np.array([origin])
        if canvas.room_for(origin) and (canvas.legal(pose[None], one)[0]):
            canvas.add(pose, origin, "patch")
            made += 1
    return made


def _place_patches(
    canvas: Canvas, rng: np.random.Generator, rows: Indices, turns: Floats, shifts: Floats
) -> Floats:
    """Poses (k, n, 3) of a source's buildings ``rows`` (n,) at random placements: one of them
    comes to a random point; where the source repeats itself, half of the placements are
    ``shifts`` (m, 2) by its steps."""
    problem, boxes = canvas.problem, canvas.problem.pattern.boxes
    west, south, east, north = problem.floor.bounds
    at = rng.uniform((west, south), (east, north), (TOGETHER, 2))
    turn, middle = rng.choice(turns, TOGETHER), boxes[rng.choice(rows, TOGETHER), :2]
    found = np.array(
        [turn_poses(boxes[rows, :3], middle[k], at[k], float(turn[k])) for k in range(TOGETHER)]
    )
    if len(shifts):
        half = TOGETHER // 2
        found[:half] = boxes[rows, :3]
        found[:half, :, :2] += shifts[rng.integers(len(shifts), size=half)][:, None]
    return found


def _nearness(canvas: Canvas, poses: Floats, good: NDArray[np.bool_]) -> Floats:
    """How much placements (k, n, 3) count by how near the fitting part of each comes to buildings:
    1 beside it, half :data:`FAR` metres on."""
    there = canvas.boxes[canvas.there]
    if not len(there):
        return np.ones(len(poses))
    step = poses[:, :, None, :2] - there[None, None, :, :2]
    away = np.hypot(step[..., 0], step[..., 1]).min(2)
    away = np.where(good, away, np.inf).min(1) - canvas.problem.pattern.reach
    return np.asarray(1.0 / (1.0 + np.maximum(away, 0.0) / FAR))


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
