"""Guidelines of interior design as numbers: how far a furnished room keeps each.

Every row measures one number of a room and says within which limits it should lie and who says so.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import NamedTuple

from benchmarks.designer_measures import (
    alignment,
    away_from_door,
    backs,
    balance,
    clearance,
    conversation,
    desk_light,
    door_in_sight,
    faults,
    focal_point,
    furnished,
    off_axis,
    open_floor,
    route,
    turned_away,
    viewing_distance,
    windows,
    work_triangle,
)
from benchmarks.designer_rooms import Seen


class Guideline(NamedTuple):
    """One number of a room: kept from ``low`` to ``high``; two rooms whose numbers miss by the
    same to ``slack`` are equally good. None: the room does not have it."""

    name: str
    unit: str
    low: float
    high: float
    slack: float
    measure: Callable[[Seen], float | None]
    doc: str
    source: str

    def missed(self, value: float) -> float:
        """By how much a value is out of the limits."""
        return max(self.low - value, value - self.high, 0.0)


MERRELL = "Merrell et al. 2011"
SLEEP = "Spörrle & Stich 2010"
GUIDELINES: tuple[Guideline, ...] = (
    Guideline("faults", "faults", 0, 0, 0.0, faults, "what the referee finds", "scenewright check"),
    Guideline(
        "route",
        "m",
        0.6,
        inf,
        0.03,
        route,
        "widest way to all doors and things",
        "route width of a brief",
    ),
    Guideline(
        "open floor",
        "m",
        1.2,
        inf,
        0.05,
        open_floor,
        "largest circle of free floor",
        "DIN 18040-2, 1.2 m without a wheelchair",
    ),
    Guideline(
        "clearance",
        "share",
        1,
        1,
        0.03,
        clearance,
        "free floor before cupboards, desks, appliances",
        "reach of the table of kinds",
    ),
    Guideline(
        "windows", "share", 0, 0, 0.02, windows, "floor before windows under tall things", "ours"
    ),
    Guideline(
        "backs",
        "share",
        1,
        1,
        0.02,
        backs,
        "cupboards, shelves, beds with the back at a wall",
        "Liu et al. 2017, C5",
    ),
    Guideline(
        "alignment", "share", 1, 1, 0.02, alignment, "pieces parallel or square to walls", MERRELL
    ),
    Guideline(
        "balance",
        "share",
        0,
        0,
        0.02,
        balance,
        "middle of the furniture off that of the room",
        MERRELL,
    ),
    Guideline(
        "furnished",
        "share",
        0.40,
        0.55,
        0.03,
        furnished,
        "floor that groups cover",
        "Liu et al. 2017, C7",
    ),
    Guideline(
        "viewing distance",
        "widths",
        1.4,
        3.4,
        0.2,
        viewing_distance,
        "main seat to screen, by its width",
        "picture seen under 40 to 17 degrees",
    ),
    Guideline(
        "screen axis",
        "degrees",
        0,
        15,
        3.0,
        off_axis,
        "main seat off the middle before the screen",
        "ours",
    ),
    Guideline(
        "seat axis",
        "degrees",
        0,
        15,
        3.0,
        turned_away,
        "screen off the middle before the main seat",
        "ours",
    ),
    Guideline(
        "conversation",
        "m",
        1.2,
        2.4,
        0.1,
        conversation,
        "seat to nearest seat",
        f"{MERRELL}, 4 to 8 feet",
    ),
    Guideline(
        "focal point",
        "share",
        1,
        1,
        0.02,
        focal_point,
        "seats that look at screen, fire or table",
        MERRELL,
    ),
    Guideline("desk light", "m", 0, 1.0, 0.1, desk_light, "desk to window", "ours"),
    Guideline(
        "door in sight",
        "degrees",
        0,
        90,
        5.0,
        door_in_sight,
        "door off the front of one lying in bed",
        SLEEP,
    ),
    Guideline(
        "away from door",
        "share",
        1,
        1,
        0.05,
        away_from_door,
        "pillow to door, of the farthest there is",
        SLEEP,
    ),
    Guideline(
        "work triangle",
        "m",
        3.6,
        7.9,
        0.1,
        work_triangle,
        "sink, hob, fridge and back",
        "NKBA, 12 to 26 feet",
    ),
)
"""Every guideline that is measured, with limits and source."""
