"""Rows of what people sit on."""

from __future__ import annotations

from scenewright.arranging.rows import FLAT, FRONT, WHOLE, Example, Place, Row, apart, clear, faces
from scenewright.domains.hall.measures import KEPT_OFF, UNSEEN
from scenewright.domains.hall.rules.classes import (
    AT_DOORS,
    BY_WALLS,
    LOUNGE_ROW,
    LOUNGE_SEAT,
    OTHERS,
)

SEEN_FROM_DOOR = 6.2  # metres from a door at which one sees backs
TURNED_FROM = 0.45  # the cosine between a back and the way to a door from which on it is turned
CLOSE_WALL = 2.0  # metres to a wall at which nobody wants to look
_SEEN = "seen at first glance in halls laid out, 2026"
_SEAT = Place("lounge seat", 1.0, 2.0, 0.0, 0.8, 0.8)

SEATING = (
    Row(
        "seat_crowded", LOUNGE_SEAT, apart(0.0, WHOLE), OTHERS, KEPT_OFF, 8.0,
        "{of} is within {metres} m of {to}", _SEEN,
        example=Example(
            broken=(_SEAT, Place("panel", 1.0, 1.3, 0.0, 0.3, 0.3)),
            held=(_SEAT, Place("panel", 1.0, 0.8, 0.0, 0.3, 0.3)),
            mended=(_SEAT, Place("panel", 3.0, 1.3, 0.0, 0.3, 0.3)),
        ),
    ),
    Row(
        "seats_look_at_wall", LOUNGE_ROW, clear(FRONT, UNSEEN, grade=WHOLE), BY_WALLS, CLOSE_WALL,
        3.0, "{of} looks at {to} within {metres} m", _SEEN,
        example=Example(
            broken=(Place("row of lounge seats", 2.5, 3.0, 90.0, 3.0, 0.8),),
            held=(Place("row of lounge seats", 2.5, 3.0, -90.0, 3.0, 0.8),),
            mended=(Place("row of lounge seats", 2.5, 3.5, -90.0, 3.0, 0.8),),
        ),
    ),
    Row(
        "seat_back", LOUNGE_SEAT, faces(TURNED_FROM, FLAT, SEEN_FROM_DOOR), AT_DOORS, 0.0, 4.0,
        "{of} turns its back to {to}", _SEEN,
        example=Example(
            broken=(Place("lounge seat", 2.5, 3.0, 90.0, 0.8, 0.8),),
            held=(Place("lounge seat", 2.5, 3.0, 0.0, 0.8, 0.8),),
            mended=(Place("lounge seat", 2.5, 3.0, -90.0, 0.8, 0.8),),
        ),
    ),
)  # fmt: skip
"""The rows; costs in metres of fault."""
