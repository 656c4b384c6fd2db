"""A filled extension as GeoJSON (RFC 7946): areas, streets, buildings old and new.

In longitude and latitude, by the ``origin`` of the brief. The tags are those of OpenStreetMap, with
``extend`` of our own; buildings of the areas have ``new``. Read again, the file is the same brief
with its new buildings among the old: a neighbourhood that has grown.
"""

from __future__ import annotations

import os
from typing import Any

from scenewright.building.outlines import rings
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.domains.extend.pattern import STOREY
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.works import plots_of_extension
from scenewright.ground.maps.places import (
    check_origin,
    write_building,
    write_document,
    write_planted,
    write_way,
)
from scenewright.ground.maps.writing import (
    projection_about,
    write_collection,
    write_feature,
    write_ring,
)
from scenewright.ground.streetside.plot_writing import plot_features


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the map of a solution to ``path``; the file appears whole or not at all."""
    check(solution.brief)
    write_document(document(solution, plan), path)


def check(brief: Brief) -> None:
    """Raise :class:`InputError` if it is not known where on earth the areas lie."""
    check_origin(brief, "areas")


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
    features += [write_way(way, map_) for way in plan.ground.roads]
    features += plot_features(plots_of_extension(solution, whole), map_)
    for piece in (p for p in solution.pieces if p.category == "building"):
        age = "" if piece.space == OLD else "yes"
        features.append(write_building(piece, STOREY, map_, new=age))
    features += write_planted(solution.pieces, OLD, map_)
    return write_collection(solution.brief.name, features, map_)
