"""Patterns as lines: what fills a shape where a file format has no patterns of its own."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from scenewright.drawing.marks import FillPattern, PathMark, Style


def hatch_lines(
    pattern: FillPattern, low: NDArray[np.float64], high: NDArray[np.float64]
) -> list[tuple[NDArray[np.float64], Style]]:
    """Lines ``(n, 2, 2)`` that cover a box with a pattern, from corner ``low`` to ``high`` on
    paper, each set with its pen. A pattern's lines cross its tile along a side.

    >>> from scenewright.drawing.marks import line
    >>> tile = FillPattern("t", 1.0, 1.0, 0.0, "", (line([(0, 0), (0, 1)]),))
    >>> [(rows, _)] = hatch_lines(tile, np.array([0.5, 0.0]), np.array([3.5, 1.0]))
    >>> rows[:, 0, 0].tolist()
    [1.0, 2.0, 3.0]
    """
    angle = np.radians(pattern.turn)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]]) @ turn.T
    least, most = corners.min(0), corners.max(0)
    found = []
    for mark in pattern.marks:
        if not isinstance(mark, PathMark):
            continue
        for (x0, y0), (x1, y1) in (pair for ring in mark.rings for pair in pairwise(ring)):
            axis = 0 if abs(x1 - x0) < abs(y1 - y0) else 1
            step = (pattern.width, pattern.height)[axis]
            places = _repeat((x0, y0)[axis], step, least[axis], most[axis])
            rows = np.empty((len(places), 2, 2))
            rows[:, :, axis] = places[:, None]
            rows[:, :, 1 - axis] = (least[1 - axis], most[1 - axis])
            found.append((rows @ turn, mark.style))
    return found


def _repeat(first: float, step: float, least: float, most: float) -> NDArray[np.float64]:
    numbers = np.arange(np.ceil((least - first) / step), np.floor((most - first) / step) + 1)
    return np.asarray(first + numbers * step, dtype=float)
