"""A filled extension as GeoJSON (RFC 7946): areas, streets, buildings old and new.

In longitude and latitude, by the ``origin`` of the brief. The tags are those of OpenStreetMap, with
``extend`` of our own; buildings of the areas have ``new``. Read again, the file is the same brief
with its new buildings among the old: a neighbourhood that has grown.
"""

from __future__ import annotations

import json
import os
from typing import Any

from scenewright.building.outlines import rings
from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.projection import Projection
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.domains.extend.pattern import STOREY
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.works import plots_of_extension
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


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    check(solution.brief)
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
    whole = made or plan_extend(solution.brief)
    plan: ExtendPlan = whole.detail
    map_ = projection_about(solution.brief.part.origin)
    features = []
    for area in plan.areas:
        outline, holes = rings(area.outline)
        ring = [write_ring(one, map_) for one in (outline, *holes)]
        features.append(
            write_feature(area.id, "Polygon", ring, {"extend": "yes", "name": area.name})
        )
    for way in plan.ground.roads:
        kind = "residential" if way.kind == "road" else "footway"
        tags = {"highway": kind, "name": way.name, "width": way.width}
        features.append(write_feature(way.id, "LineString", write_points(way.line, map_), tags))
    features += plot_features(plots_of_extension(solution, whole), map_)
    features += [_building(p, map_) for p in solution.pieces if p.category == "building"]
    return write_collection(solution.brief.name, features, map_)


def _building(piece: Piece, map_: Projection) -> dict[str, Any]:
    use = use_of_asset(piece.asset)
    tags = {
        "building": "yes" if use is None else TAG_OF_USE[use],
        "name": piece.function,
        "height": round(piece.size.height, 3),
        "building:levels": max(1, round(piece.size.height / STOREY)),
        "model": piece.asset,
        "direction": bearing_of(piece.pose.heading),
        "new": "" if piece.space == OLD else "yes",
    }
    return write_feature(piece.id, "Polygon", [write_ring(outline_of(piece), map_)], tags)
