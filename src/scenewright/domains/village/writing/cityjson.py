"""A filled village as CityJSON 2.0: houses as prisms (level of detail 1.2), as high as they are,
and with their roofs (2.0), blocks, lanes and free squares, in the local metres of the brief."""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np
import shapely

from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import write_atomically
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
    city_document,
    flat_object,
    free_key,
    prism_object,
)
from scenewright.ground.buildings.city_roofs import add_roof
from scenewright.ground.streetside.plot_writing import add_plots


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the city model of a village to ``path``; the file appears whole or not at all."""
    made = lay_city_on_terrain(document(solution, plan), solution, plan)
    write_atomically(path, json.dumps(made, ensure_ascii=False) + "\n")


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The CityJSON object of a village."""
    plan = made or plan_village(solution.brief)
    vertices: Vertices = {}
    objects = _grounds(solution, opened(plan, solution).detail, vertices)
    add_plots(plots_of_village(solution, plan), objects, vertices)
    for piece in solution.pieces:
        if piece.category == "building" and np.isfinite([*piece.pose, *piece.size]).all():
            attributes = {
                "name": piece.function,
                "measuredHeight": round(piece.size[2], 3),
                "block": piece.space,
                "model": piece.asset,
                "area": round(float(shapely.Polygon(outline_of(piece)).area), 2),
                "heading": round(float(np.rad2deg(piece.pose.heading)), 3),
            }
            low = piece.pose.z
            shape = outline_of(piece)
            built = prism_object(shape, low, low + piece.size[2], attributes, vertices)
            objects[free_key(piece.id, objects)] = add_roof(built, piece, vertices)
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
    for way in plan.lanes:
        areas = [(area.outline, *area.holes) for area in way.areas]
        if areas:
            attributes = {"name": way.name or way.id, "class": way.kind, "width": way.width}
            found[free_key(way.id, found)] = flat_object("Road", areas, attributes, vertices)
    for patch in solution.patches:
        ring = corners(np.array([patch.box]))[0]
        attributes = {"name": patch.id, "class": "square"}
        found[free_key(patch.id, found)] = flat_object(
            "TransportSquare", [(ring,)], attributes, vertices
        )
    return found
