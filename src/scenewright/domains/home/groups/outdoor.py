"""Groups of balconies and terraces."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size

CHAIR = Size(0.52, 0.54, 0.82)
FOLDING = Size(0.44, 0.44, 0.8)


def terrace() -> Iterator[Group]:
    """A small table between two chairs, along the rail or wall."""
    for table in (0.5, 0.6, 0.75):
        width = table + 2 * CHAIR.depth
        x = table / 2 + CHAIR.depth / 2 - 0.02
        members = (
            Member("outdoor_table", 0, 0, 0, 0, Size(table - 0.06, table - 0.06, 0.7)),
            Member("outdoor_chair", x, 0, 0, pi / 2, CHAIR),
            Member("outdoor_chair", -x, 0, 0, -pi / 2, CHAIR),
        )
        yield Group("terrace", "table and two chairs", width, max(table, CHAIR.width), members)


def lounger() -> Iterator[Group]:
    """One outdoor chair."""
    chair = Member("outdoor_chair", 0, 0, 0, 0, CHAIR)
    yield Group("lounger", "outdoor chair", 0.56, 0.58, (chair,))


def folding_chair() -> Iterator[Group]:
    """One folding chair, for a balcony on which an armchair stands before the door."""
    chair = Member("outdoor_chair", 0, 0, 0, 0, FOLDING)
    yield Group("lounger", "folding chair", 0.46, 0.46, (chair,))


def planter() -> Iterator[Group]:
    """A planter box."""
    for width in (0.5, 0.8, 1.0):
        piece = Member("planter", 0, 0, 0, 0, Size(width, 0.3, 0.6))
        yield Group("planter", f"{width:.1f} m planter", width, 0.31, (piece,))


def drying() -> Iterator[Group]:
    """A drying rack."""
    piece = Member("drying_rack", 0, 0, 0, 0, Size(1.0, 0.5, 0.95))
    yield Group("drying", "drying rack", 1.0, 0.52, (piece,))
