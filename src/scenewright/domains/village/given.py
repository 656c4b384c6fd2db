"""The fixed houses of a village's brief, as pieces."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.domains.village.blocks import BlockPlan
from scenewright.ground.edits.locks import standing_piece


def given_pieces(_brief: Brief, plan: Plan, _kinds: Catalog) -> tuple[Piece, ...]:
    """The houses that stand in the blocks of a plan, by its brief alone."""
    return tuple(piece for block in plan.detail.blocks for piece in standing_pieces(block))


def standing_pieces(plan: BlockPlan) -> tuple[Piece, ...]:
    """The houses that stay where they stand."""
    return tuple(
        standing_piece(row, plan.id, row.asset, row.house or "house", "houses")
        for row in plan.fixed
    )
