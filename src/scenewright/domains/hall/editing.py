"""Objects put in, taken away or exchanged in a hall by hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from scenewright.arranging.hand_rules import HandRules
from scenewright.building.plan import room_ids
from scenewright.catalog.kinds import name_of
from scenewright.catalog.loading import catalog_of, find_asset
from scenewright.core.catalog import footprint_of
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import Edited
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose
from scenewright.core.solution import Solution
from scenewright.domains.hall.adjust import find_together
from scenewright.domains.hall.by_hand import make_way, ways_of, with_groups
from scenewright.domains.hall.demands.checked import ids_of

ALONE = "fixed"
"""The function of what answers no demand."""


def rules_of(solution: Solution, plan: Plan) -> HandRules:
    """How a hall is changed by hand: objects with their chairs; what is put in answers no demand
    and belongs to no group."""
    catalog = catalog_of(solution.brief.catalogs)

    def find(pieces: Sequence[Piece], name: str) -> Sequence[Piece]:
        return find_together(pieces, name)

    def make(model: str, space: str, pose: Pose) -> Piece:
        asset = find_asset(catalog, model)
        kind = catalog.kinds.get(asset.category)
        if kind is None or kind.support != "floor":
            raise InputError(f"'{asset.name}' does not stand on a floor", "choose one that does")
        name, group = f"{space}/{asset.category}", f"{space}/{ALONE}"
        piece = Piece(name, asset.category, asset.id, space, pose, asset.usual, group, ALONE)
        return replace(piece, fixed=True, footprint=footprint_of(asset, asset.usual))

    def settle(edited: Edited) -> Solution:
        made = make_way(solution, edited, plan)
        after = replace(solution, pieces=made.pieces)
        return with_groups(solution, after, catalog)

    asked = {
        (space, name): demand.name or demand.id or name_of(demand.category)
        for space, room in zip(room_ids(solution.brief), solution.brief.rooms, strict=True)
        for demand, name in zip(room.demands, ids_of(room.demands), strict=True)
    }
    return HandRules(
        find,
        make,
        ways_of(solution, plan),
        settle,
        lambda piece: asked.get((piece.space, piece.function), name_of(piece.category)),
    )
