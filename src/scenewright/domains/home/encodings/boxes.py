"""Genes of rectangles: what the paper's genetic algorithm works on, and back to boxes.

A gene row is ``(x, y, θ, lx, ly)`` (Liu et al. 2017): the lower left corner of the rectangle in
its own axes, the angle of its own x axis, length and width. The edge on its own x axis is the
back, so a box's heading is θ + π / 2, its width lx and its depth ly.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.problem import Problem
from scenewright.geometry.compiled import compiled

Floats = NDArray[np.float64]


def to_boxes(genes: Floats) -> Floats:
    """Boxes ``(..., n, 5)`` of genes ``(..., n, 5)``.

    >>> to_boxes(np.array([[0.0, 0.0, 0.0, 2.0, 1.0]])).round(3).tolist()
    [[1.0, 0.5, 1.571, 2.0, 1.0]]
    """
    boxes = np.array(genes, np.float64, order="C")
    _turn_to_boxes(boxes.reshape(-1, 5))
    return boxes


@compiled
def _turn_to_boxes(rows: Floats) -> None:
    for i in range(rows.shape[0]):
        cos, sin = math.cos(rows[i, 2]), math.sin(rows[i, 2])
        w, d = 0.5 * rows[i, 3], 0.5 * rows[i, 4]
        rows[i, 0] += w * cos - d * sin
        rows[i, 1] += w * sin + d * cos
        rows[i, 2] += 0.5 * math.pi


def gene_bounds(problem: Problem) -> tuple[Floats, Floats]:
    """Least and greatest genes ``(n, 5)``: corners within the ground's bounds, any angle, sizes
    within the items' limits."""
    ground, items = problem.ground, problem.items
    n = len(items.low)
    low = np.column_stack([np.tile(ground.bounds[:2], (n, 1)), np.zeros(n), items.low])
    turns = np.full(n, 2.0 * np.pi)
    return low, np.column_stack([np.tile(ground.bounds[2:], (n, 1)), turns, items.high])
