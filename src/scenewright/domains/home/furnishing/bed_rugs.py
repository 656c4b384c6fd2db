"""Rugs of a bed that came without one: under its foot and out on both sides, along its open side,
or before its foot.

A rug in the middle of the free floor belongs to nothing. One that lies a little under the bed does.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.scene import Piece
from scenewright.domains.home.measures import TUCKED

Floats = NDArray[np.float64]

ASIDE = (0.6, 0.5, 0.4)  # reach of a rug under the foot beyond both sides, metres
FOOT = (0.3, 0.1, 0.0)  # and beyond the foot, metres
UNDER = (1.5, 1.2)  # and its length, metres
LENGTHS = (1.8, 1.6, 1.4, 1.2, 1.0)  # of a rug along a bed, metres
WIDTHS = (1.2, 1.0, 0.85, 0.7)  # of that, half a metre of it before the bed at least, metres
OFF_SIDES = 0.12  # by which a rug before the foot is narrower than the bed, metres
TOWARDS = (0.0, 0.1, 0.2, 0.3, 0.4, -0.2, -0.4)  # of its middle towards the foot, metres


def list_bed_rugs(bed: Piece) -> Floats:
    """Boxes (n, 5) of rugs of a bed, the best first: under its foot, out on both sides alike, the
    widest first; then along either side, the largest first; then before its foot.

    >>> from scenewright.core.scene import Pose, Size
    >>> bed = Piece("b", "double_bed", "", "a", Pose(0.0, 0.0, 0.0, 0.0), Size(1.6, 2.0, 0.5))
    >>> list_bed_rugs(bed)[0].round(2).tolist()
    [0.55, 0.0, 0.0, 2.8, 1.5]
    """
    (x, y, _, heading), c, s = bed.pose, cos(bed.pose.heading), sin(bed.pose.heading)
    rows = np.array([*_list_under(bed), *_list_along(bed), *_list_before(bed)])
    boxes = np.empty((len(rows), 5))
    boxes[:, 0] = x + rows[:, 0] * s + rows[:, 1] * c
    boxes[:, 1] = y - rows[:, 0] * c + rows[:, 1] * s
    boxes[:, 2], boxes[:, 3:] = heading, rows[:, 2:]
    return boxes


Row = tuple[float, float, float, float]


def _list_under(bed: Piece) -> Iterator[Row]:
    """How far to the right and ahead of a bed's middle rugs under its foot lie, and their width and
    depth."""
    for aside, beyond, deep in product(ASIDE, FOOT, UNDER):
        yield 0.0, bed.size.depth / 2 + beyond - deep / 2, bed.size.width + 2 * aside, deep


def _list_along(bed: Piece) -> Iterator[Row]:
    """The same of rugs along its sides."""
    sizes = sorted(product(WIDTHS, LENGTHS), key=lambda size: -size[0] * size[1])
    for (wide, long), towards, side in product(sizes, TOWARDS, (1.0, -1.0)):
        if abs(towards) + long / 2 <= bed.size.depth / 2:
            yield side * (bed.size.width / 2 - TUCKED + wide / 2), towards, wide, long


def _list_before(bed: Piece) -> Iterator[Row]:
    """The same of rugs before its foot, as wide as the bed and a little under it."""
    for deep in WIDTHS:
        yield 0.0, bed.size.depth / 2 - TUCKED + deep / 2, bed.size.width - OFF_SIDES, deep
