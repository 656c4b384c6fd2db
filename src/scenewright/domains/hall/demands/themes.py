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


class Theme(NamedTuple):
    """A theme: the shares of its floor (``fill``) and of its ``walls`` that are usual, the
    categories (``goods``) whose numbers follow from these where a brief leaves them open, the
    ``words`` by which it is known, in names and as values of OpenStreetMap."""

    fill: float
    walls: float
    goods: tuple[str, ...]
    words: str


THEMES: dict[str, Theme] = {
    "museum": Theme(
        *(0.45, 0.6, ("showcase", "wall_exhibit", "plinth", "exhibit_panel", "interactive_table")),
        "museum gallery exhibition",
    ),
    "fair": Theme(0.6, 0.3, ("exhibit_island", "exhibit_panel"), "fair expo trade_fair"),
    "showroom": Theme(0.45, 0.3, ("exhibit_island",), "showroom car car_dealer"),
    "gate": Theme(
        0.42, 0.5, ("auditorium_seat", "bench", "lounge_seat"), "gate boarding departures"
    ),
    "worship": Theme(
        *(0.5, 0.4, ("pew", "bench", "auditorium_seat", "dining_chair")),
        "church chapel worship place_of_worship synagogue temple",
    ),
    "office": Theme(
        *(0.6, 0.5, ("desk", "corner_desk", "storage_shelf", "bookcase", "shelf_unit")),
        "office coworking coworking_space",
    ),
    "canteen": Theme(0.8, 0.5, ("dining_table", "round_table"), "canteen refectory food_court"),
    "library": Theme(
        0.55, 0.6, ("book_stack", "bookcase", "reading_table", "carrel", "shelf_unit"), "library"
    ),
    "clothes": Theme(
        *(0.58, 0.75, RETAIL),
        "clothes shoes shoe boutique fashion fashion_accessories bag leather outdoor sports sport "
        "tailor underwear lingerie baby_goods second_hand charity department_store",
    ),
    "grocery": Theme(
        *(0.6, 0.8, RETAIL),
        "supermarket convenience grocery groceries greengrocer deli frozen_food organic "
        "health_food general wholesale kiosk drugstore",
    ),
    "books": Theme(0.58, 0.8, RETAIL, "books bookshop newsagent stationery comics music"),
    "showcases": Theme(
        *(0.58, 0.8, RETAIL),
        "jewelry jewellery jeweller watches optician mobile_phone perfumery cosmetics beauty "
        "chemist pharmacy sante hearing_aids electronics computer camera tobacco e-cigarette "
        "chocolate confectionery",
    ),
    "food": Theme(
        *(0.75, 0.5, ("round_table", "dining_table")),
        "restaurant fast_food cafe bar pub ice_cream biergarten bakery coffee pastry tea juice_bar",
    ),
    "service": Theme(
        *(0.45, 0.3, ("lounge_seat", "desk")),
        "bank travel_agency car_rental bureau_de_change post_office ticket tickets post_pickup "
        "money_transfer money_lender hairdresser laundry dry_cleaning copyshop estate_agent "
        "insurance employment_agency locksmith",
    ),
    "waiting": Theme(0.52, 0.5, ("lounge_seat", "bench"), "waiting waiting_room lounge"),
    "lockers": Theme(0.52, 0.7, ("lockers",), "left_luggage luggage_locker lockers"),
    "generic": Theme(0.58, 0.75, RETAIL, "shop store retail"),
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
