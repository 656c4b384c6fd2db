"""Rows of desks at which visitors ask, are served or pay."""

from __future__ import annotations

from scenewright.arranging.rows import (
    BACK,
    FLAT,
    FRONT,
    SQUARE,
    WHOLE,
    Example,
    Place,
    Row,
    clear,
    faces,
    near,
    off,
)
from scenewright.domains.hall.measures import NEAR_ENTRANCE, QUEUE_TRIED, STAFF_ROOM
from scenewright.domains.hall.rules.classes import (
    ANY_DESK,
    AT_ENTRANCES,
    AT_EXITS,
    BY_WALLS,
    FIRST_DESK,
    LOUNGE_SEAT,
    ON_WAY_IN,
    OTHER_DESK,
    PAY_DESK,
    TILLS,
)

AT_SIDES = 0.2  # the share of the floor of staff that walls beside a desk may take
PARTLY = 0.3  # of a seat partly on that, square metres
SAT = 3.0  # metres behind a desk where no visitor sits
BACKWARDS = 0.3  # the cosine between the back of a desk and the way in from which on it is turned
FARTHEST = 33.0  # metres from the entrance from which on farther counts no more
_SEEN = "seen at first glance in halls laid out, 2026"
_STAFF = "Neufert 2012, shops: 0.75 m behind a counter"
_FAR = "{of} is farther than {metres} m from {to}"
_SEAT = Place("lounge seat", 2.5, 3.5, 0.0, 0.8, 0.8)
_NOT_SAT_ON = clear(BACK, PARTLY, each=True, grade=FLAT)._replace(per=SQUARE)

_FAR_ROWS = tuple(
    Row(
        name,
        of,
        near(FARTHEST),
        AT_ENTRANCES,
        NEAR_ENTRANCE,
        cost,
        _FAR,
        _SEEN,
        example=Example(
            broken=(Place(kind, 2.5, 3.5, -90.0, 1.0, 0.6),),
            held=(Place(kind, 2.5, 2.0, -90.0, 1.0, 0.6),),
            mended=(Place(kind, 1.0, 2.0, 0.0, 1.0, 0.6),),
        ),
    )
    for name, of, kind, cost in (
        ("first_desk_far", FIRST_DESK, "first desk", 12.0),
        ("pay_desk_far", PAY_DESK, "desk to pay at", 6.0),
        ("other_desk_far", OTHER_DESK, "other desk", 1.5),
    )
)

SERVING = (
    *_FAR_ROWS,
    Row(
        "desk_on_way", ANY_DESK, off(0.0, SQUARE, WHOLE), ON_WAY_IN, 0.0, 1.0,
        "{of} stands on {to}", _SEEN,
        example=Example(
            broken=(Place("first desk", 2.5, 1.0, 0.0, 1.0, 0.6),),
            held=(Place("first desk", 1.0, 1.0, 0.0, 1.0, 0.6),),
            mended=(Place("first desk", 2.5, 3.0, 0.0, 1.0, 0.6),),
        ),
    ),
    Row(
        "queue_on_way", ANY_DESK, clear(FRONT, 0.0, grade=WHOLE), ON_WAY_IN, QUEUE_TRIED, 1.8,
        "{of} has its queue on {to}", _SEEN,
        example=Example(
            broken=(Place("first desk", 1.0, 1.0, 0.0, 1.0, 0.6),),
            held=(Place("first desk", 1.0, 3.0, 0.0, 1.0, 0.6),),
            mended=(Place("first desk", 4.5, 1.0, 0.0, 1.0, 0.6),),
        ),
    ),
    Row(
        "desk_back", ANY_DESK, faces(BACKWARDS, FLAT), AT_ENTRANCES, 0.0, 6.0,
        "{of} turns its back to {to}", _SEEN,
        example=Example(
            broken=(Place("first desk", 2.5, 3.0, 90.0, 1.0, 0.6),),
            held=(Place("first desk", 2.5, 3.0, -90.0, 1.0, 0.6),),
            mended=(Place("first desk", 2.5, 3.0, 0.0, 1.0, 0.6),),
        ),
    ),
    Row(
        "desk_cramped", ANY_DESK, clear(BACK, AT_SIDES, grade=FLAT), BY_WALLS, STAFF_ROOM, 2.0,
        "{of} has {to} within {metres} m behind", _STAFF,
        example=Example(
            broken=(Place("first desk", 2.5, 3.5, -90.0, 1.0, 0.6),),
            held=(Place("first desk", 2.5, 2.5, -90.0, 1.0, 0.6),),
            mended=(Place("first desk", 1.5, 2.0, 0.0, 1.0, 0.6),),
        ),
    ),
    Row(
        "seats_behind_desk", ANY_DESK, _NOT_SAT_ON, LOUNGE_SEAT, SAT, 1.0,
        "{of} has {to} within {metres} m behind", _SEEN,
        example=Example(
            broken=(Place("first desk", 2.5, 2.0, -90.0, 1.0, 0.6), _SEAT),
            held=(Place("first desk", 1.0, 2.0, -90.0, 1.0, 0.6), _SEAT),
            mended=(Place("first desk", 2.5, 2.0, 90.0, 1.0, 0.6), _SEAT),
        ),
    ),
    Row(
        "tills_far", TILLS, near(18.3), AT_EXITS, 5.0, 4.0, _FAR, _SEEN,
        example=Example(
            broken=(Place("tills with lanes", 2.5, 5.5, 0.0, 1.0, 1.0),),
            held=(Place("tills with lanes", 2.5, 3.5, 0.0, 1.0, 1.0),),
            mended=(Place("tills with lanes", 1.0, 3.0, 0.0, 1.0, 1.0),),
        ),
    ),
)  # fmt: skip
"""The rows; costs in metres of fault."""
