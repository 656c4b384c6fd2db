"""Uses in an extension: new buildings have those they are copies of, and are drawn by them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.house_looks import SHED, read_asset
from scenewright.core.brief.uses import UseName, UseWish
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.domains.extend.planting import measure_planting
from scenewright.ground.buildings.dressing import ShopGround, dress, find_party, find_shop_fronts
from scenewright.ground.buildings.use_figures import measure_uses
from scenewright.ground.buildings.use_wishes import (
    NONE,
    dress_by_wish,
    is_met,
    known_uses,
    learned_share,
    list_unmet,
    main_streets,
)
from scenewright.ground.buildings.uses import count_uses


def dress_extension(
    plan: ExtendPlan, pieces: Sequence[Piece]
) -> tuple[tuple[Piece, ...], list[LeftOut]]:
    """Old and new buildings drawn by their use and their neighbours, and what areas lack of the
    uses they ask for. Shops are as many among the new fronts at main streets as among the old."""
    named = {kind.name for kind in plan.pattern.kinds if kind.model}
    free = {p.id for p in pieces if p.function not in named and (p.space == OLD or not p.fixed)}
    uses = known_uses(pieces) | dict.fromkeys(_list_small(pieces), "outbuilding")
    old = {p.id for p in pieces if p.space == OLD}
    party = find_party(pieces)
    found, lacking = dress(pieces, uses, free & old, party), list[LeftOut]()
    ground = ShopGround(shapely.Polygon(), main_streets(plan.ground.roads))
    share = learned_share([p for p in found if p.space == OLD], ground) or 0.0
    for area in plan.areas:
        drawn = {p.id for p in found if p.space == area.id and p.id in free}
        mine, wishes = [p for p in found if p.space == area.id], area.row.uses
        told = uses | dict(_convert(mine, drawn, uses, wishes))
        found = dress_by_wish(found, told, drawn, wishes.get("shop"), ground, share, party)
        mine = [p for p in found if p.space == area.id]
        fronts = sum(map(len, find_shop_fronts(mine, ground)))
        held = {told[p.id] for p in mine if p.id in told}
        lacking += list_unmet(area.id, mine, wishes, {}, held, fronts)
    return tuple(found), lacking


def _list_small(pieces: Sequence[Piece]) -> Iterator[str]:
    """The ids of houses of ours that are too small to live in."""
    rows = [p for p in pieces if read_asset(p.asset) is not None]
    shapes = polygons_of(rows) if rows else np.zeros(0, object)
    return (p.id for p, shape in zip(rows, shapes, strict=True) if shape.area < SHED)


def _convert(
    pieces: Sequence[Piece],
    drawn: set[str],
    uses: Mapping[str, UseName],
    wishes: Mapping[UseName, UseWish],
) -> Iterator[tuple[str, UseName]]:
    """Dwellings that become what an area asks for beyond what was copied, the largest first."""
    there = count_uses(pieces) if wishes else {}
    homes = [p for p in pieces if p.id in drawn and uses.get(p.id, "dwelling") == "dwelling"]
    homes = [p for p in homes if read_asset(p.asset) is not None]
    homes.sort(key=lambda p: -p.size.width * p.size.depth)
    for use, wish in wishes.items():
        own = there.get(use, NONE)
        while use not in ("shop", "dwelling") and homes and not is_met(wish, own):
            piece = homes.pop(-1 if use == "outbuilding" else 0)
            area = float(polygons_of([piece])[0].area)
            own = own._replace(number=own.number + 1, floor=own.floor + area)
            yield piece.id, use


def measure_schemes(solution: Solution, plan: Plan) -> dict[str, dict[str, Any]]:
    """The figures of uses, trees and lamps of each area of a solution, by its id."""
    rows = {one.id: [p for p in solution.pieces if p.space == one.id] for one in plan.detail.areas}
    areas = {one.id: float(one.outline.area) for one in plan.detail.areas}
    green = measure_planting(plan.detail, solution.pieces)
    return {name: measure_uses(rows[name], areas[name]) | green[name] for name in rows}
