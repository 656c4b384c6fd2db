"""How far seats look past what they are to look at."""

from __future__ import annotations

import numpy as np

from scenewright.domains.hall.problem import Floats

MOST_TURNED, SHARE = 60.0, 0.1
"""Degrees by which a seat looks past what it is to look at, and the share of the seats of one
demand that may."""


def measure_turns(seats: Floats, shown: Floats) -> Floats:
    """Degrees (n,) between where each of some seats (n, 5) looks and the nearest point of what is
    shown (5,); boxes are x, y, heading, width, depth in metres and radians.

    >>> seats = np.array([[0.0, 0, 0, 0.5, 0.5], [0, 0, np.pi / 2, 0.5, 0.5]])
    >>> measure_turns(seats, np.array([5.0, 0, np.pi, 3, 1])).round(6).tolist()
    [0.0, 90.0]
    """
    x, y, heading, width, depth = shown
    front = np.array([np.cos(heading), np.sin(heading)])
    axes = np.stack([front, (front[1], -front[0])])
    off = (seats[:, :2] - (x, y)) @ axes.T
    nearest = np.clip(off, (-0.5 * depth, -0.5 * width), (0.5 * depth, 0.5 * width))
    dx, dy = ((nearest - off) @ axes).T
    turned = np.arctan2(dy, dx) - seats[:, 2]
    found: Floats = np.degrees(np.abs(np.arctan2(np.sin(turned), np.cos(turned))))
    return found


def count_away(seats: Floats, shown: Floats) -> int:
    """How many of some seats (n, 5) look past what is shown (5,) by more than they may."""
    return int((measure_turns(seats, shown) > MOST_TURNED).sum())
