"""Headings that are square to a wall of a room."""

from __future__ import annotations

from functools import lru_cache
from math import pi, remainder

import numpy as np

from scenewright.core.same import Same
from scenewright.domains.home.problem import Ground


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
