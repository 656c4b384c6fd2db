"""Halls with a stage."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import BOTH, THREE
from scenewright.core.kind import Kind, at_wall, free, size_range

KINDS = (
    Kind(
        "auditorium_seat",
        access=BOTH,
        reach=0.45,
        back="high",
        sizes=size_range("45 55 70", "48 62 90", "75 95 120"),
        hall=free("fan chain", 0.45, 0.0, 0.0, 0.0),
        drawn_by=(".public.auditorium",),
    ),
    Kind(
        "pew",
        access=BOTH,
        reach=0.35,
        back="high",
        sizes=size_range("120 300 450", "45 55 70", "75 90 110"),
        hall=free("chain", 0.4, 0.6, 0.0, 0.6),
        drawn_by=(".public.auditorium",),
    ),
    Kind(
        "lectern",
        access=("back",),
        reach=0.6,
        sizes=size_range("40 62 100", "35 55 90", "100 122 145"),
        hall=free("single", 0.3, 0.3, 0.75, 0.3),
        drawn_by=(".public.auditorium", ".public.sacral"),
    ),
    Kind(
        "stage",
        access=THREE,
        reach=0.9,
        sizes=size_range("150 600 1200", "120 350 800", "15 50 120"),
        hall=free("single", 1.2, 0.0, 0.0, 0.0),
        drawn_by=(".public.auditorium", ".public.sacral"),
    ),
    Kind(
        "screen",
        label="projection screen",
        sizes=size_range("120 300 900", "3 50 120", "160 260 500"),
        hall=at_wall(0.9, 0.1),
        drawn_by=(".public.auditorium",),
    ),
)
