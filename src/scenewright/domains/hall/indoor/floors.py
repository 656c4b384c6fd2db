"""Floors of an indoor map: which features are units, rooms and ways, level by level, disjoint.

Where two floors overlap the smaller one keeps its shape and the larger one is cut, rooms before
ways (corridors, open areas); columns and walls drawn as areas are cut out of all. Of a room cut in
pieces the largest stays, of a way every piece.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import Literal, NamedTuple

import numpy as np
import shapely

from scenewright.building import outlines
from scenewright.core.brief.zones import Demand
from scenewright.core.errors import InputError
from scenewright.core.projection import FARTHEST, Projection, metres
from scenewright.domains.hall.demands.programme import shop_kind, shop_programme
from scenewright.ground.maps.features import Feature, SkippedFeature, levels_of

Role = Literal["unit", "room", "way", "solid"]

MAP_WALL = 0.1
"""Thickness of the walls, whose middle lines the map is taken to show."""
MAP_OVERLAP = 0.01
LEAST_AREA = 1.0
LEAST_REST = 0.1
MAP_GRID = 1e-3
MOST_FLOORS = 5_000
MOST_HOLES = 200
MOST_CORNERS = 5_000
MOST_CORNERS_ALL = 150_000
TOO_FINE = f"has more than {MOST_HOLES} holes or {MOST_CORNERS} corners"
BUILDING_PARTS = {"hall": "area", "verticalpassage": "room", "shell": "wall"}
"""Values of ``buildingpart`` that ``indoor`` has other words for."""
_WAYS = frozenset({"corridor", "area"})
_WAY_ROOMS = frozenset({"entrance", "corridor", "hall", "lobby", "vestibule"})
_NAMES = {
    "corridor": "Corridor",
    "area": "Hall",
    "toilets": "Toilets",
    "entrance": "Entrance",
    "disused": "Vacant unit",
    "vacant": "Vacant unit",
    "office": "Office",
    "waiting": "Waiting",
    "elevator": "Lift",
    "stairs": "Stairs",
    "steps": "Stairs",
    "shop": "Shop",
}


class IndoorFloor(NamedTuple):
    """One polygon of a feature on one level; ``kind`` is the programme of a unit."""

    feature: str
    tags: dict[str, str]
    role: Role
    kind: str
    level: float
    polygon: shapely.Polygon

    @property
    def demands(self) -> list[Demand]:
        """Its demands."""
        return shop_programme(self.kind, self.polygon.area, self.polygon.length)

    @property
    def name(self) -> str:
        """Its name in the map, its number, or what it is."""
        tags = self.tags
        usual = next(
            (_NAMES[v] for v in _telling(tags) if v in _NAMES),
            tags.get("shop", self.kind).replace("_", " ").capitalize() or "Room",
        )
        return (
            tags.get("name") or tags.get("brand") or " ".join((usual, tags.get("ref", ""))).strip()
        )


class Floors(NamedTuple):
    """Disjoint floors, what was left out and what was changed."""

    floors: tuple[IndoorFloor, ...]
    skipped: tuple[SkippedFeature, ...]
    changed: tuple[SkippedFeature, ...]


def role(tags: dict[str, str]) -> Role | None:
    """The kind of an area of the map, by its tags; ``None`` if it is no floor.

    >>> role({"indoor": "room", "shop": "books"}), role({"indoor": "area"}), role({"shop": "mall"})
    ('unit', 'way', None)
    >>> role({"indoor": "yes", "room": "office"}), role({"indoor": "yes", "highway": "corridor"})
    ('room', 'way')
    """
    indoor = _stated(tags)
    if indoor in ("column", "wall", "pillar"):
        return "solid"
    kind, riser = shop_kind(tags), "elevator" in _telling(tags)
    if indoor in _WAYS or (indoor == "room" and tags.get("room") in _WAY_ROOMS):
        return "unit" if kind else "room" if riser else "way"
    if indoor == "room":
        return "unit" if kind and not riser else "room"
    apart = "level" in tags and "building" not in tags
    return "unit" if not indoor and apart and tags.get("shop") and kind else None


def _stated(tags: dict[str, str]) -> str:
    """What ``indoor`` says, or older tags in its place: ``indoor=yes`` with ``room``, with a way or
    a shop; ``buildingpart``."""
    indoor = tags.get("indoor", tags.get("buildingpart", ""))
    if indoor in BUILDING_PARTS:
        return BUILDING_PARTS[indoor]
    if indoor != "yes":
        return indoor
    if tags.get("room", "no") != "no":
        return "room"
    if tags.get("highway") in ("corridor", "footway", "pedestrian"):
        return "corridor"
    return "room" if shop_kind(tags) else indoor


def floors_of(features: Iterable[Feature], map_: Projection) -> Floors:
    """The floors of all features, in metres; InputError if there are more than 5000."""
    skipped: list[SkippedFeature] = []
    changed: list[SkippedFeature] = []
    found: list[IndoorFloor] = []
    corners = 0
    for feature in features:
        try:
            fresh = _floors(feature, map_, changed)
            found += fresh
            corners += sum(shapely.count_coordinates(floor.polygon) for floor in fresh)
        except InputError as error:
            skipped.append(SkippedFeature(feature.id, error.fault))
        if len(found) > MOST_FLOORS:
            raise InputError(f"holds more than {MOST_FLOORS} rooms", "cut one building out of it")
        if corners > MOST_CORNERS_ALL:
            raise InputError("its rooms have too many corners", "cut one building out of it")
    kept: list[IndoorFloor] = []
    for level in sorted({floor.level for floor in found}):
        kept += _disjoint([f for f in found if f.level == level], skipped, changed)
    return Floors(tuple(kept), tuple(skipped), tuple(changed))


def with_points(
    floors: Iterable[IndoorFloor], points: list[tuple[Feature, shapely.Point]]
) -> list[IndoorFloor]:
    """Floors with the tags of the one shop that is marked by a point in a room without a use."""
    tree = shapely.STRtree([point for _, point in points])
    pairs = []
    for floor in floors:
        inside = [points[i][0] for i in tree.query(floor.polygon, predicate="contains").tolist()]
        here = [f for f in inside if floor.level in (levels_or_ground(f.tags))]
        bare = floor.role == "room" and not _telling(floor.tags)
        if bare and len(here) == 1:
            tags = here[0].tags | floor.tags
            floor = floor._replace(tags=tags, role="unit", kind=shop_kind(tags))
        pairs.append(floor)
    return pairs


def levels_or_ground(tags: dict[str, str]) -> tuple[float, ...]:
    """The levels of a feature; the ground floor, 0, if it names none."""
    return levels_of(tags) or (0.0,)


def _telling(tags: dict[str, str]) -> list[str]:
    stairs = ["stairs"] if tags.get("stairs") == "yes" else []
    keys = ("highway", "room", "amenity", "shop", "indoor")
    values = stairs + [tags[key] for key in keys if key in tags]
    return [value for value in values if value not in ("room", "yes")]


def _floors(feature: Feature, map_: Projection, changed: list[SkippedFeature]) -> list[IndoorFloor]:
    what = role(feature.tags)
    if what is None:
        return []
    if not feature.polygons:
        if feature.open_line and what != "solid":
            raise InputError("its line is not closed", "correct it in the map")
        return []
    levels = levels_or_ground(feature.tags)
    if len(levels) * len(feature.polygons) > MOST_FLOORS:
        raise InputError(
            f"has {len(feature.polygons)} parts on {len(levels)} levels", "correct it in the map"
        )
    if not levels_of(feature.tags):
        changed.append(SkippedFeature(feature.id, "names no level: put on level 0"))
    kind = shop_kind(feature.tags) if what == "unit" else ""
    return [
        IndoorFloor(feature.id, feature.tags, what, kind, level, shape)
        for rings in feature.polygons
        for shape in [_polygon(feature, [metres(map_, ring) for ring in rings], changed)]
        for level in levels
    ]


def _polygon(
    feature: Feature,
    rings: list[np.ndarray[tuple[int, ...], np.dtype[np.float64]]],
    changed: list[SkippedFeature],
) -> shapely.Polygon:
    """The polygon of one part, mended if only slivers of it are wrong."""
    if len(rings) - 1 > MOST_HOLES or max(map(len, rings)) > MOST_CORNERS:
        raise InputError(TOO_FINE, "correct it in the map")
    away = max(float(np.abs(ring).max()) for ring in rings)
    if away > FARTHEST:
        raise InputError(f"lies {away / 1000:.0f} km from the rest", "correct it in the map")
    shape = shapely.Polygon(rings[0].round(3), [ring.round(3) for ring in rings[1:]])
    if shape.is_valid:
        return shape
    parts = _parts(shapely.make_valid(shape))
    whole = sum(part.area for part in parts)
    if not parts or parts[0].area < 0.99 * whole:
        raise InputError("its outline crosses or touches itself", "correct it in the map")
    changed.append(SkippedFeature(feature.id, "its outline crossed itself: slivers were left out"))
    return parts[0]


def _parts(shape: shapely.Geometry) -> list[shapely.Polygon]:
    """Polygons of a geometry, largest first."""
    parts = [p for p in shapely.get_parts(shape).tolist() if isinstance(p, shapely.Polygon)]
    return sorted(parts, key=lambda part: -part.area)


def _disjoint(
    floors: list[IndoorFloor], skipped: list[SkippedFeature], changed: list[SkippedFeature]
) -> Iterator[IndoorFloor]:
    """Floors of one level, each cut by those before it: solids, rooms, ways, small before large."""
    ranks = {"solid": 0, "unit": 1, "room": 1, "way": 2}
    order = sorted(floors, key=lambda floor: (ranks[floor.role], floor.polygon.area))
    tree = shapely.STRtree([floor.polygon for floor in order])
    kept: list[shapely.Geometry | None] = [None] * len(order)
    for number, floor in enumerate(order):
        near = [i for i in tree.query(floor.polygon).tolist() if i < number and kept[i]]
        shared = shapely.area(shapely.intersection([kept[i] for i in near], floor.polygon))
        over = [i for i, area in zip(near, shared.tolist(), strict=True) if area > MAP_OVERLAP]
        parts, fault = _cut(floor, [kept[i] for i in over])
        drawn = [order[i].feature for i in over if order[i].role != "solid"]
        if drawn and not fault:
            names = ", ".join(drawn[:3]) + ", …" * (len(drawn) > 3)
            changed.append(SkippedFeature(floor.feature, f"was cut where it overlaps {names}"))
        if fault:
            skipped.append(SkippedFeature(floor.feature, fault))
        kept[number] = shapely.union_all(parts) if parts else None
        if floor.role != "solid":
            yield from (floor._replace(polygon=part) for part in parts)


def _cut(
    floor: IndoorFloor, others: list[shapely.Geometry | None]
) -> tuple[list[shapely.Polygon], str]:
    """The rest of a floor, or the reason why nothing is left."""
    if floor.role == "solid":
        return [floor.polygon], ""
    rest: list[shapely.Polygon] = [floor.polygon]
    if others:
        rest = _parts(floor.polygon.difference(shapely.union_all(others), grid_size=MAP_GRID))
        least = max(LEAST_AREA, LEAST_REST * floor.polygon.area * (floor.role != "way"))
        rest = [part for part in rest if part.area >= least]
        if not rest:
            return [], "others cover all of it"
    faults = [_fault(part) for part in rest]
    good = [part for part, fault in zip(rest, faults, strict=True) if not fault]
    return (good if floor.role == "way" else good[:1]), "" if good else faults[0]


def _fault(polygon: shapely.Polygon) -> str:
    """Why a brief would not take this room, if it would not."""
    outline, holes = rings(polygon)
    if len(holes) > MOST_HOLES or max(map(len, (outline, *holes))) > MOST_CORNERS:
        return TOO_FINE
    try:
        outlines.shrink(
            outlines.polygon(np.array(outline), tuple(map(np.array, holes))), MAP_WALL / 2
        )
    except InputError as error:
        return error.fault
    return ""


def rings(polygon: shapely.Polygon) -> tuple[list[list[float]], list[list[list[float]]]]:
    """Outline and holes as a brief lists them."""
    outline, holes = outlines.rings(polygon)
    return outline.round(3).tolist(), [hole.round(3).tolist() for hole in holes]


def counts(skipped: Iterable[SkippedFeature]) -> dict[str, int]:
    """How often each reason was given, most frequent first."""
    return dict(Counter(row.reason for row in skipped).most_common())
