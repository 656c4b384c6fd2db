"""Small objects that stand on others: what is eaten from, read, worn, washed with, played with."""

from __future__ import annotations

from scenewright.core.kind import Kind, size_range


def _small(category: str, drawn_by: str, width: str, depth: str, height: str) -> Kind:
    sizes = size_range(width, depth, height)
    cloth = category == "throw"
    return Kind(category, support="top", sizes=sizes, drawn_by=(drawn_by,), flat=cloth)


_TABLE = (
    ("plate", "16 26 32", "16 26 32", "1.5 2.4 4"),
    ("mug", "9 11.5 14", "7 8.5 11", "7 9.5 12"),
    ("drinking_glass", "5 7 9", "5 7 9", "8 12 18"),
    ("bottle", "5 7.5 11", "5 7.5 11", "18 28 38"),
    ("jar", "6 10 14", "6 10 14", "8 16 30"),
    ("jug", "13 17 22", "10 13 17", "16 22 30"),
    ("kettle", "18 24 28", "14 17 20", "18 23 28"),
    ("cooking_pot", "20 28 36", "16 22 30", "10 15 24"),
    ("chopping_board", "20 36 50", "14 24 35", "1 2 4"),
    ("utensil_pot", "10 14 18", "10 14 18", "22 32 40"),
    ("cutlery", "1.5 2 3", "15 20 25", "0.4 0.7 1.2"),
    ("napkin", "8 12 20", "10 18 25", "0.4 0.8 1.5"),
    ("tray", "25 40 55", "18 28 40", "2 3.5 6"),
    ("toaster", "24 30 40", "14 18 26", "16 20 26"),
    ("sponge", "7 10 12", "4.5 6.5 8", "2 3 4"),
)
_OWN = (
    ("book", "10 15 24", "14 22 32", "1 2.5 6"),
    ("magazine", "16 21 26", "22 28 34", "0.3 0.6 1.5"),
    ("photo_frame", "9 15 26", "5 9 14", "12 20 32"),
    ("candle", "5 8 12", "5 8 12", "6 12 24"),
    ("pump_bottle", "5 7 9", "5 7 9", "14 19 24"),
    ("cream_tube", "3.5 5 7", "3.5 5 7", "10 15 20"),
    ("toothbrush_cup", "7 10 12", "7 10 12", "15 20 24"),
    ("paper_roll", "9 11 14", "9 11 14", "9 10 26"),
    ("storage_box", "16 30 45", "14 24 38", "10 18 32"),
    ("basket", "20 32 45", "16 26 36", "10 18 32"),
    ("remote_control", "3.5 4.5 6", "14 18 22", "1.2 1.8 2.5"),
    ("phone", "6 7.5 9", "13 15.5 18", "0.6 0.9 1.2"),
    ("keyboard", "28 43 48", "10 13 16", "1.2 2 3"),
    ("mouse", "5 6.5 8", "9 11 13", "2.5 3.5 4.5"),
    ("pen_pot", "7 10 12", "7 10 12", "15 19 22"),
    ("alarm_clock", "8 12 18", "4 6 9", "6 8 12"),
    ("toy_car", "6 8 12", "10 16 24", "5 7 11"),
    ("toy_blocks", "10 14 20", "4 5 7", "9 13 18"),
    ("loudspeaker", "11 16 24", "12 18 28", "18 27 40"),
)
_SOFT = (
    ("cushion", "35 45 60", "15 24 34", "30 42 55"),
    ("throw", "40 60 180", "30 45 60", "4 8 14"),
    ("towels", "20 32 45", "14 24 35", "4 14 30"),
    ("rolled_towel", "20 30 40", "7 10 14", "7 10 14"),
    ("shoes", "14 21 26", "17 27 33", "6 9 14"),
    ("teddy", "14 22 36", "13 20 32", "18 28 45"),
    ("ball", "8 18 26", "8 18 26", "8 18 26"),
    ("bag", "22 34 45", "9 13 20", "24 34 45"),
    ("hat", "24 32 40", "22 30 38", "9 12 16"),
)
KINDS = (
    *(_small(category, ".furniture.tableware", *size) for category, *size in _TABLE),
    *(_small(category, ".furniture.belongings", *size) for category, *size in _OWN),
    *(_small(category, ".furniture.soft_goods", *size) for category, *size in _SOFT),
)
