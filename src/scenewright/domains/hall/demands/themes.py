"""Themes of halls: how full each usually is, and what of it a brief may leave open.

Shares are of floor with the free depth around objects, and of walls without doors and windows.
Sources: shops half of the floor and most of the walls, libraries 35 to 40 per cent without aisles,
canteens 1.2 to 1.4 m² a seat, restaurants 1.4 to 1.9 (Neufert 2012, Architects' Data); exhibitions
and fairs 50 to 60 per cent net of aisles (AUMA 2016); gates 1 to 1.7 m² a passenger who sits or
stands (IATA 2019, Airport Development Reference Manual 11); pews 0.9 to 1.0 m from back to back
(Neufert 2012).
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from scenewright.core.errors import InputError
from scenewright.domains.hall.classes import ANYWHERE

Sides = tuple[float, float, float, float]
RETAIL = (
    *("gondola", "wall_shelving", "clothes_rail", "round_rack", "bookcase", "book_stack"),
    *("showcase", "display_cabinet", "fridge_shelf", "shelf_unit", "ring_shelf"),
)
"""Goods that fill shops where their number is left open."""


class Role(NamedTuple):
    """What of a ``category`` meets a door: the main entrance (``in``) or one people leave by
    (``out``). It stands ``across`` the way, ``beside`` the door at walls, ``far`` from it, or is a
    desk at which people are ``served``: between ``least`` and ``within`` metres from the door,
    looking there as far as it ``faces`` matters, near a door at the ``back`` for those who serve,
    with ``queue`` metres of free floor before it, and with the goods ``behind`` it at the wall that
    are handed over there, by words in their names."""

    category: str
    door: str
    stands: str
    within: float
    least: float = 0.0
    faces: float = 1.0
    back: float = 0.0
    queue: float = 1.5
    behind: str = ""


KEPT = "cigarette tobacco spirits zigarette tabac"
HANDED = f"bread loave bottle medicine drugs brot brötchen flasche pain bouteille {KEPT}"
"""Goods that staff hands over: at a till those that are locked away, at a counter bread too."""
USUAL_ROLES = (
    Role("ticket_gate", "out", "across", 3.0),
    Role("cash_machine", "in", "beside", 5.0, least=0.5),
    Role("ticket_machine", "in", "beside", 5.0, least=0.5),
    Role("vending_machine", "in", "beside", 12.0, least=1.5),
    Role("fitting_room", "in", "far", 1000.0),
    Role("info_desk", "in", "served", 4.0, least=2.5, faces=1.6),
    Role("checkout", "out", "served", 3.5, least=2.0, faces=1.4, behind=KEPT),
    Role("counter", "in", "served", 9.0, least=2.5, faces=2.0, back=1.0, behind=HANDED),
)
"""Where visitors ask, pay and are served: desks to ask at and to pay at are at hand beside the way
in and out, counters are seen from it and near the room behind (Neufert 2012, shops, banks,
restaurants)."""
TICKETED = (*USUAL_ROLES[:-1], Role("counter", "in", "served", 4.0, least=2.5, faces=1.6))
"""Where visitors pay to come in, the counter is where they do."""
BOARDING = (
    *USUAL_ROLES[:4],
    Role("counter", "out", "served", 3.5, faces=0.2, queue=2.0),
    Role("info_desk", "out", "served", 3.5, faces=0.2, queue=2.0),
)
"""Where one boards, desks stand beside the gate (IATA 2019)."""


Island = tuple[tuple[str, float, float], ...]
"""Kinds of an island, how far each is ahead of its middle, in metres, and turned, in degrees."""
_GOODS: Island = (("display_table", 0.0, 0.0),)
_SHELF: Island = (("gondola", 0.0, 0.0),)
_BENCHES: Island = (("bench", 0.3, 0.0), ("bench", -0.3, 180.0))
_LOUNGE: Island = (("lounge_seat", 0.45, 0.0), ("lounge_seat", -0.45, 180.0))
_GREEN: Island = (("planter", 0.0, 0.0),)


class Theme(NamedTuple):
    """A theme: the shares of its floor (``fill``) and of its ``walls`` that are usual, the
    categories (``goods``) whose numbers follow from these where a brief leaves them open, the
    ``words`` by which it is known, in names and as values of OpenStreetMap, what stands at its
    doors (``roles``), what its ``desk`` without a name is called, and the ``island`` that stands
    where its floor is left empty."""

    fill: float
    walls: float
    goods: tuple[str, ...]
    words: str
    roles: tuple[Role, ...] = USUAL_ROLES
    desk: str = ""
    island: Island = ()


THEMES: dict[str, Theme] = {
    "museum": Theme(
        *(0.45, 0.6, ("showcase", "wall_exhibit", "plinth", "exhibit_panel", "interactive_table")),
        "museum gallery exhibition",
        TICKETED,
        island=_BENCHES,
    ),
    "fair": Theme(
        *(0.6, 0.3, ("exhibit_island", "exhibit_panel"), "fair expo trade_fair", TICKETED),
        island=_BENCHES,
    ),
    "showroom": Theme(
        *(0.45, 0.3, ("exhibit_island",), "showroom car car_dealer"),
        desk="sales desk",
        island=_LOUNGE,
    ),
    "gate": Theme(
        0.42,
        0.5,
        ("auditorium_seat", "bench", "lounge_seat"),
        "gate boarding departures",
        BOARDING,
        island=_BENCHES,
    ),
    "worship": Theme(
        *(0.5, 0.4, ("pew", "bench", "auditorium_seat", "dining_chair")),
        "church chapel worship place_of_worship synagogue temple",
    ),
    "office": Theme(
        *(0.6, 0.5, ("desk", "corner_desk", "storage_shelf", "bookcase", "shelf_unit")),
        "office coworking coworking_space",
        island=_LOUNGE,
    ),
    "canteen": Theme(
        0.8, 0.5, ("dining_table", "round_table"), "canteen refectory food_court", island=_GREEN
    ),
    "library": Theme(
        0.55,
        0.6,
        ("book_stack", "bookcase", "reading_table", "carrel", "shelf_unit"),
        "library",
        island=_LOUNGE,
    ),
    "clothes": Theme(
        *(0.58, 0.75, RETAIL),
        "clothes shoes shoe boutique fashion fashion_accessories bag leather outdoor sports sport "
        "tailor underwear lingerie baby_goods second_hand charity department_store",
        island=_GOODS,
    ),
    "grocery": Theme(
        *(0.6, 0.8, RETAIL),
        "supermarket convenience grocery groceries greengrocer deli frozen_food organic "
        "health_food general wholesale kiosk drugstore",
        island=_SHELF,
    ),
    "books": Theme(
        0.58, 0.8, RETAIL, "books bookshop newsagent stationery comics music", island=_GOODS
    ),
    "showcases": Theme(
        *(0.58, 0.8, RETAIL),
        "jewelry jewellery jeweller watches optician mobile_phone perfumery cosmetics beauty "
        "chemist pharmacy sante hearing_aids electronics computer camera tobacco e-cigarette "
        "chocolate confectionery",
        island=_GOODS,
    ),
    "food": Theme(
        *(0.75, 0.5, ("round_table", "dining_table")),
        "restaurant fast_food cafe bar pub ice_cream biergarten bakery coffee pastry tea juice_bar",
        island=_GREEN,
    ),
    "service": Theme(
        *(0.45, 0.3, ("lounge_seat", "desk")),
        "bank travel_agency car_rental bureau_de_change post_office ticket tickets post_pickup "
        "money_transfer money_lender hairdresser laundry dry_cleaning copyshop estate_agent "
        "insurance employment_agency locksmith",
        desk="advice desk",
        island=_LOUNGE,
    ),
    "waiting": Theme(
        0.52, 0.5, ("lounge_seat", "bench"), "waiting waiting_room lounge", island=_LOUNGE
    ),
    "lockers": Theme(
        0.52, 0.7, ("lockers",), "left_luggage luggage_locker lockers", island=_BENCHES
    ),
    "generic": Theme(0.58, 0.75, RETAIL, "shop store retail", island=_GOODS),
}
"""By name, which is the kind of its programme too."""
LINED = frozenset(name for name, theme in THEMES.items() if "book_stack" in theme.goods)
"""Those whose goods line the walls before they stand free: shops and libraries."""
THEME_OF = {word: name for name, theme in THEMES.items() for word in theme.words.split()} | {
    name: name for name in THEMES
}


def read_theme(word: str, where: str) -> str:
    """The theme a brief states, by its name or one of its words; InputError for others.

    >>> read_theme("restaurant", ""), read_theme("Museum", "")
    ('food', 'museum')
    """
    known = THEME_OF.get(word.strip().lower().replace(" ", "_"))
    if known is None:
        remedy = f"use one of: {', '.join(THEMES)}"
        raise InputError(f"'{word}' is not a theme of halls", remedy, place=where)
    return known


def guess_theme(names: Iterable[str], categories: Iterable[str]) -> str:
    """The theme that names speak of, else the one most of whose goods are asked for; else empty.

    >>> guess_theme(["Car showroom"], []), guess_theme(["Hall 3"], ["reading_table", "book_stack"])
    ('showroom', 'library')
    >>> guess_theme(["Hall"], ["showcase"]), guess_theme(["Hall"], [])
    ('museum', '')
    """
    words = [word for name in names for word in re.findall(r"[\w-]+", name.lower())]
    spoken = [THEME_OF[word] for word in words if word in THEME_OF]
    if spoken:
        return next((theme for theme in spoken if theme != "generic"), "generic")
    asked = [one for one in categories if one not in ANYWHERE]
    found = max(THEMES, key=lambda name: sum(one in THEMES[name].goods for one in asked))
    return found if set(asked) & set(THEMES[found].goods) else ""
