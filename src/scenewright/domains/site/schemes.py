"""Figures of a scheme: floor by use, dwellings by size, bays, green ground and trees.

A storey of flats is shared among dwellings of about :data:`FLAT` square metres; terraces have one
for every :data:`TERRACE` metres of front; other houses are one each. The net floor of a dwelling is
:data:`NET` of its gross floor, and a person lives on :data:`PERSON` square metres of it (mean of
Germany, Destatis 2021).
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.building_styles import STYLES, floors_of
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.site.works import works_of
from scenewright.ground.plan import SitePlan
from scenewright.ground.works import GREEN, GroundWorks

FLAT, TERRACE, NET, PERSON = 95.0, 6.0, 0.8, 47.0
"""Square metres of gross floor of a flat, metres of front of a terraced house, net of gross floor,
and net square metres a person."""
FLATS, TERRACES = ("modern_residential", "point_tower"), ("row_houses",)
STOREY = 3.0
"""Metres a storey of own models."""
SIZES = ((60.0, "to 60 m²"), (100.0, "60-100 m²"), (150.0, "100-150 m²"), (np.inf, "over 150 m²"))
"""Classes of the net floor of a dwelling."""


def measure_schemes(solution: Solution, plan: Plan) -> dict[str, dict[str, Any]]:
    """The figures of the scheme of each site of a solution, by its id."""
    return {
        site.id: measure_scheme(site, [p for p in solution.pieces if p.space == site.id], works)
        for site, works in zip(plan.detail, works_of(solution, plan.detail), strict=True)
    }


def measure_scheme(site: SitePlan, pieces: Sequence[Piece], works: GroundWorks) -> dict[str, Any]:
    """The figures of one site from its ``pieces`` and the ``works`` between them; floor and
    dwellings without those of landmarks."""
    marks = {name for row in site.landmarks for name in (row.id, f"{site.id}/{row.id}")}
    built = [p for p in pieces if p.category == "building" and p.id not in marks]
    areas = [float(shape.area) for shape in polygons_of(built)]
    by_use: dict[str, float] = defaultdict(float)
    sizes: list[float] = []
    for piece, area in zip(built, areas, strict=True):
        style = STYLES.get(piece.asset)
        floors = floors_of(style, piece.size.height) if style else round(piece.size.height / STOREY)
        by_use[style.use if style else "other"] += area * max(floors, 1)
        if style and style.use == "housing":
            sizes += list_dwellings(piece, area, max(floors, 1))
    people = sum(sizes) / PERSON
    bays = sum(row.bays for row in works.areas if row.kind == "parking")
    green = measure_green(site, built, works)
    return {
        "floor_by_use": {use: round(by_use[use], 1) for use in sorted(by_use)},
        "dwellings": len(sizes),
        "dwellings_by_size": count_sizes(sizes),
        "bays_per_dwelling": round(bays / len(sizes), 3) if sizes else None,
        "green": round(green, 1),
        "green_per_person": round(green / people, 1) if people else None,
        "trees": sum(piece.category == "tree" for piece in pieces),
    }


def list_dwellings(piece: Piece, storey: float, floors: int) -> list[float]:
    """The net floor of each dwelling of a building of housing, in square metres, from the ground of
    a ``storey`` and its ``floors``."""
    if piece.asset in FLATS:
        on_each = max(round(storey / FLAT), 1)
        return [NET * storey / on_each] * (on_each * floors)
    count = max(round(piece.size.width / TERRACE), 1) if piece.asset in TERRACES else 1
    return [NET * storey * floors / count] * count


def count_sizes(sizes: Sequence[float]) -> dict[str, int]:
    """Dwellings by class of size.

    >>> count_sizes([55.0, 80.0, 90.0])
    {'to 60 m²': 1, '60-100 m²': 2}
    """
    counted = Counter(next(name for most, name in SIZES if size <= most) for size in sizes)
    return {name: counted[name] for _, name in SIZES if counted[name]}


def measure_green(site: SitePlan, built: Sequence[Piece], works: GroundWorks) -> float:
    """Square metres that are neither built on nor paved; courts and parks count."""
    paths = [
        shapely.buffer(shapely.LineString(row.line), 0.5 * row.width) for row in works.pathways
    ]
    paved = [shapely.Polygon(row.outline) for row in works.areas if row.kind not in GREEN]
    streets = [shapely.Polygon(a.outline, a.holes) for way in site.roads for a in way.areas]
    marks = [shapely.Polygon(row.footprint) for row in site.landmarks]
    taken = shapely.union_all([*polygons_of(list(built)), *streets, *paths, *paved, *marks])
    return float(shapely.difference(shapely.Polygon(site.outline, site.holes), taken).area)
