"""Parts of buildings, and stand-ins for unknown things."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FRONT
from scenewright.core.kind import Kind, at_wall, size_range

KINDS = (
    Kind(
        "radiator",
        support="wall",
        airy=True,
        sizes=size_range("30 100 220", "6 10 22", "20 60 200"),
        in_rooms=(("bathroom", ("towel_rail", "radiator")),),
        drawn_by=(".furniture.building",),
    ),
    Kind(
        "column",
        sizes=size_range("10 35 100", "10 35 100", "100 260 600"),
        drawn_by=(".furniture.building",),
    ),
    Kind(
        "staircase",
        access=FRONT,
        reach=0.9,
        sizes=size_range("60 90 200", "120 320 600", "100 270 450"),
        drawn_by=(".furniture.building",),
    ),
    Kind(
        "fireplace",
        access=FRONT,
        hall=at_wall(0.9, 0.3),
        back="flat",
        sizes=size_range("80 125 190", "25 45 75", "80 115 260"),
        essential=("screen or focal point",),
        drawn_by=(".furniture.building",),
    ),
    Kind(
        "box",
        sizes=size_range("15 40 120", "15 35 120", "10 30 120"),
        drawn_by=(".furniture.building",),
    ),
    Kind(
        "obstacle",
        sizes=size_range("2 60 1000", "2 60 1000", "1 100 600"),
        drawn_by=(".furniture.building",),
    ),
)
