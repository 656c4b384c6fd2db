"""The unit a plan was drawn in, by its lengths: which scale makes them metres."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import log
from statistics import median
from typing import Any

UNITS = {"feet": 0.3048, "inches": 0.0254, "centimetres": 0.01, "millimetres": 0.001}
"""Metres of each."""
USUAL_DOOR, USUAL_ROOM = 0.85, 4.0
WIDEST_DOOR = 2.5
"""Doors whose median is wider are not given in metres."""


def guess_unit(length: float, usual: float) -> tuple[str, float]:
    """The unit, and its metres, in which a ``length`` is most nearly the ``usual`` one in metres.

    >>> guess_unit(900, 0.85), guess_unit(34, 0.85), guess_unit(11, 4.0)
    (('millimetres', 0.001), ('inches', 0.0254), ('feet', 0.3048))
    """
    return min(UNITS.items(), key=lambda unit: abs(log(length * unit[1] / usual)))


def suggest_scale(length: float, usual: float = USUAL_ROOM) -> str:
    """What to do about a length that is hardly metres.

    >>> suggest_scale(4000.0)
    'add --scale 0.001 if they are millimetres'
    """
    word, factor = guess_unit(length, usual)
    return f"add --scale {factor:g} if they are {word}"


def suggest_for(document: Mapping[str, Any]) -> str:
    """The same for a document of a brief that is not valid: by the median width of its doors, else
    by that of its rooms; empty if they may be metres.

    >>> room = {"outline": [[0, 0], [400, 0], [400, 300]], "doors": [{"width": 85}]}
    >>> suggest_for({"rooms": [room]})
    'add --scale 0.01 if they are centimetres'
    """
    rooms = [room for room in _items(document, "rooms") if isinstance(room, Mapping)]
    doors = [door.get("width") for room in rooms for door in _items(room, "doors")]
    widths = [width for width in doors if _is_length(width)]
    if widths and median(widths) > WIDEST_DOOR:
        return suggest_scale(median(widths), USUAL_DOOR)
    sides = [side for room in rooms for side in _side(room)]
    return suggest_scale(median(sides)) if sides and median(sides) > 5 * USUAL_ROOM else ""


def _items(holder: Mapping[str, Any], key: str) -> list[Any]:
    found = holder.get(key)
    return [one for one in found if isinstance(one, Mapping)] if isinstance(found, list) else []


def _side(room: Mapping[str, Any]) -> Iterator[float]:
    """The longer side of the box around a room, if its corners are numbers."""
    outline = room.get("outline")
    corners = outline if isinstance(outline, list) else []
    points = [point for point in corners if isinstance(point, list) and len(point) == 2]
    if points and all(_is_number(value) for point in points for value in point):
        side = max(max(axis) - min(axis) for axis in zip(*points, strict=True))
        if _is_length(side):
            yield side


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_length(value: Any) -> bool:
    return _is_number(value) and 0 < value < 1e9
