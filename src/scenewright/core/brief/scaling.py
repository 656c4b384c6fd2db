"""A plan drawn at the wrong scale, brought to its true size: what ``scale`` of a brief means.

What is drawn in plan is multiplied: outlines, walls, doors, windows, zones, and where things are.
What is bought is not: furniture, radiators and stairs keep their size, and so do all heights.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely
from pydantic_core import PydanticCustomError

from scenewright.core.layout import corners

if TYPE_CHECKING:
    from scenewright.core.brief import Brief, FixedItem, Room, WallBrief

FARTHEST = 1e4
"""Greatest coordinate of a brief, in metres."""
LEAST, MOST = 0.001, 20.0
"""Limits of a scale."""
FINE = 0.01
"""Below this scale (millimetres) lengths are brought nearer before they are checked."""
SPANS = frozenset((("doors", "width"), ("windows", "width"), ("walls", "thickness")))
POINTS = frozenset(("outline", "holes", "at", "start", "end"))
WIDTHS = {"doors": (0.3, 20.0), "windows": (0.1, 30.0)}
"""Least and greatest width of an opening, in metres."""
THICKEST = 5.0

Spot = tuple[float, float]


def scale_widths(document: Mapping[str, Any]) -> dict[str, Any]:
    """A document of a brief, not yet checked, with the stated widths of its openings and walls
    times its scale, so that limits hold for what is built: 85 centimetres are a door. Whatever is
    no number, or no possible scale, is left for the check.

    >>> doors = [{"at": [60, 0], "width": 85}]
    >>> scale_widths({"scale": 0.01, "rooms": [{"doors": doors}]})["rooms"]
    [{'doors': [{'at': [60, 0], 'width': 0.85}]}]
    """
    document = _bring_near(document)
    factor = document.get("scale", 1.0)
    if not _is_number(factor) or factor == 1.0 or not LEAST <= factor <= MOST:
        return dict(document)
    given = {
        key: document[key] for key in ("rooms", "walls") if isinstance(document.get(key), Sequence)
    }
    return {
        **document,
        **{key: [_widen(item, key, factor) for item in items] for key, items in given.items()},
    }


def _bring_near(document: Mapping[str, Any]) -> Mapping[str, Any]:
    """A document in millimetres as one in centimetres, whose coordinates are within the limits."""
    factor = document.get("scale", 1.0)
    if not _is_number(factor) or not LEAST <= factor < FINE:
        return document
    return {key: _shrink(value, key) for key, value in document.items()} | {"scale": 10 * factor}


def _shrink(value: Any, key: str, within: str = "") -> Any:
    """A value below a key with all points in it, and widths of openings and walls, a tenth."""
    if isinstance(value, Mapping):
        return {name: _shrink(inner, name, key) for name, inner in value.items()}
    if isinstance(value, list | tuple):
        return [_shrink(inner, key, within) for inner in value]
    drawn = key in POINTS or (within, key) in SPANS
    return value / 10 if drawn and _is_number(value) else value


def _widen(item: Any, key: str, factor: float) -> Any:
    """A room, wall or opening, given as keys or as a model, with its widths times ``factor``."""
    stated = item if isinstance(item, Mapping) else getattr(item, "__dict__", {})
    changed: dict[str, Any] = {}
    if key == "rooms":
        for kind in WIDTHS:
            if isinstance(stated.get(kind), list):
                changed[kind] = [_widen(opening, kind, factor) for opening in stated[kind]]
    else:
        name = "thickness" if key == "walls" else "width"
        least, most = WIDTHS.get(key, (0.0, THICKEST))
        if _is_number(stated.get(name)):
            changed[name] = min(max(stated[name] * factor, least), most)
    if not changed:
        return item
    return {**item, **changed} if isinstance(item, Mapping) else item.model_copy(update=changed)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def scale_plan(brief: Brief, factor: float) -> dict[str, Any]:
    """The rooms, walls and stairs of a brief with every place in plan times ``factor``; widths of
    openings and walls are scaled already (:func:`scale_widths`).

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
            "doors": [_scale_place(door, factor) for door in room.doors],
            "windows": [_scale_place(window, factor) for window in room.windows],
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
    """An opening, an outlet or a radiator at its scaled place."""
    return thing.model_copy(update={"at": _scale_point(thing.at, factor)})


def _scale_wall(wall: WallBrief, factor: float) -> WallBrief:
    return wall.model_copy(
        update={"start": _scale_point(wall.start, factor), "end": _scale_point(wall.end, factor)}
    )


def _scale_fixed(
    items: list[FixedItem], walls: shapely.MultiLineString, factor: float
) -> list[FixedItem]:
    """Fixed items as far from the wall nearest to them as they were; one on another moves
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
