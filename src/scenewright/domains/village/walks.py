"""Walks of a block, from its streets and lanes to the doors of its houses."""

from __future__ import annotations

import shapely

from scenewright.domains.village.blocks import BlockPlan
from scenewright.ground.ways.door_walks import WalkGround


def walk_ground(plan: BlockPlan) -> WalkGround:
    """Where walks of a block may lie, and the street sides and lanes that they lead to."""
    streets = shapely.union_all(shapely.linestrings(plan.streets))
    if not plan.lanes.is_empty:
        streets = shapely.union(streets, shapely.boundary(plan.lanes))
    return WalkGround(shapely.Polygon(plan.ground.outline, plan.ground.holes), streets)
