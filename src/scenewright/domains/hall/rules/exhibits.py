"""Rows of what is shown."""

from __future__ import annotations

from scenewright.arranging.rows import (
    BACK,
    FRONT,
    WHOLE,
    Example,
    Place,
    Row,
    clear,
    faces,
    keep_off,
)
from scenewright.domains.hall.measures import KEPT_OFF
from scenewright.domains.hall.rules.classes import (
    AT_COLUMNS,
    AT_ENTRANCES,
    BY_WALLS,
    EXHIBIT,
    STAND,
    TWO_FACED,
)

BEFORE_WALL = 1.0  # how wide an aisle before a wall is at least, metres
_SEEN = "seen at first glance in halls laid out, 2026"
_WALKED = "Neufert 2012, libraries: an aisle behind the last stack"

EXHIBITS = (
    Row(
        "exhibit_at_column", EXHIBIT, keep_off(0.0, WHOLE, each=True), AT_COLUMNS, KEPT_OFF, 16.0,
        "{of} is within {metres} m of {to}", _SEEN,
        example=Example(
            broken=(Place("exhibit", 3.2, 2.0, 0.0, 1.0, 1.0),),
            held=(Place("exhibit", 1.5, 2.0, 0.0, 1.0, 1.0),),
            mended=(Place("exhibit", 2.7, 2.0, 0.0, 1.0, 1.0),),
        ),
    ),
    Row(
        "stand_away", STAND, faces(), AT_ENTRANCES, 0.0, 1.5,
        "{of} turns its back to {to}", _SEEN,
        example=Example(
            broken=(Place("stand", 2.5, 2.0, 90.0, 2.0, 1.0),),
            held=(Place("stand", 2.5, 2.0, -90.0, 2.0, 1.0),),
            mended=(Place("stand", 2.0, 2.5, -45.0, 2.0, 1.0),),
        ),
    ),
    Row(
        "slot_before_rows", TWO_FACED, clear(FRONT, 0.0, grade=WHOLE), BY_WALLS, BEFORE_WALL, 3.0,
        "{of} leaves less than {metres} m before {to}", _WALKED,
        example=Example(
            broken=(Place("rows with two faces", 2.5, 3.2, 90.0, 3.0, 1.0),),
            held=(Place("rows with two faces", 2.5, 2.4, 90.0, 3.0, 1.0),),
            mended=(Place("rows with two faces", 2.5, 2.0, 0.0, 3.0, 1.0),),
        ),
    ),
    Row(
        "slot_behind_rows", TWO_FACED, clear(BACK, 0.0, grade=WHOLE), BY_WALLS, BEFORE_WALL, 3.0,
        "{of} leaves less than {metres} m behind to {to}", _WALKED,
        example=Example(
            broken=(Place("rows with two faces", 2.5, 3.2, -90.0, 3.0, 1.0),),
            held=(Place("rows with two faces", 2.5, 2.4, -90.0, 3.0, 1.0),),
            mended=(Place("rows with two faces", 2.5, 2.0, 0.0, 3.0, 1.0),),
        ),
    ),
)  # fmt: skip
"""The rows; costs in metres of fault."""
