"""A solved site as CityJSON 2.0: buildings as solids of level of detail 1.2, ground, roads, and
what is laid out (lanes, drives, walks; squares and parking; courts).

Prisms over the footprints, every surface told as ground, wall or roof; vertices are whole
millimetres, each listed once. Coordinates are those of the city model that the site came from,
else the local metres of the brief. Credits are attributes of the ground: extra properties of the
whole would need an extension of the schema.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.outlines import ring, rings, signed_area
from scenewright.catalog import credits as authorship
from scenewright.catalog.loading import catalog_of
from scenewright.core.atomic_file import write_atomically
from scenewright.core.brief import Brief
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.site.plan import plans_of
from scenewright.domains.site.shapes import StandingBuilding, standing
from scenewright.ground.plan import SitePlan
from scenewright.ground.reference_system import address_of
from scenewright.ground.surfaces import paved
from scenewright.ground.works import GroundWorks

SCALE = 0.001
GROUND, ROOF, WALL = 0, 1, 2
SURFACES = [{"type": "GroundSurface"}, {"type": "RoofSurface"}, {"type": "WallSurface"}]

Vertices = dict[tuple[int, int, int], int]


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the city model of a solution to ``path``; the file appears whole or not at all."""
    write_atomically(path, json.dumps(document(solution, plan), ensure_ascii=False) + "\n")


def document(solution: Solution, made: Plan | None = None) -> dict[str, Any]:
    """The CityJSON object of a solution of sites."""
    plans: tuple[SitePlan, ...] = made.detail if made else plans_of(solution.brief)
    models = catalog_of(solution.brief.catalogs)
    credited = authorship.document(authorship.credits_of(solution.pieces, models))
    vertices: Vertices = {}
    objects: dict[str, Any] = {}
    for plan in plans:
        name = _free(plan.id, objects)
        told: dict[str, Any] = {"name": plan.name, "class": "site", "credits": credited}
        objects[name] = _flat("LandUse", [(plan.outline, *plan.holes)], told, vertices)
        for way in plan.roads:
            areas = [(area.outline, *area.holes) for area in way.areas]
            if areas:
                told = {"name": way.name or way.id, "class": way.kind, "width": way.width}
                objects[_free(way.id, objects)] = _flat("Road", areas, told, vertices)
    for works in solution.detail or ():
        for name, made_of in _laid_out(works, vertices):
            objects[_free(name, objects)] = made_of
    for row in standing(solution, plans):
        objects[_free(row.id, objects)] = _building(row, vertices)
    whole = np.array(list(vertices), np.int64).reshape(-1, 3)
    x, y, system = _frame(solution.brief)
    about: dict[str, Any] = {
        "title": solution.brief.name,
        "geographicalExtent": _extent(whole, (x, y, 0.0)),
    }
    return {
        "type": "CityJSON",
        "version": "2.0",
        "transform": {"scale": [SCALE] * 3, "translate": [x, y, 0.0]},
        "metadata": about | ({"referenceSystem": system} if system else {}),
        "CityObjects": objects,
        "vertices": whole.tolist(),
    }


def _laid_out(works: GroundWorks, vertices: Vertices) -> Iterator[tuple[str, dict[str, Any]]]:
    """Names and objects of what a solution lays out on the ground of a site."""
    for k, path in enumerate(works.pathways, 1):
        told: dict[str, Any] = {"name": path.kind, "class": path.kind, "width": path.width}
        parts = shapely.get_parts(paved([path], path.kind))
        yield (
            f"{works.site}/{path.kind}_{k}",
            _flat("Road", [rings_of(part) for part in parts], told, vertices),
        )
    for k, area in enumerate(works.areas, 1):
        told = {"name": area.about or area.kind, "class": area.kind}
        told |= {"bays": area.bays} if area.bays else {}
        kind = "LandUse" if area.kind == "court" else "TransportSquare"
        ring = [(np.array(area.outline),)]
        yield f"{works.site}/{area.kind}_{k}", _flat(kind, ring, told, vertices)


def rings_of(part: shapely.Polygon) -> tuple[Points, ...]:
    """Outline and holes of a polygon."""
    outline, holes = rings(part)
    return (outline, *holes)


def _frame(brief: Brief) -> tuple[float, float, str]:
    """What all sites add to their coordinates for those of one reference system, and its name."""
    frames = {(*site.shift, site.system) for site in brief.part.sites}
    x, y, system = frames.pop() if len(frames) == 1 else (0.0, 0.0, "")
    return x, y, address_of(system)


def _building(row: StandingBuilding, vertices: Vertices) -> dict[str, Any]:
    """A prism: its underside looks down, its walls out, its top up."""
    corners = _whole(row.footprint)
    low, high = round(row.low / SCALE), round(row.high / SCALE)
    floor = [_vertex((x, y, low), vertices) for x, y in corners.tolist()]
    top = [_vertex((x, y, high), vertices) for x, y in corners.tolist()]
    count = len(corners)
    walls = [
        [[floor[i], floor[j], top[j], top[i]]]
        for i, j in ((k, (k + 1) % count) for k in range(count))
    ]
    shell = [[floor[::-1]], [top], *walls]
    told = {
        "name": row.name,
        "measuredHeight": round(row.high - row.low, 3),
        "model": row.model,
        "storeysAboveGround": row.floors,
        "landmark": row.landmark,
        "heading": round(float(np.rad2deg(row.heading)), 3),
    }
    geometry = {
        "type": "Solid",
        "lod": "1.2",
        "boundaries": [shell],
        "semantics": {"surfaces": SURFACES, "values": [[GROUND, ROOF, *[WALL] * count]]},
    }
    return {"type": "Building", "attributes": told, "geometry": [geometry]}


def _flat(
    kind: str, areas: Sequence[tuple[Points, ...]], told: dict[str, Any], vertices: Vertices
) -> dict[str, Any]:
    boundaries = [
        [
            [_vertex((x, y, 0), vertices) for x, y in np.round(line / SCALE).astype(int).tolist()]
            for line in area
        ]
        for area in areas
    ]
    geometry = {"type": "MultiSurface", "lod": "1", "boundaries": boundaries}
    return {"type": kind, "attributes": told, "geometry": [geometry]}


def _whole(footprint: Points) -> NDArray[np.int64]:
    """A footprint in whole millimetres, counter-clockwise, no corner twice."""
    rounded = np.round(ring(footprint) / SCALE).astype(np.int64)
    corners = rounded[(rounded != np.roll(rounded, 1, axis=0)).any(1)]
    return corners if signed_area(corners.astype(float)) > 0 else corners[::-1]


def _vertex(at: tuple[int, int, int], vertices: Vertices) -> int:
    return vertices.setdefault(at, len(vertices))


def _free(wish: str, taken: dict[str, Any]) -> str:
    names = (wish if k == 1 else f"{wish}-{k}" for k in range(1, len(taken) + 2))
    return next(name for name in names if name not in taken)


def _extent(whole: NDArray[np.int64], moved: tuple[float, float, float]) -> list[float]:
    if not len(whole):
        return [*moved, *moved]
    corners = np.concatenate([whole.min(0) * SCALE + moved, whole.max(0) * SCALE + moved])
    return [round(float(value), 3) for value in corners]
