"""Buildings of a saved extension that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD
from scenewright.domains.extend.brief import LockedGrowth
from scenewright.ground.names import assign_ids


def lock_extension(solution: Solution) -> Brief:
    """The brief to solve again: locked buildings are ``fixed`` in their area and count for what is
    asked; all others are free. What stood before stands by the brief."""
    areas = solution.brief.part.areas
    names = assign_ids(areas, "area", "areas")
    updated = []
    for area, name in zip(areas, names, strict=True):
        here = [p for p in solution.pieces if p.space == name]
        ids = {p.id for p in here}
        for piece in here:
            check_lockable(piece) if piece.fixed else None
        locked = [locked_growth(p) for p in here if p.fixed]
        unplaced = [row for row in area.fixed if row.id not in ids]
        updated.append(area.model_copy(update={"fixed": [*locked, *unplaced]}))
    part = solution.brief.part.model_copy(update={"areas": updated})
    return solution.brief.model_copy(update={"part": part})


def check_lockable(piece: Piece) -> None:
    """InputError for what cannot be locked, moved or let go."""
    if piece.space == OLD:
        raise InputError(f"'{piece.id}' stood before", 'change it in the brief, under "sources"')
    if piece.category != "building":
        raise InputError(f"'{piece.id}' cannot be locked", "lock buildings only")


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
