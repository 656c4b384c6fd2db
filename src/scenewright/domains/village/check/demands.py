"""The demands of the blocks of a village against the houses on them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from scenewright.catalog.assets.buildings.house_looks import style_of_asset
from scenewright.check.buildings import is_like
from scenewright.check.owed import ALL, Owed
from scenewright.check.owed_uses import list_owed_uses
from scenewright.core.scene import Piece
from scenewright.core.solution import Patch
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.brief import VillageBlock
from scenewright.domains.village.house import House

SQUARE = "square"
SHARE = 0.97
"""The share of a square asked for that counts as all of it."""


def list_owed(
    asked: Sequence[VillageBlock],
    plan: VillagePlan,
    pieces: Sequence[Piece],
    patches: Sequence[Patch],
) -> Iterator[Owed]:
    """The houses of each block, at least one where it states no number, and its free square; all
    houses are of the library."""
    known: dict[tuple[str, str], list[House]] = {}
    for house in plan.houses:
        known.setdefault((house.name, style_of_asset(house.asset)), []).append(house)
    for block, one in zip(asked, plan.blocks, strict=True):
        here = [p for p in pieces if p.space == one.id and p.category == "building"]
        stay = {row.id for row in one.fixed}
        least = 1 if block.count is None else max(block.count, len(stay))
        most = ALL if block.count is None else least
        yield Owed(one.id, "houses", len(here), least, most, ("houses",))
        strange = sum(
            not any(
                is_like(p, h.area, h.height)
                for h in known.get((p.function, style_of_asset(p.asset)), ())
            )
            for p in here
            if p.id not in stay
        )
        yield Owed(one.id, "houses of no library", strange, 0, 0)
        yield from list_owed_uses(one.id, block.uses, here)
        if block.square is not None:
            areas = [p.box[3] * p.box[4] for p in patches if p.space == one.id]
            there = sum(area >= SHARE * block.square for area in areas)
            yield Owed(one.id, "free squares", there, 1, words=(SQUARE,))
