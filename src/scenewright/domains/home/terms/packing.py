"""Terms of packing: inside the room, not on each other, filling it as it should be filled."""

from __future__ import annotations

import math

from scenewright.geometry.boxes import Floats, Frame, area_in_polygon, common_area
from scenewright.geometry.compiled import compiled, inlined

LEAST_SHARE = 0.40
MOST_SHARE = 0.55


@inlined
def outside(frame: Frame, edges: Floats) -> float:
    """A(P) - A(P ∩ R): area of an item outside the room, square metres (Liu et al. 2017, C1)."""
    return max(4.0 * frame[4] * frame[5] - area_in_polygon(frame, edges), 0.0)


@compiled
def overlap(a: Frame, b: Frame) -> float:
    """A(P_i ∩ P_j): area shared by two items, square metres (Liu et al. 2017, C2)."""
    return common_area(a, b)


@compiled
def size(area: float, room: float) -> float:
    """How far the items' share S of the floor lies outside [0.40, 0.55] (Liu et al. 2017, C7).

    0 inside, 1 - (S / 0.40)² below, 1 - (0.55 / S)² above; range [0, 1].

    >>> size(4.5, 10.0), size(2.0, 10.0)
    (0.0, 0.75)
    """
    share = area / room
    if share < LEAST_SHARE:
        return 1.0 - (share / LEAST_SHARE) ** 2
    if share > MOST_SHARE:
        return 1.0 - (MOST_SHARE / share) ** 2
    return 0.0


@inlined
def wish(frame: Frame, width: float, depth: float) -> float:
    """|w - w*| / w* + |d - d*| / d*: relative deviation from the preferred size; NaN: none.

    The paper weighs only the summed area; this keeps each item near the size it was asked for.
    """
    off = 0.0
    if not math.isnan(width):
        off += abs(2.0 * frame[4] - width) / width
    if not math.isnan(depth):
        off += abs(2.0 * frame[5] - depth) / depth
    return off
