"""A solved extension as CityJSON 2.0: buildings old and new, areas and streets.

In local metres, or those of the city model the only source came from. Buildings are prisms over
their footprints, houses also bodies with their roofs; the model that draws them, their age and the
front's heading are attributes.
"""

from __future__ import annotations

import os
from typing import Any

from scenewright.building.outlines import rings
from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.domains.extend.pattern import STOREY
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.works import plots_of_extension
from scenewright.domains.terrain import lay_city_on_terrain
from scenewright.ground.buildings.city_objects import (
    Vertices,
    add_planted,
    add_roads,
    city_document,
    flat_object,
    free_key,
)
from scenewright.ground.buildings.city_roofs import roofed_building
from scenewright.ground.maps.places import write_document
from scenewright.ground.streetside.plot_writing import add_plots


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the city model of a solution to ``path``; the file appears whole or not at all."""
    made = lay_city_on_terrain(document(solution, plan), solution, plan)
    write_document(made, path)


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The CityJSON object of a solution of an extension."""
    whole = made or plan_extend(solution.brief)
    plan: ExtendPlan = whole.detail
    models = catalog_of(solution.brief.catalogs)
    credited = authorship.document(authorship.credits_of_solution(solution, models))
    vertices: Vertices = {}
    objects: dict[str, Any] = {}
    for area in plan.areas:
        outline, holes = rings(area.outline)
        attributes: dict[str, Any] = {"name": area.name, "class": "extension", "credits": credited}
        key = free_key(area.id, objects)
        objects[key] = flat_object("LandUse", [(outline, *holes)], attributes, vertices)
    add_roads(plan.ground.roads, objects, vertices)
    add_plots(plots_of_extension(solution, whole), objects, vertices)
    for piece in solution.pieces:
        if piece.category == "building":
            objects[free_key(piece.id, objects)] = _building(piece, vertices)
    add_planted(solution.pieces, OLD, objects, vertices)
    return city_document(solution.brief.name, objects, vertices)


def _building(piece: Piece, vertices: Vertices) -> dict[str, Any]:
    attributes = {
        "model": piece.asset,
        "storeysAboveGround": max(1, round(piece.size.height / STOREY)),
        "new": piece.space != OLD,
    }
    return roofed_building(piece, attributes, vertices)
