"""Desks of a class or a training stand in rows before what is shown to it: who sits at them looks
at it, not their backs."""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.core.catalog import Catalog
from scenewright.domains.hall.classes import SHOWS
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.desks.chairs import ADVISING, DESK_CHAIRS
from scenewright.domains.hall.seats.seating import find_show, with_chair

CLASS = 6
"""From how many desks on a demand is a class, where nothing is said of what they look at."""


def turn_to_show(wishes: list[HallDemand], catalog: Catalog) -> list[HallDemand]:
    """Demands in which desks with chairs of their own are laid out with these and turned, where
    they are to look at a stage, a screen or a lectern, or are many in a zone that has one."""
    asked = {wish.category for wish in wishes}
    return [_turn(wish, wishes, asked, catalog) for wish in wishes]


def _turn(
    wish: HallDemand, wishes: list[HallDemand], asked: set[str], catalog: Catalog
) -> HallDemand:
    deep = max((d for chair, d in _list_chairs(wish, catalog) if chair not in asked), default=0.0)
    shown = _find_shown(wish, wishes)
    return with_chair(wish, deep, shown) if deep and shown and not wish.seated else wish


def _list_chairs(wish: HallDemand, catalog: Catalog) -> Iterator[tuple[str, float]]:
    """The chairs that come with desks, before their fronts, and how deep they are."""
    for row in DESK_CHAIRS:
        if row.front and row.category == wish.category:
            yield row.chair, catalog.of(row.chair)[0].usual[1]


def _find_shown(wish: HallDemand, wishes: list[HallDemand]) -> str:
    """The id of what desks look at; empty where they are for advice or for work of their own."""
    shows = {other.id for other in wishes if other.category in SHOWS}
    advising = any(word in f"{wish.id} {wish.name}".casefold() for word in ADVISING)
    if wish.facing or advising or wish.at_wall:
        return wish.facing if wish.facing in shows else ""
    return find_show(wish, wishes) if wish.unstated and len(wish.sizes) >= CLASS else ""
