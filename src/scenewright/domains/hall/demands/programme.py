"""The default contents of a shop, by its kind, its floor and its walls.

Amounts follow the floor: footprints and the free depth around them together take the usual share
of the theme (:mod:`.themes`), walls first; the rest is left to walk. Free depths of 0.6 m at both
sides of an aisle give it 1.2 m, so that two people pass (Neufert 2012, Architects' Data, shops;
Panero and Zelnik 1979 give 1.3 m for the same). Desks come first, then furniture at walls.
"""

from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

from scenewright.catalog.kinds import SIZES, hall_use
from scenewright.core.brief.zones import AisleBrief, Demand
from scenewright.domains.hall.demands.themes import THEME_OF, THEMES, USUAL_ROLES, Sides

LONGEST_RUN, CROSS_AISLE, RUNS = 10.0, 1.5, 8
"""Metres of goods in a row between two aisles across it, at most, how wide these are, and how many
such runs there are at least: of less goods the search makes shorter rows (measured, 2026)."""
WALL_BETWEEN, CASES_BETWEEN = 1.0, 0.4
"""Metres of wall between pictures (George 2015, The Curator's Handbook), and for each case of goods
beside it, with its part of the corners."""
WALLS_OF_FILL = 0.75
"""Share of what may stand on the floor that stands at walls, at most."""
SMALLEST_SHOP = 30.0
LARGEST_SHOP = 15_000.0
"""Square metres of floor beyond which amounts no longer grow: some 10,000 seats."""

AT_WALLS = {"gondola": 0.45, "book_stack": 0.35, "clothes_rail": 0.6, "showcase": 0.6}
"""How deep goods that stand free else are at a wall, in metres: what is used from both sides about
half as deep (Neufert 2012, shops)."""
WALL_FREE: Sides = (0.6, 0.0, 0.0, 0.0)
"""Free depths round goods at walls."""
_FRONT = WALL_FREE
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

    @property
    def front(self) -> float:
        """Metres of wall it takes: what asks for room at its sides stands a metre apart."""
        return self.size[0] + WALL_BETWEEN * any(self.clear[1::2])


def _around(depth: float) -> Sides:
    return (depth, depth, depth, depth)


def usual_fixture(category: str, each: float = 0.0, share: float = 0.0, **more: Any) -> Fixture:
    """A row of things as they usually are: their size, free depths and place by their kind."""
    use, size = hall_use(category), SIZES[category][1]
    row = Fixture(category, (size[0], size[1], size[2]), use.clearance, each, share, use.place)
    return row._replace(stated=False, **more)


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
        Fixture("mannequin", (0.5, 0.5, 1.8), _around(0.4), each=50),
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
        _COUNTER._replace(each=120),
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
        _COUNTER._replace(each=60),
        usual_fixture("lounge_seat", 20),
        usual_fixture("desk", share=0.6, fills=True),
        usual_fixture("bookcase", share=0.15),
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
        usual_fixture("bookcase", share=0.35),
        Fixture("reading_table", (1.6, 0.9, 0.75), _around(0.75), share=1.0, required=True),
    ),
    "museum": (
        usual_fixture("info_desk", 1000, required=True),
        usual_fixture("wall_exhibit", share=1.0, required=True),
        usual_fixture("exhibit_island", 250),
        usual_fixture("showcase", share=0.6, fills=True),
        usual_fixture("plinth", share=0.5),
        usual_fixture("bench", 120),
    ),
    "fair": (
        usual_fixture("info_desk", 1000, required=True),
        Fixture(
            "exhibit_island",
            (3.0, 3.0, 2.5),
            (2.4, 0.0, 0.0, 0.0),
            share=1.0,
            fills=True,
            required=True,
            name="Stand",
        ),
    ),
    "showroom": (
        usual_fixture("info_desk", 1000, required=True),
        usual_fixture("desk", 200),
        usual_fixture("sofa", 400),
        Fixture(
            "exhibit_island",
            (4.4, 1.8, 1.5),
            _around(1.2),
            share=1.0,
            fills=True,
            required=True,
            name="Car",
        ),
    ),
    "gate": (
        usual_fixture("counter", 250, required=True),
        usual_fixture("ticket_gate", 200, required=True),
        usual_fixture("vending_machine", 250),
        usual_fixture("auditorium_seat", share=1.0, fills=True, required=True),
    ),
    "worship": (
        Fixture("stage", (4.0, 2.5, 0.4), (1.2, 0.0, 0.0, 0.0), 3000, required=True, name="Altar"),
        usual_fixture("lectern", 3000, required=True),
        usual_fixture("pew", share=1.0, fills=True, required=True),
    ),
    "office": (
        usual_fixture("storage_shelf", share=0.6),
        usual_fixture("copier", 250),
        usual_fixture("desk", share=1.0, fills=True, required=True),
    ),
    "canteen": (
        _COUNTER._replace(each=200),
        usual_fixture("vending_machine", 300),
        usual_fixture("dining_table", share=1.0, fills=True, required=True),
    ),
}
"""The contents of each kind of unit. A row may name one category twice, at walls and in rows."""

PLAYED = frozenset(role.category for role in USUAL_ROLES)
"""What stands where its role has it."""
_EMPTY = frozenset({"vacant", "no", "disused", "empty", "mall"})
_TAGS = ("shop", "amenity", "room")
_UNMAPPED = frozenset({"museum", "fair", "gate", "worship", "office"})
"""Themes that rooms of maps do not get by their tags."""
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
    every = (THEME_OF.get(v, "") for tag in _TAGS for v in listed[tag])
    known = [theme for theme in every if theme and theme not in _UNMAPPED]
    sells = bool(listed["shop"][0]) or any(v in _PLAIN for v in listed["room"])
    return known[0] if known else "generic" if sells else ""


def shop_programme(kind: str, area: float, perimeter: float) -> list[Demand]:
    """What a unit of ``kind`` with ``area`` m² of floor and ``perimeter`` m of walls is to hold.

    Footprints and clearances together take the usual share of the floor (:data:`THEMES`), a
    little less below 60 m², where single things count. Nothing for unknown kinds and under 30 m².

    >>> [(d.category, d.count) for d in shop_programme("grocery", 100.0, 40.0)]
    [('checkout', 1), ('fridge_shelf', 8), ('wall_shelving', 16), ('gondola', 7)]
    """
    if area < SMALLEST_SHOP or kind not in PROGRAMMES:
        return []
    rows, theme, area = PROGRAMMES[kind], THEMES[kind], min(area, LARGEST_SHOP)
    counts = count_fixtures(rows, theme.fill * area, area, theme.walls * perimeter)
    return [
        demand_of(row, count, f"{row.category}-{i}" if row.name else row.category)
        for i, (row, count) in enumerate(zip(rows, counts, strict=True))
        if count
    ]


def count_fixtures(
    rows: tuple[Fixture, ...], left: float, area: float, wall: float
) -> tuple[int, ...]:
    """How many of each row a hall of ``area`` m² gets: those counted by floor area, then what
    takes a share of the ``wall``, then of the floor that is ``left``; never more than both hold."""
    at_wall = sum(row.share for row in rows if row.place == "wall")
    order = sorted(range(len(rows)), key=lambda k: (not rows[k].each, rows[k].place != "wall"))
    counts, walled, lined = [0] * len(rows), 0.0, 0.0
    for k in order:
        row, most = rows[k], left / rows[k].used
        wished = max(round(area / row.each), row.required) if row.each else row.share * most
        if row.place == "wall" and not row.each:
            walled, lined = walled or WALLS_OF_FILL * left, lined or wall
            part = row.share / at_wall
            wished = min(part * lined / row.front, part * walled / row.used)
        if row.place == "wall":
            most = min(most, wall / row.front)
        counts[k] = int(min(wished, most) + 1e-9)
        left -= counts[k] * row.used
        at = row.place == "wall" or row.category in PLAYED
        wall = max(wall - counts[k] * row.front * at, 0.0)
    for k, row in enumerate(rows):
        if row.fills:
            more = int(left / row.used)
            counts[k] += more
            left -= more * row.used
    return tuple(counts)


def demand_of(row: Fixture, count: int, demand_id: str) -> Demand:
    """A row of a programme as a demand with a count."""
    broken = AisleBrief(every=max(int(LONGEST_RUN / row.size[0]), 1), width=CROSS_AISLE)
    return Demand(
        id=demand_id,
        name=row.name or row.category.replace("_", " ").capitalize(),
        category=row.category,
        count=count,
        size=row.size if row.stated else None,
        clearance=None if row.category in PLAYED else row.clear,
        place=None if row.category in PLAYED else row.place,
        patterns=list(row.patterns),
        required=row.required,
        aisle=broken if row.clear == _BOTH and count >= RUNS * broken.every else None,
    )
