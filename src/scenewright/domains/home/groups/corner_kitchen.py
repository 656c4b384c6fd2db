"""Kitchens round a corner: the hob in the run along one wall, the sink in the wing along the next.

The patch is that of the run; the wing reaches out of it along the wall beside, so that floor in
front of the run stays floor. What stands where is tested piece by piece.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.groups.kitchen import (
    BEYOND,
    FRIDGE,
    UNIT_DEPTH,
    WORKTOP,
    Unit,
    fill,
    hang_above,
)

CORNER = 1.0  # width and depth of the cabinet round the corner, in which one stands, metres
PAIRS = ((0.6, 0.8), (0.6, 0.6), (0.45, 0.6), (0.3, 0.45))
"""Widths of hob and sink, metres."""


def corner_kitchens() -> Iterator[Group]:
    """Complete kitchens round a corner, 1.6 to 3.4 m along the one wall and 1.45 to 3.0 m along the
    other, the corner left and right, the fridge at either end."""
    for (hob, sink), before, end in product(PAIRS, (0.0, 0.3, 0.6), (BEYOND, 0.6)):
        for more, fridge_last in product((0.0, 0.6), (True, False)):
            run = [*fill(before), ("hob_cabinet", hob), *fill(end)]
            wing = [("sink_cabinet", sink), *fill(more)]
            (run if fridge_last else wing).append(("fridge", FRIDGE.width))
            for mirrored in (False, True):
                yield _corner(run, wing, mirrored)


def corner_kitchenettes() -> Iterator[Group]:
    """The same without a fridge, 1.6 to 2.8 m by 1.45 to 2.4 m."""
    for (hob, sink), end, more in product(PAIRS, (BEYOND, 0.6), (0.0, 0.6)):
        run = [("hob_cabinet", hob), *fill(end)]
        for mirrored in (False, True):
            wing = [("sink_cabinet", sink), *fill(more)]
            yield _corner(run, wing, mirrored)._replace(function="kitchenette")


def _corner(run: list[Unit], wing: list[Unit], mirrored: bool) -> Group:
    """One with its corner on the left, or its mirror image."""
    width = CORNER + sum(wide for _, wide in run)
    depth = max(UNIT_DEPTH, FRIDGE.depth) + 0.01
    left, back = -width / 2, -depth / 2
    size = Size(CORNER, CORNER, WORKTOP)
    middle = CORNER / 2
    turn = pi / 2 if mirrored else 0.0  # the angle of the cabinet's worktop is back left
    members = [Member("corner_cabinet", left + middle, back + middle, 0, -turn, size)]
    at = left + CORNER
    for category, wide in run:
        members += _unit(category, at + wide / 2, back, wide)
        at += wide
    at = back + CORNER
    for category, wide in wing:
        size = FRIDGE if category == "fridge" else Size(wide, UNIT_DEPTH, WORKTOP)
        members.append(Member(category, left + size.depth / 2, at + wide / 2, 0, -pi / 2, size))
        at += wide
    if mirrored:
        members = [m._replace(x=-m.x, heading=-m.heading) for m in members]
    name = f"{width:.1f} by {at - back:.1f} m kitchen round a corner"
    return Group("kitchen", name, width, depth, tuple(members))


def _unit(category: str, x: float, back: float, wide: float) -> list[Member]:
    """A unit of the run with what hangs above it."""
    if category == "fridge":
        return [Member("fridge", x, back + FRIDGE.depth / 2, 0, 0, FRIDGE)]
    unit = Member(category, x, back + UNIT_DEPTH / 2, 0, 0, Size(wide, UNIT_DEPTH, WORKTOP))
    return [unit, *hang_above(category, x, wide, back)]
