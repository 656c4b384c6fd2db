"""Symmetry about a bed: its axis on the middle of the floor beside it, or on a window."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from scenewright.domains.home.problem import KnownGround, Problem, known_ground
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined

ROOMY = 9.0
"""Area in m² from which a room has floor on both sides of a double bed."""
AHEAD = 0.3
"""Metres before the middle of its back at which the floor beside a bed is measured."""
FARTHEST = 1.0
"""An axis farther off than this, metres, is as bad as any."""
PARALLEL = 0.999
"""Cosine from which on an axis is that of a window."""


@inlined
def measure_asymmetry(frames: Floats, i: int, frame: Frame, data: Floats) -> float:
    """Σ_j w_j min(1, |l_j - r_j| / 2, min_k a_jk): metres by which the axis of each bed j is off
    the middle of the floor to its left and right.

    l_j and r_j are the distances from a point 0.3 m before the middle of its back to the edge of
    the floor on either side, a_jk the distance of its axis from the middle of a window k that looks
    along it; w_j is :attr:`Items.symmetry`. Item ``i`` is taken to stand at ``frame``; -1: all
    stand where ``frames`` (n, 8) say. ``data`` as :func:`list_axes` gives it.

    Merrell et al. (2011) ask for the symmetry of a whole layout about an axis that is searched
    for; here the axis is that of the bed, and what is alike on both sides (two nightstands with
    their lamps) are members of its case.
    """
    n = frames.shape[0]
    edges, windows = int(data[n]), int(data[n + 1])
    first = n + 2
    total = 0.0
    for j in range(n):
        if data[j] == 0.0:
            continue
        bed = frame if j == i else read_frame(frames, j)
        c, s = bed[2], bed[3]
        x, y = bed[0] + c * (AHEAD - bed[5]), bed[1] + s * (AHEAD - bed[5])
        left, right = math.inf, math.inf
        for k in range(first, first + 4 * edges, 4):
            dx, dy = data[k + 2] - data[k], data[k + 3] - data[k + 1]
            across = c * dx + s * dy
            if abs(across) < 1e-9:
                continue
            t = (c * (x - data[k]) + s * (y - data[k + 1])) / across
            if 0.0 <= t <= 1.0:
                aside = s * (data[k] + t * dx - x) - c * (data[k + 1] + t * dy - y)
                if aside >= 0.0:
                    right = min(right, aside)
                else:
                    left = min(left, -aside)
        off = FARTHEST
        if left < math.inf and right < math.inf:
            off = min(off, 0.5 * abs(left - right))
        for k in range(first + 4 * edges, first + 4 * (edges + windows), 4):
            if abs(c * data[k + 2] + s * data[k + 3]) > PARALLEL:
                off = min(off, abs(s * (data[k] - x) - c * (data[k + 1] - y)))
        total += data[j] * off
    return total


def list_axes(problem: Problem) -> Floats:
    """What :func:`measure_asymmetry` knows of a room ``(n + 2 + 4 e + 4 w,)``: the weight of each
    item (0 in a room under :data:`ROOMY`), the numbers of edges and windows, the edges
    x0, y0, x1, y1 and of each window the middle and the direction it looks in; metres."""
    weights = problem.items.symmetry * (problem.ground.area >= ROOMY)
    return np.concatenate([weights, _axes_of(known_ground(problem.ground))])


@lru_cache(maxsize=256)
def _axes_of(known: KnownGround) -> Floats:
    """The same of a room alone."""
    edges = np.asarray(known.ground.edges, np.float64).reshape(-1, 4)
    windows = np.asarray(known.ground.strips, np.float64).reshape(-1, 6)
    windows = windows[windows[:, 5] == 1.0]
    looks = np.column_stack((windows[:, :2], np.cos(windows[:, 2]), np.sin(windows[:, 2])))
    return np.concatenate([[len(edges), len(looks)], edges.ravel(), looks.ravel()])
