"""The fixed houses of a village's brief, as pieces."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.village.blocks import BlockPlan


def given_pieces(_brief: Brief, plan: Plan, _kinds: Catalog) -> tuple[Piece, ...]:
    """The houses that stand in the blocks of a plan, by its brief alone."""
    return tuple(piece for block in plan.detail.blocks for piece in standing_pieces(block))


def standing_pieces(plan: BlockPlan) -> tuple[Piece, ...]:
    """The houses that stay where they stand."""
    return tuple(
        Piece(
            id=row.id,
            category="building",
            asset=row.asset,
            space=plan.id,
            pose=Pose(*row.box[:2], 0.0, row.box[2]),
            size=Size(row.box[3], row.box[4], row.height),
            group=f"{plan.id}/houses",
            function=row.house or "house",
            fixed=True,
            footprint=row.local,
        )
        for row in plan.fixed
    )
