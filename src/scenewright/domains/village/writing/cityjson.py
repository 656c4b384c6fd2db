"""A filled village as CityJSON 2.0: houses as prisms (level of detail 1.2), as high as they are,
and with their roofs (2.0), blocks, lanes and free squares, in the local metres of the brief."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import shapely

from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.terrain import lay_city_on_terrain
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.lanes import opened
from scenewright.domains.village.plan import plan_village
from scenewright.domains.village.plots import plots_of_village
from scenewright.ground.buildings.city_objects import (
    Vertices,
    add_roads,
    city_document,
    flat_object,
    free_key,
)
from scenewright.ground.buildings.city_roofs import roofed_building
from scenewright.ground.maps.places import write_document
from scenewright.ground.streetside.plot_writing import add_plots


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the city model of a village to ``path``; the file appears whole or not at all."""
    made = lay_city_on_terrain(document(solution, plan), solution, plan)
    write_document(made, path)


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The CityJSON object of a village."""
    plan = made or plan_village(solution.brief)
    vertices: Vertices = {}
    objects = _grounds(solution, opened(plan, solution).detail, vertices)
    add_plots(plots_of_village(solution, plan), objects, vertices)
    for piece in solution.pieces:
        if piece.category == "building" and np.isfinite([*piece.pose, *piece.size]).all():
            attributes = {
                "block": piece.space,
                "model": piece.asset,
                "area": round(float(shapely.Polygon(outline_of(piece)).area), 2),
            }
            built = roofed_building(piece, attributes, vertices)
            objects[free_key(piece.id, objects)] = built
    return city_document(solution.brief.name, objects, vertices)


def _grounds(solution: Solution, plan: VillagePlan, vertices: Vertices) -> dict[str, Any]:
    """Blocks, lanes and free squares."""
    credited = authorship.document(
        authorship.credits_of_solution(solution, catalog_of(solution.brief.catalogs))
    )
    found: dict[str, Any] = {}
    for block in plan.blocks:
        attributes: dict[str, Any] = {"name": block.name, "class": "block", "credits": credited}
        found[free_key(block.id, found)] = flat_object(
            "LandUse", [(block.outline,)], attributes, vertices
        )
    add_roads(plan.lanes, found, vertices)
    for patch in solution.patches:
        ring = corners(np.array([patch.box]))[0]
        attributes = {"name": patch.id, "class": "square"}
        found[free_key(patch.id, found)] = flat_object(
            "TransportSquare", [(ring,)], attributes, vertices
        )
    return found
