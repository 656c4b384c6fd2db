"""Heights of the ground over the plan, as a square grid of numbers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.space import Points

Floats = NDArray[np.float64]


class HeightGrid(NamedTuple):
    """Heights in metres ``values`` (rows to the north, columns to the east), ``step`` metres
    apart, the first at ``start`` (x, y). Between them they are bilinear, beyond them as at the
    edge."""

    start: tuple[float, float]
    step: float
    values: Floats

    @property
    def points(self) -> Floats:
        """The points (rows, columns, 2) of the grid."""
        rows, columns = self.values.shape
        x = self.start[0] + self.step * np.arange(columns)
        y = self.start[1] + self.step * np.arange(rows)
        return np.stack(np.meshgrid(x, y), -1)


class CellPosition(NamedTuple):
    """Where points lie in a grid: row and column of their cell, and how far into it, in [0, 1]."""

    row: NDArray[np.int64]
    column: NDArray[np.int64]
    up: Floats
    right: Floats


def heights_at(grid: HeightGrid, points: Points) -> Floats:
    """The heights in metres at points (n, 2), bilinear.

    >>> roof = HeightGrid((0.0, 0.0), 2.0, np.array([[0.0, 2.0], [4.0, 6.0]]))
    >>> heights_at(roof, np.array([[1.0, 1.0], [9.0, 0.0]])).tolist()
    [3.0, 2.0]
    """
    at, z = _locate(grid, points), grid.values
    low = z[at.row, at.column] * (1 - at.right) + z[at.row, at.column + 1] * at.right
    high = z[at.row + 1, at.column] * (1 - at.right) + z[at.row + 1, at.column + 1] * at.right
    return np.asarray(low * (1 - at.up) + high * at.up)


def facet_heights_at(grid: HeightGrid, points: Points) -> Floats:
    """The heights in metres at points (n, 2) on the triangles a grid is drawn with: each cell is
    halved from its lower left to its upper right corner."""
    at, z = _locate(grid, points), grid.values
    here, far = z[at.row, at.column], z[at.row + 1, at.column + 1]
    right, up = z[at.row, at.column + 1], z[at.row + 1, at.column]
    below = here + at.right * (right - here) + at.up * (far - right)
    above = here + at.up * (up - here) + at.right * (far - up)
    return np.where(at.right >= at.up, below, above)


def _locate(grid: HeightGrid, points: Points) -> CellPosition:
    rows, columns = grid.values.shape
    at = (np.asarray(points, float) - np.array(grid.start)) / grid.step
    x, y = np.clip(at[..., 0], 0, columns - 1), np.clip(at[..., 1], 0, rows - 1)
    column = np.minimum(x.astype(np.int64), columns - 2)
    row = np.minimum(y.astype(np.int64), rows - 2)
    return CellPosition(row, column, y - row, x - column)
