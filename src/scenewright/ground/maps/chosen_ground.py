"""The ground of a map that is to be built on, by its id or by a place in it.

Around a place the smallest area counts that holds it: a plot, an area of land use, or what the
streets around enclose.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np
import shapely

from scenewright.core.errors import InputError
from scenewright.core.projection import Projection, coordinates_of, metres
from scenewright.ground.maps.features import Collection, Feature
from scenewright.ground.maps.kinds import is_footprint, stands, words_of

MADE = "between the streets"
"""The layer of a site that no feature of the file draws."""
LEAST = 10.0
"""Square metres below which an area is no site."""
HALF_STREET = 4.0
"""Metres from the middle of a street to the ground beside it."""
MINOR = frozenset(
    words_of(
        "footway path steps track pedestrian cycleway bridleway service corridor proposed "
        "construction crossing elevator platform"
    )
)
"""Ways that lie within the ground between streets."""
OWN = ("site", "block", "extend")
BUILDABLE = frozenset(words_of("construction brownfield greenfield"))
SETTLED = frozenset(words_of("residential commercial retail industrial institutional education"))
"""Values of ``landuse`` of ground that is to be built on, and of ground that is built on."""
MOST_NAMED = 5
"""Areas or places that a message names."""


def order_grounds(areas: Iterable[Feature]) -> list[Feature]:
    """The areas of a map by how likely each is the ground to build on, the largest of a kind
    first: plots and building sites, settled or untagged ground, other grounds, land and water,
    administrative areas, buildings."""
    return sorted(areas, key=lambda one: (_rank(one), -_extent(one)))


def name_places(found: Collection, map_: Projection) -> list[str]:
    """Places between the streets of a map, as ``--site`` takes them, those with most ground
    first."""
    _, faces = _enclosed(found.features, map_)
    largest = sorted(faces, key=lambda face: -face.area)[:MOST_NAMED]
    points = [shapely.get_coordinates(face.representative_point()) for face in largest]
    plain = map_._replace(swapped=False)
    return [f"{x:.10g},{y:.10g}" for at in points for x, y in coordinates_of(plain, at).tolist()]


def _rank(feature: Feature) -> int:
    tags = feature.tags
    if stands(tags):
        return 5
    if tags.get("place") == "plot" or tags.get("landuse") in BUILDABLE:
        return 0
    if tags.get("landuse") in SETTLED or is_footprint(tags):
        return 1
    if tags.keys() & {"boundary", "place"}:
        return 4
    return 3 if tags.keys() & {"natural", "landuse", "waterway", "railway", "aeroway"} else 2


def _extent(feature: Feature) -> float:
    parts = [shapely.make_valid(shapely.Polygon(part[0])) for part in feature.polygons]
    return float(shapely.union_all(parts).area)


def choose_by_id(found: Collection, wanted: str) -> Collection:
    """The map with the area of an id as its only site; InputError if there is none."""
    name = re.sub(r"[^\w.-]+", "-", wanted).strip("-")
    areas = [feature for feature in found.features if feature.polygons]
    chosen = next((feature for feature in areas if feature.id in (wanted, name)), None)
    if chosen is None:
        some = ", ".join(feature.id for feature in order_grounds(areas)[:MOST_NAMED])
        raise InputError(
            f"holds no area '{wanted[:60]}'",
            f"give --site the id of one, such as {some}, or a place as x,y"
            if some
            else "give a map with areas",
        )
    return _with_site(found, chosen)


def choose_around(found: Collection, at: tuple[float, float], map_: Projection) -> Collection:
    """The map with the smallest area around a place as its only site; ``map_`` turns coordinates
    into metres about that place. InputError if nothing encloses it."""
    here = shapely.Point(0, 0)
    areas = [
        (shape.area, feature)
        for feature in found.features
        if feature.polygons and not stands(feature.tags)
        for shape in [_shape(feature, map_)]
        if shape.area >= LEAST and shape.intersects(here)
    ]
    between = _between_streets(found.features, map_, here)
    if between is not None:
        areas.append((between.area, _made(between, map_)))
    if not areas:
        raise InputError(
            f"nothing encloses the place {at[0]:.10g},{at[1]:.10g}: no plot, no area, no streets",
            "give --site another place, or the id of an area",
        )
    return _with_site(found, min(areas, key=lambda row: row[0])[1])


def _with_site(found: Collection, chosen: Feature) -> Collection:
    """The map with one feature as its only site."""
    tags = {key: text for key, text in chosen.tags.items() if key not in (*OWN, "building")}
    site = chosen._replace(tags=tags | {"site": "yes"})
    others = tuple(
        feature._replace(tags={key: v for key, v in feature.tags.items() if key not in OWN})
        for feature in found.features
        if feature.id != chosen.id
    )
    return found._replace(features=(site, *others))


def _shape(feature: Feature, map_: Projection) -> shapely.Geometry:
    parts = [[metres(map_, ring) for ring in part] for part in feature.polygons]
    return shapely.union_all([shapely.Polygon(part[0], part[1:]).buffer(0) for part in parts])


def _between_streets(
    features: Iterable[Feature], map_: Projection, here: shapely.Point
) -> shapely.Polygon | None:
    """What the streets around a place enclose, without the streets; ``None`` if they do not."""
    streets, faces = _enclosed(features, map_)
    around = [face for face in faces if face.contains(here)]
    if not around:
        return None
    left = around[0].difference(streets.buffer(HALF_STREET, join_style="mitre"))
    parts = [part for part in shapely.get_parts(left) if part.area >= LEAST]
    return min(parts, key=lambda part: part.distance(here), default=None)


def _enclosed(
    features: Iterable[Feature], map_: Projection
) -> tuple[shapely.Geometry, list[shapely.Polygon]]:
    """The middle lines of all streets, and the ground between them."""
    lines = [
        shapely.LineString(metres(map_, line))
        for feature in features
        if feature.tags.get("highway", "footway") not in MINOR
        for line in feature.lines
    ]
    streets = shapely.union_all(lines)
    return streets, list(shapely.get_parts(shapely.polygonize(shapely.get_parts(streets))))


def _made(floor: shapely.Polygon, map_: Projection) -> Feature:
    """Ground as a feature of the map."""
    plain = map_._replace(swapped=False)
    order = -1 if map_.swapped else 1
    rings = tuple(
        np.ascontiguousarray(coordinates_of(plain, shapely.get_coordinates(ring))[:, ::order])
        for ring in (floor.exterior, *floor.interiors)
    )
    return Feature("site", {"site": "yes"}, None, (rings,), False, layer=MADE)
