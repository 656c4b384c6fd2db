"""Walks from the doors of buildings to the streets, and plots, of what stands and what is new."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import GroundSurface, Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.ground.outlines import GRID, polygons
from scenewright.ground.streetside.fences import fence_lines, list_forecourts
from scenewright.ground.streetside.plots import OUTBUILDING, Plot, lay_plots
from scenewright.ground.ways.door_walks import WalkGround, lay_long_walks, lay_walks_to_doors
from scenewright.ground.ways.lanes import corners_of_line
from scenewright.ground.works import GroundWorks, Pathway

WIDE, GATE = 1.4, 1.2
"""Metres: the width of a walk, and what a fence leaves open about it."""
HIGH, THICK = 1.0, 0.08
"""Height and thickness of a fence in metres."""
GARDENS, LOW = 260.0, 11.0
"""Square metres and metres of height of the median building of a place whose plots are fenced:
larger or higher ones stand on common ground."""


def lay_walks(plan: ExtendPlan, pieces: Sequence[Piece]) -> GroundWorks:
    """A walk from the middle of each front to a street; from outbuildings to the nearest walk too,
    so that none crosses another."""
    houses = sound_buildings(pieces)
    streets = _streets(plan)
    if not houses or streets.is_empty:
        return GroundWorks("ground")
    floor = shapely.Polygon(plan.ground.outline, plan.ground.holes)
    ground = WalkGround(floor, streets, joined=True)
    small = [p for p, shape in zip(houses, polygons_of(houses), strict=True) if _serves(shape)]
    large = [piece for piece in houses if piece not in small]
    lines = lay_walks_to_doors(ground, large, small)
    nearer = ground._replace(goals=shapely.union_all([streets, *lines]))
    lines = (*lines, *lay_walks_to_doors(nearer, small, large))
    lines = (*lines, *lay_long_walks(ground, houses, lines))
    corners = (corners_of_line(line) for line in lines)
    return GroundWorks("ground", tuple(Pathway("walk", WIDE, c) for c in corners if len(c) > 1))


def _serves(shape: shapely.Polygon) -> bool:
    return bool(shape.area < OUTBUILDING)


def sound_buildings(pieces: Sequence[Piece]) -> list[Piece]:
    """The buildings among some pieces that stand somewhere."""
    houses = [p for p in pieces if p.category == "building"]
    return [p for p in houses if np.isfinite([*p.pose, *p.size]).all()]


def plots_of_extension(solution: Solution, plan: Plan) -> tuple[Plot, ...]:
    """The plots of the buildings in all areas, shared with what stands beside them; none of it is
    street."""
    new = {piece.id for piece in sound_buildings(solution.pieces) if piece.space != OLD}
    return tuple(row for row in _lay_all_plots(solution, plan) if row.house in new)


def _lay_all_plots(solution: Solution, plan: Plan) -> tuple[Plot, ...]:
    """The plots of all buildings, old and new."""
    detail: ExtendPlan = plan.detail
    found: list[Plot] = []
    areas = [area.outline for area in detail.areas]
    old = shapely.Polygon(detail.ground.outline, detail.ground.holes)
    rest = shapely.difference(shapely.difference(old, shapely.union_all(areas)), _streets(detail))
    for name, ground in ((OLD, rest), *((area.id, area.floor) for area in detail.areas)):
        houses = [p for p in sound_buildings(solution.pieces) if p.space == name]
        if houses:
            shapes = polygons_of(houses)
            serving = np.array([_serves(shape) for shape in shapes])
            found += lay_plots(ground, [piece.id for piece in houses], shapes, serving)
    return tuple(found)


def _streets(plan: ExtendPlan) -> shapely.Geometry:
    parts = [shapely.Polygon(a.outline, a.holes) for way in plan.ground.roads for a in way.areas]
    return shapely.union_all(np.array(parts, object), grid_size=GRID)


def fence_plots(
    solution: Solution, plan: Plan, works: GroundWorks, space: str
) -> Iterator[GroundSurface]:
    """Fences about the plots, old and new, where houses of the place are small: along streets with
    gates where walks lead through, and between neighbours."""
    houses = sound_buildings(solution.pieces)
    shapes = polygons_of(houses) if houses else np.zeros(0, object)
    high = [p.size.height for p in houses]
    if not houses or np.median(shapely.area(shapes)) > GARDENS or np.median(high) > LOW:
        return
    walks = [shapely.LineString(row.line).buffer(WIDE / 2 + GATE) for row in works.pathways]
    gates, streets = shapely.union_all([*walks, *list_forecourts(houses)]), _streets(plan.detail)
    lines = fence_lines(_lay_all_plots(solution, plan), shapes, streets, gates, THICK)
    strip = shapely.buffer(shapely.union_all(lines), THICK / 2, cap_style="square")
    strip = shapely.difference(strip, shapely.union_all(shapes))
    areas = tuple(rings(part) for part in polygons(strip))
    if areas:
        yield GroundSurface("fences", space, "fence", areas, -0.01, HIGH)
