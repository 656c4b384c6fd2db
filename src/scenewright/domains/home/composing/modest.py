"""Groups that are small for their room: few seats, a short kitchen, a narrow shelf.

What a group measures is compared with what rooms of its area hold in practice. Kitchen planners ask
for 3.4 m of worktop and appliances in a kitchen below 14 m² and 4 m from there (NKBA, Planning
Guidelines, 2012, 24); a table seats two from the smallest eat-in kitchen on and four where a
household eats; storage is planned by the metre.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

from scenewright.catalog.classes import RUN, TABLE_SEATS
from scenewright.core.catalog import Group
from scenewright.domains.home.measures import RAISED

STRAIGHT_UNITS = RUN - {"corner_cabinet"}
CORNER_RUN = 1.4
"""Metres of front that a cabinet round a corner stands for."""
LOUNGE = 0.8
"""Metres of seat that the lounge of a corner sofa adds to its width."""


class Expected(NamedTuple):
    """What is measured of a group, and the least of it in rooms from an area in m² on:
    rows (area, least), the smallest room first."""

    measure: Callable[[Group], float]
    rows: tuple[tuple[float, float], ...]


def _count(*categories: str) -> Callable[[Group], float]:
    return lambda case: float(sum(m.category in categories for m in case.members))


def _metres(*categories: str) -> Callable[[Group], float]:
    return lambda case: sum(m.size.width for m in case.members if m.category in categories)


def _run(case: Group) -> float:
    low = [m for m in case.members if m.z < RAISED]
    corners = sum(m.category == "corner_cabinet" for m in low)
    return sum(m.size.width for m in low if m.category in STRAIGHT_UNITS) + CORNER_RUN * corners


def _seat(case: Group) -> float:
    corners = sum(m.category == "corner_sofa" for m in case.members)
    return _metres("sofa", "loveseat", "corner_sofa", "armchair")(case) + LOUNGE * corners


EXPECTED: dict[str, Expected] = {
    "kitchen": Expected(_run, ((7.0, 3.0), (9.0, 3.6), (14.0, 4.0), (18.0, 4.8))),
    "kitchenette": Expected(_run, ((8.0, 2.4), (10.0, 2.8), (14.0, 3.4))),
    "counter": Expected(_run, ((9.0, 1.2), (12.0, 1.6), (16.0, 2.0))),
    "dining": Expected(_count("dining_chair"), ((9.0, 4.0), (26.0, 6.0))),
    "dining_wall": Expected(
        _count("dining_chair", "stool"), ((7.0, 2.0), (10.0, 3.0), (13.0, 4.0))
    ),
    "seating": Expected(_seat, ((11.0, 1.8), (16.0, 2.0), (20.0, 2.6), (27.0, 3.2), (45.0, 4.6))),
    "media": Expected(_metres("tv_stand", "wall_shelf"), ((16.0, 1.2), (20.0, 1.4), (27.0, 1.8))),
    "lounger": Expected(_count("outdoor_chair", "side_table"), ((1.8, 2.0),)),
    "planter": Expected(_metres("planter"), ((2.5, 0.8), (5.0, 1.0))),
    "washer": Expected(_metres("washing_machine"), ((4.0, 0.6),)),
    "wardrobe": Expected(_metres("wardrobe"), ((6.0, 1.2), (8.0, 1.4), (10.0, 1.6), (13.0, 1.8))),
    "single": Expected(_metres("single_bed"), ((8.0, 0.9), (10.5, 1.2))),
    "sleeping": Expected(_metres("double_bed"), ((11.0, 1.6), (14.0, 1.8))),
    "desk": Expected(_metres("desk"), ((6.5, 1.0), (9.0, 1.2), (13.0, 1.4))),
    "kids_desk": Expected(_metres("kids_desk"), ((8.0, 1.0),)),
    "chest": Expected(_metres("chest_of_drawers"), ((9.0, 0.8), (13.0, 1.0))),
    "shelf": Expected(_metres("bookcase"), ((8.0, 0.8), (13.0, 1.2), (22.0, 1.6))),
    "sideboard": Expected(_metres("sideboard"), ((14.0, 1.4), (22.0, 1.8))),
    "storage": Expected(_metres("storage_shelf"), ((4.0, 1.0), (8.0, 1.6))),
}
"""By group."""


SEATED = ((16.0, 6), (9.0, 4))
"""Area in m² from which the table of a kitchen has that many seats, the largest room first."""


def find_few_places(case: Group, area: float) -> float:
    """How far the places at a table fall short of what a kitchen of ``area`` square metres has,
    from 0 (they do not) to 1.

    >>> from scenewright.domains.home.cases.library import cases
    >>> four = next(g for g in cases("dining").groups if g.name == "1.2 m table for 4")
    >>> find_few_places(four, 10.0), round(find_few_places(four, 18.0), 2)
    (0.0, 0.33)
    """
    asked = next((count for start, count in SEATED if area >= start), 0)
    seats = sum(m.category in TABLE_SEATS for m in case.members)
    return max(0.0, 1.0 - seats / asked) if asked else 0.0


def find_shortage(case: Group, area: float) -> float:
    """How far a case falls short of what a room of ``area`` square metres has, from 0 (it does
    not) to 1.

    >>> from scenewright.domains.home.cases.library import cases
    >>> narrow = cases("wardrobe").groups[0]
    >>> find_shortage(narrow, 5.0), round(find_shortage(narrow, 14.0), 2)
    (0.0, 0.67)
    """
    expected = EXPECTED.get(case.function)
    if expected is None:
        return 0.0
    least = max((value for start, value in expected.rows if area >= start), default=0.0)
    return max(0.0, 1.0 - _measure(case) / least - 1e-6) if least else 0.0


@lru_cache(maxsize=4096)
def _measure(case: Group) -> float:
    """How much a case has of what rooms expect of its group."""
    return EXPECTED[case.function].measure(case)
