"""Houses of a saved village that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.brief import LockedHouse
from scenewright.ground.edits.locks import lock_areas
from scenewright.ground.names import assign_ids

WORDS = ("trees", "houses")
"""Things that cannot be locked, and those that can."""


def lock_village(solution: Solution) -> Brief:
    """The brief to solve again: locked houses are ``fixed`` in their block and count for what is
    asked; all others are free."""
    blocks = solution.brief.part.blocks
    names = assign_ids(blocks, "block", "blocks")
    updated = lock_areas(solution, blocks, names, _keep_house, *WORDS)
    part = solution.brief.part.model_copy(update={"blocks": updated})
    return solution.brief.model_copy(update={"part": part})


def _keep_house(piece: Piece) -> LockedHouse:
    """A house as the brief keeps it."""
    return LockedHouse(
        id=piece.id,
        house=piece.function,
        model=piece.asset,
        at=piece.pose[:2],
        heading=piece.pose.heading,
        size=(*piece.size,),
        footprint=list(piece.footprint) or None,
    )
