"""The largest rectangle of marked cells: a stack of rising columns, row by row."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Flags = NDArray[np.bool_]


def largest_rectangle(free: Flags) -> tuple[int, int, int, int]:
    """First and last (exclusive) row and column of the largest rectangle of marked cells.

    >>> largest_rectangle(np.array([[1, 1, 0], [1, 1, 1], [0, 1, 1]], bool))
    (0, 2, 0, 2)
    """
    best, found = 0, (0, 0, 0, 0)
    heights = np.zeros(free.shape[1], int)
    for row in range(len(free)):
        heights = np.where(free[row], heights + 1, 0)
        stack: list[tuple[int, int]] = []
        for column, high in enumerate([*heights.tolist(), 0]):
            start = column
            while stack and stack[-1][1] >= high:
                start, tall = stack.pop()
                if tall * (column - start) > best:
                    best, found = tall * (column - start), (row + 1 - tall, row + 1, start, column)
            stack.append((start, high))
    return found
