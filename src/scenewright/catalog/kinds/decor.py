"""Textiles, pictures, plants and small things."""

from __future__ import annotations

from scenewright.core.kind import Kind, at_wall, size_range

KINDS = (
    Kind(
        "rug",
        flat=True,
        sizes=size_range("40 200 500", "40 140 400", "0.4 1.2 3"),
        drawn_by=(".furniture.textiles",),
    ),
    Kind(
        "curtain",
        support="wall",
        sizes=size_range("30 180 600", "5 9 25", "50 220 340"),
        drawn_by=(".furniture.textiles",),
    ),
    Kind(
        "blind",
        support="wall",
        sizes=size_range("30 140 400", "3 6 15", "30 130 320"),
        drawn_by=(".furniture.textiles",),
    ),
    Kind(
        "picture",
        support="wall",
        back="flat",
        sizes=size_range("15 70 200", "1.5 4 6", "15 50 140"),
        drawn_by=(".furniture.decor",),
    ),
    Kind(
        "wall_clock",
        support="wall",
        sizes=size_range("15 30 60", "2 4 10", "15 30 60"),
        drawn_by=(".furniture.decor",),
    ),
    Kind(
        "books",
        support="top",
        sizes=size_range("10 25 90", "10 18 30", "3 10 32"),
        drawn_by=(".furniture.decor",),
    ),
    Kind(
        "plant",
        support="top",
        airy=True,
        sizes=size_range("10 25 55", "10 25 55", "15 40 80"),
        in_rooms=(("exterior", ("tree",)),),
        drawn_by=(".furniture.greenery",),
    ),
    Kind(
        "potted_tree",
        airy=True,
        sizes=size_range("30 50 110", "30 50 110", "80 150 240"),
        hall=at_wall(0.15, 0.6),
        in_rooms=(("exterior", ("tree",)),),
        forms="plant",
        drawn_by=(".furniture.greenery",),
    ),
    Kind(
        "vase",
        support="top",
        sizes=size_range("7 16 35", "7 16 35", "12 28 80"),
        drawn_by=(".furniture.greenery",),
    ),
    Kind(
        "bowl",
        support="top",
        sizes=size_range("10 28 50", "10 28 50", "4 10 22"),
        drawn_by=(".furniture.greenery",),
    ),
)
