"""Houses of a saved village that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.brief import LockedHouse
from scenewright.ground.names import assign_ids


def lock_village(solution: Solution) -> Brief:
    """The brief to solve again: locked houses are ``fixed`` in their block and count for what is
    asked; all others are free."""
    blocks = solution.brief.part.blocks
    names = assign_ids(blocks, "block", "blocks")
    for piece in solution.pieces:
        check_lockable(piece) if piece.fixed else None
    updated = []
    for block, name in zip(blocks, names, strict=True):
        here = [p for p in solution.pieces if p.space == name]
        ids = {p.id for p in here}
        locked = [locked_house(p) for p in here if p.fixed]
        unplaced = [row for row in block.fixed if row.id not in ids]
        updated.append(block.model_copy(update={"fixed": [*locked, *unplaced]}))
    part = solution.brief.part.model_copy(update={"blocks": updated})
    return solution.brief.model_copy(update={"part": part})


def check_lockable(piece: Piece) -> None:
    """InputError for what cannot be locked: trees follow the houses."""
    if piece.category != "building":
        raise InputError(
            f"'{piece.id}' cannot be locked: trees are placed after the houses", "lock houses only"
        )


def locked_house(piece: Piece) -> LockedHouse:
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
