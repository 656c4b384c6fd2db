"""Sites drawn for OpenStreetMap or by a planner, as GeoJSON.

Polygons with the tag ``site`` are sites, and their properties fields of the brief (``setback``,
``floor_area_ratio`` …); without one the area most likely to be built on is the site. Lines
with ``highway`` become roads and paths as wide as their class, polygons with ``building``, or with
no tag of a map at all, landmarks; water is no ground. What lies outside is cut off. The brief
carries a report of what became of every feature.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.projection import Projection, metres
from scenewright.domains.site.brief import VERGE
from scenewright.domains.site.reading.standing import (
    OUTSIDE,
    DrawnFeature,
    find_landmarks,
    note_points,
)
from scenewright.domains.site.reading.tags import OWN, is_water, number_of, width_of
from scenewright.ground.maps.chosen_ground import MOST_NAMED, name_places, order_grounds
from scenewright.ground.maps.fates import Note
from scenewright.ground.maps.features import Collection, Feature, SkippedFeature, load
from scenewright.ground.maps.place import corners_of, projection_of
from scenewright.ground.maps.report import report_map
from scenewright.ground.outlines import GRID, grow
from scenewright.ground.reading.road_areas import pieces

MOST_SITES = 100
BEYOND = 10.0
"""Metres to which roads are kept outside the outline."""

LEAST_SITE, LARGEST_EXTENT = 10.0, 10_000.0
UNREAD = "is no site, building, way or water"


class SiteReport(NamedTuple):
    """What was read: the brief, how many features there were, how many roads and landmarks came
    of them, and what was left out or changed and why."""

    brief: Brief
    features: int
    roads: int
    landmarks: int
    skipped: tuple[SkippedFeature, ...]


def read(path: Path, keep: bool = False) -> Brief:
    """The brief of a site map. There is nothing to ``keep``."""
    del keep
    return read_report(path).brief


def read_report(path: Path) -> SiteReport:
    """The brief of a site map, and what was found and left out."""
    return report(load(path), Path(path).stem)


def recognises(found: Collection) -> bool:
    """Whether a map can be of a site: a building, a road, or something tagged as a site."""
    return any(
        (feature.polygons and ({"site", "building", "landuse"} | OWN.keys()) & feature.tags.keys())
        or (feature.lines and "highway" in feature.tags)
        for feature in found.features
    )


def brief_of(found: Collection, name: str) -> Brief:
    """The brief of a site map already read."""
    return report(found, name).brief


def report(found: Collection, name: str) -> SiteReport:
    """The brief and report of features already read; InputError if no site is among them."""
    notes: list[Note] = []
    outlines = _outlines(found.features, notes)
    if not outlines:
        _refuse(found)
    if len(outlines) > MOST_SITES:
        raise InputError(f"holds {len(outlines):,} sites", f"at most {MOST_SITES} are read")
    corners = np.vstack([ring for f in outlines for part in f.polygons for ring in part])
    map_ = projection_of(found, corners)
    drawn = [DrawnFeature(f, _shape(f, map_, notes)) for f in found.features if f.polygons]
    sites = []
    for number, feature in enumerate(outlines):
        shape = next(row.shape for row in drawn if row.feature is feature)
        sites.append(_site(feature, shape, drawn, found, outlines, map_, notes))
        sites[-1].setdefault("name", name if len(outlines) == 1 else f"{name} {number + 1}")
    stated = report_map(found, map_, notes, lambda _name: UNREAD)
    brief = Brief.model_validate(
        {"domain": "site", "name": name, "sites": sites, "input_report": stated}
    )
    told = [SkippedFeature(note.name, note.reason) for note in notes if note.outcome != "used"]
    return SiteReport(
        brief,
        len(found.features) + len(found.skipped),
        sum(len(site.roads) for site in brief.part.sites),
        sum(len(site.landmarks) for site in brief.part.sites),
        (*found.skipped, *told),
    )


def _refuse(found: Collection) -> NoReturn:
    """Raise the InputError of a map without a site, with places between its streets."""
    corners = corners_of(found)
    places = name_places(found, projection_of(found, corners)) if len(corners) else []
    choice = f", or give --site a place between its streets, such as {' or '.join(places)}"
    raise InputError(
        f"holds no outline of a site among its {len(found.features)} features",
        'draw a polygon with the property "site": "yes"' + choice * bool(places),
    )


def _outlines(features: tuple[Feature, ...], notes: list[Note]) -> list[Feature]:
    """The features drawn as sites, else the area most likely to be built on that is no building
    nor water; ``notes`` say which of several it is, and how another is chosen."""
    areas = [f for f in features if f.polygons and not is_water(f.tags)]
    tagged = [f for f in areas if f.tags.get("site", "no") != "no"]
    plain = [f for f in areas if not {"building", "highway", "building:part"} & f.tags.keys()]
    if tagged:
        return tagged
    likely = order_grounds(plain)[:MOST_NAMED]
    if len(likely) > 1:
        others = ", ".join(feature.id for feature in likely[1:])
        reason = f"taken as the site, as no area is tagged so; --site takes another: {others}"
        notes.append(Note(likely[0].id, "changed", reason))
    return likely[:1]


def _shape(feature: Feature, map_: Projection, notes: list[Note]) -> shapely.Geometry:
    """The polygons of a feature in metres; those that cross themselves as what they enclose."""
    parts = [[metres(map_, ring) for ring in part] for part in feature.polygons]
    polygons = [shapely.Polygon(part[0], part[1:]) for part in parts]
    shape = shapely.union_all([polygon.buffer(0) for polygon in polygons])
    if not all(polygon.is_valid for polygon in polygons):
        notes.append(Note(feature.id, "left out", "crosses itself: only what it encloses was read"))
    return shape


def _largest(shape: shapely.Geometry) -> shapely.Polygon:
    parts = [p for p in shapely.get_parts(shape) if p.geom_type == "Polygon"]
    return max(parts, key=lambda part: part.area, default=shapely.Polygon())


def _site(
    feature: Feature,
    shape: shapely.Geometry,
    drawn: list[DrawnFeature],
    found: Collection,
    outlines: list[Feature],
    map_: Projection,
    notes: list[Note],
) -> dict[str, Any]:
    """One site as a document of the brief."""
    floor = _largest(shape)
    _check(feature, floor, map_)
    ground = _dry(feature, floor, drawn, notes)
    outline, cut = rings(ground)
    landmarks = find_landmarks(drawn, ground, outlines, notes)
    notes += note_points(found.features, map_, ground, landmarks)
    if shape.area - floor.area > LEAST_SITE:
        reason = f"only the largest of its {len(feature.polygons)} parts was read"
        notes.append(Note(feature.id, "changed", reason))
    stated = number_of(feature.tags.get("verge", ""))
    verge = VERGE if stated is None else stated
    document: dict[str, Any] = {
        "id": feature.id,
        "outline": outline.tolist(),
        "holes": [hole.tolist() for hole in cut],
        "roads": _roads(found.features, floor, map_, verge, notes),
        "landmarks": _unique(landmarks),
    }
    for key, field in OWN.items():
        value = number_of(feature.tags.get(key, ""))
        if value is not None:
            document[field] = round(value) if field == "day" else value
    if map_.system and not map_.turns:
        document |= {"shift": map_.origin, "system": map_.system.name}
    elif map_.where:
        document["origin"] = map_.where
    if map_.where:
        document.setdefault("latitude", max(min(map_.where[1], 89.0), -89.0))
    if feature.tags.get("name"):
        document["name"] = feature.tags["name"]
    return document


def _dry(
    feature: Feature, floor: shapely.Polygon, drawn: list[DrawnFeature], notes: list[Note]
) -> shapely.Polygon:
    """The largest piece of a site without its water."""
    water = [row for row in drawn if is_water(row.feature.tags) and row.feature is not feature]
    wet = [row for row in water if shapely.intersection(row.shape, floor).area > 0]
    reached = {row.feature.id for row in wet}
    notes += [
        Note(name, "used") if name in reached else Note(name, "left out", OUTSIDE)
        for name in (row.feature.id for row in water)
    ]
    rest = shapely.difference(floor, shapely.union_all([row.shape for row in wet]), grid_size=GRID)
    ground = _largest(rest) if wet else floor
    if ground.is_empty:
        raise InputError("its ground lies under water", "leave the water out", place=feature.id)
    lost = rest.area - ground.area if wet else 0.0
    about = f"water cuts {lost:.0f} m² off it: the largest piece was read"
    cut = lost >= LEAST_SITE
    notes.append(Note(feature.id, "changed" if cut else "used", about if cut else ""))
    return ground


def _check(feature: Feature, floor: shapely.Polygon, map_: Projection) -> None:
    """A site must have ground, and be of a size that its coordinates can be right."""
    west, south, east, north = floor.bounds if not floor.is_empty else (0.0, 0.0, 0.0, 0.0)
    if floor.area < LEAST_SITE:
        fault = f"holds only {floor.area:.2g} m²"
        remedy = "its coordinates may be in another reference system: export it as longitude and "
        remedy += "latitude (WGS 84)"
        flat = "draw it in metres; of a map in degrees cut out at most 10 km"
        raise InputError(fault, remedy if map_.turns else flat, place=feature.id)
    if max(east - west, north - south) > LARGEST_EXTENT:
        raise InputError(
            f"is {max(east - west, north - south) / 1000:.0f} km long",
            "cut a site of at most 10 km out of the map",
            place=feature.id,
        )


def _roads(
    features: tuple[Feature, ...],
    floor: shapely.Polygon,
    map_: Projection,
    verge: float,
    notes: list[Note],
) -> list[dict[str, Any]]:
    """Roads and paths that reach the site or run beside it, cut off a few metres outside it."""
    near = shapely.buffer(floor, verge + BEYOND)
    shapely.prepare(floor)
    found: list[dict[str, Any]] = []
    for feature in features:
        way = width_of(feature.tags)
        if not way:
            if "highway" in feature.tags and (feature.lines or feature.polygons):
                reason = f"highway={feature.tags['highway']} is no way there is"
                notes.append(Note(feature.id, "left out", reason))
            continue
        before = len(found)
        for line, width in _middle_lines(feature, way[1], near, map_):
            found += [
                {
                    "id": feature.id,
                    "name": feature.tags.get("name", ""),
                    "line": shapely.get_coordinates(part).tolist(),
                    "width": width,
                    "kind": way[0],
                }
                for part in _near_parts(line, width, floor, verge)
            ]
        if feature.lines or feature.polygons:
            notes.append(_note_way(feature, len(found) - before))
    return _unique(found)


def _near_parts(
    whole: shapely.LineString, width: float, floor: shapely.Polygon, verge: float
) -> list[shapely.LineString]:
    """The parts of a line whose surface comes within a verge of a floor: cut off :data:`BEYOND`
    metres outside, or farther where the street beside the verge needs it."""
    if not shapely.dwithin(floor, whole, verge + width):
        return []
    found = []
    for far, least, most in ((BEYOND, 0.0, 0.0), (verge + width / 2 + BEYOND, 1e-9, verge)):
        cut = shapely.intersection(whole, grow(floor, far))
        for part in shapely.get_parts(shapely.line_merge(cut)):
            area = shapely.buffer(part, width / 2, cap_style="flat", join_style="mitre")
            if part.geom_type == "LineString" and least <= shapely.distance(area, floor) <= most:
                found.append(part)
    return found


def _middle_lines(
    feature: Feature, width: float, near: shapely.Geometry, map_: Projection
) -> Iterator[tuple[shapely.LineString, float]]:
    """The middle lines of a way in metres and their widths; of an area its straight pieces."""
    for line in feature.lines:
        yield shapely.LineString(metres(map_, line)), width
    for part in feature.polygons if not feature.lines else ():
        area = shapely.Polygon(metres(map_, part[0]), [metres(map_, hole) for hole in part[1:]])
        for piece in pieces(shapely.intersection(area.buffer(0), near, grid_size=GRID)):
            yield shapely.LineString(piece.line), min(max(piece.width, 0.5), 100.0)


def _note_way(feature: Feature, count: int) -> Note:
    if not count:
        return Note(feature.id, "left out", "does not reach the site")
    area = "" if feature.lines else "is drawn as an area: read as straight pieces"
    about = "; ".join(filter(None, (area, feature.lost)))
    return Note(feature.id, "changed" if about else "used", about)


def _unique(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows with an id given twice lose the second."""
    seen: set[str] = set()
    for row in rows:
        row["id"] = "" if row["id"] in seen else row["id"]
        seen.add(row["id"])
    return rows
