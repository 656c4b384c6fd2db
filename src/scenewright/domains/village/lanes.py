"""Lanes laid into the deep blocks of a village, before its houses are."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog.assets.buildings.house_looks import LOOKS
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.village.blocks import BlockPlan, VillagePlan
from scenewright.ground import outlines as shapes
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.plan import Area, SitePlan, Way
from scenewright.ground.ways.inner_lanes import LaidLane, area_of, edges_of, lay_inner_lanes

LAID = "/lane-"
"""In the ids of lanes that were laid."""
OVER = 7.0
"""Metres of a verge that a lane is led over to the street."""


class VillageLane(NamedTuple):
    """A lane that was laid in a ``block``."""

    block: str
    line: Points
    width: float
    head: float


def lay_village_lanes(village: VillagePlan) -> tuple[VillageLane, ...]:
    """The lanes that the blocks of a village want, off houses that stay and other lanes."""
    found = []
    for block in village.blocks:
        stay = [shapely.Polygon(row.outline) for row in block.fixed]
        taken = np.array([*stay, *shapely.get_parts(block.lanes)], object)
        floor = shapely.Polygon(block.outline)
        for lane in lay_inner_lanes(floor, block.streets, taken, LOOKS[village.look].lane):
            line = lead_out(lane, block)
            found.append(VillageLane(block.id, np.round(line, 3), lane.width, lane.head))
    return tuple(found)


def lead_out(lane: LaidLane, block: BlockPlan) -> Points:
    """The line of a lane, led over the verge onto the street where it ends on a street side."""
    ways = shapely.union_all(
        [shapely.Polygon(a.outline, a.holes) for way in block.ground.roads for a in way.areas]
    )
    line = lane.line
    for last in (False, True):
        if ways.is_empty or (last and lane.head):
            continue
        end = shapely.Point(line[-1 if last else 0])
        step = shapely.get_coordinates(shapely.shortest_line(end, ways))
        long = float(np.hypot(*(step[1] - step[0])))
        if 0.01 < long <= OVER:
            goal = step[1] + (step[1] - step[0]) / long * 0.2
            line = np.vstack([line, goal]) if last else np.vstack([goal, line])
    return line


def with_lanes(village: VillagePlan, lanes: Sequence[VillageLane]) -> VillagePlan:
    """A village with lanes in its blocks: their edges are street sides, their ground is free."""
    if not lanes:
        return village
    ways, blocks = list(village.lanes), []
    for block in village.blocks:
        own = [lane for lane in lanes if lane.block == block.id]
        made = [_way(f"{block.id}{LAID}{k}", lane) for k, lane in enumerate(own, 1)]
        ways += made
        blocks.append(_open(block, own, made) if own else block)
    return village._replace(blocks=tuple(blocks), lanes=tuple(ways))


def _way(name: str, lane: VillageLane) -> Way:
    area = area_of(LaidLane(lane.line, lane.width, lane.head))
    parts = tuple(Area(*rings(part), part.area) for part in shapes.polygons(area))
    kind = "path" if lane.width < 3.0 else "road"
    return Way(name, "", kind, lane.width, lane.line, (lane.line,), parts)


def _open(block: BlockPlan, lanes: Sequence[VillageLane], ways: Sequence[Way]) -> BlockPlan:
    floor = shapely.Polygon(block.outline)
    areas = [shapely.Polygon(a.outline, a.holes) for way in ways for a in way.areas]
    shared = shapely.intersection(shapely.union_all(areas), floor, grid_size=shapes.GRID)
    inside = shapely.union_all(np.array(shapes.polygons(shared), object))
    sides = np.concatenate([edges_of(LaidLane(row.line, row.width)) for row in lanes])
    lines = shapely.linestrings(sides)
    kept = shapely.covers(shapely.buffer(floor, 0.05), lines)
    return block._replace(
        streets=np.concatenate([block.streets, sides[kept]]),
        lanes=shapely.union(block.lanes, inside),
        ground=block.ground._replace(roads=(*block.ground.roads, *ways)),
    )


def opened(plan: Plan, solution: Solution) -> Plan:
    """The plan of a solution with the lanes that were laid for it."""
    lanes = solution.detail or ()
    return plan._replace(detail=with_lanes(plan.detail, lanes)) if lanes else plan


def list_grounds(solution: Solution, plan: Plan) -> tuple[SitePlan, ...]:
    """The grounds of the blocks of a village, with the lanes laid in them."""
    return tuple(block.ground for block in opened(plan, solution).detail.blocks)


def list_ways(solution: Solution, plan: Plan) -> list[BuiltRoad]:
    """The middle lines of the lanes of a village, those laid in its blocks too."""
    lanes = opened(plan, solution).detail.lanes
    return [BuiltRoad(way.line, way.width, way.kind, way.name) for way in lanes]
