"""Groups of balconies and terraces."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size

CHAIR = Size(0.52, 0.54, 0.82)
FOLDING = Size(0.44, 0.44, 0.8)
TABLE = Size(0.4, 0.4, 0.5)


def terrace() -> Iterator[Group]:
    """A small table between two chairs along the rail or wall: face to face, or side by side on
    what is long and thin; folding ones on little floor."""
    for table, chair in ((0.46, FOLDING), (0.5, CHAIR), (0.6, CHAIR), (0.75, CHAIR)):
        width = table + 2 * chair.depth
        x = table / 2 + chair.depth / 2 - 0.02
        members = (
            Member("outdoor_table", 0, 0, 0, 0, Size(table - 0.06, table - 0.06, 0.7)),
            Member("outdoor_chair", x, 0, 0, pi / 2, chair),
            Member("outdoor_chair", -x, 0, 0, -pi / 2, chair),
        )
        yield Group("terrace", "table and two chairs", width, max(table, chair.width), members)
    for chair in (FOLDING, CHAIR):
        yield _side_by_side(chair)


def _side_by_side(chair: Size) -> Group:
    x = (TABLE.width + chair.width) / 2 + 0.03
    members = (
        Member("outdoor_table", 0, 0, 0, 0, TABLE._replace(height=0.7)),
        Member("outdoor_chair", x, 0, 0, 0, chair),
        Member("outdoor_chair", -x, 0, 0, 0, chair),
    )
    width = TABLE.width + 2 * chair.width + 0.08
    return Group("terrace", "two chairs side by side, table", width, chair.depth + 0.02, members)


def lounger() -> Iterator[Group]:
    """One outdoor chair, by itself or with a small table on either side."""
    chair = Member("outdoor_chair", 0, 0, 0, 0, CHAIR)
    yield Group("lounger", "outdoor chair", 0.56, 0.58, (chair,))
    yield from (_with_table(chair, side) for chair in (CHAIR, FOLDING) for side in (1, -1))


def _with_table(chair: Size, side: int) -> Group:
    width = chair.width + TABLE.width + 0.04
    members = (
        Member("outdoor_chair", side * (chair.width - width + 0.02) / 2, 0, 0, 0, chair),
        Member("side_table", side * (width - TABLE.width - 0.02) / 2, 0, 0, 0, TABLE),
    )
    name = f"outdoor chair of {chair.width:.2f} m, side table"
    return Group("lounger", name, width, chair.depth + 0.02, members)


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
