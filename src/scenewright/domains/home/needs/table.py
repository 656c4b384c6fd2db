"""What a household needs of a home, one row a need: how much, of which rooms, and after whom."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import floor
from typing import NamedTuple

from scenewright.catalog.classes import DESKS, WORKTOP
from scenewright.core.scene import Piece
from scenewright.domains.home.groups.classes import (
    BED_GROUPS,
    COOKING,
    DESK_GROUPS,
    SLEPT_IN,
    TABLES,
    UNITS,
    WET_ROOMS,
)
from scenewright.domains.home.needs.counting import (
    count_eaters,
    count_kinds,
    count_sleepers,
    count_soft_places,
    measure_widths,
)

SEAT_FROM, SEAT_EACH, MOST_SOFT = 20.0, 14.0, 5
"""Floor of a home in m² from which it owes a soft seat, floor for each further one, and the most
it owes."""
RAIL = 0.75
"""Metres of hanging rail that one person's clothes take."""
PREPARED, SERVED = 0.9, 0.15
"""Metres of worktop to prepare a meal at, and for each who eats beside two."""
SHELF = 0.4
"""Metres of shelves for one person's things."""
CENSUS = "six designers' homes (bench census)"
"""Homes counted for what they hold of each need."""
WORK_FROM, WASH_FROM = 45.0, 27.0
"""Floor in m² from which a home owes a place to work, and a washing machine."""


class Residence(NamedTuple):
    """A home as its needs see it: how many live in it, its floor in m² without balconies, and the
    functions of all its rooms."""

    people: int
    floor: float
    uses: frozenset[str]


class Need(NamedTuple):
    """One need: its name as people say it and its ``unit``; how much a home owes (0: not this
    one); how much of it pieces of a room ``serve``, and the ``groups`` that bring them; the
    functions of the rooms that owe it, the more fitting first; the ``source``."""

    name: str
    unit: str
    owed: Callable[[Residence], float]
    serve: Callable[[Sequence[Piece]], float]
    groups: frozenset[str]
    rooms: tuple[frozenset[str], ...]
    source: str


def count_soft_seats(home: Residence) -> int:
    """Soft seats a home owes.

    >>> [count_soft_seats(Residence(4, area, frozenset())) for area in (18.0, 20.0, 40.0, 90.0)]
    [0, 1, 2, 4]
    """
    if home.floor < SEAT_FROM:
        return 0
    return min(home.people, MOST_SOFT, max(floor(home.floor / SEAT_EACH), 1))


def _of_kitchens(amount: Callable[[Residence], float]) -> Callable[[Residence], float]:
    """What a home owes if it has a kitchen."""
    return lambda home: amount(home) if "kitchen" in home.uses else 0.0


def _of_bathrooms(home: Residence) -> float:
    return float(bool({"bathroom", "washroom"} & home.uses))


def _measure_worktop(home: Residence) -> float:
    return PREPARED + SERVED * max(home.people - 2, 0)


def _wash_clothes(home: Residence) -> float:
    return float(home.floor >= WASH_FROM and bool(home.uses & (WET_ROOMS | {"kitchen"})))


_COOK, _DAY, _NIGHT = frozenset(("kitchen",)), frozenset(("living", "dining")), SLEPT_IN
_WET = WET_ROOMS - {"toilet"}

NEEDS: tuple[Need, ...] = (
    Need(
        "beds",
        "",
        lambda home: float(home.people),
        count_sleepers,
        frozenset(BED_GROUPS),
        (_NIGHT,),
        "a bed for each who lives in a home (DIN 18011: bedrooms for one and for two)",
    ),
    Need(
        "places to eat",
        "",
        lambda home: float(home.people),
        count_eaters,
        TABLES,
        (_DAY | _COOK, frozenset(("hall",)), _NIGHT | {"study"}),
        "0.6 m of a table's edge for each who eats (NKBA, Kitchen Planning Guidelines, 9; Neufert)",
    ),
    Need(
        "soft seats",
        "",
        lambda home: float(count_soft_seats(home)),
        count_soft_places,
        frozenset(("seating", "reading")),
        (frozenset(("living",)), _NIGHT | {"study", "dining"}, _COOK | {"hall"}),
        "our own: one from 20 m² of floor on, one for each 14 m² up to one for each resident; four "
        f"of {CENSUS} hold as many",
    ),
    Need(
        "place to work",
        "",
        lambda home: float("study" in home.uses or home.floor >= WORK_FROM),
        count_kinds(DESKS),
        DESK_GROUPS | {"corner_desk"},
        (frozenset(("study",)), _NIGHT, _DAY),
        f"our own: one in a home with a study, or from 45 m² of floor on; none of {CENSUS} has one",
    ),
    Need(
        "toilet",
        "",
        lambda home: float(bool(home.uses & WET_ROOMS)),
        count_kinds(("toilet",)),
        frozenset(("toilet",)),
        (WET_ROOMS,),
        "DIN 18040-2: toilet, basin and bath or shower in every dwelling",
    ),
    Need(
        "basin",
        "",
        lambda home: float(bool(home.uses & WET_ROOMS)),
        count_kinds(("basin", "pedestal_basin")),
        frozenset(("basin",)),
        (_WET, WET_ROOMS),
        "DIN 18040-2: toilet, basin and bath or shower in every dwelling",
    ),
    Need(
        "bath or shower",
        "",
        _of_bathrooms,
        count_kinds(("bathtub", "shower", "wall_shower")),
        frozenset(("bath", "shower")),
        (_WET,),
        "DIN 18040-2: toilet, basin and bath or shower in every dwelling",
    ),
    Need(
        "clothes",
        "m of rail",
        lambda home: RAIL * home.people,
        measure_widths(("wardrobe",)),
        frozenset(("wardrobe", "chest")),
        (_NIGHT, frozenset(("hall", "storage", "living"))),
        f"5 ft of rod for two (HUD, Minimum Property Standards for Housing); five of {CENSUS}",
    ),
    Need(
        "shelves",
        "m",
        lambda home: SHELF * home.people,
        measure_widths(("bookcase", "shelf_unit", "storage_shelf", "sideboard")),
        frozenset(("shelf", "storage", "sideboard")),
        (frozenset(("living", "study", "storage")), _NIGHT),
        f"0.4 m for each resident, the least of {CENSUS}",
    ),
    Need(
        "worktop",
        "m",
        _of_kitchens(_measure_worktop),
        measure_widths(WORKTOP),
        UNITS | {"island"},
        (_COOK,),
        "36 in to prepare at (NKBA, Kitchen Planning Guidelines, 12); for more than two our own",
    ),
    Need(
        "hob",
        "",
        _of_kitchens(lambda _: 1.0),
        count_kinds(("hob_cabinet",)),
        UNITS,
        (_COOK,),
        "EN 1116: worktop, sink and hob in every kitchen",
    ),
    Need(
        "fridge",
        "",
        _of_kitchens(lambda _: 1.0),
        count_kinds(("fridge",)),
        COOKING,
        (_COOK,),
        "NKBA, Kitchen Planning Guidelines, 16: one with a landing beside it",
    ),
    Need(
        "washing machine",
        "",
        _wash_clothes,
        count_kinds(("washing_machine",)),
        frozenset(("washer",)),
        (_WET, _COOK),
        f"each of {CENSUS}, from 27 m² of floor on",
    ),
)
"""The needs of a home, what one cannot live without first."""
