"""The largest void: how much of a room's free floor lies in one piece."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.domains.home.problem import Problem
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined

STEP = 0.25  # between the points at which the void is looked for, metres


@inlined
def largest_void(frames: Floats, i: int, frame: Frame, floor: Floats) -> float:
    """max_p min(d_R(p), min_j d_j(p)) / max_p d_R(p): radius of the largest empty circle of the
    furnished room over that of the empty one, in [0, 1].

    d_R(p) is the distance of a point p of the floor to walls and fixed pieces, d_j(p) that to item
    j (0 within it), metres; p are points of a grid along the longest wall. 1: nothing stands where
    the room is widest. Item ``i`` is taken to stand at ``frame``; -1: all stand where ``frames``
    (n, 8) say. ``floor`` (1 + 3k,) as :func:`find_floor` gives it.

    The largest empty circle is Toussaint's (1983, Computing largest empty circles with location
    constraints), here on the points of a grid, so that it is at most half a diagonal of the grid
    too small.
    """
    most = 0.0
    for k in range(1, floor.shape[0], 3):
        far = floor[k + 2]
        for j in range(frames.shape[0]):
            if far <= most:
                break
            item = frame if j == i else read_frame(frames, j)
            dx, dy = floor[k] - item[0], floor[k + 1] - item[1]
            ahead = max(abs(dx * item[2] + dy * item[3]) - item[5], 0.0)
            aside = max(abs(dy * item[2] - dx * item[3]) - item[4], 0.0)
            far = min(far, math.sqrt(ahead * ahead + aside * aside))
        most = max(most, far)
    return most / floor[0] if floor.shape[0] > 0 else 0.0


def find_floor(problem: Problem) -> Floats:
    """What :func:`largest_void` knows of a room: the radius of its largest circle, then x, y and
    the distance to walls and fixed pieces of each point of its floor, metres; empty where the term
    weighs nothing or no point is free."""
    if not problem.weights.get("largest_void"):
        return np.zeros(0)
    edges = np.asarray(problem.ground.edges, np.float64).reshape(-1, 4)
    walls = shapely.multilinestrings(edges.reshape(-1, 2, 2))
    along = edges[np.hypot(*(edges[:, 2:] - edges[:, :2]).T).argmax()]
    u = (along[2:] - along[:2]) / np.hypot(*(along[2:] - along[:2]))
    v = np.array([-u[1], u[0]])
    ends = (edges[:, :2] - along[:2]) @ np.stack([u, v]).T
    a, b = (
        np.arange(lo + STEP / 2, hi, STEP) for lo, hi in zip(ends.min(0), ends.max(0), strict=True)
    )
    grid = along[:2] + np.stack(np.meshgrid(a, b), -1).reshape(-1, 2) @ np.stack([u, v])
    inside = np.sum(_crosses(edges, grid), axis=1) % 2 == 1
    points = grid[inside]
    far = shapely.distance(walls, shapely.points(points))
    for x, y, heading, width, depth in problem.ground.obstacles:
        d = points - (x, y)
        ahead = np.abs(d @ (math.cos(heading), math.sin(heading))) - depth / 2
        aside = np.abs(d @ (-math.sin(heading), math.cos(heading))) - width / 2
        far = np.minimum(far, np.hypot(np.maximum(ahead, 0), np.maximum(aside, 0)))
    if not far.size or far.max() <= 0.0:
        return np.zeros(0)
    return np.concatenate([[far.max()], np.column_stack([points, far]).ravel()])


def _crosses(edges: Floats, points: Floats) -> Floats:
    """Whether the ray to the right of each point (p, 2) crosses each edge (e, 4): (p, e)."""
    x, y = points[:, :1], points[:, 1:]
    x0, y0, x1, y1 = edges.T
    spans = (y0 > y) != (y1 > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x0 + (y - y0) * (x1 - x0) / (y1 - y0)
    return np.asarray(spans & (x < at))
