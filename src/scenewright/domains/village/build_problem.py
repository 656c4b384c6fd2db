"""From the plan of a block to the problem of filling it."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.blocks import BlockPlan, VillagePlan
from scenewright.domains.village.brief import HouseClass, VillageBlock
from scenewright.domains.village.composing import rim_of
from scenewright.domains.village.given import standing_pieces
from scenewright.domains.village.house import class_of_area
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.settings import VillageSettings
from scenewright.domains.village.standing import stand
from scenewright.domains.village.uses import wishes_left

PACE = 2.0
"""Metres between the places tried for a free square along the street."""
CLASSES: tuple[HouseClass, ...] = ("small", "medium", "large")


def build_problem(
    block: VillageBlock, plan: BlockPlan, village: VillagePlan, settings: VillageSettings
) -> VillageProblem:
    """The problem of filling one block."""
    style = village.style
    fixed = stand(
        [row.outline for row in plan.fixed], [class_of_area(_area(r.outline)) for r in plan.fixed]
    )
    floor = shapely.Polygon(plan.outline)
    shapely.prepare(floor)
    asked = [block.classes.get(name, 0.0) for name in CLASSES]
    given = (asked[0], asked[1], asked[2]) if sum(asked) > 0 else None
    square = find_square(block, plan)
    return VillageProblem(
        plan.id,
        floor,
        plan.streets,
        plan.street_share,
        shapely.Polygon(plan.ground.outline, plan.ground.holes),
        fixed,
        village.houses,
        block.count,
        block.coverage,
        given,
        settings,
        style,
        shapely.union(shapely.Polygon(square), plan.lanes) if square is not None else plan.lanes,
        village.nets,
        rim_of(square, plan.streets) if settings.composed else np.zeros((0, 2, 2)),
        tuple(wishes_left(block, standing_pieces(plan)).items()),
    )


def _area(outline: Points) -> float:
    return float(shapely.Polygon(outline).area)


def find_square(block: VillageBlock, plan: BlockPlan) -> Points | None:
    """The corners (4, 2) of the free square a block asks for: on a street, as near the middle of
    its longest street side as it fits; None if it asks for none or none fits."""
    if block.square is None:
        return None
    side = float(np.sqrt(block.square))
    floor = shapely.buffer(shapely.Polygon(plan.outline), 1e-3)
    taken = shapely.union_all([*(shapely.Polygon(row.outline) for row in plan.fixed), plan.lanes])
    steps = plan.streets[:, 1] - plan.streets[:, 0]
    for k in np.argsort(-np.hypot(steps[:, 0], steps[:, 1]), kind="stable"):
        start, length = plan.streets[k, 0], float(np.hypot(*steps[k]))
        way = steps[k] / length
        spots = np.arange(side / 2, length - side / 2 + 1e-9, PACE)
        for at in spots[np.argsort(np.abs(spots - length / 2), kind="stable")]:
            for left in (1.0, -1.0):
                found = _square(start + at * way, way, left, side)
                shape = shapely.Polygon(found)
                if floor.covers(shape) and not taken.intersects(shape):
                    return found
    return None


def _square(at: Points, way: Points, left: float, side: float) -> Points:
    """A square to one side of a line, counter-clockwise, just off it."""
    inward = left * np.array([-way[1], way[0]])
    near = at + 0.01 * inward
    corners = [
        near - way * side / 2,
        near + way * side / 2,
        near + way * side / 2 + inward * side,
        near - way * side / 2 + inward * side,
    ]
    return np.array(corners if left > 0 else corners[::-1])
