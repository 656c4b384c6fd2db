"""Trees of a village: fruit trees in the gardens, one on the square.

They are dressing, placed after the houses, clear of them, of their doors and of the walks.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.catalog.assets import shipped
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.core.solution import Patch
from scenewright.core.space import Points
from scenewright.domains.village.blocks import BlockPlan
from scenewright.domains.village.walks import walk_ground
from scenewright.ground.planting.pieces import tree_piece
from scenewright.ground.planting.places import FROM_HOUSES, FROM_WAYS, drop_near, shake_grid
from scenewright.ground.ways.door_walks import lay_walks_to_doors

GROVE = 6.0
"""Side of the squares that hold at most one tree, in metres."""
FROM_BORDER, FROM_SQUARES = 1.6, 1.5
TALL = (0.42, 0.5, 0.58, 0.66)
"""Sizes of fruit trees as shares of the usual tree, few so that files can share their meshes."""
SQUARE_TREE = 0.85
MOST = 250


def plant(
    plan: BlockPlan, houses: Sequence[Piece], patches: Sequence[Patch], rng: np.random.Generator
) -> tuple[Piece, ...]:
    """The trees of a block with its houses and squares."""
    kinds = shipped().of("tree")
    squares = [shapely.Point(patch.box[0], patch.box[1]) for patch in patches]
    reach = [patch.box[3] / 2 for patch in patches]
    points = _spots(plan, houses, rng)
    for point, half in zip(squares, reach, strict=True):
        away = shapely.distance(shapely.points(points), point)
        points = points[away > half * math.sqrt(2) + FROM_SQUARES]
    points = points[rng.permutation(len(points))][:MOST]
    sizes = rng.integers(len(TALL), size=len(points))
    species = rng.random(len(points)) < 0.12
    spots = [(at, TALL[k], int(other)) for at, k, other in zip(points, sizes, species, strict=True)]
    spots += [(np.array([p.x, p.y]), SQUARE_TREE, 0) for p in squares]
    return tuple(
        tree_piece(f"{plan.id}/tree_{k}", plan.id, kinds[other % len(kinds)], at, scale, rng)
        for k, (at, scale, other) in enumerate(spots, 1)
    )


def _spots(plan: BlockPlan, houses: Sequence[Piece], rng: np.random.Generator) -> Points:
    """Points (k, 2) of a shaken grid in the gardens, denser here and there."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    step = max(GROVE, math.sqrt(plan.area / (2 * MOST)))
    grid = shake_grid(low + step / 2, high, step, rng)
    angle, shift = rng.uniform(0, 2 * math.pi, (2, 4))
    ways = np.stack([np.cos(angle), np.sin(angle)]) * 2 * math.pi / 45.0
    dense = np.cos(grid @ ways + shift).sum(1) / 2.0
    grid = grid[dense + rng.normal(0.0, 0.4, len(grid)) > 0.0]
    floor = shapely.buffer(shapely.Polygon(plan.outline), -FROM_BORDER)
    grid = grid[shapely.contains_xy(floor, grid[:, 0], grid[:, 1])]
    lines = lay_walks_to_doors(walk_ground(plan), houses)
    lanes = shapely.get_parts(plan.lanes)
    for shapes, distance in (
        (polygons_of(houses), FROM_HOUSES),
        (np.array(lines), FROM_WAYS),
        (lanes, FROM_WAYS),
    ):
        grid = drop_near(grid, shapely.STRtree(shapes), distance)
    return grid
