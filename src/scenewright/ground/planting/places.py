"""Places of trees and lamps: in rows beside ways, on a shaken grid of open ground, clear of what
stands there."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

Floats = NDArray[np.float64]
AVENUE, VERGE = 10.0, 1.6
"""Distance of the trees of a row, and of their stems from the edge of a street, in metres."""
FROM_HOUSES, FROM_WAYS = 3.2, 1.4
"""Metres that stems keep from houses with gardens, and from ways."""
SHAKEN = 0.35
"""The share of its step by which a point of a grid is moved at most."""


def points_beside(line: Floats, off: float, step: float, start: float) -> Floats:
    """Points ``(n, 3)`` every ``step`` metres along a line (k, 2), ``off`` metres to its left, and
    the direction of the line there.

    >>> points_beside(np.array([[0.0, 0.0], [10.0, 0.0]]), 2.0, 5.0, 1.0).tolist()
    [[1.0, 2.0, 0.0], [6.0, 2.0, 0.0]]
    """
    length = np.hypot(*np.diff(line, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(length)])
    at = np.arange(start, along[-1], step)
    piece = np.clip(np.searchsorted(along, at, side="right") - 1, 0, len(length) - 1)
    ways = np.diff(line, axis=0)[piece] / length[piece, None]
    points = line[piece] + ways * (at - along[piece])[:, None]
    left = np.stack([-ways[:, 1], ways[:, 0]], 1)
    return np.column_stack([points + off * left, np.arctan2(ways[:, 1], ways[:, 0])])


def turn_to_road(direction: Floats, side: int) -> Floats:
    """The headings in [-π, π) of lamps whose arms reach over the road, from the ``side`` of it on
    which they stand (1: left, -1: right) and its direction there.

    >>> turn_to_road(np.array([0.0]), 1).round(3).tolist()
    [-1.571]
    """
    turned = direction - side * np.pi / 2 + np.pi
    return np.asarray(turned % (2 * np.pi) - np.pi)


def shake_grid(low: Floats, high: Floats, step: float, rng: np.random.Generator) -> Floats:
    """Points (n, 2) of a grid between two corners (2,), each moved a little."""
    grid = np.stack(np.meshgrid(*(np.arange(a, b, step) for a, b in zip(low, high, strict=True))))
    points = grid.reshape(2, -1).T
    return np.asarray(points + rng.uniform(-SHAKEN, SHAKEN, points.shape) * step)


def drop_near(points: Floats, shapes: shapely.STRtree, distance: float) -> Floats:
    """Points (n, k), x and y ahead, without those within a ``distance`` in metres of a shape.

    >>> drop_near(np.array([[0.0, 0.0], [5.0, 0.0]]), shapely.STRtree([shapely.Point(1, 0)]), 2.0)
    array([[5., 0.]])
    """
    made = shapely.points(points[:, :2])
    near = shapes.query(made, predicate="dwithin", distance=distance)[0]
    return np.delete(points, np.unique(near), axis=0)


def keep_apart(points: Floats, distance: float) -> Floats:
    """Points (n, k) without those nearer than ``distance`` to one before them that stays.

    >>> keep_apart(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), 1.5).tolist()
    [[0.0, 0.0], [2.0, 0.0]]
    """
    if not len(points):
        return points
    made = shapely.points(points[:, :2])
    first, second = shapely.STRtree(made).query(made, predicate="dwithin", distance=distance)
    gone: set[int] = set()
    for a, b in sorted(zip(first.tolist(), second.tolist(), strict=True)):
        if a < b and a not in gone:
            gone.add(b)
    return np.delete(points, sorted(gone), axis=0)


def spread_evenly(points: Floats, count: int) -> Floats:
    """``count`` of some points in rows, at even steps; all where there are no more."""
    if count >= len(points):
        return points
    return points[((np.arange(count) + 0.5) * len(points) / max(count, 1)).astype(int)]
