"""Bathrooms and toilets."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FRONT, PIPE, TRAY
from scenewright.core.kind import Kind, size_range

KINDS = (
    Kind(
        "toilet",
        access=FRONT,
        back="high",
        sizes=size_range("33 38 45", "48 66 76", "70 78 92"),
        services=(PIPE,),
        essential=("bath, shower or toilet", "toilet"),
        forms="toilet",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "basin",
        label="basin cabinet",
        access=FRONT,
        sizes=size_range("45 80 160", "30 48 60", "78 88 100"),
        services=(PIPE,),
        essential=("basin", "basin or washing machine"),
        forms="basin",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "pedestal_basin",
        access=FRONT,
        sizes=size_range("30 50 70", "24 42 56", "76 86 95"),
        services=(PIPE,),
        essential=("basin", "basin or washing machine"),
        forms="basin",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "bathtub",
        access=FRONT,
        sizes=size_range("100 170 195", "60 75 110", "45 58 70"),
        services=(TRAY,),
        essential=("bath, shower or toilet",),
        forms="bath",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "shower",
        access=FRONT,
        sizes=size_range("65 90 165", "65 90 125", "185 200 225"),
        services=(TRAY,),
        essential=("bath, shower or toilet",),
        forms="shower",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "wall_shower",
        access=FRONT,
        sizes=size_range("20 30 60", "6 12 30", "160 210 240"),
        services=(PIPE,),
        essential=("bath, shower or toilet",),
        forms="shower",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "mirror",
        support="wall",
        back="flat",
        sizes=size_range("25 60 180", "1 3 16", "35 80 190"),
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "towel_rail",
        support="wall",
        airy=True,
        sizes=size_range("30 50 80", "4 10 20", "8 80 180"),
        drawn_by=(".furniture.sanitary",),
    ),
)
