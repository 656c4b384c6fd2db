"""How wide furniture along walls of bathrooms, halls and stores may be, by area of the room."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, lru_cache
from math import inf
from typing import NamedTuple

from scenewright.core.catalog import Group
from scenewright.domains.home.composing.filling.beside_others import WORTH
from scenewright.domains.home.groups.bath import fitted_basins, fitted_baths, fitted_showers
from scenewright.domains.home.groups.entry import fitted_consoles, fitted_shelving, fitted_shoes
from scenewright.domains.home.groups.living import deep_bookcases, fitted_bookcases
from scenewright.domains.home.groups.sleeping import chest, fitted_wardrobes
from scenewright.domains.home.rules.every import NEAR_DOOR

SHELVED = 5.0  # what a store may cost more for a wall of shelves


class Growth(NamedTuple):
    """Forms a group may grow to; rows (area, usual, most), the smallest room first: from ``area``
    square metres on it is ``usual`` metres wide, and up to ``most`` where it then fills its stretch
    of wall; whether a way stays free before it (``walked``); what the room may cost more for it
    (``worth``), and how far it keeps off where doors open in rooms of
    :data:`~.every.ROOMY` square metres (``off``), metres."""

    forms: Callable[[], Iterator[Group]]
    rows: tuple[tuple[float, float, float], ...]
    walked: bool = False
    worth: float = WORTH
    off: float = 0.0


SHOWER = Growth(
    fitted_showers, ((0.0, 0.8, 1.05), (2.2, 0.9, 1.1), (3.5, 1.0, 1.3), (5.0, 1.2, 1.4))
)
BATH = Growth(fitted_baths, ((0.0, 1.4, 1.8), (4.0, 1.6, 1.85), (5.0, 1.7, 1.9)))
BASIN = Growth(
    fitted_basins,
    ((0.0, 0.45, 0.5), (1.6, 0.5, 0.6), (2.4, 0.6, 0.8), (4.0, 0.8, 1.0), (6.0, 1.0, 1.2)),
)
SHOES = Growth(
    fitted_shoes,
    ((0.0, 0.5, 0.7), (2.5, 0.8, 1.0), (4.0, 1.0, 1.2), (6.0, 1.2, 1.4), (9.0, 1.4, 1.8)),
    True,
)
CONSOLE = Growth(fitted_consoles, ((0.0, 1.2, 1.4), (9.0, 1.4, 1.6)), True)
CHEST = Growth(chest, ((0.0, 0.8, 1.0), (6.0, 1.0, 1.2), (9.0, 1.2, 1.2)), True)
CLOTHES = Growth(fitted_wardrobes, ((0.0, 1.0, 1.4), (9.0, 1.6, 2.0), (12.0, 1.8, 2.4)), True)
BOOKS = Growth(fitted_bookcases, ((0.0, 0.8, 1.2), (6.0, 1.2, 1.6), (9.0, 1.6, 2.4)), True)
SHELVES = Growth(fitted_shelving, ((0.0, inf, inf),), worth=SHELVED, off=NEAR_DOOR)
ROWS = Growth(deep_bookcases, ((0.0, inf, inf),), worth=SHELVED, off=NEAR_DOOR)

WET = {"shower": SHOWER, "bath": BATH, "basin": BASIN}
GROWING: dict[str, dict[str, Growth]] = {
    "bathroom": WET,
    "washroom": WET,
    "toilet": WET,
    "bedroom": {"chest": CHEST},
    "hall": {"shoes": SHOES, "console": CONSOLE, "chest": CHEST, "shelf": BOOKS},
    "storage": {"storage": SHELVES},
    "other": {"shelf": ROWS, "storage": SHELVES},
}
"""By function of a room what may grow there, in this order."""
GROWING_LAST = {"wardrobe": CLOTHES, "shelf": BOOKS}
"""What grows in rooms one lives in when all needs of a home stand."""


@cache
def list_growing(functions: tuple[str, ...]) -> dict[str, Growth]:
    """What may grow in a room for these functions; nothing where one of them is none of
    :data:`GROWING`."""
    if not functions or not GROWING.keys() >= set(functions):
        return {}
    return {name: growth for f in functions for name, growth in GROWING[f].items()}


@lru_cache(maxsize=64)
def list_depths(growth: Growth) -> tuple[tuple[float, tuple[Group, ...]], ...]:
    """The depths of a group's forms, each with its forms, the widest first."""
    forms = sorted(growth.forms(), key=lambda form: -form.width)
    depths = sorted({form.depth for form in forms})
    return tuple((deep, tuple(f for f in forms if f.depth == deep)) for deep in depths)


def bound_width(growth: Growth, area: float, stretch: float) -> float:
    """How wide a group may be in a room of ``area`` square metres on a ``stretch`` of wall, m.

    >>> bound_width(BASIN, 3.0, 0.75), bound_width(BASIN, 3.0, 1.5)
    (0.75, 0.6)
    """
    _, usual, most = next(row for row in reversed(growth.rows) if row[0] <= area)
    return stretch if stretch <= most else usual
