"""Terms of composition: how the pieces of a room hang together as a picture."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from scenewright.domains.home.problem import KnownGround, Problem, known_ground
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined


@inlined
def balance(frames: Floats, i: int, frame: Frame, middle: Floats) -> float:
    """|Σ A_j (c_j - m)| / (Σ A_j √A(R)): how far the middle of all furniture is from the room's.

    A_j are the areas of the items and fixed pieces, c_j their middles, m the centroid of the room
    R; 0 is balanced, and the size of the room does not matter. Item ``i`` is taken to stand at
    ``frame``; -1: all stand where ``frames`` (n, 8) say. ``middle`` (6,) as
    :func:`find_middle` gives it.

    Merrell et al. (2011) print the distance alone and measure it from the middle of the room's
    bounds, which in an L-shaped room may be outside.
    """
    x, y, mass = middle[2], middle[3], middle[4]
    for j in range(frames.shape[0]):
        item = frame if j == i else read_frame(frames, j)
        area = 4.0 * item[4] * item[5]
        x, y, mass = x + area * (item[0] - middle[0]), y + area * (item[1] - middle[1]), mass + area
    return math.sqrt(x * x + y * y) / (mass * middle[5]) if mass > 0.0 else 0.0


def find_middle(problem: Problem) -> Floats:
    """What :func:`balance` knows of a room (6,): m, the moments Σ A (c - m) of the fixed pieces,
    their area and √A(R); metres."""
    return _middle_of(known_ground(problem.ground))


@lru_cache(maxsize=256)
def _middle_of(known: KnownGround) -> Floats:
    edges = np.asarray(known.ground.edges, np.float64).reshape(-1, 4)
    fixed = np.asarray(known.ground.obstacles, np.float64).reshape(-1, 5)
    cross = edges[:, 0] * edges[:, 3] - edges[:, 2] * edges[:, 1]
    whole = max(float(cross.sum()), 1e-9)
    x, y = cross @ (edges[:, :2] + edges[:, 2:]) / (3.0 * whole)
    areas = fixed[:, 3] * fixed[:, 4]
    moments = areas @ (fixed[:, :2] - np.array([x, y]))
    return np.array([x, y, *moments, areas.sum(), math.sqrt(0.5 * whole)])
