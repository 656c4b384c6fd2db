"""Neighbours: houses share a wall in line, stand square to each other, or leave a passage.

Roofs reach as far as footprints do; those of houses that touch askew would cut into each other.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.streetside.plots import PASSAGE, Flags, Shapes

Floats = NDArray[np.float64]

TOUCHING, SHARED = 0.3, 2.0
"""Metres within which walls are one, and of the least wall that is shared."""
IN_LINE, SQUARE = 0.02, 0.05
"""Radians by which houses that share a wall, and those nearer than a passage, may be askew."""


def find_crowding(shapes: Shapes, turns: Floats, others: Shapes, other_turns: Floats) -> Flags:
    """Which footprints (k,) at angles ``turns`` (k,) crowd one of ``others`` (n,): they are nearer
    than a passage and askew to it, or touch it by less than :data:`SHARED` metres of wall.

    >>> house = np.array([shapely.box(0, 0, 8, 6)], object)
    >>> others = np.array([shapely.box(9, 0, 12, 6), shapely.box(8, 5, 12, 9)], object)
    >>> [bool(find_crowding(house, np.array([turn]), others[[k]], np.zeros(1))[0])
    ...  for turn, k in ((0.0, 0), (0.1, 0), (0.0, 1))]
    [False, True, True]
    """
    found = np.zeros(len(shapes), bool)
    if not len(others) or not len(shapes):
        return found
    one, other = shapely.STRtree(others).query(shapes, predicate="dwithin", distance=PASSAGE)
    turn = turns[one] - other_turns[other]
    askew = np.abs((turn + np.pi / 4) % (np.pi / 2) - np.pi / 4)
    gap = shapely.distance(shapes[one], others[other])
    touching = gap < TOUCHING
    found[one[askew > np.where(touching, IN_LINE, SQUARE)]] = True
    one, other, gap = one[touching], other[touching], gap[touching]
    near = shapely.buffer(shapes[one], gap + SHARED * IN_LINE, quad_segs=2)
    along = shapely.length(shapely.intersection(shapely.boundary(others[other]), near))
    found[one[along < SHARED]] = True
    return found
