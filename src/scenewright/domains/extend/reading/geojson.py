"""Extensions drawn as GeoJSON: a map of buildings, and polygons tagged ``extend`` to be filled.

Buildings and streets are the source; a polygon with ``extend=yes`` is an area. Its tags ``count``
and ``coverage`` are those of the brief.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.projection import Projection, metres
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.maps.fates import Note
from scenewright.ground.maps.features import Collection, Feature, in_degrees
from scenewright.ground.maps.footprints import PARCEL, UNTAGGED, find_footprints, note_plots
from scenewright.ground.maps.kinds import stands
from scenewright.ground.maps.place import projection_of
from scenewright.ground.maps.report import report_map
from scenewright.ground.reading.maps import buildings_of, number_of, roads_of
from scenewright.ground.reading.planted import drop_planted, read_planted

UNREAD = "is no area to fill, building, street, tree or lamp"


def recognises(found: Collection) -> bool:
    """Whether a map can be of an extension: a polygon tagged ``extend``."""
    return any(_is_area(feature) for feature in found.features)


def names_itself(found: Collection) -> bool:
    """Whether a map says that it is of an extension, whatever else it holds."""
    return recognises(found)


def _is_area(feature: Feature) -> bool:
    return bool(feature.polygons) and feature.tags.get("extend", "no") != "no"


def brief_of(found: Collection, name: str) -> Brief:
    """The brief of a map; InputError if it has no area to fill, or no building to go by."""
    given, found = found, in_degrees(found)
    areas = [feature for feature in found.features if _is_area(feature)]
    corners = [ring for f in found.features for p in f.polygons for ring in p]
    if not areas:
        raise InputError(
            "holds no area to fill", 'draw a polygon with the property "extend": "yes"'
        )
    map_ = projection_of(found, np.vstack(corners))
    lost: list[str] = []
    planted = read_planted([f for f in found.features if not _is_area(f)], map_)
    rest = drop_planted(found.features, planted)
    buildings = list(buildings_of(rest, map_, lost))
    if not buildings:
        raise InputError("holds no building to go by", 'tag footprints with "building": "yes"')
    roads = [road for f in rest for road in roads_of(f, map_)]
    notes = note_features(found._replace(features=rest), areas, {b.id for b in buildings}, map_)
    source = {
        "name": name[:80],
        "stands": True,
        "buildings": [
            {
                "id": one.id,
                "name": one.name[:80],
                "outline": one.outline.round(3).tolist(),
                "height": one.height,
                "heading": one.heading,
                "model": one.model if not one.model.startswith("model:") else "",
            }
            for one in buildings
        ],
        "roads": [_road(road) for road in roads],
        "trees": planted.trees,
        "lamps": planted.lamps,
    }
    document: dict[str, Any] = {
        "domain": "extend",
        "name": name,
        "sources": [source],
        "areas": [_area(feature, map_) for feature in areas],
        "notes": [line[:400] for line in lost[:100]],
        "input_report": report_map(given, map_, [*notes, *planted.notes], lambda _name: UNREAD),
    }
    if map_.where:
        document["origin"] = map_.where
    return Brief.model_validate(document)


def note_features(
    found: Collection, areas: list[Feature], built: set[str], map_: Projection
) -> list[Note]:
    """What became of areas, buildings (those ``built``, by their ids) and streets."""
    notes = list[Note]()
    bare, parcels = find_footprints(found.features)
    names = {feature.id for feature in areas}
    for feature in found.features:
        parts = [f"{feature.id}.{k}" for k in range(1, len(feature.polygons) + 1)]
        kept = [name in built for name in (parts if len(parts) > 1 else [feature.id])]
        if feature.id in names:
            first = "only the first of its parts was read" if parts[1:] else ""
            notes.append(Note(feature.id, "changed" if first else "used", first))
        elif stands(feature.tags) or feature.id in bare:
            about = [UNTAGGED] * (feature.id in bare)
            about += [f"{kept.count(False)} of its parts has no usable footprint"] * (not all(kept))
            about += [feature.lost] * bool(feature.lost)
            note = Note(feature.id, "changed" if about else "used", "; ".join(about))
            lost = Note(feature.id, "left out", "has no usable footprint", True)
            notes.append(note if any(kept) and feature.polygons else lost)
        elif feature.id in parcels:
            notes.append(Note(feature.id, "left out", PARCEL))
        elif "highway" in feature.tags and (feature.lines or feature.polygons):
            read = any(True for _ in roads_of(feature, map_))
            why = "" if read else "is no line with a length"
            notes.append(Note(feature.id, "used" if read else "left out", why))
    return [*notes, *note_plots(found.features, notes)]


def _area(feature: Feature, map_: Projection) -> dict[str, Any]:
    rings = [metres(map_, ring)[:-1].round(3).tolist() for ring in feature.polygons[0]]
    made: dict[str, Any] = {
        "name": feature.tags.get("name", feature.id),
        "outline": rings[0],
        "holes": rings[1:],
    }
    count, coverage = (number_of(feature.tags.get(key), -1.0) for key in ("count", "coverage"))
    if count >= 0:
        made["count"] = round(count)
    if coverage > 0:
        made["coverage"] = coverage
    return made


def _road(road: BuiltRoad) -> dict[str, Any]:
    return {
        "name": road.name[:80],
        "line": road.line.round(3).tolist(),
        "width": road.width,
        "kind": road.kind,
    }
