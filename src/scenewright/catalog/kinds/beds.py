"""Beds and nightstands."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FLANKS, THREE
from scenewright.core.kind import Kind, OwnGroup, size_range

KINDS = (
    Kind(
        "double_bed",
        access=FLANKS,
        back="high",
        sizes=size_range("135 160 215", "190 205 235", "70 95 130"),
        essential=("bed", "double bed"),
        forms="sleeping",
        drawn_by=(".furniture.beds", ".styled.beds"),
    ),
    Kind(
        "single_bed",
        access=THREE,
        back="high",
        sizes=size_range("70 90 130", "160 205 220", "55 95 120"),
        essential=("bed",),
        forms="single",
        drawn_by=(".furniture.beds", ".styled.beds"),
    ),
    Kind(
        "bunk_bed",
        access=THREE,
        sizes=size_range("80 100 120", "165 205 220", "145 165 185"),
        essential=("bed",),
        forms="bunk",
        drawn_by=(".furniture.beds",),
    ),
    Kind(
        "cot",
        access=THREE,
        sizes=size_range("60 68 80", "110 126 150", "75 90 110"),
        essential=("bed",),
        alone=OwnGroup("cot"),
        drawn_by=(".furniture.beds",),
    ),
    Kind(
        "nightstand",
        back="flat",
        sizes=size_range("28 42 65", "28 40 52", "38 50 65"),
        essential=("nightstand",),
        drawn_by=(".furniture.beds", ".styled.cases"),
    ),
)
