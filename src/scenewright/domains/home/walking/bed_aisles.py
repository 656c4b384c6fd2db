"""Beds for two that stand free between walls or furniture: one gets in sideways from the foot.

A bed for two is used from its long sides. Where a bay is hardly wider than the bed no route comes
to either of them; if both are free a little, one goes there sideways from the foot. A person turned
sideways takes 0.33 m (Panero, Zelnik 1979: 0.29 to 0.33 m body depth).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import cos, hypot, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.scene import Piece
from scenewright.geometry.boxes import area_in_polygon, common_area, make_frame

Floats = NDArray[np.float64]
Box = tuple[float, float, float, float, float]

DOUBLE = "double_bed"
AISLE = 0.335  # width that one passes sideways, metres; the referee asks for 5 mm less
HEAD = 0.45  # of a bed's length its nightstands take, metres
PASSED = 0.02  # share of an aisle that something may take, as a radiator does


def list_aisles(bed: Piece, width: float = AISLE, further: float = AISLE) -> tuple[Box, Box]:
    """The boxes on the left and the right of a bed, ``width`` metres wide, from its nightstands to
    ``further`` metres beyond its foot."""
    long = bed.size.depth - HEAD + further
    ahead = (HEAD + further) / 2
    return _beside(bed, -1.0, ahead, width, long), _beside(bed, 1.0, ahead, width, long)


def list_mouths(bed: Piece, depth: float) -> tuple[Box, Box]:
    """The boxes before the foot, ``depth`` metres deep, from which one gets to the aisles."""
    ahead = (bed.size.depth + depth) / 2
    return _beside(bed, -1.0, ahead, AISLE, depth), _beside(bed, 1.0, ahead, AISLE, depth)


def are_open(bed: Piece, solid: Iterable[Sequence[float]], edges: Floats) -> bool:
    """Whether both aisles of a bed are free of all that is ``solid``, boxes (n, 5), and on the
    floor within ``edges`` (e, 4)."""
    boxes = list(solid)
    return all(is_free(aisle, boxes, edges) for aisle in list_aisles(bed))


def is_free(aisle: Box, solid: Iterable[Sequence[float]], edges: Floats) -> bool:
    """Whether no more than :data:`PASSED` of an aisle is taken or no floor."""
    frame, (x, y, _, width, depth) = make_frame(*aisle), aisle
    most, reach = PASSED * width * depth, hypot(width, depth) / 2
    taken = width * depth - float(area_in_polygon(frame, edges))
    for u, v, turn, wide, deep in solid:
        if taken <= most and hypot(u - x, v - y) < reach + hypot(wide, deep) / 2:
            taken += float(common_area(frame, make_frame(u, v, turn, wide, deep)))
    return taken <= most


def _beside(bed: Piece, side: float, ahead: float, width: float, depth: float) -> Box:
    """A box that touches the line of a bed's right (``side`` 1) or left (-1) side, its middle
    ``ahead`` metres before that of the bed."""
    (x, y, _, turn), aside = bed.pose, side * (bed.size.width + width) / 2
    c, s = cos(turn), sin(turn)
    return x + ahead * c + aside * s, y + ahead * s - aside * c, turn, width, depth
