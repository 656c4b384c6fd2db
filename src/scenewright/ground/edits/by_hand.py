"""Buildings put in, taken away or exchanged on open ground by hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import shapely

from scenewright.arranging.give_way import Ways
from scenewright.arranging.hand_rules import HandRules
from scenewright.catalog.loading import catalog_of, find_asset
from scenewright.core.catalog import footprint_of
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import Edited
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose
from scenewright.core.solution import Solution
from scenewright.ground.edits.adjusting import GroundRules, build_around

BUILDING = "building"
TIMES = 5.0
"""Times as far as for furniture that a place for a building is looked for."""
FRONT = 2.0
"""Metres before the front of a building that stay free where it is put by hand."""


def ground_rules(solution: Solution, plan: Plan, rules: GroundRules) -> HandRules:
    """How open ground is changed by hand: building by building; one more of a kind is named as
    those that stand there, or by a model of the catalog."""
    floors = {s.id: shapely.Polygon(s.outline, [*s.holes]) for s in plan.spaces}
    catalog = catalog_of(solution.brief.catalogs)

    def make(model: str, space: str, pose: Pose) -> Piece:
        like = find_like(solution.pieces, model, space)
        name = (like.function if like else model).casefold().replace(" ", "_")
        if like is not None:
            return replace(like, id=f"{space}/{name}", space=space, pose=pose, fixed=True)
        asset = find_asset(catalog, model)
        if asset.category != BUILDING:
            raise InputError(f"'{asset.name}' is no building", "choose one")
        group = next((p.group for p in solution.pieces if p.space == space and p.group), space)
        piece = Piece(f"{space}/{name}", BUILDING, asset.id, space, pose, asset.usual, group)
        covered = footprint_of(asset, asset.usual)
        return replace(piece, function=asset.name, fixed=True, footprint=covered)

    def settle(edited: Edited) -> Solution:
        return build_around(solution, edited, rules, None, solution.seed)

    built = [p.id for p in solution.pieces if p.category == BUILDING]
    ways = Ways(
        {name: (name,) for name in built},
        lambda piece: floors[piece.space],
        through=lambda piece: piece.category != BUILDING,
        apart=rules.apart,
        front=FRONT,
        times=TIMES,
        strict=True,
    )
    return HandRules(
        rules.find, make, ways, settle, lambda p: f"{p.function} (of the {rules.noun})"
    )


def find_like(pieces: Sequence[Piece], name: str, space: str) -> Piece | None:
    """A building of a kind that is called so, of the space if there is one there."""
    wanted = name.casefold()
    found = [
        p
        for p in pieces
        if p.category == BUILDING and wanted in (p.function.casefold(), p.asset.casefold())
    ]
    return min(found, key=lambda p: (p.space != space, p.id), default=None)
