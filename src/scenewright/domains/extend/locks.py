"""Buildings of a saved extension that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.brief import LockedGrowth
from scenewright.ground.edits.locks import lock_areas
from scenewright.ground.names import assign_ids

WORDS = ("roads", "buildings")
"""Things that cannot be locked, and those that can."""


def lock_extension(solution: Solution) -> Brief:
    """The brief to solve again: locked buildings are ``fixed`` in their area and count for what is
    asked; all others are free. What stood before stands by the brief."""
    areas = solution.brief.part.areas
    names = assign_ids(areas, "area", "areas")
    updated = lock_areas(solution, areas, names, locked_growth, *WORDS)
    part = solution.brief.part.model_copy(update={"areas": updated})
    return solution.brief.model_copy(update={"part": part})


def locked_growth(piece: Piece) -> LockedGrowth:
    """A building as the brief keeps it."""
    return LockedGrowth(
        id=piece.id,
        kind=piece.function,
        model=piece.asset,
        at=piece.pose[:2],
        heading=piece.pose.heading,
        size=(*piece.size,),
        footprint=list(piece.footprint) or None,
    )
