"""Lamps. The light of each is that of the incandescent bulb it is sold to replace: 25, 40, 60, 75
and 100 W give 249, 470, 806, 1,055 and 1,521 lm (Commission Regulation (EC) 244/2009, table 6)."""

from __future__ import annotations

from scenewright.core.kind import Kind, size_range

KINDS = (
    Kind(
        "floor_lamp",
        airy=True,
        sizes=size_range("22 38 70", "22 38 70", "110 155 195"),
        lumens=1055.0,
        drawn_by=(".furniture.lighting", ".styled.lamps"),
    ),
    Kind(
        "table_lamp",
        support="top",
        airy=True,
        sizes=size_range("14 28 45", "14 28 45", "22 45 70"),
        lumens=470.0,
        drawn_by=(".furniture.lighting", ".styled.lamps"),
    ),
    Kind(
        "desk_lamp",
        support="top",
        sizes=size_range("12 18 30", "20 40 60", "28 45 65"),
        lumens=470.0,
        drawn_by=(".furniture.lighting",),
    ),
    Kind(
        "wall_lamp",
        support="wall",
        sizes=size_range("8 16 40", "6 14 30", "12 26 60"),
        lumens=470.0,
        drawn_by=(".furniture.lighting",),
    ),
    Kind(
        "pendant_lamp",
        support="ceiling",
        sizes=size_range("15 42 90", "15 42 90", "25 90 180"),
        lumens=806.0,
        drawn_by=(".furniture.lighting", ".styled.lamps"),
    ),
    Kind(
        "ceiling_lamp",
        support="ceiling",
        sizes=size_range("18 45 120", "18 45 120", "4 14 35"),
        lumens=1521.0,
        drawn_by=(".furniture.lighting", ".styled.lamps"),
    ),
)
