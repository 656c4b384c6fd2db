"""Shelves, rails and tills of shops, and library stacks."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, BOTH, FRONT
from scenewright.core.kind import Kind, at_wall, free, size_range

KINDS = (
    Kind(
        "gondola",
        access=BOTH,
        reach=0.6,
        sizes=size_range("50 125 250", "50 90 140", "110 160 240"),
        hall=free("chain", 0.7, 0.0, 0.7, 0.0),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "wall_shelving",
        access=FRONT,
        reach=0.6,
        sizes=size_range("50 125 250", "25 45 80", "110 210 270"),
        hall=at_wall(0.75),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "ring_shelf",
        access=FRONT,
        reach=0.6,
        sizes=size_range("40 100 250", "25 45 80", "90 150 230"),
        hall=free("circulation chain", 0.75, 0.0, 0.0, 0.0),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "fridge_shelf",
        label="cooler with glass doors",
        access=FRONT,
        reach=0.75,
        sizes=size_range("60 130 400", "45 75 120", "130 205 240"),
        hall=at_wall(0.75),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "book_stack",
        access=BOTH,
        reach=0.6,
        sizes=size_range("60 100 600", "35 50 80", "90 200 250"),
        hall=free("chain", 0.6, 0.0, 0.6, 0.0),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "clothes_rail",
        access=BOTH,
        reach=0.6,
        sizes=size_range("60 130 250", "35 55 80", "110 140 180"),
        hall=free("chain grid", 0.6, 0.2, 0.6, 0.2),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "round_rack",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("70 110 160", "70 110 160", "110 135 160"),
        hall=free("grid chain", 0.6),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "mannequin",
        sizes=size_range("35 50 80", "25 40 80", "120 182 210"),
        hall=free("grid chain single", 0.3),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "display_table",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("70 140 240", "50 80 150", "60 90 130"),
        hall=free("grid chain radiation", 0.6),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "checkout",
        access=FRONT,
        reach=0.9,
        sizes=size_range("120 220 400", "80 120 250", "90 130 160"),
        hall=free("chain single", 0.9, 0.0, 0.6, 0.0),
        staff=0.9,
        drawn_by=(".public.tills",),
    ),
    Kind(
        "fitting_room",
        access=FRONT,
        reach=0.9,
        sizes=size_range("75 100 180", "75 110 200", "190 215 270"),
        hall=at_wall(0.9),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "basket_stack",
        access=ALL_SIDES,
        reach=0.45,
        sizes=size_range("30 45 70", "25 34 50", "35 80 130"),
        hall=free("single chain", 0.3),
        drawn_by=(".public.shop",),
    ),
)
