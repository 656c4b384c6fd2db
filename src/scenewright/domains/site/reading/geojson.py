"""Sites drawn for OpenStreetMap or by a planner, as GeoJSON.

Polygons with the tag ``site`` are sites, and their properties fields of the brief (``setback``,
``floor_area_ratio`` …); without one the largest polygon that is no building is the site. Lines
with ``highway`` become roads and paths as wide as their class, polygons with ``building``
landmarks, polygons of water holes. What lies outside is cut off; broken features are left out.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains.site.brief import VERGE
from scenewright.domains.site.reading.tags import OWN, height_of, is_water, number_of, width_of
from scenewright.ground.map_features import Collection, Feature, SkippedFeature, load
from scenewright.ground.projection import Projection, metres, projection

MOST_SITES = 100
BEYOND = 10.0
"""Metres to which roads are kept outside the outline."""

LEAST_SITE, LEAST_BUILDING, LARGEST_EXTENT = 10.0, 1.0, 10_000.0


class SiteReport(NamedTuple):
    """What was read: the brief, how many features there were, how many roads and landmarks came
    of them, and what was left out and why."""

    brief: Brief
    features: int
    roads: int
    landmarks: int
    skipped: tuple[SkippedFeature, ...]


class _Drawn(NamedTuple):
    """A feature with its polygons in metres."""

    feature: Feature
    shape: shapely.Geometry


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
    outlines = _outlines(found.features)
    if not outlines:
        raise InputError(
            f"holds no outline of a site among its {len(found.features)} features",
            'draw a polygon with the property "site": "yes"',
        )
    if len(outlines) > MOST_SITES:
        raise InputError(f"holds {len(outlines):,} sites", f"at most {MOST_SITES} are read")
    corners = np.vstack([ring for f in outlines for part in f.polygons for ring in part])
    map_ = projection(corners, found.crs)
    skipped: list[SkippedFeature] = []
    drawn = [_Drawn(f, _shape(f, map_, skipped)) for f in found.features if f.polygons]
    sites = []
    for number, feature in enumerate(outlines):
        shape = next(row.shape for row in drawn if row.feature is feature)
        sites.append(_site(feature, shape, drawn, found, map_, skipped))
        sites[-1].setdefault("name", name if len(outlines) == 1 else f"{name} {number + 1}")
    brief = Brief.model_validate({"domain": "site", "name": name, "sites": sites})
    return SiteReport(
        brief,
        len(found.features) + len(found.skipped),
        sum(len(site.roads) for site in brief.part.sites),
        sum(len(site.landmarks) for site in brief.part.sites),
        (*found.skipped, *skipped),
    )


def _outlines(features: tuple[Feature, ...]) -> list[Feature]:
    """The features drawn as sites, else the largest polygon that is no building nor water."""
    areas = [f for f in features if f.polygons and not is_water(f.tags)]
    tagged = [f for f in areas if f.tags.get("site", "no") != "no"]
    plain = [f for f in areas if not {"building", "highway", "building:part"} & f.tags.keys()]
    largest = sorted(plain, key=lambda f: _extent(f), reverse=True)[:1]
    return tagged or largest


def _extent(feature: Feature) -> float:
    found = shapely.union_all([shapely.make_valid(shapely.Polygon(p[0])) for p in feature.polygons])
    return float(found.area)


def _shape(feature: Feature, map_: Projection, skipped: list[SkippedFeature]) -> shapely.Geometry:
    """The polygons of a feature in metres; those that cross themselves as what they enclose."""
    parts = [[metres(map_, ring) for ring in part] for part in feature.polygons]
    shape = shapely.union_all([shapely.Polygon(part[0], part[1:]).buffer(0) for part in parts])
    if not shapely.union_all([shapely.Polygon(part[0]) for part in parts[:1]]).is_valid:
        skipped.append(
            SkippedFeature(feature.id, "crosses itself and was read as what it encloses")
        )
    return shape


def _largest(shape: shapely.Geometry) -> shapely.Polygon:
    parts = [p for p in shapely.get_parts(shape) if p.geom_type == "Polygon"]
    return max(parts, key=lambda part: part.area, default=shapely.Polygon())


def _site(
    feature: Feature,
    shape: shapely.Geometry,
    drawn: list[_Drawn],
    found: Collection,
    map_: Projection,
    skipped: list[SkippedFeature],
) -> dict[str, Any]:
    """One site as a document of the brief."""
    floor = _largest(shape)
    _check(feature, floor, map_)
    water = [
        row.shape for row in drawn if is_water(row.feature.tags) and row.feature is not feature
    ]
    holes = [hole for hole in map(_largest, water) if not hole.is_empty and floor.contains(hole)]
    ground = _largest(shapely.difference(floor, shapely.union_all(holes))) if holes else floor
    outline, cut = rings(ground)
    stated = number_of(feature.tags.get("verge", ""))
    verge = VERGE if stated is None else stated
    document: dict[str, Any] = {
        "id": feature.id,
        "outline": outline.tolist(),
        "holes": [hole.tolist() for hole in cut],
        "roads": _roads(found.features, floor, map_, verge),
        "landmarks": _landmarks(drawn, ground, feature, skipped),
    }
    for key, field in OWN.items():
        value = number_of(feature.tags.get(key, ""))
        if value is not None:
            document[field] = round(value) if field == "day" else value
    if not map_.turns:
        document |= {"shift": map_.origin, "system": found.crs[:200]}
    else:
        document["origin"] = map_.origin
        document.setdefault("latitude", max(min(map_.origin[1], 89.0), -89.0))
    if feature.tags.get("name"):
        document["name"] = feature.tags["name"]
    return document


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
    features: tuple[Feature, ...], floor: shapely.Polygon, map_: Projection, verge: float
) -> list[dict[str, Any]]:
    """Roads and paths that reach the site or run beside it, cut off a few metres outside it."""
    found: list[dict[str, Any]] = []
    for feature in features:
        way = width_of(feature.tags)
        for line in (row for row in feature.lines if way and len(row) > 1):
            kind, width = way or ("", 0.0)
            whole = shapely.LineString(metres(map_, line))
            found += [
                {
                    "id": feature.id,
                    "name": feature.tags.get("name", ""),
                    "line": shapely.get_coordinates(part).tolist(),
                    "width": width,
                    "kind": kind,
                }
                for part in _near_parts(whole, width, floor, verge)
            ]
    return _unique(found)


def _near_parts(
    whole: shapely.LineString, width: float, floor: shapely.Polygon, verge: float
) -> list[shapely.LineString]:
    """The parts of a line whose surface comes within a verge of a floor: cut off :data:`BEYOND`
    metres outside, or so much farther that the street beside the verge is whole."""
    found = []
    for far, least, most in ((BEYOND, 0.0, 0.0), (verge + width / 2 + BEYOND, 1e-9, verge)):
        cut = shapely.intersection(whole, shapely.buffer(floor, far))
        for part in shapely.get_parts(shapely.line_merge(cut)):
            area = shapely.buffer(part, width / 2, cap_style="flat", join_style="mitre")
            if part.geom_type == "LineString" and least <= shapely.distance(area, floor) <= most:
                found.append(part)
    return found


def _landmarks(
    drawn: list[_Drawn], ground: shapely.Polygon, own: Feature, skipped: list[SkippedFeature]
) -> list[dict[str, Any]]:
    """Buildings at least half inside, less what lies outside or in one before."""
    rows = [
        r
        for r in drawn
        if r.feature.tags.get("building", "no") != "no"
        and r.feature is not own
        and not r.shape.is_empty
    ]
    rows = [row for row in rows if shapely.intersects(row.shape, ground)]
    taken = shapely.STRtree([row.shape for row in rows]) if rows else None
    kept: dict[int, shapely.Polygon] = {}
    found = []
    for number, row in enumerate(rows):
        shape = shapely.Polygon(_largest(row.shape).exterior)
        near = [kept[k] for k in taken.query(row.shape).tolist() if k in kept] if taken else []
        rest = shapely.intersection(shape, ground, grid_size=1e-4)
        if near:
            rest = shapely.difference(rest, shapely.union_all(near), grid_size=1e-4)
        rest = shapely.Polygon(_largest(rest).exterior)
        if rest.area < max(0.5 * shape.area, LEAST_BUILDING):
            skipped.append(
                SkippedFeature(row.feature.id, "less than half of it is free inside the site")
            )
            continue
        kept[number] = rest
        tags = row.feature.tags
        document = {
            "id": row.feature.id,
            "name": tags.get("name", ""),
            "outline": rings(rest)[0].tolist(),
        }
        height = height_of(tags)
        found.append(document | ({"height": height} if height else {}))
    return _unique(found)


def _unique(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows with an id given twice lose the second."""
    seen: set[str] = set()
    for row in rows:
        row["id"] = "" if row["id"] in seen else row["id"]
        seen.add(row["id"])
    return rows
