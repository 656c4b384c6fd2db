"""What buildings are used for, by the models that draw them, and how many there are of each use.

A use is one of :data:`~scenewright.core.brief.uses.USES`. The ground floor of a house with a shop
is the shop, what is above it is lived in.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from scenewright.catalog.assets.buildings.building_styles import STYLES, floors_of
from scenewright.catalog.assets.buildings.house_looks import FORMS, read_asset
from scenewright.catalog.assets.buildings.rural_houses import storeys_of_house
from scenewright.core.brief.uses import USES, UseName
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece

STOREY = 3.0
"""Metres of a storey of a model that does not tell its own."""
_STYLED: dict[str, UseName] = {
    "housing": "dwelling",
    "civic": "public",
    "sacred": "public",
    "commercial": "shop",
    "works": "works",
    "garden": "public",
}


class UseCount(NamedTuple):
    """Of a use: how many buildings, and square metres of their floors."""

    number: int
    floor: float


def use_of_asset(asset: str) -> UseName | None:
    """The use that a shipped model shows; ``None`` of a model that is not shipped.

    >>> use_of_asset("rowshop_hui_gabled"), use_of_asset("gothic_church"), use_of_asset("model:x")
    ('shop', 'public', None)
    """
    words = read_asset(asset)
    if words is not None:
        return FORMS[words[0]].use
    style = STYLES.get(asset)
    return None if style is None else _STYLED[style.use]


def count_floors(piece: Piece) -> int:
    """The storeys of a building, at least one."""
    words, style = read_asset(piece.asset), STYLES.get(piece.asset)
    if words is not None:
        return storeys_of_house(piece.size, piece.footprint, words)
    floors = floors_of(style, piece.size.height) if style else round(piece.size.height / STOREY)
    return max(floors, 1)


def count_uses(
    pieces: Iterable[Piece], known: Mapping[str, UseName] | None = None
) -> dict[UseName, UseCount]:
    """Buildings and their floor by use, those of no known use left out; ``known`` are uses of
    models that are not shipped, by function."""
    built = [p for p in pieces if p.category == "building"]
    count, floor = dict.fromkeys(USES, 0), dict.fromkeys(USES, 0.0)
    for piece, shape in zip(built, polygons_of(built) if built else (), strict=True):
        use = use_of_asset(piece.asset) or (known or {}).get(piece.function)
        if use is None:
            continue
        count[use] += 1
        floors, words = count_floors(piece), read_asset(piece.asset)
        own = 1 if use == "shop" and words is not None else floors
        floor[use] += own * float(shape.area)
        floor["dwelling"] += (floors - own) * float(shape.area)
    return {use: UseCount(count[use], round(floor[use], 1)) for use in USES if count[use]}
