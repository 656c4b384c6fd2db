"""Banks on a raster: how high ground stands that falls no steeper than a batter from what is fixed.

From cells fixed at heights z_i the highest ground of slope s through none of them is
max_i (z_i - s d_i), d_i the distance to each: swept over the raster in four directions (chamfer
distances, at most 8 per cent too long; Borgefors 1986).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled

Floats = NDArray[np.float64]
SWEEPS = 2


@compiled
def lift_by_batters(heights: Floats, fall: float) -> None:
    """Raise the cells of ``heights`` (rows, columns) in place to what falls by ``fall`` metres a
    cell from their neighbours; unknown ones start at -inf."""
    rows, columns = heights.shape
    slant = fall * np.sqrt(2.0)
    for _ in range(SWEEPS):
        for i in range(rows):
            for j in range(columns):
                best = heights[i, j]
                if i > 0:
                    best = max(best, heights[i - 1, j] - fall)
                    if j > 0:
                        best = max(best, heights[i - 1, j - 1] - slant)
                    if j < columns - 1:
                        best = max(best, heights[i - 1, j + 1] - slant)
                if j > 0:
                    best = max(best, heights[i, j - 1] - fall)
                heights[i, j] = best
        for i in range(rows - 1, -1, -1):
            for j in range(columns - 1, -1, -1):
                best = heights[i, j]
                if i < rows - 1:
                    best = max(best, heights[i + 1, j] - fall)
                    if j > 0:
                        best = max(best, heights[i + 1, j - 1] - slant)
                    if j < columns - 1:
                        best = max(best, heights[i + 1, j + 1] - slant)
                if j < columns - 1:
                    best = max(best, heights[i, j + 1] - fall)
                heights[i, j] = best


def bank(heights: Floats, fall: float) -> Floats:
    """The highest ground (rows, columns) that falls no steeper than ``fall`` metres a cell from
    known cells of ``heights``; NaN is not known.

    >>> bank(np.array([[3.0, np.nan, np.nan]]), 1.0).tolist()
    [[3.0, 2.0, 1.0]]
    """
    found = np.where(np.isnan(heights), -np.inf, heights)
    lift_by_batters(found, fall)
    return found
