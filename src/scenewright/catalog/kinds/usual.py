"""What many kinds share: sides people use them from, what they are connected by, what chairs go
under."""

from __future__ import annotations

from scenewright.core.kind import Service, Side

FRONT: tuple[Side, ...] = ("front",)
ALL_SIDES: tuple[Side, ...] = ("front", "back", "left", "right")
SEAT: tuple[Side, ...] = ("back", "left", "right")
"""One sits down at a table from any side but the table's."""
FLANKS: tuple[Side, ...] = ("left", "right")
THREE: tuple[Side, ...] = ("front", "left", "right")
BOTH: tuple[Side, ...] = ("front", "back")

TABLES = ("dining_table", "round_table", "outdoor_table")
HIGH = 0.95
"""Height of a table in metres from which on one stands at it, or sits at it on a bar stool."""


def is_high(category: str, height: float) -> bool:
    """Whether one stands at a table, or sits at it on a bar stool. What rises above the top of a
    reading table are its lamps.

    >>> is_high("round_table", 1.1), is_high("reading_table", 1.15)
    (True, False)
    """
    return category in TABLES and height >= HIGH


DESKS = ("desk", "corner_desk", "kids_desk", "vanity")

LEAD = Service("power", 1.5, "lead")
HOSE = Service("water", 1.5, "hose")
PIPE = Service("water", 0.5, "pipe")
TRAY = Service("water", 1.0, "pipe")
