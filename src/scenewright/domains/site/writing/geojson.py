"""A solved site as GeoJSON (RFC 7946): outline, roads, what is laid out, footprints with heights.

In longitude and latitude (WGS 84) if every site has an ``origin``; else in the metres of the
reference system that all sites came from, which the file names (``crs``, of GeoJSON before the
RFC). Other metres are not written: every reader would take them for degrees. The tags are those of
OpenStreetMap, and the file reads as a site again.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.projection import Projection, projection, projection_at
from scenewright.core.reference_system import urn_of
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.plan import plans_of
from scenewright.domains.site.shapes import StandingBuilding, standing
from scenewright.ground.maps.places import write_document, write_way
from scenewright.ground.maps.writing import bearing_of, write_feature, write_points, write_ring
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.ways.junctions import Crossing
from scenewright.ground.ways.surfaces import kerb, list_zebras
from scenewright.ground.works import Pathway, PavedArea

FIELDS = (
    "setback",
    "road_setback",
    "verge",
    "spacing",
    "sun_spacing",
    "floor_area_ratio",
    "coverage",
    "height_limit",
    "fire_access",
    "sun_hours",
    "day",
)
PATH_TAGS = {
    "lane": {"highway": "service"},
    "drive": {"highway": "service", "service": "parking_aisle"},
    "walk": {"highway": "footway"},
}
AREA_TAGS = {
    "square": {"place": "square", "highway": "pedestrian", "area": "yes"},
    "forecourt": {"highway": "pedestrian", "area": "yes"},
    "parking": {"amenity": "parking", "parking": "surface"},
    "court": {"leisure": "garden"},
    "park": {"leisure": "park"},
}
"""Tags of OpenStreetMap for what is laid out."""


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    check(solution.brief)
    write_document(document(solution, plan), path)


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The FeatureCollection of a solution of sites; its ``crs`` is null where its metres are of no
    system."""
    plans: tuple[SitePlan, ...] = made.detail if made else plans_of(solution.brief)
    rows = standing(solution, plans)
    in_degrees = _in_degrees(solution.brief)
    features: list[dict[str, Any]] = []
    for site, plan in zip(solution.brief.part.sites, plans, strict=True):
        map_ = _projection(site, in_degrees)
        features.append(_site(site, plan, map_))
        features += [_way(way, map_) for way in plan.roads]
        features += [_crossing(one, plan.id, k, map_) for k, one in enumerate(list_zebras(plan), 1)]
        for works in (one for one in solution.detail or () if one.site == plan.id):
            features += [_path(path, plan.id, k, map_) for k, path in enumerate(works.pathways, 1)]
            features += [_area(area, plan.id, k, map_) for k, area in enumerate(works.areas, 1)]
        features += [_building(row, map_) for row in rows if row.site == plan.id]
    found: dict[str, Any] = {
        "type": "FeatureCollection",
        "name": solution.brief.name,
        "features": features,
    }
    models = catalog_of(solution.brief.catalogs)
    found["credits"] = authorship.document(authorship.credits_of_solution(solution, models))
    if not in_degrees:
        names = {urn_of(site.system) for site in solution.brief.part.sites}
        name = {"name": names.pop() if len(names) == 1 else ""}
        found["crs"] = {"type": "name", "properties": name} if name["name"] else None
    return found


def check(brief: Brief) -> None:
    """Raise :class:`InputError` if it is not known where on earth the sites of a brief lie."""
    systems = {urn_of(site.system) for site in brief.part.sites}
    if not _in_degrees(brief) and (len(systems) != 1 or "" in systems):
        raise InputError(
            "GeoJSON is in degrees, and the brief does not say where its sites lie",
            'give each site an "origin": [longitude, latitude]',
        )


def _in_degrees(brief: Brief) -> bool:
    return all(site.origin for site in brief.part.sites)


def _projection(site: Site, in_degrees: bool) -> Projection:
    if in_degrees:
        return projection(np.array([site.origin], float))
    return projection_at(site.shift, site.system)


def _site(site: Site, plan: SitePlan, map_: Projection) -> dict[str, Any]:
    values = {field: getattr(site, field) for field in FIELDS}
    stated = {field: value for field, value in values.items() if value is not None}
    rings = [write_ring(ring, map_) for ring in (plan.outline, *plan.holes)]
    return write_feature(plan.id, "Polygon", rings, {"site": "yes", "name": plan.name} | stated)


def _way(way: Way, map_: Projection) -> dict[str, Any]:
    beside = way.kind == "road" and kerb(way.width)
    return write_way(way, map_, **({"sidewalk": "both"} if beside else {}))


def _crossing(one: Crossing, site: str, number: int, map_: Projection) -> dict[str, Any]:
    """A zebra crossing, as a point of its street."""
    tags = {"highway": "crossing", "crossing": "marked"}
    (point,) = write_points(one.at[None], map_)
    return write_feature(f"{site}/crossing_{number}", "Point", point, tags)


def _path(path: Pathway, site: str, number: int, map_: Projection) -> dict[str, Any]:
    """A lane, drive or walk that the solution lays out."""
    tags = PATH_TAGS[path.kind] | {"laid_out": path.kind, "width": path.width}
    points = write_points(np.array(path.line), map_)
    return write_feature(f"{site}/{path.kind}_{number}", "LineString", points, tags)


def _area(area: PavedArea, site: str, number: int, map_: Projection) -> dict[str, Any]:
    """A square, forecourt, car park or court."""
    tags: dict[str, Any] = AREA_TAGS[area.kind] | {"laid_out": area.kind, "name": area.about}
    tags |= {"capacity": area.bays} if area.bays else {}
    ring = [write_ring(np.array(area.outline), map_)]
    return write_feature(f"{site}/{area.kind}_{number}", "Polygon", ring, tags)


def _building(row: StandingBuilding, map_: Projection) -> dict[str, Any]:
    tags: dict[str, Any] = {
        "building": "yes",
        "name": row.name,
        "height": round(row.high - row.low, 3),
        "building:levels": row.floors,
        "model": row.model,
        "direction": bearing_of(row.heading),
        "landmark": "yes" if row.landmark else "no",
    }
    return write_feature(row.id, "Polygon", [write_ring(row.footprint, map_)], tags)
