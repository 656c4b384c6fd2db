"""Rooms beside a room: closets that are entered from it alone, and those with water."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Space
from scenewright.domains.home.groups.classes import WET_ROOMS

Floats = NDArray[np.float64]

LEAST_CLOSET = 0.45
"""Square metres of a closet that holds more clothes than a wardrobe of 0.6 m."""

PARTED, LEAST_SHARED = 0.3, 0.3
"""Metres of wall at most between two rooms that share it, and of its length at least."""


def list_wet_walls(space: Space, rooms: Sequence[Space]) -> Floats:
    """The walls (n, 5) of a room to bathrooms, toilets and washrooms, as boxes of their length and
    :data:`PARTED` deep beyond them that look into the room.

    >>> box = np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
    >>> room = Space("a", "a", ("bedroom",), "0", box)
    >>> bath = Space("b", "b", ("bathroom",), "0", box + [2.1, 0.0])
    >>> list_wet_walls(room, (room, bath)).round(2).tolist()
    [[2.15, 1.0, 3.14, 2.0, 0.3]]
    """
    others = [room for room in rooms if room.id != space.id and room.level == space.level]
    wet = [shapely.Polygon(o.outline) for o in others if WET_ROOMS.intersection(o.functions)]
    beyond = shapely.union_all([shape.buffer(PARTED, join_style="mitre") for shape in wet])
    ends = zip(space.outline, np.roll(space.outline, -1, 0), strict=True)
    found = []
    for edge in ends if wet else ():
        for part in shapely.get_parts(shapely.LineString(edge).intersection(beyond)):
            if part.length >= LEAST_SHARED:
                (x0, y0), (x1, y1) = part.coords[0], part.coords[-1]
                turn = np.arctan2(x1 - x0, y0 - y1)
                x, y = (
                    (x0 + x1 - PARTED * np.cos(turn)) / 2,
                    (y0 + y1 - PARTED * np.sin(turn)) / 2,
                )
                found.append([x, y, turn, part.length, PARTED])
    return np.array(found).reshape(-1, 5)


def has_closet(space: Space, rooms: Sequence[Space]) -> bool:
    """Whether a storage room of :data:`LEAST_CLOSET` is entered from a room and from no other.

    >>> import numpy as np
    >>> from scenewright.core.space import Opening
    >>> box = np.array([[0.0, 0.0], [1.6, 0.0], [1.6, 0.8], [0.0, 0.8]])
    >>> door = Opening("d", "door", "0", 0.8, 0.0, 1.0, 0.0, 1.4, 0.1, 0.0, 2.0, spaces=("a", "b"))
    >>> room = Space("a", "a", ("bedroom",), "0", box - [0.0, 0.9], openings=(door,))
    >>> closet = Space("b", "b", ("storage",), "0", box, openings=(door,))
    >>> has_closet(room, (room, closet)), has_closet(closet, (room, closet))
    (True, False)
    """
    return any(_is_closet_of(space, other) for other in rooms if other.id != space.id)


def _is_closet_of(space: Space, other: Space) -> bool:
    if other.functions != ("storage",):
        return False
    doors = [opening for opening in other.openings if opening.kind != "window"]
    if not doors or any(set(door.spaces) != {space.id, other.id} for door in doors):
        return False
    return float(shapely.Polygon(other.outline, list(other.holes)).area) >= LEAST_CLOSET
