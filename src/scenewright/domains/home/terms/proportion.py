"""Proportion of what a room is arranged about to the wall behind it."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.home.problem import Problem
from scenewright.geometry.boxes import Floats, Frame, distance_to_segment, read_frame
from scenewright.geometry.compiled import inlined

LEAST, MOST = 0.5, 5 / 6
"""Shares of its wall that a piece looks right on: about two thirds."""


@inlined
def wall_proportion(frames: Floats, i: int, frame: Frame, room: Floats) -> float:
    """Σ_j min(1, 2 max(0, 1/2 - w_j / l_j, w_j / l_j - 5/6)) / m over the m items a room is
    arranged about: seats, screen and bed.

    w_j is the width of item j, l_j the length of the wall behind it in metres: of least
    d + 1 - cos α, the distance of the middle of its back and the angle to the wall's normal. In
    [0, 1]; 0 where each takes from half to five sixths of its wall. Item ``i`` is taken to stand
    at ``frame``; -1: all stand where ``frames`` (n, 8) say. ``room`` as :func:`find_walls` gives
    it.

    Ours, after the decorators' rule that a sofa takes two thirds of its wall, which is nowhere
    printed as a formula; the bounds are a sixth to either side of it.
    """
    n, total, count = frames.shape[0], 0.0, 0
    if room.shape[0] == 0:
        return 0.0
    for j in range(n):
        if room[j] == 0.0:
            continue
        item = frame if j == i else read_frame(frames, j)
        x, y = item[0] - item[5] * item[2], item[1] - item[5] * item[3]
        least, length = math.inf, 0.0
        for k in range(n, room.shape[0], 4):
            dx, dy = room[k + 2] - room[k], room[k + 3] - room[k + 1]
            long = math.sqrt(dx * dx + dy * dy)
            off = 1.0 - (dx * item[3] - dy * item[2]) / max(long, 1e-9)
            off += distance_to_segment(x, y, room[k], room[k + 1], room[k + 2], room[k + 3])
            if off < least:
                least, length = off, long
        share = 2.0 * item[4] / max(length, 1e-9)
        total += min(1.0, 2.0 * max(0.0, LEAST - share, share - MOST))
        count += 1
    return total / count if count > 0 else 0.0


def find_walls(problem: Problem) -> Floats:
    """What :func:`wall_proportion` knows of a room (n + 4w,): 1 for each item the room is arranged
    about, then the walls x0, y0, x1, y1; empty where the term weighs nothing."""
    if not problem.weights.get("wall_proportion"):
        return np.zeros(0)
    roles = (problem.items.main_wall != 0.0).astype(np.float64)
    return np.concatenate([roles, np.asarray(problem.ground.walls, np.float64).ravel()])
