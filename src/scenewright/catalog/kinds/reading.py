"""Reading rooms."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import BOTH, DESKS, FRONT, SEAT, TABLES
from scenewright.core.kind import Kind, TableChairs, free, size_range

KINDS = (
    Kind(
        "reading_table",
        access=BOTH,
        reach=0.6,
        airy=True,
        sizes=size_range("80 240 600", "60 120 180", "70 115 135"),
        hall=free("grid chain", 0.9, 0.6, 0.9, 0.6),
        chairs=TableChairs("reading_chair", 0.75, 0.1),
        drawn_by=(".public.reading",),
    ),
    Kind(
        "reading_chair",
        access=SEAT,
        under=("reading_table", "carrel", *TABLES, *DESKS),
        back="high",
        sizes=size_range("40 48 65", "42 52 65", "75 84 105"),
        hall=free("grid fan chain", 0.1, 0.1, 0.5, 0.1),
        drawn_by=(".public.reading",),
    ),
    Kind(
        "carrel",
        access=FRONT,
        reach=0.75,
        sizes=size_range("70 100 160", "55 75 110", "105 130 170"),
        hall=free("chain grid", 0.75, 0.0, 0.0, 0.0),
        drawn_by=(".public.reading",),
    ),
    Kind(
        "lounge_seat",
        access=FRONT,
        back="high",
        sizes=size_range("55 78 120", "55 78 110", "60 75 105"),
        hall=free("around", 0.45, 0.0, 0.0, 0.0),
        drawn_by=(".public.reading",),
    ),
    Kind(
        "catalogue_terminal",
        access=FRONT,
        reach=0.6,
        sizes=size_range("40 60 120", "40 55 90", "95 140 175"),
        hall=free("chain radiation single", 0.75, 0.1, 0.1, 0.1),
        drawn_by=(".public.reading",),
    ),
)
