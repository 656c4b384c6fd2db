"""Rows for rooms one cooks and eats in."""

from __future__ import annotations

from scenewright.arranging.rows import (
    BACK,
    FLAT,
    FRONT,
    Class,
    Example,
    Place,
    Row,
    apart,
    beside,
    clear,
    keep_off,
    near,
)
from scenewright.catalog.classes import EATING_TABLES, RUN
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.measures import ALIKE, RAISED
from scenewright.domains.home.rules.classes import (
    ANYTHING,
    BY_DOORS,
    BY_GLASS,
    BY_WALLS,
    CHAIRS,
    FED,
    stand,
)
from scenewright.domains.home.rules.every import BRIGHT, DAYLIT
from scenewright.domains.home.rules.sources import DAYLIGHT, FLATS, NKBA, NKBA_17, PANERO
from scenewright.domains.home.rules.zones import APART
from scenewright.domains.home.settings import MERE_KITCHEN

AT_FRIDGE = 0.5  # what a machine beside the fridge costs of one away from all units
TOGETHER = 0.06  # pieces nearer to one another than this stand together, metres
IN_LINE = 0.3  # and if one is no farther ahead of the other, metres
WHOLE_FROM, IN_SMALL = 9.0, 0.4
"""Area in m² from which a kitchen is one whole, its fridge at its units, and how much that counts
in a smaller one."""
CUPBOARDS = frozenset(
    (
        *("bookcase", "chest_of_drawers", "coat_rack", "console_table", "desk", "shelf_unit"),
        *("shoe_cabinet", "sideboard", "storage_shelf", "tv_stand", "vanity", "wardrobe"),
    )
)
"""What is not to stand across the end of a worktop."""

_BESIDE = beside(IN_LINE, ALIKE)
_NEAR = "{of} is within {metres} m of {to}"
_OPENS = "{of} has less than {metres} m before it, for {to}"
_DRAWN = "{of} cannot be drawn back {metres} m for {to}"
_WASHER = Class("a washing machine", groups=frozenset(("washer",)), floor=True)

KITCHEN = (
    Row(
        "washer_at_fridge", _WASHER, _BESIDE,
        Class("a unit of the run", RUN - {"fridge"}, below=RAISED), TOGETHER, "loose",
        "{of} stands beside no unit but the fridge", FLATS, times=AT_FRIDGE,
    ),
    Row(
        "washer_alone", _WASHER, _BESIDE, Class("a unit", RUN, below=RAISED), TOGETHER, "loose",
        "{of} stands away from the kitchen", FLATS, times=1.0 - AT_FRIDGE,
    ),
    Row(
        "fridge_away", Class("a fridge", groups=frozenset(("fridge",)), floor=True), _BESIDE,
        Class("a unit", RUN, below=RAISED), TOGETHER, "fridge_alone",
        "{of} stands away from the units one cooks at", NKBA, area=WHOLE_FROM, tight=IN_SMALL,
    ),
    Row(
        "beside_clothes", Class("a table", groups=TABLES, floor=True), keep_off(0.0, FLAT),
        Class("a wardrobe", groups=frozenset(("wardrobe",))), APART, "beside_clothes", _NEAR,
        FLATS, only=MERE_KITCHEN, moves=False,
    ),
    Row(
        "dim_table", Class("a table", EATING_TABLES), near(DAYLIT), BY_GLASS, BRIGHT, "dim_table",
        "{of} is more than {metres} m from {to}", DAYLIGHT, only=MERE_KITCHEN, moves=False,
    ),
    Row(
        "across_run", stand("a unit", *(RUN - {"fridge"})), clear(FRONT, each=True),
        stand("a cupboard", *CUPBOARDS), 0.4, 6.0, _OPENS, NKBA, late=True,
    ),
    Row(
        "shelf_at_hob", stand("a hob", "hob_cabinet"), apart(), stand("a bookcase", "bookcase"),
        0.3, 6.0, _NEAR, NKBA_17, late=True,
        example=Example(
            broken=(Place("hob_cabinet", 1.0, 3.7, -90.0, 0.6, 0.6),
                    Place("bookcase", 1.75, 3.8, -90.0, 0.8, 0.3)),
            held=(Place("hob_cabinet", 1.0, 3.7, -90.0, 0.6, 0.6),
                  Place("bookcase", 2.1, 3.8, -90.0, 0.8, 0.3)),
            mended=(Place("hob_cabinet", 1.0, 3.7, -90.0, 0.6, 0.6),
                    Place("bookcase", 4.8, 2.0, 180.0, 0.8, 0.3)),
        ),
    ),
    Row(
        "fridge_front", stand("a fridge", "fridge"), clear(FRONT, each=True),
        stand("a cupboard or low table", *CUPBOARDS, "side_table", "coffee_table"), 0.4, 6.0,
        _OPENS, NKBA, late=True,
    ),
    Row(
        "chair_drawn", stand("a chair", *CHAIRS), clear(BACK, each=True), ANYTHING, 0.5, 5.0,
        _DRAWN, PANERO, late=True,
    ),
    Row(
        "chair_wedged", stand("a chair", *FED), clear(BACK, each=True), ANYTHING, 0.25, 10.0,
        _DRAWN, PANERO, late=True,
    ),
    Row(
        "chair_wall", stand("a chair", *CHAIRS), clear(BACK, 0.1), BY_DOORS, 0.5, 5.0, _DRAWN,
        PANERO, late=True,
    ),
    Row(
        "stool_wall", stand("a stool", "stool"), clear(BACK, 0.3), BY_DOORS, 0.55, 5.0, _DRAWN,
        PANERO, late=True,
    ),
    Row(
        "chair_at_wall", stand("a chair", *FED), clear(BACK, 0.08), BY_WALLS, 0.25, 10.0, _DRAWN,
        PANERO, late=True,
    ),
)  # fmt: skip
"""The rows."""
SECOND_AWAY = (
    Row(
        "second_away", Class("a second run", groups=frozenset(("counter",)), floor=True), _BESIDE,
        Class("a unit", RUN, below=RAISED), TOGETHER, 1.0, "{of} stands away from the first", FLATS,
    ),
)  # fmt: skip
"""What is asked before a second run is joined to the first."""
