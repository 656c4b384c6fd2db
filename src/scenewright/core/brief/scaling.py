"""A plan drawn at the wrong scale, brought to its true size: what ``scale`` of a brief means.

What is drawn in plan is multiplied: outlines, walls, doors, windows, zones, and where things are.
What is bought is not: furniture, radiators and stairs keep their size, and so do all heights.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import shapely
from pydantic_core import PydanticCustomError

from scenewright.core.layout import corners

if TYPE_CHECKING:
    from scenewright.core.brief import Brief, Door, FixedItem, Room, WallBrief, Window

FARTHEST = 1e4
"""Greatest coordinate of a brief, in metres."""
WIDTHS = {"Door": (0.3, 20.0), "Window": (0.1, 30.0)}
"""Least and greatest width of an opening, in metres."""
THICKEST = 5.0

Spot = tuple[float, float]


def scale_plan(brief: Brief, factor: float) -> dict[str, Any]:
    """The rooms, walls and stairs of a brief with every length in plan times ``factor``.

    >>> from scenewright.core.brief import Brief
    >>> small = {"outline": [[0, 0], [4, 0], [4, 3]], "doors": [{"at": [2, 0], "width": 0.6}]}
    >>> room = Brief.model_validate({"scale": 1.5, "rooms": [small]}).rooms[0]
    >>> room.outline[2], room.doors[0].at, round(room.doors[0].width, 3)
    ((6.0, 4.5), (3.0, 0.0), 0.9)
    """
    _check_extent(brief, factor)
    return {
        "rooms": [_scale_room(room, factor) for room in brief.rooms],
        "walls": [_scale_wall(wall, factor) for wall in brief.walls],
        "stairs": [s.model_copy(update={"at": _scale_point(s.at, factor)}) for s in brief.stairs],
    }


def _check_extent(brief: Brief, factor: float) -> None:
    reach = max((abs(v) for room in brief.rooms for at in room.outline for v in at), default=0.0)
    if reach * factor > FARTHEST:
        raise PydanticCustomError("scale", "a scale with which the plan lies within 10 km of 0, 0")


def _scale_room(room: Room, factor: float) -> Room:
    ring = shapely.MultiLineString([[*points, points[0]] for points in (room.outline, *room.holes)])
    return room.model_copy(
        update={
            "outline": [_scale_point(at, factor) for at in room.outline],
            "holes": [[_scale_point(at, factor) for at in hole] for hole in room.holes],
            "doors": [_scale_opening(door, factor) for door in room.doors],
            "windows": [_scale_opening(window, factor) for window in room.windows],
            "outlets": [_scale_place(outlet, factor) for outlet in room.outlets],
            "radiators": [_scale_place(radiator, factor) for radiator in room.radiators],
            "zones": [
                zone
                if zone.outline is None
                else zone.model_copy(
                    update={"outline": [_scale_point(at, factor) for at in zone.outline]}
                )
                for zone in room.zones
            ],
            "fixed": _scale_fixed(room.fixed, ring, factor),
        }
    )


def _scale_place(thing: Any, factor: float) -> Any:
    """An outlet or a radiator at its scaled place."""
    return thing.model_copy(update={"at": _scale_point(thing.at, factor)})


def _scale_opening(opening: Door | Window, factor: float) -> Door | Window:
    least, most = WIDTHS[type(opening).__name__]
    width = min(max(opening.width * factor, least), most)
    return opening.model_copy(update={"at": _scale_point(opening.at, factor), "width": width})


def _scale_wall(wall: WallBrief, factor: float) -> WallBrief:
    return wall.model_copy(
        update={
            "start": _scale_point(wall.start, factor),
            "end": _scale_point(wall.end, factor),
            "thickness": min(wall.thickness * factor, THICKEST),
        }
    )


def _scale_fixed(
    items: list[FixedItem], walls: shapely.MultiLineString, factor: float
) -> list[FixedItem]:
    """Fixed items as far from the wall nearest to them as they were; what stands on another moves
    along with it."""
    by_id = {item.id: item for item in items if item.id}
    moved = []
    for item in items:
        x, y = _nearest(by_id.get(item.on or "", item), walls)
        at = (item.at[0] + (factor - 1.0) * x, item.at[1] + (factor - 1.0) * y)
        moved.append(item.model_copy(update={"at": at}))
    return moved


def _nearest(item: FixedItem, walls: shapely.MultiLineString) -> Spot:
    """The point of the walls nearest to the footprint of an item."""
    box = shapely.Polygon(corners(np.array([[*item.at, item.heading, *item.size[:2]]]))[0])
    x, y = shapely.shortest_line(walls, box).coords[0]
    return float(x), float(y)


def _scale_point(at: Spot, factor: float) -> Spot:
    return at[0] * factor, at[1] * factor
