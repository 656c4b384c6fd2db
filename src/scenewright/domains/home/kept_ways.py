"""Screens wider than their stand, where they would bar a way of the home."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import RoomTask
from scenewright.domains.home.barred import find_barred
from scenewright.domains.home.home_floor import join_floors

SCREEN = "tv"


def keep_ways(
    tasks: Sequence[RoomTask],
    placed: Sequence[Sequence[Piece]],
    grown: list[list[Piece]],
    width: float,
) -> list[list[Piece]]:
    """The pieces of each room as ``grown``, or with the screens they were ``placed`` with where
    wider ones bar a way of ``width`` metres in the home."""
    if not any(map(_reaches_beyond, grown)):
        return grown
    rooms, catalog = tuple(task.space for task in tasks), tasks[0].catalog
    floors = join_floors(rooms, width)
    barred = find_barred(list(chain(*grown)), rooms, floors, catalog)
    if not barred:
        return grown
    before = {p.id: p for p in chain(*placed) if p.category == SCREEN}
    narrow = [[before.get(p.id, p) for p in here] for here in grown]
    fewer = len(find_barred(list(chain(*narrow)), rooms, floors, catalog)) < len(barred)
    return narrow if fewer else grown


def _reaches_beyond(pieces: Sequence[Piece]) -> bool:
    """Whether a screen is wider than what it stands on."""
    width = {p.id: p.size.width for p in pieces}
    return any(
        p.category == SCREEN and p.on in width and p.size.width > width[p.on] for p in pieces
    )
