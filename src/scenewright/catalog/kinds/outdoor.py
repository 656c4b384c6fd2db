"""Balconies and terraces."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, FRONT, THREE
from scenewright.core.kind import Kind, free, size_range

KINDS = (
    Kind(
        "outdoor_table",
        access=ALL_SIDES,
        airy=True,
        sizes=size_range("40 80 220", "40 80 110", "40 72 78"),
        hall=free("grid chain", 0.75),
        forms="terrace",
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "outdoor_chair",
        access=THREE,
        under=("outdoor_table",),
        airy=True,
        back="high",
        sizes=size_range("44 54 70", "44 56 75", "70 82 98"),
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "deck_chair",
        access=FRONT,
        airy=True,
        back="high",
        sizes=size_range("55 66 85", "120 190 215", "30 75 112"),
        forms="lounger",
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "planter",
        airy=True,
        sizes=size_range("25 80 200", "18 30 60", "30 60 150"),
        hall=free("grid chain single", 0.15),
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "drying_rack",
        access=ALL_SIDES,
        airy=True,
        sizes=size_range("50 100 190", "35 55 70", "75 95 120"),
        drawn_by=(".furniture.outdoor",),
    ),
)
