"""Furniture of exhibitions: things are shown in and on it."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, BOTH, FRONT
from scenewright.core.kind import Kind, at_wall, free, size_range

KINDS = (
    Kind(
        "showcase",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("60 120 400", "40 60 150", "80 105 130"),
        hall=free("chain radiation grid", 0.75, 0.45, 0.75, 0.45),
        drawn_by=(".public.exhibition",),
    ),
    Kind(
        "plinth",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("25 50 150", "25 50 150", "90 160 320"),
        hall=free("radiation grid chain", 0.75),
        drawn_by=(".public.exhibition", ".public.sacral"),
    ),
    Kind(
        "exhibit_panel",
        access=BOTH,
        reach=0.6,
        sizes=size_range("60 150 300", "4 40 60", "160 210 280"),
        hall=free("chain radiation", 0.75, 0.1, 0.75, 0.1),
        drawn_by=(".public.exhibition",),
    ),
    Kind(
        "wall_exhibit",
        access=FRONT,
        reach=0.6,
        sizes=size_range("60 120 400", "25 40 70", "160 220 300"),
        hall=at_wall(0.9, 0.1),
        drawn_by=(".public.exhibition", ".public.paintings"),
    ),
    Kind(
        "interactive_table",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("80 140 240", "60 80 150", "70 90 110"),
        hall=free("grid single", 0.75),
        drawn_by=(".public.exhibition",),
    ),
    Kind(
        "exhibit_island",
        access=ALL_SIDES,
        reach=0.75,
        sizes=size_range("150 300 900", "120 240 600", "60 160 400"),
        hall=free("single grid", 0.9),
        drawn_by=(
            ".exhibits.islands",
            ".exhibits.whales",
            ".exhibits.cars",
            ".exhibits.locomotives",
            ".exhibits.aircraft",
            ".exhibits.boats",
            ".exhibits.stands",
            ".exhibits.scale_models",
            ".exhibits.sculptures",
        ),
    ),
)
