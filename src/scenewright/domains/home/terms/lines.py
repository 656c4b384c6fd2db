"""Lines that pieces share: axes and edges of one in those of another, or on a window's axis."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.home.problem import Problem
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined

SEEN = 0.5
"""Lines farther apart than this, metres, do not look as if they were meant to be one."""
PARALLEL = 0.999
"""Cosine from which on two lines are parallel."""


@inlined
def shared_lines(frames: Floats, i: int, frame: Frame, windows: Floats) -> float:
    """Σ_j min(1, min_k min_{p ∈ L_j, q ∈ L_k} |p - q| / 0.5) / n: how far the lines of items are
    from those of others.

    L_j are the three lines of item j along its heading, its left edge, axis and right edge, and
    L_k those of an item k whose heading is parallel or opposite, or the axis of a window that looks
    along it; distances in metres. An item that has none parallel counts 0. In [0, 1]; 0 where each
    item continues a line of another. Item ``i`` is taken to stand at ``frame``; -1: all stand
    where ``frames`` (n, 8) say. ``windows`` (1 + 4k,) as :func:`find_window_axes` gives it.

    O'Donovan, Agarwala, Hertzmann (2014, Learning layouts for single-page graphic designs) count
    elements that share an edge or an axis in the same way, of pages and within a threshold; here
    the distance itself counts, so that a search feels it.
    """
    n, total = frames.shape[0], 0.0
    if windows.shape[0] == 0 or n == 0:
        return 0.0
    for j in range(n):
        item = frame if j == i else read_frame(frames, j)
        c, s, half = item[2], item[3], item[4]
        least, any_ = math.inf, False
        for k in range(n):
            other = frame if k == i else read_frame(frames, k)
            if k != j and abs(c * other[2] + s * other[3]) > PARALLEL:
                aside = (other[1] - item[1]) * c - (other[0] - item[0]) * s
                least, any_ = min(least, between(aside, half, other[4])), True
        for k in range(1, windows.shape[0], 4):
            if abs(c * windows[k + 2] + s * windows[k + 3]) > PARALLEL:
                aside = (windows[k + 1] - item[1]) * c - (windows[k] - item[0]) * s
                least, any_ = min(least, between(aside, half, 0.0)), True
        if any_:
            total += min(1.0, least / SEEN)
    return total / n


@inlined
def between(aside: float, half: float, other: float) -> float:
    """The least distance of -h, 0, h to a - g, a, a + g: edges and axes of two boxes of half widths
    h and g whose axes are a metres apart."""
    least = math.inf
    for mine in (-half, 0.0, half):
        for theirs in (aside - other, aside, aside + other):
            least = min(least, abs(mine - theirs))
    return least


def find_window_axes(problem: Problem) -> Floats:
    """What :func:`shared_lines` knows of a room: how many windows there are, then the middle of
    each and the direction (cos, sin) it looks in; empty where the term weighs nothing."""
    if not problem.weights.get("shared_lines"):
        return np.zeros(0)
    strips = np.asarray(problem.ground.strips, np.float64).reshape(-1, 6)
    lit = strips[strips[:, 5] == 1.0]
    looks = np.column_stack((lit[:, :2], np.cos(lit[:, 2]), np.sin(lit[:, 2])))
    return np.concatenate([[float(len(lit))], looks.ravel()])
