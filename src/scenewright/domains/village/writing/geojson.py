"""A filled village as GeoJSON (RFC 7946): blocks, street sides, lanes, houses with their doors.

In longitude and latitude, by the ``origin`` of the brief. The tags are those of OpenStreetMap, with
``block`` and ``street_side`` of our own, and the file reads as a village again.
"""

from __future__ import annotations

import json
import os
from typing import Any

from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.projection import Projection
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.lanes import opened
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.plots import plots_of_village
from scenewright.ground.buildings.use_words import TAG_OF_USE
from scenewright.ground.buildings.uses import use_of_asset
from scenewright.ground.maps.writing import (
    bearing_of,
    projection_about,
    write_collection,
    write_feature,
    write_points,
    write_ring,
)
from scenewright.ground.streetside.plot_writing import plot_features

STOREY = 2.7


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    check(solution.brief)
    write_atomically(path, json.dumps(document(solution, plan), ensure_ascii=False) + "\n")


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The FeatureCollection of a solution of a village."""
    plan = made or plan_village(solution.brief)
    village: VillagePlan = opened(plan, solution).detail
    map_ = projection_about(solution.brief.part.origin)
    features = []
    for block in village.blocks:
        tags = {"block": "yes", "name": block.name}
        features.append(write_feature(block.id, "Polygon", [write_ring(block.outline, map_)], tags))
        for k, side in enumerate(block.streets, 1):
            name = f"{block.id}/street-{k}"
            tags = {"street_side": block.id}
            features.append(write_feature(name, "LineString", write_points(side, map_), tags))
    for way in village.lanes:
        kind = "residential" if way.kind == "road" else "footway"
        tags_ = {"highway": kind, "name": way.name, "width": way.width}
        features.append(write_feature(way.id, "LineString", write_points(way.line, map_), tags_))
    features += plot_features(plots_of_village(solution, plan), map_)
    features += [_house(p, map_) for p in solution.pieces if p.category == "building"]
    models = catalog_of(solution.brief.catalogs)
    stated = {"credits": authorship.document(authorship.credits_of_solution(solution, models))}
    return write_collection(solution.brief.name, features, map_) | stated


def check(brief: Brief) -> None:
    """Raise :class:`InputError` if it is not known where on earth a village lies."""
    if brief.part.origin is None:
        raise InputError(
            "GeoJSON is in degrees, and the brief does not say where its blocks lie",
            'give the brief an "origin": [longitude, latitude]',
        )


def _house(piece: Piece, map_: Projection) -> dict[str, Any]:
    use = use_of_asset(piece.asset)
    tags = {
        "building": "yes" if use is None else TAG_OF_USE[use],
        "name": piece.function,
        "height": round(piece.size.height, 3),
        "building:levels": max(1, round(piece.size.height / STOREY)),
        "model": piece.asset,
        "direction": bearing_of(piece.pose.heading),
    }
    return write_feature(piece.id, "Polygon", [write_ring(outline_of(piece), map_)], tags)
