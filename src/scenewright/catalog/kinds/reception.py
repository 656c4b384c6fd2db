"""Desks, barriers and machines of public buildings."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, BOTH, FRONT
from scenewright.core.kind import Kind, at_wall, free, size_range

KINDS = (
    Kind(
        "counter",
        access=FRONT,
        reach=0.9,
        sizes=size_range("80 200 800", "45 65 120", "80 100 120"),
        hall=free("chain single", 0.9, 0.0, 0.9, 0.0),
        staff=0.9,
        drawn_by=(".public.reception", ".public.sacral"),
    ),
    Kind(
        "info_desk",
        access=FRONT,
        reach=0.9,
        sizes=size_range("120 260 800", "60 90 250", "90 110 125"),
        hall=free("single", 1.2, 0.3, 0.9, 0.3),
        staff=0.9,
        drawn_by=(".public.reception",),
    ),
    Kind(
        "corner_counter",
        access=FRONT,
        reach=0.9,
        sizes=size_range("160 280 600", "140 220 400", "90 110 120"),
        hall=free("single", 1.2, 0.3, 0.3, 0.3),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "ticket_gate",
        access=BOTH,
        reach=0.9,
        sizes=size_range("70 95 130", "80 140 200", "90 100 120"),
        hall=free("chain", 1.2, 0.0, 1.2, 0.0),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "rope_barrier",
        sizes=size_range("80 150 300", "25 32 45", "85 98 110"),
        hall=free("chain", 0.3, 0.0, 0.3, 0.0),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "partition",
        sizes=size_range("30 200 3000", "10 15 25", "200 300 600"),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "glass_barrier",
        sizes=size_range("20 200 3000", "5 6 12", "80 100 130"),
        drawn_by=(".public.barriers",),
    ),
    Kind(
        "gate_leaf",
        swings=True,
        sizes=size_range("40 110 260", "2 3 5", "60 90 120"),
        drawn_by=(".public.barriers",),
    ),
    Kind(
        "gate_post",
        sizes=size_range("60 120 220", "15 20 30", "80 100 130"),
        drawn_by=(".public.barriers",),
    ),
    Kind(
        "litter_bin",
        access=ALL_SIDES,
        reach=0.45,
        sizes=size_range("25 40 120", "25 40 60", "45 80 130"),
        hall=at_wall(0.45, 0.15),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "sign_totem",
        sizes=size_range("30 60 120", "10 25 60", "120 200 300"),
        hall=free("single", 0.45, 0.15, 0.15, 0.15),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "lockers",
        access=FRONT,
        reach=0.75,
        sizes=size_range("28 120 400", "30 50 65", "90 185 220"),
        hall=at_wall(0.9),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "vending_machine",
        access=FRONT,
        reach=0.75,
        sizes=size_range("60 95 140", "60 85 110", "150 185 210"),
        hall=at_wall(0.9),
        drawn_by=(".public.reception", ".public.machines"),
    ),
    Kind(
        "cash_machine",
        access=FRONT,
        reach=0.75,
        sizes=size_range("55 75 120", "50 75 110", "130 155 210"),
        hall=at_wall(0.9),
        drawn_by=(".public.machines",),
    ),
    Kind(
        "ticket_machine",
        access=FRONT,
        reach=0.75,
        sizes=size_range("55 80 120", "50 75 110", "130 175 210"),
        hall=at_wall(0.9),
        drawn_by=(".public.machines",),
    ),
    Kind(
        "copier",
        access=FRONT,
        reach=0.75,
        sizes=size_range("50 70 140", "50 70 85", "95 110 130"),
        hall=at_wall(0.9),
        drawn_by=(".public.machines",),
    ),
)
