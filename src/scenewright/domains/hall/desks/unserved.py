"""Desks at which nobody can serve: a wall behind them leaves no room to stand."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.problem import Floats

ROOM, WITHIN, MIDDLE = 0.75, 0.025, 0.8
"""Floor behind a desk for those who serve: its depth in metres, how far it reaches into the desk
(whose back may be at the wall), and its share of the desk's width."""


def count_unserved(space: Space, pieces: Iterable[Piece]) -> int:
    """How many desks of a space have a wall, or one that was built, too near behind them.

    >>> from scenewright.core.scene import Pose, Size
    >>> outline = np.array([[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [0.0, 4.0]])
    >>> hall = Space("hall", "Hall", (), "ground", outline)
    >>> def desk(y):
    ...     pose, size = Pose(3.0, y, 0.0, np.pi / 2), Size(2.0, 0.6, 1.0)
    ...     return Piece("", "counter", "", "hall", pose, size)
    >>> [count_unserved(hall, [desk(y)]) for y in (0.6, 1.2)]
    [1, 0]
    """
    held = list(pieces)
    desks = [box for piece in held if piece.category in SERVING for box in boxes_of(piece)]
    if not desks:
        return 0
    built = [box for piece in held if piece.category == "partition" for box in boxes_of(piece)]
    rings = [space.outline, *space.holes, *corners(np.array(built).reshape(-1, 5))]
    walls = shapely.union_all([shapely.LinearRing(ring) for ring in rings])
    strips = shapely.polygons(corners(find_staff_floor(np.array(desks))))
    return int(shapely.intersects(strips, walls).sum())


def find_staff_floor(desks: Floats) -> Floats:
    """Boxes (n, 5) of the floor on which those stand who serve at desks (n, 5)."""
    front = np.stack([np.cos(desks[:, 2]), np.sin(desks[:, 2])], axis=1)
    boxes = desks.copy()
    boxes[:, :2] -= (0.5 * (desks[:, 4:] + ROOM) - WITHIN) * front
    boxes[:, 3], boxes[:, 4] = MIDDLE * desks[:, 3], ROOM
    return boxes
