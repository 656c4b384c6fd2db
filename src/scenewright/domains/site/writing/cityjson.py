"""A solved site as CityJSON 2.0: buildings as solids of level of detail 1.2 (and 2.0 where
their roof is known), ground, roads, and what is laid out (lanes, drives, walks; squares and
parking; courts).

Prisms over the footprints and bodies under roofs, every surface marked as ground, wall or roof;
vertices are whole millimetres, each listed once. Coordinates are those of the city model that the
site came from, else the local metres of the brief. Credits are attributes of the ground: extra
properties of the whole would need an extension of the schema.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.georeference import georeference_of
from scenewright.core.plan import Plan
from scenewright.core.projection import projection_at
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.site.plan import plans_of
from scenewright.domains.site.shapes import StandingBuilding, standing
from scenewright.domains.terrain import lay_city_on_terrain
from scenewright.ground.buildings.city_objects import (
    Vertices,
    add_roads,
    city_document,
    flat_object,
    free_key,
    prism_object,
)
from scenewright.ground.buildings.city_roofs import add_flat_roof, add_roof
from scenewright.ground.maps.places import write_document
from scenewright.ground.plan import SitePlan
from scenewright.ground.ways.surfaces import pave
from scenewright.ground.works import GREEN, GroundWorks


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the city model of a solution to ``path``; the file appears whole or not at all."""
    made = lay_city_on_terrain(document(solution, plan), solution, plan)
    write_document(made, path)


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The CityJSON object of a solution of sites."""
    plans: tuple[SitePlan, ...] = made.detail if made else plans_of(solution.brief)
    models = catalog_of(solution.brief.catalogs)
    credited = authorship.document(authorship.credits_of_solution(solution, models))
    vertices: Vertices = {}
    objects: dict[str, Any] = {}
    for plan in plans:
        name = free_key(plan.id, objects)
        attributes: dict[str, Any] = {"name": plan.name, "class": "site", "credits": credited}
        objects[name] = flat_object("LandUse", [(plan.outline, *plan.holes)], attributes, vertices)
        add_roads(plan.roads, objects, vertices)
    for works in solution.detail or ():
        for name, made_of in _laid_out(works, vertices):
            objects[free_key(name, objects)] = made_of
    placed = {piece.id: piece for piece in solution.pieces}
    for row in standing(solution, plans):
        objects[free_key(row.id, objects)] = _building(row, placed.get(row.id), vertices)
    return city_document(solution.brief.name, objects, vertices, *_frame(solution.brief))


def _laid_out(works: GroundWorks, vertices: Vertices) -> Iterator[tuple[str, dict[str, Any]]]:
    """Names and objects of what a solution lays out on the ground of a site."""
    for k, path in enumerate(works.pathways, 1):
        attributes: dict[str, Any] = {"name": path.kind, "class": path.kind, "width": path.width}
        parts = shapely.get_parts(pave([path], path.kind))
        yield (
            f"{works.site}/{path.kind}_{k}",
            flat_object("Road", [rings_of(part) for part in parts], attributes, vertices),
        )
    for k, area in enumerate(works.areas, 1):
        attributes = {"name": area.about or area.kind, "class": area.kind}
        attributes |= {"bays": area.bays} if area.bays else {}
        kind = "LandUse" if area.kind in GREEN else "TransportSquare"
        ring = [(np.array(area.outline),)]
        yield f"{works.site}/{area.kind}_{k}", flat_object(kind, ring, attributes, vertices)


def rings_of(part: shapely.Polygon) -> tuple[Points, ...]:
    """Outline and holes of a polygon."""
    outline, holes = rings(part)
    return (outline, *holes)


def _frame(brief: Brief) -> tuple[tuple[float, float], str, tuple[float, float, float]]:
    """What all sites add to their coordinates for those of one reference system, its name, and
    the metres in a unit of it along x, y and upwards."""
    shift, address = georeference_of(brief)
    if not address:
        return shift, "", (1.0, 1.0, 1.0)
    map_ = projection_at(shift, address)
    return shift, address, (*map_.scale, map_.system.height if map_.system else 1.0)


def _building(row: StandingBuilding, piece: Piece | None, vertices: Vertices) -> dict[str, Any]:
    """A prism over the footprint, and its body with the roof it is drawn with: a level one where
    it has no model."""
    attributes = {
        "name": row.name,
        "measuredHeight": round(row.high - row.low, 3),
        "model": row.model,
        "storeysAboveGround": row.floors,
        "landmark": row.landmark,
        "heading": round(float(np.rad2deg(row.heading)), 3),
    }
    made = prism_object(row.footprint, row.low, row.high, attributes, vertices)
    if not row.model:
        return add_flat_roof(made)
    return add_roof(made, piece, vertices) if piece else made
