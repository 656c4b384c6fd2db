"""Corners in which rows along two walls meet."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.zoning.borders import WallStretch

CORNER_BEHIND, CORNER_OFF, AT = 0.12, 0.1, 0.05
"""Metres behind the start of a stretch and off its wall at which another wall is looked for, and
from a corner that count as in it."""


def corner_share(wall: WallStretch, floor: shapely.Polygon) -> float:
    """The share of its depth that a row at the wall before the start of a stretch takes of it: 1
    in right and acute angles, less in obtuse ones, 0 where no wall stands there.

    >>> room = shapely.Polygon([(0, 0), (6, 0), (8, 2), (8, 5), (0, 5)])
    >>> corner_share(WallStretch(0.0, 0.0, 6.0, 0.0), room)
    1.0
    >>> round(corner_share(WallStretch(6.0, 0.0, 8.0, 2.0), room), 3)
    0.707
    >>> corner_share(WallStretch(2.0, 0.0, 6.0, 0.0), room)
    0.0
    """
    start, way = np.array([wall.x0, wall.y0]), np.array([wall.x1 - wall.x0, wall.y1 - wall.y0])
    way = way / np.hypot(*way)
    probe = start - CORNER_BEHIND * way + CORNER_OFF * np.array([-way[1], way[0]])
    if shapely.contains_xy(floor, *probe):
        return 0.0
    rings = [shapely.get_coordinates(ring) for ring in (floor.exterior, *floor.interiors)]
    before = [step for ring in rings for step in np.diff(ring, axis=0)[_end_at(ring, start)]]
    if len(before) != 1 or before[0] @ way <= 0.0:
        return 1.0
    (x, y), (along, across) = before[0], way
    return float(min(abs(x * across - y * along) / np.hypot(x, y), 1.0))


def _end_at(ring: Floats, point: Floats) -> NDArray[np.bool_]:
    """Which edges (k - 1,) of a ring (k, 2) end at a point (2,)."""
    return np.asarray(np.hypot(*(ring[1:] - point).T) < AT, bool)
