"""Seats that people talk from: near enough to each other, and turned to each other."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.home.problem import Problem
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined

SPEAKING = 2.4
"""Metres between people who talk at ease: 8 feet."""
SEATS = frozenset(("seating", "reading"))


@inlined
def conversation(frames: Floats, i: int, frame: Frame, seats: Floats) -> float:
    """Σ_j min_k (max(0, d_jk - 2.4) / 2.4 + (2 - cos α_jk - cos α_kj) / 4), at most 1 for each seat
    group j, over the other seat groups k.

    d_jk is the distance of the middles of their fronts in metres, α_jk the angle between the
    heading of j and the way from its back to the front of k. 0 where all seats are within speaking
    distance and look at each other, or where there is one group. Item ``i`` is taken to stand at
    ``frame``; -1: all stand where ``frames`` (n, 8) say. ``seats`` (n,), 1 for each group of
    seats, as :func:`find_seats` gives it.

    The 8 feet and the cosines are those of Merrell et al. (2011, conversation), who let the term
    fall off as a square and leave its weight unprinted; they measure single seats, here groups.
    """
    total = 0.0
    for j in range(seats.shape[0]):
        if seats[j] == 0.0:
            continue
        mine = frame if j == i else read_frame(frames, j)
        least = math.inf
        for k in range(seats.shape[0]):
            if k != j and seats[k] != 0.0:
                other = frame if k == i else read_frame(frames, k)
                least = min(least, apart(mine, other))
        total += min(1.0, least) if least < math.inf else 0.0
    return total


@inlined
def apart(a: Frame, b: Frame) -> float:
    """How little two groups of seats are one for those who sit there: distance and look."""
    ax, ay = a[0] + a[5] * a[2], a[1] + a[5] * a[3]
    bx, by = b[0] + b[5] * b[2], b[1] + b[5] * b[3]
    far = math.sqrt((bx - ax) ** 2 + (by - ay) ** 2)
    away = 2.0 - toward(a, bx, by) - toward(b, ax, ay)
    return max(0.0, far - SPEAKING) / SPEAKING + 0.25 * away


@inlined
def toward(seat: Frame, x: float, y: float) -> float:
    """Cosine of the angle between the heading of a seat and the way from its back to a point."""
    dx, dy = x - seat[0] + seat[5] * seat[2], y - seat[1] + seat[5] * seat[3]
    return (dx * seat[2] + dy * seat[3]) / max(math.sqrt(dx * dx + dy * dy), 1e-9)


def find_seats(problem: Problem) -> Floats:
    """1 for each item that is a group of seats, (n,); empty where the term weighs nothing or there
    are fewer than two."""
    seats = np.array([name.split("_")[0] in SEATS for name in problem.names], np.float64)
    return seats if problem.weights.get("conversation") and seats.sum() > 1 else np.zeros(0)
