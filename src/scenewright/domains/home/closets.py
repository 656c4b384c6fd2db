"""Closets: storage rooms that belong to one room, being entered from it alone."""

from __future__ import annotations

from collections.abc import Sequence

import shapely

from scenewright.core.space import Space

LEAST_CLOSET = 0.45
"""Square metres of a closet that holds more clothes than a wardrobe of 0.6 m."""


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
