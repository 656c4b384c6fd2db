"""The default contents of a shop, by its kind, its floor and its walls.

Amounts follow the floor: footprints and the free depth around them together take half of it, the
rest is left to walk. Free depths of 0.6 m at both sides of an aisle give it 1.2 m, so that two
people pass (Neufert 2012, Architects' Data, shops; Panero and Zelnik 1979 give 1.3 m for the
same). Rows of a kind are listed in the order in which they get their share.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

from scenewright.core.brief.zones import AisleBrief, Demand

UTILISATION = 0.52
"""Share of the floor that footprints and clearances may take together, at most."""
WALL_SHARE = 0.45
"""Share of the walls that things may stand at; the rest is doors, windows and corners."""
LONGEST_RUN, CROSS_AISLE, RUNS = 10.0, 1.5, 8
"""Metres of goods in a row between two aisles across it, at most, how wide these are, and how many
such runs there are at least: of less goods the search makes shorter rows (measured, 2026)."""
SMALLEST_SHOP = 30.0
LARGEST_SHOP = 20_000.0
"""Square metres of floor beyond which amounts no longer grow: some 6000 objects."""

Sides = tuple[float, float, float, float]
_FRONT: Sides = (0.6, 0.0, 0.0, 0.0)
_BOTH: Sides = (0.6, 0.0, 0.6, 0.0)
_SERVED: Sides = (0.9, 0.3, 0.9, 0.3)


class Fixture(NamedTuple):
    """One row of a programme: things of one ``size`` with free depths ``clear`` (front, left,
    back, right). One for every ``each`` square metres, or, where that is 0, as many as fit in
    ``share`` of what the rows before leave. ``fills`` rows take what is left in the end. A size
    that is not ``stated`` is for counting only: tills without belts are desks
    (:mod:`..desks.cash_desks`)."""

    category: str
    size: tuple[float, float, float]
    clear: Sides
    each: float = 0.0
    share: float = 0.0
    place: Literal["wall", "free"] = "free"
    patterns: tuple[str, ...] = ()
    fills: bool = False
    required: bool = False
    name: str = ""
    stated: bool = True

    @property
    def used(self) -> float:
        """Area of footprint and clearance, in square metres."""
        front, left, back, right = self.clear
        return (self.size[0] + left + right) * (self.size[1] + front + back)


def _around(depth: float) -> Sides:
    return (depth, depth, depth, depth)


_BELT = Fixture("checkout", (2.0, 0.9, 0.95), _SERVED, each=150, required=True)
_TILL = _BELT._replace(size=(1.6, 0.7, 1.2), each=250, stated=False)
_WALL = Fixture("wall_shelving", (1.0, 0.45, 2.2), _FRONT, share=0.35, place="wall")
_GONDOLA = Fixture(
    "gondola", (1.25, 0.9, 1.5), _BOTH, share=0.6, patterns=("chain",), fills=True, required=True
)
_TABLE = Fixture("display_table", (1.4, 0.8, 0.85), _around(0.6), share=0.5, fills=True)
_BASKETS = Fixture("basket_stack", (0.45, 0.35, 0.9), _FRONT, each=400)
_COUNTER = Fixture("counter", (2.0, 0.8, 1.0), _SERVED, each=60, required=True)

PROGRAMMES: dict[str, tuple[Fixture, ...]] = {
    "clothes": (
        _TILL,
        Fixture("fitting_room", (1.1, 1.1, 2.1), (0.9, 0.0, 0.0, 0.0), each=45, place="wall"),
        _WALL._replace(share=0.25),
        Fixture(
            "clothes_rail",
            (1.5, 0.6, 1.5),
            _BOTH,
            share=0.45,
            patterns=("chain", "grid"),
            fills=True,
            required=True,
        ),
        Fixture("round_rack", (1.0, 1.0, 1.4), _around(0.6), share=0.4),
        Fixture("mannequin", (0.5, 0.5, 1.8), _around(0.4), each=35),
        _TABLE,
    ),
    "grocery": (
        _BELT,
        _BASKETS,
        Fixture("fridge_shelf", (1.25, 0.8, 2.0), (0.9, 0.0, 0.0, 0.0), share=0.15, place="wall"),
        _WALL._replace(share=0.2),
        _GONDOLA._replace(share=1.0),
    ),
    "books": (
        _TILL,
        Fixture("bookcase", (1.0, 0.35, 2.2), _FRONT, share=0.35, place="wall", required=True),
        Fixture("book_stack", (1.0, 0.6, 1.6), _BOTH, share=0.6, patterns=("chain",), fills=True),
        Fixture("lounge_seat", (0.8, 0.8, 0.8), (0.6, 0.2, 0.0, 0.2), each=120),
        _TABLE,
    ),
    "showcases": (
        _COUNTER,
        _WALL._replace(share=0.3),
        Fixture("showcase", (1.2, 0.6, 1.1), _around(0.6), share=0.7, fills=True, required=True),
        _TABLE,
    ),
    "generic": (_TILL, _WALL, _GONDOLA, _TABLE),
    "food": (
        _COUNTER._replace(each=120),
        Fixture(
            "round_table",
            (0.8, 0.8, 0.75),
            _around(0.85),
            share=0.8,
            fills=True,
            patterns=("grid", "chain"),
            required=True,
        ),
    ),
    "service": (
        _COUNTER._replace(each=25),
        Fixture("lounge_seat", (0.8, 0.8, 0.8), (0.6, 0.2, 0.0, 0.2), share=0.6, fills=True),
        Fixture("display_table", (1.2, 0.6, 0.85), _around(0.6), each=60),
    ),
    "waiting": (
        Fixture(
            "lounge_seat",
            (0.8, 0.8, 0.8),
            (0.8, 0.1, 0.3, 0.1),
            share=1.0,
            fills=True,
            patterns=("chain", "grid"),
            required=True,
        ),
    ),
    "lockers": (
        Fixture("info_desk", (1.6, 0.8, 1.0), _SERVED, each=200),
        Fixture(
            "lockers",
            (0.9, 0.55, 1.9),
            (0.9, 0.0, 0.0, 0.0),
            share=0.4,
            place="wall",
            required=True,
        ),
        Fixture(
            "lockers",
            (0.9, 0.55, 1.9),
            (0.9, 0.0, 0.0, 0.0),
            share=1.0,
            fills=True,
            patterns=("chain",),
            name="Lockers in rows",
        ),
    ),
    "library": (
        Fixture(
            "book_stack",
            (1.0, 0.6, 2.0),
            _BOTH,
            share=0.6,
            patterns=("chain",),
            fills=True,
            required=True,
        ),
        Fixture("reading_table", (1.6, 0.9, 0.75), _around(0.75), share=1.0, required=True),
    ),
}
"""The contents of each kind of unit. A row may name one category twice, at walls and in rows."""

_KINDS = {
    "clothes": "clothes shoes boutique fashion fashion_accessories bag leather outdoor sports "
    "sport tailor underwear lingerie baby_goods second_hand charity department_store",
    "grocery": "supermarket convenience grocery greengrocer deli frozen_food organic "
    "health_food general wholesale kiosk drugstore",
    "books": "books newsagent stationery comics music",
    "showcases": "jewelry jewellery watches optician mobile_phone perfumery cosmetics beauty "
    "chemist pharmacy sante hearing_aids electronics computer camera tobacco e-cigarette "
    "chocolate confectionery",
    "food": "restaurant fast_food cafe bar pub food_court ice_cream biergarten bakery coffee "
    "pastry tea juice_bar canteen",
    "service": "travel_agency car_rental bank bureau_de_change post_office ticket tickets "
    "post_pickup money_transfer money_lender hairdresser laundry dry_cleaning copyshop "
    "estate_agent insurance employment_agency locksmith",
    "waiting": "waiting waiting_room lounge",
    "lockers": "left_luggage luggage_locker lockers",
    "library": "library",
}
KIND_OF = {value: kind for kind, values in _KINDS.items() for value in values.split()}
_EMPTY = frozenset({"vacant", "no", "disused", "empty", "mall"})
_TAGS = ("shop", "amenity", "room")
_PLAIN = frozenset({"shop", "retail", "store"})


def shop_kind(tags: Mapping[str, str]) -> str:
    """The programme of a unit, by its OpenStreetMap tags; empty if it is none to be filled.

    A shop of a kind not listed is ``generic``; of several kinds in one tag the first known counts.

    >>> shop_kind({"shop": "shoes"}), shop_kind({"shop": "toys"}), shop_kind({"shop": "vacant"})
    ('clothes', 'generic', '')
    >>> shop_kind({"amenity": "cafe;bar"}), shop_kind({"room": "office"})
    ('food', '')
    """
    listed = {tag: [v.strip().lower() for v in tags.get(tag, "").split(";")] for tag in _TAGS}
    if "disused" in listed["room"] or set(listed["shop"]) & _EMPTY:
        return ""
    known = [KIND_OF[v] for tag in _TAGS for v in listed[tag] if v in KIND_OF]
    sells = bool(listed["shop"][0]) or any(v in _PLAIN for v in listed["room"])
    return known[0] if known else "generic" if sells else ""


def shop_programme(kind: str, area: float, perimeter: float) -> list[Demand]:
    """What a unit of ``kind`` with ``area`` m² of floor and ``perimeter`` m of walls is to hold.

    Footprints and clearances together take 45 to 52 per cent of the floor, down to 40 below
    60 m², where single things count. Nothing for unknown kinds and under 30 m².

    >>> [(d.category, d.count) for d in shop_programme("grocery", 100.0, 40.0)]
    [('checkout', 1), ('fridge_shelf', 3), ('wall_shelving', 7), ('gondola', 11)]
    """
    rows = PROGRAMMES.get(kind, ())
    if area < SMALLEST_SHOP or not rows:
        return []
    area = min(area, LARGEST_SHOP)
    counts = _counts(rows, UTILISATION * area, area, WALL_SHARE * perimeter)
    return [
        _demand(row, count, f"{row.category}-{i}" if row.name else row.category)
        for i, (row, count) in enumerate(zip(rows, counts, strict=True))
        if count
    ]


def _counts(rows: tuple[Fixture, ...], left: float, area: float, wall: float) -> list[int]:
    """How many of each row, in order; never more than the area ``left`` and the ``wall`` hold."""
    counts = []
    for row in rows:
        # Small numbers only for small floors: half a till is one till.
        wished = (
            max(round(area / row.each), row.required) if row.each else row.share * left / row.used
        )
        most = left / row.used
        if row.place == "wall":
            most = min(most, wall / row.size[0])
        counts.append(int(min(wished, most)))
        left -= counts[-1] * row.used
        wall -= counts[-1] * row.size[0] * (row.place == "wall")
    for i, row in enumerate(rows):
        if row.fills:
            more = int(left / row.used)
            counts[i] += more
            left -= more * row.used
    return counts


def _demand(row: Fixture, count: int, demand_id: str) -> Demand:
    broken = AisleBrief(every=max(int(LONGEST_RUN / row.size[0]), 1), width=CROSS_AISLE)
    return Demand(
        id=demand_id,
        name=row.name or row.category.replace("_", " ").capitalize(),
        category=row.category,
        count=count,
        size=row.size if row.stated else None,
        clearance=row.clear,
        place=row.place,
        patterns=list(row.patterns),
        required=row.required,
        aisle=broken if row.clear == _BOTH and count >= RUNS * broken.every else None,
    )
