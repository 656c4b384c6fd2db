"""How a house stands to those around it and to the street: gaps, angles, distances.

Angles are between the longer sides of the least rectangles, modulo 90 degrees, so in [0, π/4].
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.standing import Floats, Indices, Shapes, StandingHouses

FAR = 1e6
"""The gap, in metres, of a house that stands alone."""


class PoseRelations(NamedTuple):
    """Of each pose (k,): metres to the ``nearest`` house and which it is (-1: none), the angle
    ``turn`` from it, metres to the nearest street side and the angle ``street_turn`` from it."""

    gap: Floats
    nearest: Indices
    turn: Floats
    street: Floats
    street_turn: Floats


def relate(
    shapes: Shapes, angles: Floats, standing: StandingHouses, streets: Points
) -> PoseRelations:
    """The relations of footprints (k,) at angles (k,) to houses that stand and to street sides
    (s, 2, 2).

    >>> house = np.array([shapely.box(0, 6, 8, 12)], object)
    >>> others = StandingHouses(np.array([shapely.box(10, 6, 14, 10)], object),
    ...                   np.array([[12.0, 8, 0.1, 4, 4]]), np.array([0]))
    >>> found = relate(house, np.zeros(1), others, np.array([[[0.0, 0.0], [20.0, 0.0]]]))
    >>> [round(float(v[0]), 3) for v in found]
    [2.0, 0.0, 0.1, 6.0, 0.0]
    """
    count = len(shapes)
    gap, nearest = np.full(count, FAR), np.full(count, -1)
    turn = np.zeros(count)
    if len(standing.shapes) and count:
        away = shapely.distance(shapes[:, None], standing.shapes[None])
        nearest = away.argmin(1)
        gap = away[np.arange(count), nearest]
        turn = fold(angles - standing.frames[nearest, 2])
    sides = shapely.linestrings(streets)
    to_street = shapely.distance(shapes[:, None], sides[None])
    side = to_street.argmin(1)
    along = streets[:, 1] - streets[:, 0]
    street_turn = fold(angles - np.arctan2(along[side, 1], along[side, 0]))
    return PoseRelations(gap, nearest, turn, to_street.min(1), street_turn)


def fold(angle: Floats) -> Floats:
    """Angles (n,) modulo a right angle, without sign: in [0, π/4].

    >>> fold(np.array([0.1, -0.1, np.pi / 2 + 0.2])).round(3).tolist()
    [0.1, 0.1, 0.2]
    """
    return np.abs((angle + np.pi / 4) % (np.pi / 2) - np.pi / 4)
