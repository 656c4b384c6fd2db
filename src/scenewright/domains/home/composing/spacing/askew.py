"""What is to stand square to some wall of its room and does not."""

from __future__ import annotations

from functools import lru_cache
from math import pi, remainder

import numpy as np

from scenewright.catalog.classes import BEDS, SOFAS
from scenewright.core.same import Same
from scenewright.core.scene import Piece
from scenewright.domains.home.problem import Ground

SQUARE = frozenset(
    (*SOFAS, *BEDS, "wardrobe", "chest_of_drawers", "sideboard", "bookcase", "storage_shelf")
)
"""What is to stand so; armchairs and what goes with them need not."""
ASKEW, COST = 0.05, 16.0
"""By how much more than this something is turned from every wall (radians), and what that costs."""


def is_askew(piece: Piece, ground: Ground) -> bool:
    """Whether a piece of those is askew to all walls of a room."""
    if piece.category not in SQUARE:
        return False
    return abs(piece.pose.heading - square_up(piece.pose.heading, ground)) > ASKEW


def square_up(heading: float, ground: Ground) -> float:
    """The heading nearest to one that is square to a wall."""
    off = (remainder(heading - turn, pi / 2) for turn in _read_turns(Same(ground)))
    return heading - min(off, key=abs)


@lru_cache(maxsize=64)
def _read_turns(same: Same[Ground]) -> tuple[float, ...]:
    """The directions of the walls of a room, each once, less quarters of a turn."""
    way = same.value.edges[:, 2:4] - same.value.edges[:, :2]
    turns = np.remainder(np.arctan2(way[:, 1], way[:, 0]), np.pi / 2)
    return tuple(np.unique(turns.round(4)).tolist())
