"""Floor on which somebody could stand and to which nobody gets: a strip behind a sofa, a niche; and
doors whose own leaf, once it is open, leaves no way on.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.piece_outlines import boxes_of
from scenewright.core.same import once
from scenewright.core.scene import Piece
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.walking.ways import find_shut_off, walk_floor
from scenewright.geometry.boxes import Floats

CUT_FROM = 10.0
"""Area in m² of a room from which its floor is worth getting to."""
SQUEEZE, STAND = 0.44, 0.6
"""Gaps through which one gets, and the floor one stands on, in metres."""
SHUT = 15.0
"""What each door costs whose leaf shuts it off."""
CUT_UNSEEN, COST, EACH, CUT_COUNTED = 0.1, 4.0, 5.0, 10.0
"""Square metres of middles of such floor that are not noticed, what more costs, what each square
metre of them costs besides, and the most that counts."""


def cost_of_cut_off(pieces: Sequence[Piece], ground: Ground) -> float:
    """What it costs that some floor of a room is cut off by pieces."""
    if ground.area < CUT_FROM or not len(ground.doors):
        return 0.0
    area = measure_cut_off(pieces, ground)
    return min(COST + EACH * area, CUT_COUNTED) if area > CUT_UNSEEN else 0.0


def cost_of_shut_off(pieces: Sequence[Piece], ground: Ground) -> float:
    """What it costs that who opens a door to a right angle stands between its leaf and pieces."""
    if not len(ground.leaves) or len(ground.doors) < 2:
        return 0.0
    boxes: Floats = np.array([box for p in pieces for box in boxes_of(p)]).reshape(-1, 5)
    shut = find_shut_off(ground, boxes, SQUEEZE) & ~_find_shut_empty(ground)
    return SHUT * int(shut.sum())


@once(64)
def _find_shut_empty(ground: Ground) -> NDArray[np.bool_]:
    nothing: NDArray[np.float64] = np.zeros((0, 5))
    return find_shut_off(ground, nothing, SQUEEZE)


def measure_cut_off(pieces: Sequence[Piece], ground: Ground) -> float:
    """Square metres of the middles of discs :data:`STAND` wide that stand free in a room and to
    which none :data:`SQUEEZE` wide gets from a door, less what is cut off in the empty room."""
    boxes: Floats = np.array([box for p in pieces for box in boxes_of(p)]).reshape(-1, 5)
    return max(walk_floor(ground, boxes, SQUEEZE, STAND) - _measure_empty(ground), 0.0)


@once(64)
def _measure_empty(ground: Ground) -> float:
    nothing: NDArray[np.float64] = np.zeros((0, 5))
    return walk_floor(ground, nothing, SQUEEZE, STAND)
