"""The plots of a village: what of a block belongs to which house."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Patch, Solution
from scenewright.domains.village.blocks import BlockPlan, VillagePlan
from scenewright.domains.village.house import is_outbuilding
from scenewright.domains.village.lanes import opened
from scenewright.ground.streetside.plots import Plot, lay_plots


def plots_of_village(solution: Solution, plan: Plan) -> tuple[Plot, ...]:
    """The plots of all blocks of a solution."""
    village: VillagePlan = opened(plan, solution).detail
    return tuple(
        plot
        for block in village.blocks
        for plot in lay_block_plots(village, block, solution.pieces, solution.patches)
    )


def lay_block_plots(
    village: VillagePlan, block: BlockPlan, pieces: Sequence[Piece], patches: Sequence[Patch]
) -> tuple[Plot, ...]:
    """The plots of one block: its ground without lanes and squares, shared out among its houses."""
    houses = houses_on(block, pieces)
    if not houses:
        return ()
    shapes = polygons_of(houses)
    uses = {house.name: house.use for house in village.houses}
    serving = [
        is_outbuilding(uses.get(piece.function, ""), float(shape.area))
        for piece, shape in zip(houses, shapes, strict=True)
    ]
    kept = shapely.union_all([block.lanes, *squares_on(block, patches)])
    ground = shapely.difference(shapely.Polygon(block.outline), kept)
    names = [piece.id for piece in houses]
    return lay_plots(ground, names, shapes, np.array(serving, bool))


def houses_on(block: BlockPlan, pieces: Sequence[Piece]) -> list[Piece]:
    """The sound houses of a block."""
    here = [p for p in pieces if p.space == block.id and p.category == "building"]
    return [p for p in here if np.isfinite([*p.pose, *p.size]).all()]


def squares_on(block: BlockPlan, patches: Sequence[Patch]) -> list[shapely.Polygon]:
    """The free squares of a block."""
    here = [patch.box for patch in patches if patch.space == block.id]
    return [shapely.Polygon(corners(np.array([box]))[0]) for box in here]
