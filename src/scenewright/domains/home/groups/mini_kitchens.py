"""Mini kitchens: sink, hob and, where it fits, a low fridge under one worktop of 0.8 to 1.65 m.

They are what is sold for a niche of a hall or of a single room, 0.6 m deep and, slimmer, 0.5 m: a
narrow sink, two rings, and nothing higher than the worktop but the wall cabinets.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.groups.kitchen import (
    BEYOND,
    UNIT_DEPTH,
    WORKTOP_HEIGHT,
    Unit,
    fill,
    hang_above,
)
from scenewright.domains.home.groups.low_fridges import LOW, SHORTEST, pantry
from scenewright.domains.home.least_sizes import HOB, SINK
from scenewright.domains.home.measures import ROUNDING

WIDTHS = (1.65, 1.6, 1.5, 1.35, SHORTEST, 1.1, 1.0, 0.9, 0.8)
SLIM_DEPTH = 0.5
"""Depth of units where those of 0.6 m leave no way past them, metres."""
DRAINER = 0.6  # width of a small sink with a draining board, metres


def mini_kitchens() -> Iterator[Group]:
    """The widest first, of each width the deeper first."""
    for width in WIDTHS:
        units = pantry(width) if width >= SHORTEST - ROUNDING else bare(width)
        for depth in (UNIT_DEPTH, SLIM_DEPTH):
            yield _in_row(units, width, depth)


def bare(length: float) -> list[Unit]:
    """Sink and hob in less than 1.3 m: with 0.3 m of worktop between them, else with a draining
    board.

    >>> [(name, round(wide, 2)) for name, wide in bare(1.1)]
    [('sink_cabinet', 0.5), ('drawer_cabinet', 0.3), ('hob_cabinet', 0.3)]
    >>> [(name, round(wide, 2)) for name, wide in bare(0.8)]
    [('sink_cabinet', 0.5), ('hob_cabinet', 0.3)]
    """
    spare = length - SINK.width - HOB.width
    if spare < BEYOND - ROUNDING:
        sink = min(length - HOB.width, DRAINER)
        return [("sink_cabinet", sink), ("hob_cabinet", length - sink)]
    return [("sink_cabinet", SINK.width), *fill(spare), ("hob_cabinet", HOB.width)]


def _in_row(units: list[Unit], width: float, depth: float) -> Group:
    """Units of ``depth`` side by side, and what hangs above them."""
    members: list[Member] = []
    at, back = -width / 2, -(depth + 0.01) / 2
    for unit, wide in units:
        name, x = ("fridge" if unit == LOW else unit), at + wide / 2
        members.append(Member(name, x, back + depth / 2, 0, 0, Size(wide, depth, WORKTOP_HEIGHT)))
        members += hang_above(unit, x, wide, back)
        at += wide
    function = "kitchen" if any(unit == LOW for unit, _ in units) else "kitchenette"
    return Group(function, f"{width:.2f} m mini kitchen", width, depth + 0.01, tuple(members))
