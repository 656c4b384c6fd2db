"""Uses in a village: which houses are chosen for them, and how what stands is drawn by them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import shapely

from scenewright.core.brief.uses import UseName, UseWish
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.domains.village.blocks import BlockPlan, VillagePlan
from scenewright.domains.village.brief import VillageBlock
from scenewright.domains.village.house import House, is_outbuilding
from scenewright.domains.village.lanes import LAID
from scenewright.ground.buildings.dressing import ShopGround, find_shop_fronts
from scenewright.ground.buildings.use_figures import measure_uses
from scenewright.ground.buildings.use_wishes import (
    dress_by_wish,
    known_uses,
    learned_share,
    list_unmet,
    main_streets,
)
from scenewright.ground.buildings.uses import UseCount, count_uses


def use_of_house(house: House) -> UseName:
    """The use of a house of the library; an outbuilding by its size where it says nothing."""
    if is_outbuilding(house.use, house.area):
        return "outbuilding"
    return house.use or "dwelling"


def wishes_left(block: VillageBlock, standing: Sequence[Piece]) -> dict[UseName, UseWish]:
    """What a block asks of uses, less what stands in it; shops are chosen once all stand."""
    there = count_uses(standing)
    found: dict[UseName, UseWish] = {}
    for use, wish in block.uses.items():
        own = there.get(use, UseCount(0, 0.0))
        count = None if wish.count is None else max(wish.count - own.number, 0)
        floor = None if wish.floor is None else max(wish.floor - own.floor, 0.0)
        if use != "shop":
            found[use] = UseWish(count=count, floor=floor)
    return found


def meet_uses(
    houses: Sequence[House],
    chosen: Sequence[int],
    wishes: Mapping[UseName, UseWish],
    rng: np.random.Generator,
) -> list[int]:
    """Houses of the library by number with as many of each use as are wished for: one too many is
    replaced by the dwelling about as large, one that lacks replaces such a dwelling."""
    found, homes = list(chosen), [k for k, h in enumerate(houses) if _is_home(h)]
    for use, wish in wishes.items():
        rows = [k for k, house in enumerate(houses) if use_of_house(house) == use]
        own = [place for place, k in enumerate(found) if k in rows]
        if not rows:
            continue
        asked = _draw_rows(houses, rows, [found[place] for place in own], wish, rng)
        for place in own[len(asked) :][::-1]:
            if use != "dwelling" and homes:
                found[place] = min(
                    homes, key=lambda k: abs(houses[k].area - houses[found[place]].area)
                )
            else:
                del found[place]
        for number in asked[len(own) :]:
            spare = [p for p, k in enumerate(found) if k in homes and "dwelling" not in wishes]
            if use == "dwelling" or not spare:
                found.append(number)
            else:
                gap = [abs(houses[found[p]].area - houses[number].area) for p in spare]
                found[spare[int(np.argmin(gap))]] = number
    return found


def _is_home(house: House) -> bool:
    return use_of_house(house) == "dwelling" and house.share > 0


def _draw_rows(
    houses: Sequence[House],
    rows: Sequence[int],
    own: Sequence[int],
    wish: UseWish,
    rng: np.random.Generator,
) -> list[int]:
    """Houses of one use, those chosen already first: so many, or with so much floor."""
    floors = np.array([houses[k].area * houses[k].levels for k in rows])
    share = np.array([houses[k].share for k in rows])
    odds = share if share.sum() else np.ones(len(rows))
    if wish.count and wish.floor:
        odds = np.exp(-np.abs(np.log(floors * wish.count / wish.floor)) / 0.2) + 1e-9
    found: list[int] = []
    while not _enough(houses, found, wish):
        next_ = own[len(found)] if len(found) < len(own) else None
        found.append(
            rows[int(rng.choice(len(rows), p=odds / odds.sum()))] if next_ is None else next_
        )
    return found


def _enough(houses: Sequence[House], found: Sequence[int], wish: UseWish) -> bool:
    if wish.count is not None:
        return len(found) >= wish.count
    return sum(houses[k].area * houses[k].levels for k in found) >= (wish.floor or 0.0)


def dress_block(
    block: VillageBlock,
    plan: BlockPlan,
    houses: Sequence[House],
    pieces: Sequence[Piece],
    square: shapely.Geometry,
) -> tuple[list[Piece], list[LeftOut]]:
    """The houses of a block drawn by their uses, and what it lacks of those it asks for."""
    library = {house.name: use_of_house(house) for house in houses}
    drawn = {p.id for p in pieces if not p.fixed}
    uses = known_uses([p for p in pieces if p.fixed])
    uses |= {p.id: library.get(p.function, "dwelling") for p in pieces if p.id in drawn}
    given = [way for way in plan.ground.roads if LAID not in way.id]
    ground = ShopGround(square, main_streets(given))
    share = learned_share([p for p in pieces if p.fixed], ground)
    found = dress_by_wish(pieces, uses, drawn, block.uses.get("shop"), ground, share)
    fronts = sum(map(len, find_shop_fronts(found, ground)))
    held = set(library.values())
    return found, list(list_unmet(plan.id, found, block.uses, library, held, fronts))


def measure_schemes(solution: Solution, plan: Plan) -> dict[str, dict[str, Any]]:
    """The figures of uses of each block of a solution, by its id."""
    village: VillagePlan = plan.detail
    known = {house.name: use_of_house(house) for house in village.houses}
    rows = {one.id: [p for p in solution.pieces if p.space == one.id] for one in village.blocks}
    return {one.id: measure_uses(rows[one.id], one.area, known) for one in village.blocks}
