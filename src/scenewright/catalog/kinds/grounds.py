"""Things outside buildings, and buildings."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FRONT
from scenewright.core.kind import Kind, size_range

KINDS = (
    Kind(
        "building",
        access=FRONT,
        reach=1.5,
        sizes=size_range("540 2400 12000", "540 1800 9600", "480 1400 15000"),
        drawn_by=(
            ".buildings.eastern",
            ".buildings.sacred",
            ".buildings.mosques",
            ".buildings.civic",
            ".buildings.houses",
            ".buildings.corner_houses",
            ".buildings.towers",
            ".buildings.works",
        ),
    ),
    Kind(
        "house",
        access=FRONT,
        reach=1.5,
        sizes=size_range("250 1100 4000", "250 900 3000", "220 750 1800"),
        drawn_by=(".buildings.rural_houses",),
    ),
    Kind(
        "tree",
        sizes=size_range("200 700 1600", "200 700 1600", "300 900 2500"),
        drawn_by=(".buildings.street_furniture",),
    ),
    Kind(
        "road",
        flat=True,
        sizes=size_range("100 600 4000", "100 4000 50000", "1 4 5"),
        drawn_by=(".buildings.street_furniture",),
    ),
    Kind(
        "lamp_post",
        sizes=size_range("12 30 60", "60 140 250", "300 600 1200"),
        lumens=5000.0,
        kelvin=3000.0,
        drawn_by=(".buildings.street_furniture",),
    ),
    Kind(
        "site_bench",
        label="park bench",
        access=FRONT,
        sizes=size_range("120 180 300", "45 60 90", "70 82 100"),
        drawn_by=(".buildings.street_furniture",),
    ),
)
