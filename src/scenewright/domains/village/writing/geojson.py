"""A filled village as GeoJSON (RFC 7946): blocks, street sides, lanes, houses with their doors.

In longitude and latitude, by the ``origin`` of the brief. The tags are those of OpenStreetMap, with
``block`` and ``street_side`` of our own, and the file reads as a village again.
"""

from __future__ import annotations

import os
from typing import Any

from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.lanes import opened
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.plots import plots_of_village
from scenewright.ground.maps.places import check_origin, write_building, write_document, write_way
from scenewright.ground.maps.writing import (
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
    write_document(document(solution, plan), path)


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
    features += [write_way(way, map_) for way in village.lanes]
    features += plot_features(plots_of_village(solution, plan), map_)
    houses = [p for p in solution.pieces if p.category == "building"]
    features += [write_building(p, STOREY, map_) for p in houses]
    models = catalog_of(solution.brief.catalogs)
    stated = {"credits": authorship.document(authorship.credits_of_solution(solution, models))}
    return write_collection(solution.brief.name, features, map_) | stated


def check(brief: Brief) -> None:
    """Raise :class:`InputError` if it is not known where on earth a village lies."""
    check_origin(brief, "blocks")
