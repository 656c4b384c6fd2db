"""Bar stools: before counters to sit at, and round high tables."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from scenewright.catalog.kinds.usual import is_high
from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.accessories.setting import Setting
from scenewright.domains.hall.accessories.spots import Spots, face, join_spots, make_spots
from scenewright.domains.hall.holdings import HallDemand, may_stand_together
from scenewright.domains.hall.problem import Floats

COUNTER = "counter"
PLACE, OFF, SERVED = 0.6, 0.05, 0.9
"""Metres of a counter for each stool, between the two, and of each counter that stay free for who
is served standing."""
CLOSE, LITTLE = 0.55, 0.8
"""The same where one more finds a place so."""
AT_TABLE, NEXT = 0.5, 0.1
"""What a place at a table costs more than one at a counter, and each next one of the same."""


def may_sit_high(wish: HallDemand, wishes: list[HallDemand]) -> bool:
    """Whether some counter or high table may stand in a zone of stools."""
    return any(
        (other.category == COUNTER or is_high(other.category, other.sizes[0].height))
        and may_stand_together(wish, other)
        for other in wishes
    )


def find_stool_spots(setting: Setting, size: Size) -> Spots:
    """Spots before the counters and round the high tables that stand."""
    parts = [make_spots(np.zeros((0, 5)), 0.0)]
    for piece in setting.pieces:
        if piece.category == COUNTER:
            parts.append(_weigh(list(_before(piece, size)), 0.0))
        elif is_high(piece.category, piece.size.height):
            parts.append(_weigh(list(_around(piece, size)), AT_TABLE))
    return join_spots(parts)


def _weigh(rows: list[Floats], cost: float) -> Spots:
    """Spots (k, 5) of one piece, each next one dearer."""
    boxes = np.array(rows).reshape(-1, 5)
    costs: Floats = cost + NEXT * np.arange(len(boxes), dtype=np.float64)
    return make_spots(boxes, costs)


def _before(counter: Piece, size: Size) -> Iterator[Floats]:
    """Places along the front of a counter but for its last metre, looking at it."""
    heading, wide = counter.pose.heading, counter.size.width
    front = np.array([math.cos(heading), math.sin(heading)])
    right = np.array([front[1], -front[0]])
    at = np.array(counter.pose[:2]) + (0.5 * (counter.size.depth + size.depth) + OFF) * front
    count = count_before(wide)
    pitch = PLACE if count == _count(wide, PLACE, SERVED) else CLOSE
    for number in range(count):
        along = (number + 0.5) * pitch - 0.5 * wide
        yield face((at + along * right)[None], heading + math.pi, size)[0]


def count_before(wide: float) -> int:
    """How many stools have a place before a counter of so many metres, closer together where one
    more finds a place so.

    >>> count_before(4.0), count_before(3.0)
    (5, 4)
    """
    return max(_count(wide, PLACE, SERVED), _count(wide, CLOSE, LITTLE))


def _count(wide: float, place: float, served: float) -> int:
    return max(int((wide - served) / place + 1e-9), 0)


def _around(table: Piece, size: Size) -> Iterator[Floats]:
    """Places at the sides of a table, each across from another."""
    far = 0.5 * (table.size.width + size.depth) + OFF
    for turns in (0, 2, 1, 3):
        angle = table.pose.heading + 0.5 * math.pi * turns
        at = np.array(table.pose[:2]) + far * np.array([math.cos(angle), math.sin(angle)])
        yield face(at[None], angle + math.pi, size)[0]
