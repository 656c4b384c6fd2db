"""A filled village as GeoJSON (RFC 7946): blocks, street sides, lanes, houses with their doors.

In longitude and latitude, by the ``origin`` of the brief. The tags are those of OpenStreetMap, with
``block`` and ``street_side`` of our own, and the file reads as a village again.
"""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.plan import plan_village
from scenewright.ground.projection import Projection, coordinates_of, projection

STOREY = 2.7


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    write_atomically(path, json.dumps(document(solution, plan), ensure_ascii=False) + "\n")


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The FeatureCollection of a solution of a village."""
    check(solution.brief)
    village: VillagePlan = (made or plan_village(solution.brief)).detail
    map_ = projection(np.array([solution.brief.part.origin], float))
    features = []
    for block in village.blocks:
        tags = {"block": "yes", "name": block.name}
        features.append(_feature(block.id, "Polygon", [_ring(block.outline, map_)], tags))
        for k, side in enumerate(block.streets, 1):
            name = f"{block.id}/street-{k}"
            told = {"street_side": block.id}
            features.append(_feature(name, "LineString", _points(side, map_), told))
    for way in village.lanes:
        kind = "residential" if way.kind == "road" else "footway"
        tags_ = {"highway": kind, "name": way.name, "width": way.width}
        features.append(_feature(way.id, "LineString", _points(way.line, map_), tags_))
    features += [_house(p, map_) for p in solution.pieces if p.category == "building"]
    return {"type": "FeatureCollection", "name": solution.brief.name, "features": features}


def check(brief: Brief) -> None:
    """Raise :class:`InputError` if it is not known where on earth a village lies."""
    if brief.part.origin is None:
        raise InputError(
            "GeoJSON is in degrees, and the brief does not say where its blocks lie",
            'give the brief an "origin": [longitude, latitude]',
        )


def _house(piece: Piece, map_: Projection) -> dict[str, Any]:
    north = (90.0 - float(np.rad2deg(piece.pose.heading))) % 360.0
    told = {
        "building": "yes",
        "name": piece.function,
        "height": round(piece.size.height, 3),
        "building:levels": max(1, round(piece.size.height / STOREY)),
        "model": piece.asset,
        "direction": round(north, 2),
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
