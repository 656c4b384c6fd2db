"""Rows for rooms of any use: what opens, stands before windows and doors, or is askew."""

from __future__ import annotations

from scenewright.arranging.rows import (
    ALONG,
    BACK,
    FLAT,
    FRONT,
    METRES,
    PIECE,
    Class,
    Example,
    Place,
    Row,
    clear,
    near,
    off,
    square_to,
)
from scenewright.catalog.classes import BEDS, DESKS, RUN, SOFAS, SOFT_SEATS
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.rules.classes import (
    ANYTHING,
    AT_DOORS,
    AT_OPENINGS,
    AT_WINDOWS,
    BY_DOORS,
    BY_GLASS,
    BY_WALLS,
    MOVED,
    ON_WAYS,
    TO_WALLS,
    stand,
)
from scenewright.domains.home.rules.sources import APPLETON, DAYLIGHT, FLATS, NEUFERT

CHESTS = ("chest_of_drawers", "sideboard")
FIRM, TALL = 1.9, 2.6
"""How much more it costs that what is built in stands before a wide door, or what is as tall."""
TALL_KINDS = frozenset(("bookcase", "fridge", "wardrobe"))
FIRMNESS = dict.fromkeys(RUN, FIRM) | dict.fromkeys(TALL_KINDS, TALL)
"""The same, by kind."""
SHADES = frozenset(
    (
        *(*SOFT_SEATS, *BEDS, "chest_of_drawers", "sideboard", "tv_stand", "bookcase", "wardrobe"),
        *("shelf_unit", "hob_cabinet"),
    )
)
"""What takes a window's light, or is not to stand in it."""
SEEN = 0.02  # less of an opening that something stands before is not seen, metres
BRIGHT, DAYLIT = 1.05, 2.1
"""Metres from a window up to which a desk is in full daylight, and from which it has hardly any: a
window lights the floor as deep as its head is high (the primary sidelighted area of ASHRAE 90.1,
2019, 3.2), by half of that well."""
ROOMY = 8.0  # area from which a bed leaves the floor at doors free, m²
NEAR_DOOR = 0.3  # a bed nearer to where a door opens is in the entrance, metres
ASKEW = 0.05  # turned by more from every wall is askew, radians

_BEFORE = off(SEEN, ALONG, each=True)
_SQUARE = (*SOFAS, *BEDS, "wardrobe", *CHESTS, "bookcase", "storage_shelf")
_OPENS = "{of} has less than {metres} m to open towards {to}"
_COVERED = "{of} stands before {to}"

EVERY = (
    Row(
        "doors", stand("a wardrobe", "wardrobe"), clear(FRONT, 0.05, within=PIECE),
        Class("something", but=MOVED, below=ON_FLOOR), 0.45, "doors", _OPENS, NEUFERT,
        fixed=True,
    ),
    Row(
        "window", stand("furniture", *SHADES), _BEFORE, AT_WINDOWS, 0.0, "window", _COVERED,
        DAYLIGHT,
    ),
    Row(
        "opening", Class("something", but=RUN | TALL_KINDS | {"rug"}, below=ON_FLOOR), _BEFORE,
        AT_OPENINGS, 0.0, "opening", _COVERED, FLATS,
    ),
    Row(
        "opening_firm", stand("a kitchen unit", *(RUN - TALL_KINDS)), _BEFORE, AT_OPENINGS, 0.0,
        "opening", _COVERED, FLATS, times=FIRM,
    ),
    Row(
        "opening_tall", stand("a tall piece", *TALL_KINDS), _BEFORE, AT_OPENINGS, 0.0, "opening",
        _COVERED, FLATS, times=TALL,
    ),
    Row(
        "at_door", stand("a bed or an armchair", *BEDS, "armchair"),
        off(SEEN / NEAR_DOOR, METRES, each=True), AT_DOORS, NEAR_DOOR, "at_door",
        "{of} is within {metres} m of {to}", FLATS, area=ROOMY,
    ),
    Row(
        "dark", stand("a desk", *DESKS), near(DAYLIT), BY_GLASS, BRIGHT, "dark",
        "{of} is more than {metres} m from {to}", DAYLIGHT,
    ),
    Row(
        "back_to_door", stand("the chair of a desk", "office_chair"), clear(BACK, each=True),
        AT_DOORS, 1.5, 2.0, "{of} has its back to {to} within {metres} m", APPLETON, late=True,
        example=Example(
            broken=(Place("office_chair", 2.5, 1.6, 90.0, 0.58, 0.58),),
            held=(Place("office_chair", 2.5, 3.2, 90.0, 0.58, 0.58),),
            mended=(Place("office_chair", 4.0, 1.6, 0.0, 0.58, 0.58),),
        ),
    ),
    Row(
        "wardrobe_front", stand("a wardrobe", "wardrobe"), clear(FRONT, each=True), ANYTHING, 0.5,
        8.0, _OPENS, NEUFERT, late=True,
    ),
    Row(
        "drawers_front", stand("a chest", *CHESTS, "tv_stand"), clear(FRONT, each=True), ANYTHING,
        0.5, 6.0, _OPENS, NEUFERT, late=True,
    ),
    Row(
        "shelves_front", stand("shelves", "shoe_cabinet", "bookcase", "storage_shelf"),
        clear(FRONT, each=True), ANYTHING, 0.4, 5.5, _OPENS, NEUFERT, late=True,
    ),
    Row(
        "wardrobe_wall", stand("a wardrobe", "wardrobe"), clear(FRONT, 0.15), BY_WALLS, 0.45, 8.0,
        _OPENS, NEUFERT, late=True,
    ),
    Row(
        "drawers_wall", stand("a chest", *CHESTS), clear(FRONT, 0.15), BY_WALLS, 0.45, 5.0, _OPENS,
        NEUFERT, late=True,
    ),
    Row(
        "storage_door", stand("storage", *CHESTS, "bookcase"), clear(FRONT, 0.6), BY_DOORS, 0.3,
        4.0, _OPENS, NEUFERT, late=True,
    ),
    Row(
        "on_way", stand("a plant or lamp", "potted_tree", "floor_lamp"), off(0.3, grade=FLAT),
        ON_WAYS, 0.0, 5.0, "{of} stands on {to}", FLATS, late=True,
    ),
    Row(
        "askew", stand("furniture", *_SQUARE), square_to(), TO_WALLS, ASKEW, 16.0,
        "{of} is askew to {to}", FLATS, late=True,
    ),
)  # fmt: skip
"""The rows."""
