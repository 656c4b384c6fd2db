"""Which points lie inside directed edges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def lie_inside(edges: Floats, x: Floats, y: Floats) -> NDArray[np.bool_]:
    """Which points (any shape, ``x`` and ``y`` alike) lie inside closed rings of edges (e, 4), by
    the parity of edges to their right (Shimrat 1962); one edge at a time, so that memory does not
    grow with their number.

    >>> square = np.array([[0, 0, 2, 0], [2, 0, 2, 2], [2, 2, 0, 2], [0, 2, 0, 0]], float)
    >>> lie_inside(square, np.array([1.0, 3.0]), np.array([1.0, 1.0])).tolist()
    [True, False]
    """
    odd = np.zeros(x.shape, bool)
    for x0, y0, x1, y1 in edges:
        if y0 != y1:
            odd ^= ((y0 > y) != (y1 > y)) & (x < (x1 - x0) * (y - y0) / (y1 - y0) + x0)
    return odd
