"""How far the long sides of boxes are from walls over most of their length."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import distance_to_segment
from scenewright.geometry.compiled import compiled

Floats = NDArray[np.float64]

ALONG = 0.3  # of the depth, ahead of the middle and behind it: where a side is measured


def measure_flank_gaps(boxes: Floats, walls: Floats) -> Floats:
    """Metres ``(n, 2)`` from the left and the right side of boxes ``(n, 5)`` to the nearest of
    ``walls`` (w, 4), the larger of two places of each side, so that a side at a wall is there over
    most of its length.

    >>> walls = np.array([[0.0, 0.0, 4.0, 0.0], [4.0, 0.0, 4.0, 4.0]])
    >>> box = np.array([[3.5, 1.2, np.pi / 2, 0.9, 2.0]])
    >>> measure_flank_gaps(box, walls).round(2).tolist()
    [[0.95, 0.05]]
    """
    gaps = np.empty((len(boxes), 2))
    fill_flank_gaps(np.ascontiguousarray(boxes), np.ascontiguousarray(walls), gaps)
    return gaps


@compiled
def fill_flank_gaps(boxes: Floats, walls: Floats, gaps: Floats) -> None:
    """Write :func:`measure_flank_gaps` into ``gaps`` (n, 2)."""
    for i in range(boxes.shape[0]):
        c, s = math.cos(boxes[i, 2]), math.sin(boxes[i, 2])
        for side in range(2):
            out, far = (2 * side - 1) * boxes[i, 3] / 2, 0.0
            for end in range(2):
                ahead = (2 * end - 1) * ALONG * boxes[i, 4]
                x, y = boxes[i, 0] + out * s + ahead * c, boxes[i, 1] - out * c + ahead * s
                near = math.inf
                for k in range(walls.shape[0]):
                    w = walls[k]
                    near = min(near, distance_to_segment(x, y, w[0], w[1], w[2], w[3]))
                far = max(far, near)
            gaps[i, side] = far
