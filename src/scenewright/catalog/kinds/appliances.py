"""Machines for laundry, sound and pictures."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FRONT, HOSE, LEAD
from scenewright.core.kind import Kind, Service, size_range

KINDS = (
    Kind(
        "washing_machine",
        access=FRONT,
        reach=0.6,
        back="flat",
        sizes=size_range("44 60 70", "38 60 70", "78 85 106"),
        services=(LEAD, HOSE),
        essential=("basin or washing machine",),
        forms="washer",
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "dryer",
        access=FRONT,
        reach=0.6,
        back="flat",
        sizes=size_range("55 60 70", "50 60 70", "80 85 106"),
        services=(LEAD,),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "tv",
        label="television",
        support="top",
        sizes=size_range("50 110 190", "4 20 35", "32 68 115"),
        services=(LEAD, Service("antenna", 1.5, "cable")),
        essential=("screen or focal point",),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "monitor",
        support="top",
        sizes=size_range("36 58 90", "12 20 28", "34 45 60"),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "laptop",
        support="top",
        back="high",
        sizes=size_range("26 34 42", "18 25 30", "16 22 28"),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "speaker",
        sizes=size_range("12 24 40", "14 28 42", "20 90 120"),
        drawn_by=(".furniture.appliances",),
    ),
)
