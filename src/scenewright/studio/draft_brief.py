"""What a drawn plan means: the brief of its kind of scene."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping

import shapely

from scenewright.core.brief import Brief
from scenewright.formats import brief_json
from scenewright.studio.draft_geometry import REACH, holds, is_inner, nearest_edge, on_level
from scenewright.studio.shapes import Json

SLAB = 0.25
"""Metres between the clear height of a storey and the floor of the next."""
ABOUT = 20.0
"""Metres round a site within which a street is one of its streets."""


def brief_of(draft: Json) -> Brief:
    """The brief that a draft means; InputError where it means none."""
    document = {
        **_without(draft.get("kept", {}), "source"),
        "name": draft["name"],
        "domain": draft["domain"],
        **MEANINGS[draft["domain"]](draft),
    }
    if draft["style"]:
        document["style"] = draft["style"]
    return brief_json.loads(json.dumps(document))


def _home(draft: Json) -> Json:
    rooms = [*_rooms(draft)]
    document: Json = {"rooms": rooms, "outlines": "inner" if is_inner(draft) else "centre"}
    document |= {key: draft[key] for key in ("wall_thickness", "outer_wall_thickness")}
    if len(draft["levels"]) < 2 and "kept" not in draft:
        return document
    for room, row in zip(rooms, draft["rooms"], strict=True):
        room["level"] = row["level"]
    return document | {"levels": [*_levels(draft)], "stairs": draft["stairs"]}


def _levels(draft: Json) -> Iterator[Json]:
    elevation = draft["levels"][0].get("elevation", 0.0)
    for number, one in enumerate(draft["levels"]):
        name = one["name"] or ("Ground floor" if not number else f"Floor {number}")
        yield {**_without(one, "slab"), "name": name, "elevation": round(elevation, 4)}
        elevation += one["height"] + one.get("slab", SLAB)


def _hall(draft: Json) -> Json:
    document = _home({**draft, "levels": draft["levels"][:1]})
    for room in document["rooms"]:
        shape = shapely.Polygon(room["outline"])
        room["zones"] = [
            _without(row, "level")
            for row in draft["zones"]
            if shape.contains(shapely.Polygon(row["outline"]).representative_point())
        ] + room.pop("proposed", [])
    return document


def _site(draft: Json) -> Json:
    """Streets near a site are its, those that were taken over stay ``of`` the sites they were."""
    sites = []
    for row in draft["rooms"]:
        shape = shapely.Polygon(row["outline"])
        near = [one for one in draft["streets"] if _is_of(one, row["id"], _line, shape, ABOUT)]
        roads = [_without(one, "level", "of") for one in near]
        sites.append({**_without(row, "level", "asked"), "roads": roads, **row.get("asked", {})})
    return {"sites": sites}


def _village(draft: Json) -> Json:
    blocks = [{**_without(row, "level", "asked"), **row.get("asked", {})} for row in draft["rooms"]]
    lanes = [_without(row, "level") for row in draft["streets"]]
    return {"style": "rural", "blocks": blocks, "lanes": lanes}


def _extend(draft: Json) -> Json:
    """Buildings and streets are one source; streets whose middle lies in an area are that's, those
    that were taken over stay ``of`` the areas they were, or of none."""
    areas, of_none = [], [*draft["streets"]]
    for row in draft["rooms"]:
        shape = shapely.Polygon(row["outline"])
        own = [one for one in draft["streets"] if _is_of(one, row["id"], _middle, shape, 0.0)]
        of_none = [one for one in of_none if one not in own]
        roads = [_without(one, "level", "of") for one in own]
        areas.append({**_without(row, "level", "asked"), "roads": roads, **row.get("asked", {})})
    buildings = [
        {
            key: value
            for key, value in _without(row, "level", "name").items()
            if value not in ("", None)
        }
        for row in draft["buildings"]
    ]
    source = {
        **draft.get("kept", {}).get("source", {}),
        "buildings": buildings,
        "roads": [_without(one, "level", "of") for one in of_none],
    }
    return {"sources": [source], "areas": areas}


def _line(street: Json) -> shapely.LineString:
    return shapely.LineString(street["line"])


def _middle(street: Json) -> shapely.Point:
    return _line(street).interpolate(0.5, normalized=True)


def _is_of(
    street: Json,
    place: str,
    part: Callable[[Json], shapely.Geometry],
    shape: shapely.Polygon,
    reach: float,
) -> bool:
    """Whether a street is a place's: it was taken over so, or a part of it is within reach."""
    if "of" in street:
        return place in street["of"]
    return bool(shape.distance(part(street)) <= reach)


MEANINGS: Mapping[str, Callable[[Json], Json]] = {
    "home": _home,
    "hall": _hall,
    "site": _site,
    "village": _village,
    "extend": _extend,
}


def _rooms(draft: Json) -> Iterator[Json]:
    opens: dict[int, list[Json]] = {}
    for row in draft["openings"]:
        edge = nearest_edge(draft, row["at"], row["level"])
        if edge.far <= REACH:
            opens.setdefault(edge.room, []).append(row)
    for number, room in enumerate(draft["rooms"]):
        here = opens.get(number, ())
        yield {
            **_without(room, "level", "asked"),
            "doors": [_opening(row) for row in here if row["kind"] != "window"],
            "windows": [_opening(row) for row in here if row["kind"] == "window"],
            "holes": [*room.get("holes", ()), *_columns(draft, room)],
            **room.get("asked", {}),
        }


def _columns(draft: Json, room: Json) -> Iterator[list[list[float]]]:
    for column in on_level(draft, "columns", room["level"]):
        (x, y), half = column["at"], column["size"] / 2
        if holds(room["outline"], x, y):
            low, high, left, right = y - half, y + half, x - half, x + half
            yield [[left, low], [right, low], [right, high], [left, high]]


def _opening(row: Json) -> Json:
    kept = _without(row, "kind", "level")
    return kept | ({"swing": "none"} if row["kind"] == "passage" else {})


def _without(row: Json, *keys: str) -> Json:
    return {key: value for key, value in row.items() if key not in keys}
