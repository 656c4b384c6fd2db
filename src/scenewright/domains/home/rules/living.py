"""Rows for rooms one sits in."""

from __future__ import annotations

from scenewright.arranging.rows import (
    ANY,
    FRONT,
    WALLS,
    Class,
    Example,
    Place,
    Row,
    clear,
    keep_off,
    no_back,
)
from scenewright.catalog.classes import SOFAS, SOFT_SEATS
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.rules.classes import ANYTHING, AT_WINDOWS, BY_WALLS, stand
from scenewright.domains.home.rules.sources import DGUV, FLATS, PANERO

AHEAD, WIDE = 1.2, 0.8
"""The floor before the middle of a sofa that it looks over, metres: a low table and those who pass
have room there."""
FEET, ARM = 0.45, 0.2  # room for feet before seats, and for arms beside them, metres
SEAT = 0.95  # how deep the seats of a sofa are, the long one of a corner sofa apart, metres
SEEN, FELT = 0.12, 0.05  # shares of that and of the floor for feet that are not noticed
BESIDE_TABLE = 0.2  # a seat nearer than this to where one sits at a table crowds it, metres
BEHIND = 4.0  # what it costs that an armchair looks at a back right before it
UNSEEN = 0.02  # floor too little to be seen, square metres

_SOFA, _ARMCHAIR = stand("a sofa", *SOFAS), stand("an armchair", "armchair")
_AT_SIGHT = Class(
    "something",
    but=frozenset(("rug",)),
    outside=frozenset(("seating", "reading", "media", "plant")),
    below=ON_FLOOR,
    parts=WALLS,
)
_LOOKS = "{of} looks at {to} within {metres} m"

LIVING = (
    Row(
        "outlook", Class("a sofa", SOFAS), clear(FRONT, SEEN, within=ANY, wide=WIDE, start=SEAT),
        _AT_SIGHT, AHEAD, "outlook", _LOOKS, PANERO, moves=False,
    ),
    Row(
        "feet", Class("a sofa", SOFAS), clear(FRONT, FELT, within=ANY, inset=ARM), _AT_SIGHT, FEET,
        "outlook", _LOOKS, PANERO, joined=True, moves=False,
    ),
    Row(
        "crowded", Class("a table to eat at", groups=TABLES, floor=True),
        keep_off(UNSEEN, each=True), Class("a sofa or armchair", SOFT_SEATS), BESIDE_TABLE,
        "crowded", "{of} has {to} within {metres} m", FLATS,
    ),
    Row(
        "armchair_front", _ARMCHAIR, clear(FRONT, each=True), ANYTHING, 0.4, 5.0, _LOOKS, PANERO,
        late=True,
    ),
    Row(
        "back_before", _ARMCHAIR, no_back(FRONT, 0.5, 0.5, UNSEEN),
        stand("the back of a seat", *SOFAS, "dining_chair"), 1.6, BEHIND, _LOOKS, PANERO, late=True,
    ),
    Row(
        "mirrored", Class("a screen", frozenset(("tv",))), clear(FRONT, each=True), AT_WINDOWS, 3.0,
        3.0, "{of} looks at {to} within {metres} m, which is mirrored in it", DGUV, late=True,
        example=Example(
            broken=(Place("tv", 2.5, 1.3, 90.0, 1.2, 0.1, 0.6),),
            held=(Place("tv", 2.5, 0.3, 90.0, 1.2, 0.1, 0.6),),
            mended=(Place("tv", 0.3, 2.0, 0.0, 1.2, 0.1, 0.6),),
        ),
    ),
    Row(
        "sofa_wall", _SOFA, clear(FRONT, 0.03), BY_WALLS, FEET, 5.0, _LOOKS, PANERO, late=True,
    ),
    Row(
        "armchair_wall", _ARMCHAIR, clear(FRONT, 0.3), BY_WALLS, 0.45, 5.0, _LOOKS, PANERO,
        late=True,
    ),
)  # fmt: skip
"""The rows."""
