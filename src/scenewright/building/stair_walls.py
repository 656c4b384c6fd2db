"""Stairs that would run through a wall."""

from __future__ import annotations

from collections.abc import Sequence

import shapely

from scenewright.core.errors import InputError
from scenewright.core.space import Space
from scenewright.core.stairs import Stairs

INTO = 0.2
"""How far steps may reach into the next room, metres: plans are not drawn more exactly."""
BENEATH = {"storage", "other"}
"""Rooms that may be walled off beneath stairs."""


def check_walls(
    stairs: Stairs,
    entry: int,
    spaces: Sequence[Space],
    floors: Sequence[shapely.Polygon],
    place: str,
) -> None:
    """Raise an :class:`InputError` if the steps lie over a room of the lower level that a wall
    parts from the room of the foot, ``spaces[entry]``. A closet may lie beneath them."""
    steps = shapely.union_all([shapely.Polygon(tread.outline) for tread in stairs.treads])
    foot = spaces[entry]
    for space, floor in zip(spaces, floors, strict=True):
        if space.level != stairs.level or space.id == foot.id or BENEATH & set(space.functions):
            continue
        if _are_open(foot, space) or shapely.buffer(floor & steps, -INTO / 2).is_empty:
            continue
        raise InputError(
            f"runs through the wall between '{foot.id}' and '{space.id}'",
            "move, turn or narrow the stairs, or join the rooms by an open passage",
            place=place,
        )


def _are_open(one: Space, other: Space) -> bool:
    """Whether an open passage joins two rooms."""
    return any(o.kind == "passage" and other.id in o.spaces for o in one.openings)
