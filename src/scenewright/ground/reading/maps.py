"""Buildings, streets and grounds of a GeoJSON map, by the tags of OpenStreetMap."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.projection import Projection, metres, projection
from scenewright.core.space import Points
from scenewright.ground.buildings.built import BuiltBuilding, BuiltRoad, BuiltScene
from scenewright.ground.buildings.use_words import ROOFS, word_of_tags
from scenewright.ground.maps.features import Collection, Feature, collection, in_degrees
from scenewright.ground.maps.footprints import find_footprints
from scenewright.ground.maps.kinds import stands
from scenewright.ground.maps.place import projection_of
from scenewright.ground.reading.cleaning import MOST_BUILDINGS, clean_outline, drop_overlaps
from scenewright.ground.reading.planted import drop_planted, read_planted

STOREY, HEIGHT = 3.0, 7.5
WIDTHS = {"primary": 9.0, "secondary": 8.0, "tertiary": 7.0, "residential": 6.0, "service": 4.0}
PATHS = ("footway", "path", "steps", "track", "pedestrian", "cycleway", "bridleway")
USUAL, NARROW = 5.5, 2.0


def map_scene(document: Any, name: str, origin: tuple[float, float] | None = None) -> BuiltScene:
    """The scene of a GeoJSON document."""
    return scene_of_features(collection(document), name, origin)


def scene_of_features(
    found: Collection, name: str, origin: tuple[float, float] | None = None
) -> BuiltScene:
    """The scene of the features of a map, in metres about ``origin`` or the map's middle."""
    found = in_degrees(found)
    corners = [ring for f in found.features for p in f.polygons for ring in p]
    corners += [line for f in found.features for line in f.lines]
    if not corners:
        raise InputError("holds no buildings", "give a map with building polygons")
    map_ = projection_about(np.vstack(corners), found, origin)
    left_out: list[str] = [f"{row.feature}: {row.reason}" for row in found.skipped]
    planted = read_planted(found.features, map_)
    rest = drop_planted(found.features, planted)
    buildings = list(buildings_of(rest, map_, left_out))
    if len(buildings) > MOST_BUILDINGS:
        raise InputError(f"holds {len(buildings):,} buildings", f"{MOST_BUILDINGS:,} are read")
    kept, overlapping = drop_overlaps(buildings)
    roads = tuple(road for f in rest for road in roads_of(f, map_))
    scene = BuiltScene(name, kept, roads, None, (*left_out, *overlapping), map_.where)
    return scene._replace(trees=planted.trees, lamps=planted.lamps)


def projection_about(
    corners: Points, found: Collection, origin: tuple[float, float] | None
) -> Projection:
    """The projection of a map about a given longitude and latitude, else about its middle."""
    map_ = projection_of(found, corners)
    if origin is None or not map_.turns:
        return map_
    return projection(np.array([origin], float))


def buildings_of(
    features: tuple[Feature, ...], map_: Projection, left_out: list[str]
) -> Iterator[BuiltBuilding]:
    """The buildings of features; what has no usable footprint is ``left_out``."""
    bare, _ = find_footprints(features)
    for feature in features:
        if not feature.polygons or not (stands(feature.tags) or feature.id in bare):
            continue
        for number, rings in enumerate(feature.polygons):
            outline = clean_outline(metres(map_, rings[0]))
            label = feature.id if len(feature.polygons) == 1 else f"{feature.id}.{number + 1}"
            if outline is None:
                left_out.append(f"{label}: has no usable footprint")
                continue
            tags = feature.tags
            levels = number_of(tags.get("building:levels"), 0.0)
            usual = levels * STOREY + 1.5 if levels else HEIGHT
            height = min(max(number_of(tags.get("height"), usual), 2.0), 400.0)
            north = tags.get("direction")
            heading = None if north is None else np.pi / 2 - np.deg2rad(number_of(north, 0.0))
            yield BuiltBuilding(
                label,
                tags.get("name", ""),
                outline,
                height,
                None if heading is None else float((heading + np.pi) % (2 * np.pi) - np.pi),
                tags.get("model", ""),
                word_of_tags(tags),
                ROOFS.get(tags.get("roof:shape", ""), ""),
            )


def roads_of(feature: Feature, map_: Projection) -> Iterator[BuiltRoad]:
    """The streets and paths a feature draws."""
    kind = feature.tags.get("highway", "")
    if not kind:
        return
    path = kind in PATHS
    usual = NARROW if path else WIDTHS.get(kind, USUAL)
    width = number_of(feature.tags.get("width"), usual) or usual
    for line in feature.lines:
        points = metres(map_, line)
        if len(points) > 1 and np.ptp(points, axis=0).max() > 0.5:
            yield BuiltRoad(
                points,
                min(max(width, 0.5), 60.0),
                "path" if path else "road",
                feature.tags.get("name", ""),
            )


def number_of(text: Any, otherwise: float) -> float:
    """A number at the head of a tag, else another.

    >>> number_of("12.5 m", 3.0), number_of(None, 3.0)
    (12.5, 3.0)
    """
    try:
        value = float(str(text).split()[0])
    except (ValueError, IndexError):
        return otherwise
    return value if np.isfinite(value) and value >= 0 else otherwise
