"""A filled extension as GeoJSON (RFC 7946): areas, streets, buildings old and new.

In longitude and latitude, by the ``origin`` of the brief. The tags are those of OpenStreetMap, with
``extend`` of our own; buildings of the areas have ``new``. Read again, the file is the same brief
with its new buildings among the old: a neighbourhood that has grown.
"""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from scenewright.building.outlines import rings
from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.domains.extend.plan import plan_extend
from scenewright.ground.projection import Projection, coordinates_of, projection

STOREY = 3.0


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    write_atomically(path, json.dumps(document(solution, plan), ensure_ascii=False) + "\n")


def check(brief: Brief) -> None:
    """Raise :class:`InputError` if it is not known where on earth the areas lie."""
    if brief.part.origin is None:
        raise InputError(
            "GeoJSON is in degrees, and the brief does not say where its areas lie",
            'give the brief an "origin": [longitude, latitude]',
        )


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The FeatureCollection of a solution of an extension."""
    check(solution.brief)
    plan: ExtendPlan = (made or plan_extend(solution.brief)).detail
    map_ = projection(np.array([solution.brief.part.origin], float))
    features = []
    for area in plan.areas:
        outline, holes = rings(area.outline)
        ring = [_ring(one, map_) for one in (outline, *holes)]
        features.append(_feature(area.id, "Polygon", ring, {"extend": "yes", "name": area.name}))
    for way in plan.ground.roads:
        kind = "residential" if way.kind == "road" else "footway"
        told = {"highway": kind, "name": way.name, "width": way.width}
        features.append(_feature(way.id, "LineString", _points(way.line, map_), told))
    features += [_building(p, map_) for p in solution.pieces if p.category == "building"]
    return {"type": "FeatureCollection", "name": solution.brief.name, "features": features}


def _building(piece: Piece, map_: Projection) -> dict[str, Any]:
    north = (90.0 - float(np.rad2deg(piece.pose.heading))) % 360.0
    told = {
        "building": "yes",
        "name": piece.function,
        "height": round(piece.size.height, 3),
        "building:levels": max(1, round(piece.size.height / STOREY)),
        "model": piece.asset,
        "direction": round(north, 2),
        "new": "" if piece.space == OLD else "yes",
    }
    return _feature(piece.id, "Polygon", [_ring(outline_of(piece), map_)], told)


def _feature(name: str, kind: str, coordinates: Any, told: dict[str, Any]) -> dict[str, Any]:
    properties = {key: value for key, value in told.items() if value != ""}
    geometry = {"type": kind, "coordinates": coordinates}
    return {"type": "Feature", "id": name, "properties": properties, "geometry": geometry}


def _ring(ring: Points, map_: Projection) -> list[list[float]]:
    return _points(np.vstack([ring, ring[:1]]), map_)


def _points(points: Points, map_: Projection) -> list[list[float]]:
    """Degrees to 1e-8 (a millimetre)."""
    found: list[list[float]] = coordinates_of(map_, points).round(8).tolist()
    return found
