"""Headings that are square to a wall of a room."""

from __future__ import annotations

from math import pi, remainder

import numpy as np

from scenewright.core.same import once
from scenewright.domains.home.problem import Ground


def square_up(heading: float, ground: Ground) -> float:
    """The heading nearest to one that is square to a wall."""
    off = (remainder(heading - turn, pi / 2) for turn in _read_turns(ground))
    return heading - min(off, key=abs)


@once(64)
def _read_turns(ground: Ground) -> tuple[float, ...]:
    """The directions of the walls of a room, each once, less quarters of a turn."""
    way = ground.edges[:, 2:4] - ground.edges[:, :2]
    turns = np.remainder(np.arctan2(way[:, 1], way[:, 0]), np.pi / 2)
    return tuple(np.unique(turns.round(4)).tolist())
