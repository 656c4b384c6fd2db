"""A layout: poses and sizes of the items, as plain arrays.

``boxes`` is ``(..., n, 5)``: centre x, centre y, heading, width, depth; leading axes are the
population. The frame is that of a piece (see :mod:`scenewright.core.scene`): the front looks along
the heading, the back edge is opposite.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError

Boxes = NDArray[np.float64]


class Layout(NamedTuple):
    """Boxes ``(n, 5)`` of the items, in the order of the problem's items, and their energy."""

    boxes: Boxes
    energy: float


class NamedBox(NamedTuple):
    """One row of a layout given by hand or by another program: what it is of (the furniture group
    of a home, the demand of a hall, the building of a site), and its box (centre x, centre y,
    heading, width, depth) in metres and radians."""

    name: str
    box: tuple[float, float, float, float, float]


Layouts = Mapping[str, Sequence[NamedBox]]
"""Rows of a layout by the id of the room, hall or site they are in."""


def check_layouts(layouts: Layouts, spaces: Sequence[str]) -> None:
    """InputError for a space there is not, or a box that is not five numbers with an area."""
    for space, rows in layouts.items():
        if space not in spaces:
            raise InputError(f"unknown space '{space}'", f"use one of: {', '.join(spaces[:20])}")
        for number, row in enumerate(rows):
            box = np.asarray(row.box, np.float64)
            if box.shape != (5,) or not np.isfinite(box).all() or (box[3:] <= 0).any():
                raise InputError(
                    "is not a box (x, y, heading, width, depth)",
                    "give five numbers, width and depth above 0",
                    place=f"{space}[{number}] '{row.name}'",
                )


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
