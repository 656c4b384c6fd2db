"""Things of one kind that stand in one hall are drawn by several models: shelves, racks, exhibits
in turn; seats and tables, which stand in rows of their like, by one model a hall."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from zlib import crc32

from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Asset, Catalog
from scenewright.core.scene import Piece
from scenewright.domains.hall.furnishing.assemble import Laid

ALIKE = frozenset(
    (
        *(
            "auditorium_seat",
            "bench",
            "dining_chair",
            "office_chair",
            "bar_stool",
            "lounge_seat",
            "pew",
            "reading_chair",
            "stool",
        ),
        *("carrel", "counter", "checkout", "desk", "dining_table", "reading_table", "round_table"),
        *("lockers", "ticket_gate", "rope_barrier", "partition"),
    )
)
"""Kinds of which one model serves a whole hall."""


def vary_halls(laid: dict[int, Laid], catalog: Catalog, seed: int) -> dict[int, Laid]:
    """Halls whose things of one kind are drawn by several models."""
    return {
        k: one._replace(pieces=vary_models(one.pieces, catalog, seed)) for k, one in laid.items()
    }


def vary_models(pieces: Iterable[Piece], catalog: Catalog, seed: int) -> tuple[Piece, ...]:
    """The pieces, each drawn by one of the models that are alike the one chosen for it: of the
    same kind, sizes, style and words, over the same footprint, and in a room all of one suit. The
    first is drawn by the seed, the others follow in turn, so that ``n`` things by ``k`` models
    have no model more than ``ceil(n / k)`` times in a room."""
    told: Counter[tuple[str, ...]] = Counter()
    return tuple(_vary(piece, catalog, seed, told) for piece in pieces)


def _vary(piece: Piece, catalog: Catalog, seed: int, told: Counter[tuple[str, ...]]) -> Piece:
    kind, asset = KINDS.get(piece.category), catalog.assets.get(piece.asset)
    if asset is None or kind is None or kind.hall is None:
        return piece
    suits = suited(catalog, asset)
    names = suits[crc32(f"{seed}/{piece.space}".encode()) % len(suits)]
    if len(names) + len(suits) < 3:
        return piece
    key = (piece.space, *names)
    number = crc32(f"{seed}/{names[0]}".encode()) + told[key]
    told[key] += piece.category not in ALIKE
    chosen = catalog.assets[names[number % len(names)]]
    same = chosen.footprint(piece.size) == asset.footprint(piece.size)
    return replace(piece, asset=chosen.id) if same else piece


@cache
def suited(catalog: Catalog, asset: Asset) -> tuple[tuple[str, ...], ...]:
    """The ids of the models that may stand for one another, those of each suit by themselves, in
    the order of the suits' names.

    >>> from scenewright.catalog.assets import shipped
    >>> [names[0] for names in suited(shipped(), shipped().assets["round_rack"])]
    ['round_rack_k', 'round_rack_f', 'round_rack']
    """
    found: dict[str, list[str]] = {}
    for one in catalog.of(asset.category):
        if _traits(one) == _traits(asset):
            found.setdefault(one.suit, []).append(one.id)
    return tuple(tuple(found[suit]) for suit in sorted(found))


def _traits(asset: Asset) -> tuple[object, ...]:
    sizes = (asset.smallest, asset.usual, asset.largest)
    return (*sizes, asset.style, asset.called, asset.over, asset.author)
