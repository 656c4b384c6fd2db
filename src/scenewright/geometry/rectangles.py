"""The largest rectangle of marked cells: a stack of rising columns, row by row."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled

Flags = NDArray[np.bool_]
Ints = NDArray[np.int64]


def largest_rectangle(free: Flags) -> tuple[int, int, int, int]:
    """First and last (exclusive) row and column of the largest rectangle of marked cells.

    >>> largest_rectangle(np.array([[1, 1, 0], [1, 1, 1], [0, 1, 1]], bool))
    (0, 2, 0, 2)
    """
    found, work = np.zeros(4, np.int64), np.zeros((3, free.shape[1] + 1), np.int64)
    find_largest(free, work, found)
    first, last, left, right = found.tolist()
    return first, last, left, right


@compiled
def find_largest(free: Flags, work: Ints, found: Ints) -> None:
    """Write :func:`largest_rectangle` to ``found`` (4,); ``work`` (3, columns + 1), all 0, holds
    the heights of columns and the stack: where each step starts and how high it is."""
    heights, starts, steps = work[0], work[1], work[2]
    best, columns = 0, free.shape[1]
    for row in range(free.shape[0]):
        top = 0
        for column in range(columns + 1):
            start = column
            if column < columns:
                heights[column] = heights[column] + 1 if free[row, column] else 0
            while top > 0 and steps[top - 1] >= heights[column]:
                top -= 1
                start, tall = starts[top], steps[top]
                if tall * (column - start) > best:
                    best = tall * (column - start)
                    found[0], found[1], found[2], found[3] = row + 1 - tall, row + 1, start, column
            starts[top], steps[top] = start, heights[column]
            top += 1
