"""Indoor Mapping Data Format (IMDF) in the tags of OpenStreetMap's simple indoor tagging.

A feature of IMDF says what it is by ``feature_type`` and a ``category``, and names its level by the
id of another feature: units become rooms and ways, openings doors, levels numbers.
"""

from __future__ import annotations

import math
from typing import Any

UNITS = {
    "walkway": {"indoor": "corridor"},
    "movingwalkway": {"indoor": "corridor"},
    "footbridge": {"indoor": "corridor"},
    "ramp": {"indoor": "corridor"},
    "lobby": {"indoor": "area"},
    "platform": {"indoor": "area"},
    "terrace": {"indoor": "area"},
    "unenclosedarea": {"indoor": "area"},
    "column": {"indoor": "column"},
    "brick": {"indoor": "wall"},
    "concrete": {"indoor": "wall"},
    "drywall": {"indoor": "wall"},
    "glass": {"indoor": "wall"},
    "structure": {"indoor": "wall"},
    "wood": {"indoor": "wall"},
    "opentobelow": {"indoor": "void"},
    "retail": {"indoor": "room", "shop": "yes"},
    "foodservice": {"indoor": "room", "amenity": "restaurant"},
    "restroom": {"indoor": "room", "room": "toilets"},
    "elevator": {"indoor": "room", "room": "elevator"},
    "escalator": {"indoor": "room", "room": "stairs"},
    "stairs": {"indoor": "room", "room": "stairs"},
    "steps": {"indoor": "room", "room": "stairs"},
    "office": {"indoor": "room", "room": "office"},
    "waitingroom": {"indoor": "room", "room": "waiting"},
}
"""Tags of units by their category; any other unit is a room."""
METRES_PER_DEGREE = 111_320.0


def is_imdf(rows: list[Any]) -> bool:
    """Whether features are those of IMDF."""
    return any(isinstance(row, dict) and isinstance(row.get("feature_type"), str) for row in rows)


def to_indoor_tags(rows: list[Any]) -> list[Any]:
    """Features of IMDF with the tags of indoor maps; others as they are."""
    levels = _levels([row for row in rows if isinstance(row, dict)])
    return [_turn(row, levels) if isinstance(row, dict) else row for row in rows]


def _properties(row: dict[str, Any]) -> dict[str, Any]:
    found = row.get("properties")
    return found if isinstance(found, dict) else {}


def _levels(rows: list[dict[str, Any]]) -> dict[str, str]:
    """The number of each level by its id: the ordinal it states, else its place in the file."""
    found: dict[str, str] = {}
    for row in rows:
        ordinal, name = _properties(row).get("ordinal"), row.get("id")
        if row.get("feature_type") == "level" and isinstance(name, str) and type(ordinal) is int:
            found[name] = str(ordinal)
    for row in rows:
        name = _properties(row).get("level_id")
        if isinstance(name, str) and name not in found:
            found[name] = str(len(found))
    return found


def _turn(row: dict[str, Any], levels: dict[str, str]) -> dict[str, Any]:
    kind, about = row.get("feature_type"), _properties(row)
    if not isinstance(kind, str):
        return row
    category = str(about.get("category", "")).partition(".")[0]
    tags = {"name": _label(about.get("name")), "level": levels.get(str(about.get("level_id")), "")}
    if kind == "unit":
        tags |= UNITS.get(category, {"indoor": "room"})
    elif kind == "opening":
        tags |= {"door": "yes"}
    else:
        tags = {"indoor": kind, "name": tags["name"]}
    shown = {key: value for key, value in tags.items() if value}
    found = {"type": "Feature", "properties": shown, "geometry": row.get("geometry")}
    found |= {"id": row["id"]} if "id" in row else {}
    return _as_door(found) if kind == "opening" else found


def _label(name: Any) -> str:
    """The English label of a feature, else its first."""
    if isinstance(name, dict):
        texts = [text for text in (name.get("en"), *name.values()) if isinstance(text, str)]
        return texts[0] if texts else ""
    return name if isinstance(name, str) else ""


def _as_door(row: dict[str, Any]) -> dict[str, Any]:
    """An opening, drawn as a line, as a door in its middle, as wide as it is long."""
    geometry = row["geometry"]
    try:
        (x1, y1), (x2, y2) = ([float(v) for v in geometry["coordinates"][k][:2]] for k in (0, -1))
    except (TypeError, ValueError, OverflowError, KeyError, IndexError):
        return row
    x, y = (x1 + x2) / 2, (y1 + y2) / 2
    across = (x2 - x1) * math.cos(math.radians(y)) if math.isfinite(y) else math.nan
    width = METRES_PER_DEGREE * math.hypot(across, y2 - y1)
    if not 0.1 < width < 50:
        return row
    point = {"type": "Point", "coordinates": [x, y]}
    return row | {"geometry": point, "properties": row["properties"] | {"width": f"{width:.2f}"}}
