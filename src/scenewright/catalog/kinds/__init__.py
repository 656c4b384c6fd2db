"""The kinds of object: one row each, one file a theme, and the tables read off them.

Reach depths follow usual dimensioning guides (Neufert; Panero & Zelnik): about 0.5 m to sit or to
pass, 0.75 m before doors and drawers, 0.9 m before cooking units. Sizes follow what shops sell.

Services are measured in plan, from the outlet to the nearest point of the piece. Appliances come
with a mains lead of about 1.5 m and supply and drain hoses of about 1.5 m; a computer's lead of
1.8 m has to go down from the desk and along it. Basins and sinks are joined by hoses of 0.3 to
0.5 m and a trap, so the outlet is behind them or just beside; a toilet stands at its drain. Baths
and showers are plumbed under their tray, a metre at most to keep the fall.

Clearances in halls follow planning guides (Neufert, *Architects' Data*; Panero & Zelnik, *Human
Dimension and Interior Space*, 1979): half of an aisle of 1.2 to 1.5 m before a shelf, since two
that face each other share it; about 0.45 m of seatway in a row of seats; 0.75 to 0.9 m for those
who stop and look; nothing beside kinds that stand side by side with their like.

Other packages add kinds by the entry point ``scenewright.kinds``: ``gym = "gym.kinds:KINDS"``.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from importlib import import_module
from typing import TYPE_CHECKING, Any

from scenewright.catalog.kinds.said import said_words
from scenewright.core.kind import HallUse, Kind, Service, SizeRange, free
from scenewright.core.plugins import load_plugins

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP = "scenewright.kinds"
"""The entry points by which other packages add rows."""

_THEMES = (
    "seating",
    "tables",
    "beds",
    "storage",
    "kitchen",
    "bath",
    "appliances",
    "lighting",
    "decor",
    "small",
    "outdoor",
    "fixtures",
    "leisure",
    "exhibition",
    "shop",
    "reading",
    "auditorium",
    "reception",
    "grounds",
)


def _rows() -> Iterator[tuple[str, Kind]]:
    """Where each row is from, and the row with its words."""
    said = said_words()
    for theme in _THEMES:
        for kind in import_module(f"{__name__}.{theme}").KINDS:
            yield theme, replace(kind, words=(*kind.words, *said.get(kind.category, ())))


def _by_category() -> dict[str, Kind]:
    """All kinds; a package whose rows are no kinds, or kinds there are already, is left out."""
    found = {kind.category: kind for _, kind in _rows()}

    def check(_: EntryPoint, rows: Any) -> dict[str, Kind]:
        own = {kind.category: kind for kind in map(_check_kind, rows)}
        twice = sorted(own.keys() & found.keys())
        if twice or len(own) < len(rows):
            raise TypeError(f"adds a kind that there is already: '{(twice or list(own))[0]}'")
        found.update(own)
        return own

    for _ in load_plugins(GROUP, check):
        pass
    return found


def _check_kind(row: Any) -> Kind:
    """A row that is a kind, of the types it states."""
    if not isinstance(row, Kind):
        raise TypeError(f"adds {str(row)[:40]}, which is no Kind")
    for name in ("access", "services", "words"):
        if not isinstance(getattr(row, name), tuple):
            raise TypeError(f"adds the kind '{row.category}', whose {name} are no tuple")
    return row


KINDS: dict[str, Kind] = _by_category()
SIZES: dict[str, SizeRange] = {kind.category: kind.sizes for kind in KINDS.values() if kind.sizes}
"""Smallest, usual and largest size of every kind, in metres."""

ELSE = free("chain grid single", 0.6)
"""How halls lay out a kind whose row does not say."""


def hall_use(category: str) -> HallUse:
    """How a kind is placed in a hall; where its row says nothing, free, 0.6 m clear all around.

    >>> hall_use("gondola").clearance
    (0.7, 0.0, 0.7, 0.0)
    >>> hall_use("fountain").place
    'free'
    """
    kind = KINDS.get(category)
    return kind.hall if kind and kind.hall else ELSE


def services_of(category: str) -> tuple[Service, ...]:
    """The services of a kind; empty for an unknown category.

    >>> [service.outlet for service in services_of("dishwasher")]
    ['power', 'water']
    """
    return KINDS[category].services if category in KINDS else ()


def name_of(category: str) -> str:
    """The plain name of a kind.

    >>> name_of("tv_stand"), name_of("office_chair"), name_of("garden_gnome")
    ('TV stand', 'office chair', 'garden gnome')
    """
    return (KINDS.get(category) or Kind(category)).name
