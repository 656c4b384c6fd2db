"""A layout: poses and sizes of the items, as plain arrays.

``boxes`` is ``(..., n, 5)``: centre x, centre y, heading, width, depth; leading axes are the
population. The frame is that of a piece (see :mod:`scenewright.scene`): the front looks along
the heading, the back edge is opposite.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Boxes = NDArray[np.float64]


class Layout(NamedTuple):
    """Boxes ``(n, 5)`` of the items, in the order of the problem's items, and their energy."""

    boxes: Boxes
    energy: float


def corners(boxes: Boxes) -> Boxes:
    """Corners ``(..., n, 4, 2)`` of boxes ``(..., n, 5)``, counter-clockwise from back right.

    Back right, front right, front left, back left, seen from above with the front ahead.

    >>> corners(np.array([[0.0, 0.0, np.pi / 2, 2.0, 1.0]])).round(3).tolist()
    [[[1.0, -0.5], [1.0, 0.5], [-1.0, 0.5], [-1.0, -0.5]]]
    """
    cos, sin = np.cos(boxes[..., 2]), np.sin(boxes[..., 2])
    right = np.stack([sin, -cos], -1) * boxes[..., 3:4] / 2
    front = np.stack([cos, sin], -1) * boxes[..., 4:5] / 2
    centre = boxes[..., :2]
    return np.stack(
        [
            centre + right - front,
            centre + right + front,
            centre - right + front,
            centre - right - front,
        ],
        -2,
    )
