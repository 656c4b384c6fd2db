"""Data of OpenStreetMap as rows of GeoJSON, by osmium: everything that has tags, once.

Nodes are points, ways lines or areas, relations of type ``multipolygon`` and ``boundary`` areas.
What an extract cuts off is drawn by the corners that it holds.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from scenewright.core.errors import InputError
from scenewright.ground.geodata.limits import CUT, CUT_OFF, MOST_FEATURES, PARTLY
from scenewright.ground.maps.kinds import words_of

Row = dict[str, Any]
LONGEST_TAG, MOST_TAGS = 250, 500
AREAS = frozenset(
    words_of(
        "aeroway amenity block boundary building building:part craft extend historic indoor "
        "landuse leisure military natural office place public_transport room shop site sport "
        "tourism area:highway water"
    )
)
"""Keys that make a closed way an area."""
AREA_TAGS = frozenset(
    (("area", "yes"), ("man_made", "silo"), ("highway", "platform"), ("waterway", "riverbank"))
)
BARE = frozenset(words_of("type source note fixme created_by"))
"""Keys of a relation that do not say what it is."""
LINES = frozenset(words_of("coastline cliff tree_row ridge arete"))
"""Values of ``natural`` that are lines even where they close."""


def list_rows(file: Path) -> Iterator[Row]:
    """The rows of a file in OSM XML or PBF, in its order, areas of relations last."""
    import osmium

    processor = osmium.FileProcessor(str(file)).with_locations("flex_mem").with_areas()
    processor = processor.with_filter(osmium.filter.EmptyTagFilter())
    draw = osmium.geom.GeoJSONFactory().create_multipolygon
    rows: dict[str, Row] = {}
    for one in processor:
        made = _area(one, draw) if one.is_area() else _row(one)
        if made is not None and (one.is_area() or made["id"] not in rows):
            rows[made["id"]] = made
        if len(rows) > MOST_FEATURES:
            raise InputError(f"holds more than {MOST_FEATURES:,} features", CUT)
    yield from rows.values()


def _row(one: Any) -> Row:
    """A node, way or relation as a row; a relation until its area comes."""
    tags = _tags(one)
    if one.is_node():
        if not one.location.valid():
            return _state("node", one.id, tags, None, "has no place")
        return _state("node", one.id, tags, _geometry("Point", _at(one.location)))
    if one.is_way():
        return _way(one, tags)
    kind = tags.get("type", "")
    area = kind in ("multipolygon", "boundary")
    fault = CUT_OFF if area else "is a relation and no area"
    if area and tags.keys() <= BARE:
        fault = "its ways say what it is"
    return _state("relation", one.id, tags, None, fault)


def _way(one: Any, tags: dict[str, str]) -> Row:
    line = [_at(node) for node in one.nodes if node.location.valid()]
    lost = PARTLY if len(line) < len(one.nodes) else ""
    if len(line) < 2:
        return _state("way", one.id, tags, None, CUT_OFF)
    ring = len(line) > 3 and line[0] == line[-1] and _is_area(tags)
    geometry = _geometry("Polygon", [line]) if ring else _geometry("LineString", line)
    return _state("way", one.id, tags, geometry, lost)


def _area(one: Any, draw: Callable[[Any], str]) -> Row | None:
    """The area that a relation is; none of a way, which is drawn by its own corners, nor of a
    relation that does not say what it is: its ways do."""
    if one.from_way() or _tags(one).keys() <= BARE:
        return None
    try:
        geometry = json.loads(draw(one))
    except (RuntimeError, ValueError):
        return None
    return _state("relation", one.orig_id(), _tags(one), geometry)


def _state(kind: str, number: int, tags: dict[str, str], geometry: Any, about: str = "") -> Row:
    row = {"type": "Feature", "id": f"{kind}/{number}", "properties": tags, "geometry": geometry}
    return row | ({"scenewright": {"lost": about}} if about else {})


def _geometry(kind: str, coordinates: Any) -> Row:
    return {"type": kind, "coordinates": coordinates}


def _at(place: Any) -> list[float]:
    return [place.lon, place.lat]


def _tags(one: Any) -> dict[str, str]:
    listed = [(tag.k[:LONGEST_TAG], tag.v[:LONGEST_TAG]) for tag in one.tags]
    return dict(listed[:MOST_TAGS])


def _is_area(tags: dict[str, str]) -> bool:
    """Whether a closed way with such tags is an area.

    >>> _is_area({"building": "yes"}), _is_area({"highway": "residential"})
    (True, False)
    """
    if tags.get("area") == "no" or tags.get("natural") in LINES:
        return False
    return bool(AREAS & tags.keys() or AREA_TAGS & tags.items())
