"""Villages drawn for OpenStreetMap or by a planner, as GeoJSON.

Polygons with the tag ``block`` are blocks; lines with ``highway`` lanes as wide as their tag
``width``, else as their class. Sides of a block are streets where a line with ``street_side`` names
it, else along lanes. Houses (``building``) in a block stay where they stand unless the tag is
``building=proposed``. Polygons with ``building=library``, wherever they lie, are the houses to
choose from (``building:levels``, ``roof:shape``, ``height``), their footprints as drawn. The brief
carries a report of what became of every feature.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import shapely

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.projection import Projection, metres
from scenewright.core.space import Points
from scenewright.domains.village.house import rectangle_about
from scenewright.ground.buildings.plain_buildings import fits_footprint, plain_building
from scenewright.ground.buildings.use_words import ROOFS, use_of_tags, use_of_word, word_of_tags
from scenewright.ground.maps.fates import Note
from scenewright.ground.maps.features import Collection, Feature, in_degrees
from scenewright.ground.maps.footprints import PARCEL, UNTAGGED, find_footprints, note_plots
from scenewright.ground.maps.kinds import stands
from scenewright.ground.maps.place import projection_of
from scenewright.ground.maps.report import report_map

WIDTHS = {"primary": 8.0, "secondary": 7.0, "tertiary": 6.5, "residential": 5.5, "service": 4.0}
PATHS = ("footway", "path", "steps", "track", "pedestrian", "cycleway")
LANE, PATH, STOREY, HEIGHT = 5.0, 2.0, 2.7, 7.5
LIBRARY = "library"
MOST_BLOCKS = 1000
UNREAD = "is no block, lane or house"
LEAST_OVER = 1.0
"""Square metres of a block from which a house across its border stands in it."""
NEAR = 0.5
"""Metres within which a side of a block is one named as street."""


def recognises(found: Collection) -> bool:
    """Whether a map can be of a village: a polygon tagged as a block."""
    return any(_is_block(feature) for feature in found.features)


def names_itself(found: Collection) -> bool:
    """Whether a map says that it is of a village, whatever else it holds."""
    return recognises(found)


def _is_block(feature: Feature) -> bool:
    return bool(feature.polygons) and feature.tags.get("block", "no") != "no"


def brief_of(found: Collection, name: str) -> Brief:
    """The brief of a village map; InputError if no block is among its features."""
    given, found = found, in_degrees(found)
    blocks = [feature for feature in found.features if _is_block(feature)]
    if not blocks:
        raise InputError(
            f"holds no block among its {len(found.features)} features",
            'draw a polygon with the property "block": "yes"',
        )
    if len(blocks) > MOST_BLOCKS:
        raise InputError(f"holds {len(blocks):,} blocks", f"at most {MOST_BLOCKS} are read")
    map_ = projection_of(found, np.vstack([p[0] for f in blocks for p in f.polygons]))
    lanes = [lane for f in found.features for lane in _lanes(f, map_)]
    notes: list[Note] = []
    document: dict[str, Any] = {
        "domain": "village",
        "name": name,
        "blocks": [_block(f, found, map_, bool(lanes), notes) for f in blocks],
        "lanes": lanes,
        "houses": [
            _choice(f, f"{f.tags.get('name') or f.id}", metres(map_, p[0]))
            for f in found.features
            for p in f.polygons
            if f.tags.get("building") == LIBRARY
        ],
    }
    if map_.where:
        document["origin"] = map_.where
    notes += [*_note_others(found, blocks), *note_plots(found.features, notes)]
    document["input_report"] = report_map(given, map_, notes, otherwise_of(given))
    return Brief.model_validate(document)


def otherwise_of(found: Collection) -> Callable[[str], str]:
    """Why a feature is left out that no note is about, by its name."""
    houses = {f.id for f in found.features if f.polygons and stands(f.tags)}
    points = {f.id for f in found.features if not f.polygons and stands(f.tags)}

    def reason(name: str) -> str:
        if name in points:
            return "is no outline of a house"
        return "stands in no block" if name in houses else UNREAD

    return reason


def _note_others(found: Collection, blocks: list[Feature]) -> Iterator[Note]:
    """What became of lanes, sides of streets, houses to choose from and such to be replaced."""
    names = {name for f in blocks for name in (f.id, f.tags.get("name", ""))} - {""}
    for feature in found.features:
        kind = feature.tags.get("building", "")
        if "highway" in feature.tags and (feature.lines or feature.polygons):
            area = "" if feature.lines else "is drawn as an area: only lines are read as lanes"
            yield Note(feature.id, "left out" if area else "used", area)
        elif "street_side" in feature.tags:
            known = feature.tags["street_side"] in names
            yield Note(feature.id, "used" if known else "left out", "" if known else "of no block")
        elif kind == LIBRARY and feature.polygons:
            yield Note(feature.id, "used")
        elif kind == "proposed" and feature.polygons:
            yield Note(feature.id, "left out", "is proposed: houses are placed anew")


def _block(
    feature: Feature, found: Collection, map_: Projection, lanes: bool, notes: list[Note]
) -> dict[str, Any]:
    ring = _ring(metres(map_, feature.polygons[0][0]))
    made: dict[str, Any] = {
        "name": feature.tags.get("name", feature.id),
        "outline": ring.round(3).tolist(),
    }
    named = [
        metres(map_, line)
        for other in found.features
        if other.tags.get("street_side") in (feature.id, feature.tags.get("name", ""))
        for line in other.lines
    ]
    sides = _along(ring, named)
    if named and sides:
        made["streets"] = sides
    elif not lanes:
        made["streets"] = list(range(len(ring)))
    parts = len(feature.polygons)
    about = f"only the first of its {parts} parts was read" if parts > 1 else ""
    notes.append(Note(feature.id, "changed" if about else "used", about))
    made["fixed"] = list(_houses(feature, shapely.Polygon(ring), found, map_, notes))
    return made


def _houses(
    block: Feature, floor: shapely.Polygon, found: Collection, map_: Projection, notes: list[Note]
) -> Iterator[dict[str, Any]]:
    """The houses that stand in a block."""
    bare, parcels = find_footprints(found.features)
    notes += [Note(name, "left out", PARCEL) for name in sorted(parcels)]
    for feature in found.features:
        untagged = feature.id in bare
        if feature is block or not (_stays(feature) or untagged):
            continue
        for number, part in enumerate(feature.polygons, 1):
            corners = _ring(metres(map_, part[0]))
            shape = shapely.make_valid(shapely.Polygon(corners))
            if not floor.contains(shape.representative_point()):
                if shapely.intersection(floor, shape).area >= LEAST_OVER:
                    notes.append(Note(feature.id, "left out", "lies across a block's border", True))
                continue
            reason = "; ".join(filter(None, (UNTAGGED * untagged, feature.lost)))
            notes.append(Note(feature.id, "changed" if reason else "used", reason))
            house = _house(feature, corners)
            yield house | ({"id": f"{house['id']}.{number}"} if number > 1 else {})


def _stays(feature: Feature) -> bool:
    return stands(feature.tags) and feature.tags.get("building") != LIBRARY


def _choice(feature: Feature, name: str, corners: Points) -> dict[str, Any]:
    """A house of the library."""
    ring = _ring(corners)
    made: dict[str, Any] = {
        "name": name[:80],
        "footprint": (ring - ring.mean(0)).round(3).tolist(),
        "levels": int(min(max(_number(feature.tags.get("building:levels"), 2.0), 1), 12)),
        "roof": ROOFS.get(feature.tags.get("roof:shape", ""), "gabled"),
        "use": use_of_word(feature.tags.get("building:use", "")),
    }
    height = _number(feature.tags.get("height"), 0.0)
    return made | ({"height": height} if height else {})


def _ring(ring: Points) -> Points:
    """A ring without its closing corner."""
    return ring[:-1] if len(ring) > 1 and np.allclose(ring[0], ring[-1]) else ring


def _along(ring: Points, named: list[Points]) -> list[int]:
    """The sides of a ring whose ends both lie on a line named as street."""
    if not named:
        return []
    lines = shapely.union_all([shapely.LineString(line) for line in named])
    on = shapely.distance(shapely.points(ring), lines) <= NEAR
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    between = shapely.distance(shapely.points(middle), lines) <= NEAR
    return np.flatnonzero(on & np.roll(on, -1) & between).tolist()


def _lanes(feature: Feature, map_: Projection) -> list[dict[str, Any]]:
    kind = feature.tags.get("highway", "")
    if not kind:
        return []
    path = kind in PATHS
    width = _number(feature.tags.get("width"), PATH if path else WIDTHS.get(kind, LANE))
    return [
        {
            "name": feature.tags.get("name", ""),
            "line": metres(map_, line).round(3).tolist(),
            "width": min(max(width, 0.5), 60.0),
            "kind": "path" if path else "road",
        }
        for line in feature.lines
    ]


def _house(feature: Feature, ring: Points) -> dict[str, Any]:
    """A house that stands, its front as the tag ``direction`` says, else along its longer side."""
    angle, _, _ = rectangle_about(ring)
    direction = feature.tags.get("direction")
    heading = np.pi / 2 - np.deg2rad(_number(direction, 0.0)) if direction else angle + np.pi / 2
    cos, sin = np.cos(np.pi / 2 - heading), np.sin(np.pi / 2 - heading)
    local = ring @ np.array([[cos, sin], [-sin, cos]])
    low, high = local.min(0), local.max(0)
    middle = (low + high) / 2 @ np.array([[cos, -sin], [sin, cos]])
    levels = _number(feature.tags.get("building:levels"), 0.0)
    height = _number(feature.tags.get("height"), levels * STOREY + 2 if levels else HEIGHT)
    width, depth = (high - low).tolist()
    area = float(shapely.make_valid(shapely.Polygon(ring)).area)
    drawn = plain_building((width, depth, height), area, use=word_of_tags(feature.tags))
    return {
        "id": feature.id,
        "house": feature.tags.get("name", ""),
        "model": feature.tags.get("model", "" if fits_footprint(drawn) else drawn),
        "at": [round(float(v), 3) for v in middle],
        "heading": float((heading + np.pi) % (2 * np.pi) - np.pi),
        "size": [width, depth, height],
        "footprint": (local - (low + high) / 2).round(6).tolist(),
        "use": use_of_tags(feature.tags),
        "roof": ROOFS.get(feature.tags.get("roof:shape", "")),
    }


def _number(text: Any, otherwise: float) -> float:
    """A number at the head of a tag, else another."""
    try:
        value = float(str(text).split()[0])
    except (ValueError, IndexError):
        return otherwise
    return value if np.isfinite(value) and value >= 0 else otherwise
