"""A layout: poses and sizes of the items, as plain arrays.

``boxes`` is ``(..., n, 5)``: centre x, centre y, heading, width, depth; leading axes are the
population. The frame is that of a piece (see :mod:`scenewright.core.scene`): the front looks along
the heading, the back edge is opposite.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
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


SEARCH, FIT, ROUTES, REPAIR, SETTLED = STAGES = ("search", "fit", "routes", "repair", "settled")
"""Stages of a run in which a space is pictured, in the order in which they first come."""


class BestLayout(NamedTuple):
    """What a run has found so far in one space: the ``share`` of its present search, the energy of
    its best layout (infinite where the solver knows none), and ``rows``, which makes that layout
    as it may be given by hand. It may only be called before the listener returns: the search goes
    on with the same arrays.

    ``stage`` is what it comes from: the search; what fits furniture into it; what keeps routes
    open; a repair; or that it is settled. What changes a layout after the search has its
    ``reason`` in words. A stage may be met again: rooms that lack something are tried again."""

    space: str
    share: float
    energy: float
    rows: Callable[[], tuple[NamedBox, ...]]
    stage: str = SEARCH
    reason: str = ""


Watch = Callable[[BestLayout], None]
"""A listener to the best layouts of a run; called from the threads that search."""


def name_rows(names: Sequence[str], boxes: Boxes) -> tuple[NamedBox, ...]:
    """Rows of names and boxes ``(n, 5)``.

    >>> name_rows(["desk"], np.array([[1.0, 2.0, 0.0, 1.2, 0.6]]))
    (NamedBox(name='desk', box=(1.0, 2.0, 0.0, 1.2, 0.6)),)
    """
    found = zip(names, np.asarray(boxes, np.float64).tolist(), strict=True)
    return tuple(NamedBox(name, (x, y, heading, w, d)) for name, (x, y, heading, w, d) in found)


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
    found = np.empty((*boxes.shape[:-1], 4, 2))
    for k, (right, front) in enumerate(((sin, cos), (-cos, sin))):
        right, front = right * boxes[..., 3] / 2, front * boxes[..., 4] / 2
        least, most = boxes[..., k] - right, boxes[..., k] + right
        found[..., 0, k], found[..., 1, k] = most - front, most + front
        found[..., 2, k], found[..., 3, k] = least + front, least - front
    return found
