"""Screens wider than their stand, where they would bar a way of the home."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.walking.barred import find_barred
from scenewright.domains.home.walking.home_floor import HomeFloor

SCREEN = "tv"


def find_barring_screens(
    placed: Iterable[Piece],
    pieces: Sequence[Piece],
    rooms: Sequence[Space],
    floors: Sequence[HomeFloor],
    catalog: Catalog,
) -> dict[str, Piece]:
    """The screens as they were ``placed``, by their ids, where those that have grown among the
    ``pieces`` of a home bar a way over its ``floors``; none where they bar nothing."""
    narrow = {p.id: p for p in placed if p.category == SCREEN}
    if not _reach_beyond(pieces, narrow):
        return {}
    barred = find_barred(pieces, rooms, floors, catalog)
    if not barred:
        return {}
    fewer = find_barred([narrow.get(p.id, p) for p in pieces], rooms, floors, catalog)
    return narrow if len(fewer) < len(barred) else {}


def _reach_beyond(pieces: Sequence[Piece], narrow: Iterable[str]) -> bool:
    """Whether one of the screens is wider than what it stands on."""
    width, screens = {p.id: p.size.width for p in pieces}, frozenset(narrow)
    wide = (p.size.width > width.get(p.on or "", p.size.width) for p in pieces if p.id in screens)
    return any(wide)
