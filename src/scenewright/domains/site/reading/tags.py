"""Widths, heights and storeys of roads and buildings by the tags of OpenStreetMap."""

from __future__ import annotations

import re
from typing import Any

from scenewright.ground.maps.kinds import use_of

ROADS = {
    "motorway": 22.0,
    "motorway_link": 7.5,
    "trunk": 18.0,
    "trunk_link": 7.5,
    "primary": 14.0,
    "primary_link": 7.0,
    "secondary": 10.0,
    "secondary_link": 6.0,
    "tertiary": 7.5,
    "tertiary_link": 6.0,
    "unclassified": 6.0,
    "residential": 6.0,
    "living_street": 5.0,
    "service": 4.0,
    "busway": 7.0,
    "road": 6.0,
    "track": 3.0,
}
"""Widths in metres of carriageways by ``highway``."""

PATHS = {
    "pedestrian": 5.0,
    "footway": 2.0,
    "path": 1.5,
    "cycleway": 2.5,
    "steps": 2.0,
    "bridleway": 2.0,
    "corridor": 2.0,
}
"""The same of ways for walking."""

LANE, STOREY = 3.25, 3.2
NARROWEST, WIDEST, LOWEST, HIGHEST = 0.5, 100.0, 1.0, 1000.0

OWN = {
    "setback": "setback",
    "road_setback": "road_setback",
    "verge": "verge",
    "spacing": "spacing",
    "sun_spacing": "sun_spacing",
    "floor_area_ratio": "floor_area_ratio",
    "far": "floor_area_ratio",
    "coverage": "coverage",
    "height_limit": "height_limit",
    "fire_access": "fire_access",
    "sun_hours": "sun_hours",
    "day": "day",
}
"""Properties of a site, and the fields of the brief they are."""

ROOFS = {
    "flat": "flat",
    "gabled": "gabled",
    "half-hipped": "gabled",
    "saltbox": "gabled",
    "skillion": "flat",
    "hipped": "hipped",
    "pyramidal": "hipped",
    "mansard": "hipped",
    "gambrel": "gabled",
}
"""Shapes of roofs by ``roof:shape``."""

_NUMBER = re.compile(r"\s*([+-]?\d+(?:[.,]\d+)?)\s*(m|metres|meters|ft|feet|')?\s*", re.IGNORECASE)


def number_of(text: str) -> float | None:
    """A length in metres; feet where it says so. ``None`` if it is none.

    >>> number_of("12.5 m"), number_of("10 ft"), number_of("3,5"), number_of("tall")
    (12.5, 3.048, 3.5, None)
    """
    found = _NUMBER.fullmatch(text)
    if not found or len(found[1]) > 12:
        return None
    value = float(found[1].replace(",", "."))
    feet = (found[2] or "m").casefold() in ("ft", "feet", "'")
    return round(value * 0.3048, 4) if feet else value


def width_of(tags: dict[str, str]) -> tuple[str, float] | None:
    """Kind (road or path) and width of a line with ``highway``; ``None`` if it is no way.

    ``width`` says it (0 does not), else the number of ``lanes``, else the class.

    >>> width_of({"highway": "residential", "width": "4.5 m"}), width_of({"highway": "footway"})
    (('road', 4.5), ('path', 2.0))
    >>> width_of({"highway": "primary", "lanes": "2"}), width_of({"highway": "proposed"})
    (('road', 6.5), None)
    """
    kind = tags.get("highway", "")
    if kind not in ROADS and kind not in PATHS:
        return None
    lanes = number_of(tags.get("lanes", ""))
    width = number_of(tags.get("width", "") or tags.get("est_width", ""))
    if not width:
        usual = ROADS.get(kind) or PATHS[kind]
        width = lanes * LANE if lanes and kind in ROADS else usual
    return "road" if kind in ROADS else "path", min(max(width, NARROWEST), WIDEST)


def height_of(tags: dict[str, str]) -> float | None:
    """Height of a building: as it says, else 3.2 m a storey; ``None`` if it says neither, or
    nothing above 0.

    >>> height_of({"height": "12"}), height_of({"building:levels": "5"}), height_of({})
    (12.0, 16.0, None)
    """
    height = number_of(tags.get("height", "") or tags.get("est_height", ""))
    levels = number_of(tags.get("building:levels", "") or tags.get("levels", ""))
    if (height is None or height <= 0) and levels is not None:
        height = round(levels * STOREY, 2)
    return min(max(height, LOWEST), HIGHEST) if height and height > 0 else None


def appearance_of(tags: dict[str, str]) -> dict[str, Any]:
    """The looks of a standing building, as keys of a landmark of the brief.

    >>> appearance_of({"building": "church", "height": "-1", "building:levels": "2"})
    {'height': 6.4, 'levels': 2, 'use': 'church'}
    """
    levels, roof = number_of(tags.get("building:levels", "")), tags.get("roof:shape", "")
    found = {
        "height": height_of(tags),
        "levels": min(max(round(levels), 1), 300) if levels and levels > 0 else None,
        "use": use_of(tags)[:80],
        "roof": ROOFS.get(roof, ""),
    }
    return {key: value for key, value in found.items() if value}


def is_water(tags: dict[str, str]) -> bool:
    """Whether an area is water."""
    return tags.get("natural") == "water" or "water" in tags or tags.get("waterway") == "riverbank"
