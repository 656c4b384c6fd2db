"""A solved site as GeoJSON (RFC 7946): outline, roads, footprints with heights and names.

In longitude and latitude (WGS 84) if the site has an origin; else in metres, which the file says.
The tags are those of OpenStreetMap, and the file reads as a site again.
"""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from scenewright import authorship
from scenewright.brief.site import Site
from scenewright.formats.indoor_projection import Projection, coordinates_of, projection
from scenewright.formats.site_shapes import Standing, standing
from scenewright.site.plan import SitePlan, Way, plans_of
from scenewright.solution import Solution
from scenewright.space import Points
from scenewright.stock import catalog_of
from scenewright.whole_file import write_whole

METRES = "coordinates are metres, x to the east and y to the north: the brief has no origin"
PLAIN = Projection((0.0, 0.0), (1.0, 1.0), False)
FIELDS = ("setback", "road_setback", "spacing", "sun_spacing", "floor_area_ratio", "coverage",
          "height_limit", "fire_access", "sun_hours", "day")  # fmt: skip


def write(solution: Solution, path: str | os.PathLike[str]) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    write_whole(path, json.dumps(document(solution), ensure_ascii=False) + "\n")


def document(solution: Solution) -> dict[str, Any]:
    """The FeatureCollection of a solution of sites."""
    plans = plans_of(solution.brief)
    rows = standing(solution, plans)
    features: list[dict[str, Any]] = []
    for site, plan in zip(solution.brief.sites, plans, strict=True):
        map_ = projection(np.array([site.origin], float)) if site.origin else PLAIN
        features.append(_site(site, plan, map_))
        features += [_way(way, map_) for way in plan.roads]
        features += [_building(row, map_) for row in rows if row.site == plan.id]
    found: dict[str, Any] = {"type": "FeatureCollection", "name": solution.brief.name,
                             "features": features}  # fmt: skip
    models = catalog_of(solution.brief.catalogs)
    found["credits"] = authorship.document(authorship.credits_of(solution.pieces, models))
    return found if all(s.origin for s in solution.brief.sites) else found | {"note": METRES}


def _site(site: Site, plan: SitePlan, map_: Projection) -> dict[str, Any]:
    values = {field: getattr(site, field) for field in FIELDS}
    stated = {field: value for field, value in values.items() if value is not None}
    rings = [_ring(ring, map_) for ring in (plan.outline, *plan.holes)]
    return _feature(plan.id, "Polygon", rings, {"site": "yes", "name": plan.name} | stated)


def _way(way: Way, map_: Projection) -> dict[str, Any]:
    kind = "residential" if way.kind == "road" else "footway"
    told = {"highway": kind, "name": way.name, "width": way.width}
    return _feature(way.id, "LineString", _points(way.line, map_), told)


def _building(row: Standing, map_: Projection) -> dict[str, Any]:
    north = (90.0 - float(np.rad2deg(row.heading))) % 360.0
    told: dict[str, Any] = {
        "building": "yes", "name": row.name, "height": round(row.high - row.low, 3),
        "building:levels": row.floors, "model": row.model, "direction": round(north, 2),
        "landmark": "yes" if row.landmark else "no",
    }  # fmt: skip
    return _feature(row.id, "Polygon", [_ring(row.footprint, map_)], told)


def _feature(name: str, kind: str, coordinates: Any, told: dict[str, Any]) -> dict[str, Any]:
    properties = {key: value for key, value in told.items() if value != ""}
    geometry = {"type": kind, "coordinates": coordinates}
    return {"type": "Feature", "id": name, "properties": properties, "geometry": geometry}


def _ring(ring: Points, map_: Projection) -> list[list[float]]:
    return _points(np.vstack([ring, ring[:1]]), map_)


def _points(points: Points, map_: Projection) -> list[list[float]]:
    """Degrees to 1e-8 (a millimetre), metres to a millimetre."""
    found: list[list[float]] = coordinates_of(map_, points).round(8 if map_.turns else 3).tolist()
    return found
