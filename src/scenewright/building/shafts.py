"""Shafts: what is walled in without a door, for ducts and lifts."""

from __future__ import annotations

from shapely import Polygon

from scenewright.core.space import Space

NAMELESS = frozenset(("other", "shaft", "duct", "void"))
"""Names that tell no use of a room."""
LARGEST, AIRED = 4.0, 2.0
"""Square metres: the largest shaft, and the largest with a window."""


def is_shaft(space: Space) -> bool:
    """Whether a room that tells no use has no door; a window may air a small one."""
    nameless = space.name.strip().lower() in NAMELESS
    closed = all(opening.kind == "window" for opening in space.openings)
    most = AIRED if space.openings else LARGEST
    return nameless and closed and Polygon(space.outline, space.holes).area < most
