"""Trees of a village: fruit trees in the gardens, one on the square.

They are dressing, placed after the houses, clear of them, of their doors and of the walks.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.catalog.assets import shipped
from scenewright.core.catalog import Asset
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Patch
from scenewright.core.space import Points
from scenewright.domains.village.blocks import BlockPlan
from scenewright.domains.village.walks import walk_ground
from scenewright.ground.ways.door_walks import lay_walks_to_doors

GROVE = 6.0
"""Side of the squares that hold at most one tree, in metres."""
FROM_HOUSES, FROM_WALKS, FROM_BORDER, FROM_SQUARES = 3.2, 1.4, 1.6, 1.5
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
        _tree(f"{plan.id}/tree_{k}", plan.id, kinds[other % len(kinds)], at, scale, rng)
        for k, (at, scale, other) in enumerate(spots, 1)
    )


def _spots(plan: BlockPlan, houses: Sequence[Piece], rng: np.random.Generator) -> Points:
    """Points (k, 2) of a shaken grid in the gardens, denser here and there."""
    low, high = plan.outline.min(0), plan.outline.max(0)
    step = max(GROVE, math.sqrt(plan.area / (2 * MOST)))
    axes = (np.arange(a + step / 2, b, step) for a, b in zip(low, high, strict=True))
    grid = np.stack(np.meshgrid(*axes), -1).reshape(-1, 2)
    grid = grid + rng.uniform(-0.35, 0.35, grid.shape) * step
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
        (np.array(lines), FROM_WALKS),
        (lanes, FROM_WALKS),
    ):
        if len(shapes) and len(grid):
            near = shapely.STRtree(shapes).query(
                shapely.points(grid), predicate="dwithin", distance=distance
            )[0]
            grid = np.delete(grid, np.unique(near), axis=0)
    return grid


def _tree(
    name: str, block: str, asset: Asset, at: Points, scale: float, rng: np.random.Generator
) -> Piece:
    return Piece(
        id=name,
        category="tree",
        asset=asset.id,
        space=block,
        pose=Pose(float(at[0]), float(at[1]), 0.0, float(rng.uniform(-math.pi, math.pi))),
        size=Size(*(side * scale for side in asset.usual)),
        group=f"{block}/green",
        function="tree",
    )
