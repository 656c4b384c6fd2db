"""Doors, passages and windows of drawn rooms: gaps in walls, leaves, layers of their symbols."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Point, Polygon

from scenewright.building.drawn.bridges import Gap
from scenewright.building.drawn.drawing import Arc, Drawn, Segments

BESIDE, REACH = 0.2, 0.75
"""Metres beyond a wall's face at which its rooms are looked for; from a symbol to its wall."""
CLUSTER = 0.15
"""Lines of a layer of doors or windows closer than this are one symbol."""
NARROWEST, LEAST_WINDOW = 0.5, 0.3
Vector = NDArray[np.float64]


class Found(NamedTuple):
    """An opening of the room by number: ``door`` or ``window`` with the keys of the brief, the
    number of the room beyond or ``None``, and how it was found."""

    room: int
    kind: str
    keys: dict[str, Any]
    beyond: int | None


def find_openings(drawn: Drawn, rooms: list[Polygon], gaps: list[Gap]) -> list[Found]:
    """The openings of rooms, those that overlap another on the same wall left out."""
    places = [_place_gap(gap, drawn) for gap in gaps]
    places += [_place_mark(mark, "door") for mark in _marks(drawn.doors, NARROWEST)]
    windows = [_place_mark(mark, "window") for mark in _marks(drawn.windows, LEAST_WINDOW)]
    outer = bool(len(drawn.windows)) or bool(drawn.arcs)
    found: list[Found] = []
    taken: list[tuple[Vector, float]] = []
    for place in [*windows, *places]:
        if any(np.hypot(*(place.middle - at)) < 0.5 * (place.width + wide) for at, wide in taken):
            continue
        opening = _opening(place, drawn, rooms, outer)
        if opening is not None:
            taken.append((place.middle, place.width))
            found.append(opening)
    return found


class Place(NamedTuple):
    """Where an opening is drawn: its middle, direction along the wall, width, the thickness of the
    wall, what it is by its layer, and the leaf that is drawn at it."""

    middle: Vector
    along: Vector
    width: float
    thickness: float
    kind: str
    leaf: Arc | None


def _place_gap(gap: Gap, drawn: Drawn) -> Place:
    return Place(gap.middle, gap.along, gap.width, gap.thickness, "", _leaf_at(gap, drawn.arcs))


def _leaf_at(gap: Gap, arcs: tuple[Arc, ...]) -> Arc | None:
    """The leaf that hangs at a jamb of a gap and is about as wide."""
    reach = gap.width / 2 + gap.thickness / 2 + 0.25
    near = [
        arc
        for arc in arcs
        if np.hypot(*(np.array(arc.middle) - gap.middle)) <= reach
        and 0.4 * gap.width <= arc.radius <= 1.25 * gap.width
    ]
    return min(near, key=lambda a: abs(a.radius - gap.width), default=None)


def _marks(lines: Segments, least: float) -> list[Polygon]:
    """The smallest boxes around the symbols on a layer."""
    drawn = [line for line in shapely.linestrings(lines) if line.length > 1e-6]
    grown = shapely.union_all([line.buffer(CLUSTER / 2) for line in drawn])
    boxes = []
    for part in shapely.get_parts(grown):
        inside = [line for line in drawn if part.intersects(line)]
        box = shapely.oriented_envelope(shapely.union_all(inside))
        if box.length >= 2 * least:
            boxes.append(box)
    return boxes


def _place_mark(box: shapely.Geometry, kind: str) -> Place:
    """A symbol by its box: it runs along the longer side."""
    points = shapely.get_coordinates(box)
    sides = np.diff(points, axis=0) if len(points) > 2 else np.diff(points[:2], axis=0)
    lengths = np.hypot(*sides.T)
    longest = int(np.argmax(lengths))
    middle = shapely.get_coordinates(shapely.centroid(box))[0]
    along = sides[longest] / lengths[longest]
    thick = float(lengths.min()) if len(points) > 2 else 0.0
    return Place(middle, along, float(lengths[longest]), thick, kind, None)


def _opening(place: Place, drawn: Drawn, rooms: list[Polygon], outer: bool) -> Found | None:
    """The opening of a place in the rooms beside it; ``None`` where there is no room."""
    normal = np.array([-place.along[1], place.along[0]])
    beside = [
        _room_at(place.middle + sign * (place.thickness / 2 + BESIDE) * normal, rooms)
        for sign in (1.0, -1.0)
    ]
    inner = [room for room in beside if room is not None]
    if not inner or (len(inner) == 2 and inner[0] == inner[1]):
        return None
    leaf = place.leaf
    room = _swept_room(leaf, rooms, inner) if leaf is not None else inner[0]
    beyond = next((other for other in inner if other != room), None)
    outside = beyond is None
    window = place.kind == "window" or (
        outside and outer and leaf is None and place.kind == "" and not _is_door_like(place, drawn)
    )
    return _in_room(place, leaf, rooms[room], room, beyond, window and outside)


def _is_door_like(place: Place, drawn: Drawn) -> bool:
    """Whether a gap to the outside without a leaf is a door: as wide as a gate, or there are no
    leaves in the drawing that windows could be told from."""
    return place.width > 3.5 or not drawn.arcs


def _room_at(point: Vector, rooms: list[Polygon]) -> int | None:
    here = Point(point)
    return next((k for k, room in enumerate(rooms) if room.contains(here)), None)


def _swept_room(leaf: Arc, rooms: list[Polygon], beside: list[int]) -> int:
    """The room a leaf turns into."""
    middle = np.mean([leaf.middle, leaf.start, leaf.end], axis=0)
    return min(beside, key=lambda room: rooms[room].distance(Point(middle)))


def _in_room(
    place: Place, leaf: Arc | None, room: Polygon, number: int, beyond: int | None, window: bool
) -> Found | None:
    """The opening on the nearest edge of a room, no wider than the edge."""
    ring = np.asarray(room.exterior.coords)
    edges = np.stack([ring[:-1], ring[1:]], 1)
    near = shapely.distance(shapely.linestrings(edges), Point(place.middle))
    ways = edges[:, 1] - edges[:, 0]
    lengths = np.hypot(*ways.T)
    parallel = np.abs((ways / np.maximum(lengths, 1e-9)[:, None]) @ place.along) > 0.9
    near = np.where(parallel & (lengths > LEAST_WINDOW + 0.05), near, np.inf)
    edge = int(np.argmin(near))
    if near[edge] > REACH:
        return None
    width = float(min(place.width, lengths[edge] - 0.04))
    unit = ways[edge] / lengths[edge]
    along = float((place.middle - edges[edge, 0]) @ unit)
    along = float(np.clip(along, width / 2 + 0.01, lengths[edge] - width / 2 - 0.01))
    at = [round(float(v), 4) for v in edges[edge, 0] + along * unit]
    if width < (LEAST_WINDOW if window else NARROWEST):
        return None
    keys: dict[str, Any] = {"at": at, "width": round(min(width, 20.0), 3)}
    if window:
        return Found(number, "window", keys, None)
    keys |= _leaf_keys(leaf, place, room)
    return Found(number, "door", keys, beyond)


def _leaf_keys(leaf: Arc | None, place: Place, room: Polygon) -> dict[str, str]:
    """Hinge and swing as seen from inside the room, facing the door."""
    if leaf is None:
        return {"swing": "none" if place.kind == "" else "in"}
    swept = np.mean([leaf.middle, leaf.start, leaf.end], axis=0)
    normal = np.array([-place.along[1], place.along[0]])
    facing = normal if (place.middle - swept) @ normal > 0 else -normal
    turned_in = room.buffer(0.3).contains(Point(swept))
    right = np.array([facing[1], -facing[0]])
    side = (np.array(leaf.middle) - place.middle) @ right
    return {"hinge": "right" if side > 0 else "left", "swing": "in" if turned_in else "out"}
