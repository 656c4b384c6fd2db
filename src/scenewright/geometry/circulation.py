"""Terms of circulation: the walking route from the door to the side each item is used from."""

from __future__ import annotations

from scenewright.geometry.boxes import Floats, Frame, Sides, beyond, part_of, read_frame, read_sides
from scenewright.geometry.compiled import inlined
from scenewright.geometry.flood import Bits, flood
from scenewright.geometry.paths import CLEAR, LOOK, RouteGrid, sweep_box

REACH = 0.2


@inlined
def solid_part(frame: Frame, inset: Sides) -> Frame:
    """The box less its walkable insets (front, left, back, right)."""
    w = max(frame[4] - 0.5 * (inset[1] + inset[3]), 0.0)
    d = max(frame[5] - 0.5 * (inset[0] + inset[2]), 0.0)
    return part_of(frame, 0.5 * (inset[1] - inset[3]), 0.5 * (inset[2] - inset[0]), w, d)


@inlined
def is_reached(frame: Frame, access: Sides, reached: Bits, grid: RouteGrid) -> bool:
    """True if some reached cell lies beside one of the sides it is used from (``access`` above 0),
    or none is asked, and beside each it has to be used from (above 1)."""
    asked, found = False, False
    for side in range(4):
        must = access[side] > 1.0
        if must or (access[side] > 0.0 and not found):
            asked = True
            zone = beyond(frame, side, grid.radius - 0.5 * grid.cell + REACH)
            if sweep_box(reached, grid, zone, 0.0, LOOK):
                found = True
            elif must:
                return False
    return found or not asked


@inlined
def route(
    frames: Floats,
    access: Floats,
    inset: Floats,
    grid: RouteGrid,
    free: Bits,
    reached: Bits,
    most: float,
) -> float:
    """Items not reached plus doors not joined to the first door, by a route of the stated width.

    A flood fill from the first door over the cells where a disc of the route's width fits; an
    item is reached if a filled cell lies within half the width + 0.2 m of a side it is used
    from. ``access`` and ``inset`` (n, 4) are the items'; ``free`` and ``reached`` scratch
    (h, k). A room without doors has nothing to reach. Counting stops over ``most``.
    """
    doors = grid.doors.shape[0]
    if doors == 0:
        return 0.0
    for row in range(free.shape[0]):
        for word in range(free.shape[1]):
            free[row, word] = grid.free[row, word]
            reached[row, word] = grid.doors[0, row, word]
    for i in range(frames.shape[0]):
        solid = solid_part(read_frame(frames, i), read_sides(inset, i))
        sweep_box(free, grid, solid, grid.radius, CLEAR)
    flood(reached, free)
    return count_missed(frames, access, inset, grid, reached, most)


@inlined
def count_missed(
    frames: Floats, access: Floats, inset: Floats, grid: RouteGrid, reached: Bits, most: float
) -> float:
    """Doors and items without a ``reached`` cell (h, k), as :func:`route` counts them."""
    missed = 0.0
    for k in range(1, grid.doors.shape[0]):
        joined = False
        for row in range(reached.shape[0]):
            for word in range(reached.shape[1]):
                joined |= (reached[row, word] & grid.doors[k, row, word]) != 0
        missed += 0.0 if joined else 1.0
        if missed > most:
            return missed
    return add_unreached(missed, frames, access, inset, grid, reached, most)


@inlined
def add_unreached(
    missed: float,
    frames: Floats,
    access: Floats,
    inset: Floats,
    grid: RouteGrid,
    reached: Bits,
    most: float,
) -> float:
    """What is ``missed`` so far and the items without a ``reached`` cell (h, k) at their sides."""
    for i in range(frames.shape[0]):
        solid = solid_part(read_frame(frames, i), read_sides(inset, i))
        missed += 0.0 if is_reached(solid, read_sides(access, i), reached, grid) else 1.0
        if missed > most:
            return missed
    return missed
