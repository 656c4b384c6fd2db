"""What a brief asks of uses against what stands: what is met, and why the rest is not."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

import shapely

from scenewright.core.brief.uses import UseName, UseWish, use_words
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.ground.buildings.dressing import (
    ShopGround,
    choose_shops,
    dress,
    find_shop_fronts,
    turn_into_shop,
)
from scenewright.ground.buildings.uses import UseCount, count_uses, use_of_asset
from scenewright.ground.plan import Way

NONE = UseCount(0, 0.0)
WIDE = 0.9
"""The share of the width of the widest street that a main street has."""


def dress_by_wish(
    pieces: Sequence[Piece],
    uses: Mapping[str, UseName],
    drawn: set[str],
    wish: UseWish | None,
    ground: ShopGround,
    share: float | None = None,
    party: Collection[str] | None = None,
) -> list[Piece]:
    """The pieces in the form of their ``uses`` by id, with as many shops among the dwellings at
    squares and main streets as are wished for, or a ``share`` of these fronts; only those with an
    id in ``drawn`` change. ``party`` as in :func:`~scenewright.ground.buildings.dressing.dress`."""
    told = {name: use for name, use in uses.items() if use != "shop" or name not in drawn}
    found = dress(pieces, told, drawn, party)
    fronts = [p for p in found if p.id in drawn and told.get(p.id, "dwelling") == "dwelling"]
    square, street = find_shop_fronts(fronts, ground)
    if wish is None:
        chosen = set(choose_shops(square, street, share))
    else:
        chosen = set(_draw_shops(found, (*square, *street), wish))
    return [turn_into_shop(p) if p.id in chosen else p for p in found]


def _draw_shops(pieces: Sequence[Piece], fronts: Sequence[str], wish: UseWish) -> Iterator[str]:
    """So many of the houses by id that shops meet a wish, with those that there are."""
    there, known = count_uses(pieces).get("shop", NONE), {piece.id: piece for piece in pieces}
    for name in fronts:
        if is_met(wish, there):
            return
        yield name
        own = count_uses([turn_into_shop(known[name])])["shop"]
        there = UseCount(there.number + 1, there.floor + own.floor)


def is_met(wish: UseWish, there: UseCount) -> bool:
    """Whether a wish is met by what is there.

    >>> is_met(UseWish(count=2), UseCount(2, 90.0)), is_met(UseWish(floor=100.0), NONE)
    (True, False)
    """
    if wish.count is not None:
        return there.number >= wish.count
    return there.floor >= (wish.floor or 0.0)


def list_unmet(
    space: str,
    pieces: Sequence[Piece],
    wishes: Mapping[UseName, UseWish],
    known: Mapping[str, UseName],
    held: set[UseName],
    fronts: int,
) -> Iterator[LeftOut]:
    """What a space lacks of the wishes, with the reason: the library has no such house (``held``
    are the uses it has), too few ``fronts`` at squares and main streets, or no place is left."""
    there = count_uses(pieces, known) if wishes else {}
    for use, wish in wishes.items():
        own = there.get(use, NONE)
        if is_met(wish, own):
            continue
        if wish.count is not None:
            what = f"{wish.count - own.number} of {wish.count} {use_words(use, wish.count)}"
        else:
            asked = round(wish.floor or 0.0)
            what = f"{asked - round(own.floor)} of {asked} m² of {use_words(use, 2)}"
        yield LeftOut(space, what, _reason(use, held, fronts), True)


def _reason(use: UseName, held: set[UseName], fronts: int) -> str:
    if use == "shop":
        return f"houses that look at a square or main street: {fronts}"
    if use not in held:
        return "none of the houses to choose from is one"
    return "no more place for one that a way from the street leads to"


def known_uses(pieces: Sequence[Piece]) -> dict[str, UseName]:
    """The uses that the models of some pieces show, by id."""
    shown = {piece.id: use_of_asset(piece.asset) for piece in pieces}
    return {name: use for name, use in shown.items() if use is not None}


def main_streets(ways: Sequence[Way]) -> shapely.Geometry:
    """The ground of the widest streets."""
    roads = [way for way in ways if way.kind == "road"]
    widest = max((way.width for way in roads), default=0.0)
    areas = [a for way in roads if way.width >= WIDE * widest for a in way.areas]
    return shapely.union_all([shapely.Polygon(a.outline, a.holes) for a in areas])


def learned_share(standing: Sequence[Piece], ground: ShopGround) -> float | None:
    """The share of the standing houses at squares and main streets that have a shop, where any
    has; ``None`` where nothing is learned of them."""
    shown = known_uses(standing)
    fronts = [name for row in find_shop_fronts(standing, ground) for name in row]
    own = sum(shown.get(name) == "shop" for name in fronts)
    return own / len(fronts) if own else None
