"""The buildings of a city model (CityJSON), with the models that draw them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import shapely

from scenewright.catalog.models.cityjson import City, city_of, parts_at, roots_of, turn_of
from scenewright.catalog.models.gltf_scene import plan_of_parts
from scenewright.catalog.models.model import clean
from scenewright.core.catalog import OWN, Part
from scenewright.core.errors import InputError
from scenewright.ground.buildings.built import BuiltBuilding, BuiltRoad, BuiltScene
from scenewright.ground.outlines import GRID
from scenewright.ground.reading.cleaning import clean_outline, drop_overlaps
from scenewright.ground.reading.planted_city import planted_city
from scenewright.ground.reading.road_areas import NARROW, pieces


def city_scene(document: dict[str, Any], path: Path) -> BuiltScene:
    """The scene of a city model, in metres about its middle."""
    city = city_of(document)
    stem, seen, left = clean(path.stem, "model"), Counter[str](), list[str]()
    found = []
    for key in roots_of(city):
        short = clean(key, "unnamed")
        try:
            parts = parts_at(city, key)
        except InputError as error:
            left.append(f"{short}: {error.fault}")
            continue
        seen[short] += 1
        name = f"{stem}/{short}" + (f"-{seen[short]}" if seen[short] > 1 else "")
        built = _building(city, key, short, f"{OWN}{name}", parts)
        if built is None:
            left.append(f"{short}: has no usable footprint")
        else:
            found.append(built)
    kept, overlapping = drop_overlaps(found)
    planted = planted_city(city)
    return BuiltScene(
        path.stem.removesuffix(".city"),
        kept,
        tuple(_roads(city)),
        left_out=(*left, *overlapping, *planted.left_out),
        catalog=str(path.absolute()),
        trees=planted.trees,
        lamps=planted.lamps,
    )


def _roads(city: City) -> Iterator[BuiltRoad]:
    """The roads of a city model, which it draws as areas, in straight pieces."""
    areas = [_area(city, key) for key, one in city.objects.items() if one.get("type") == "Road"]
    for piece in pieces(shapely.union_all(areas, grid_size=GRID)):
        kind = "path" if piece.width < NARROW else "road"
        yield BuiltRoad(np.array(piece.line), min(max(piece.width, 0.5), 60.0), kind)


def _area(city: City, key: str) -> shapely.Geometry:
    """The outline of an object in plan; empty if its geometry cannot be used."""
    try:
        return plan_of_parts(parts_at(city, key))
    except InputError:
        return shapely.Polygon()


def _building(
    city: City, key: str, short: str, model: str, parts: tuple[Part, ...]
) -> BuiltBuilding | None:
    attributes = city.objects[key].get("attributes")
    name = clean(attributes.get("name")) if isinstance(attributes, dict) else ""
    return building_of_parts(parts, short, name, model)


def building_of_parts(
    parts: tuple[Part, ...], short: str, name: str, model: str
) -> BuiltBuilding | None:
    """The building of some parts where they stand, its front the side nearest to the south;
    ``None`` if they cover no usable footprint."""
    points = np.concatenate([part.vertices[np.unique(part.faces)] for part in parts])
    pieces = [p for p in shapely.get_parts(plan_of_parts(parts)) if p.geom_type == "Polygon"]
    if not pieces:
        return None
    whole = max(pieces, key=lambda part: part.area)
    outline = clean_outline(shapely.get_coordinates(whole.exterior))
    if outline is None:
        return None
    height = max(float(np.ptp(points[:, 2])), 1.0)
    return BuiltBuilding(short, name, outline, height, turn_of(parts) - np.pi / 2, model)
