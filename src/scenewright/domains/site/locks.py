"""Buildings of a saved site that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import LockedBuilding
from scenewright.ground.names import assign_ids

LANDMARK = "landmark"


def lock_sites(solution: Solution) -> Brief:
    """The brief to solve again: locked buildings are ``fixed`` on their site and count for what
    is asked; all others are free. Landmarks stand by the brief, locked or not."""
    sites = solution.brief.part.sites
    names = assign_ids(sites, "site", "sites")
    for piece in solution.pieces:
        check_lockable(piece) if piece.fixed else None
    updated = []
    for site, name in zip(sites, names, strict=True):
        here = [p for p in solution.pieces if p.space == name]
        ids = {p.id for p in here}
        locked = [locked_building(p) for p in here if p.fixed and p.function != LANDMARK]
        unplaced = [row for row in site.fixed if row.id not in ids]
        updated.append(site.model_copy(update={"fixed": [*locked, *unplaced]}))
    part = solution.brief.part.model_copy(update={"sites": updated})
    return solution.brief.model_copy(update={"part": part})


def check_lockable(piece: Piece) -> None:
    """InputError for what cannot be locked: trees and lamps follow the buildings."""
    if piece.category != "building":
        raise InputError(
            f"'{piece.id}' cannot be locked: trees and lamps are placed after the buildings",
            "lock buildings only",
        )


def locked_building(piece: Piece) -> LockedBuilding:
    """A building as the brief keeps it."""
    return LockedBuilding(
        id=piece.id,
        name=piece.function,
        model=piece.asset,
        at=piece.pose[:2],
        heading=piece.pose.heading,
        size=(*piece.size,),
        footprint=list(piece.footprint) or None,
    )
