"""The walking route of a chain with the cells each item takes kept, so that a move costs little.

One item moves at a time: only its cells are found anew, those of all others are kept. What was
reached before is reached still unless something stands there now, so most floods begin where the
last one ended, and where the same cells are free none is needed. Which cells are reached depends
on the free ones alone: the count is that of :func:`scenewright.geometry.circulation.route`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import Floats, Frame, Sides, read_frame, read_sides
from scenewright.geometry.circulation import add_unreached, solid_part
from scenewright.geometry.compiled import inlined
from scenewright.geometry.flood import NONE, Bits, flood
from scenewright.geometry.paths import SET, RouteGrid, sweep_box


class KeptRoute(NamedTuple):
    """The cells ``taken`` (n, c) by each item, in words row after row; those of the item last
    ``tried``, those that were ``free`` when last looked at and of these the ``reached`` ones
    (h, k each). ``rows`` (5, c) are these three again, as words row after row, the free cells of
    the empty room, and scratch; ``doors`` (d, c) are the cells of the doors."""

    taken: NDArray[np.uint64]
    tried: Bits
    free: Bits
    reached: Bits
    rows: NDArray[np.uint64]
    doors: NDArray[np.uint64]


TRIED, FREE, REACHED, EMPTY, NOW = range(5)


def make_route(n: int, grid: RouteGrid) -> KeptRoute:
    """Room for the route among ``n`` items."""
    size = grid.free.size
    rows, taken = np.zeros((5, size), np.uint64), np.zeros((n, size), np.uint64)
    rows[EMPTY], doors = grid.free.ravel(), grid.doors.reshape(len(grid.doors), size)
    tried, free, reached = rows[:3].reshape(3, *grid.free.shape)
    return KeptRoute(taken, tried, free, reached, rows, doors)


@inlined
def try_cells(kept: KeptRoute, grid: RouteGrid, frame: Frame, inset: Sides) -> None:
    """Find the cells that an item at ``frame`` takes."""
    for c in range(kept.rows.shape[1]):
        kept.rows[TRIED, c] = NONE
    sweep_box(kept.tried, grid, solid_part(frame, inset), grid.radius, SET)


@inlined
def keep_cells(kept: KeptRoute, i: int) -> None:
    """Take over the cells last tried for item ``i``."""
    for c in range(kept.rows.shape[1]):
        kept.taken[i, c] = kept.rows[TRIED, c]


@inlined
def keep_all(kept: KeptRoute, grid: RouteGrid, frames: Floats, inset: Floats) -> None:
    """Find and keep the cells of all items."""
    for i in range(frames.shape[0]):
        try_cells(kept, grid, read_frame(frames, i), read_sides(inset, i))
        keep_cells(kept, i)


@inlined
def flood_again(kept: KeptRoute, i: int) -> None:
    """What is reached with item ``i`` on the cells tried."""
    rows, changed, lost = kept.rows, NONE, NONE
    for c in range(rows.shape[1]):
        rows[NOW, c] = rows[EMPTY, c] & ~rows[TRIED, c]
    for j in range(kept.taken.shape[0]):
        if j != i:
            for c in range(rows.shape[1]):
                rows[NOW, c] &= ~kept.taken[j, c]
    for c in range(rows.shape[1]):
        changed |= rows[NOW, c] ^ rows[FREE, c]
        lost |= rows[REACHED, c] & ~rows[NOW, c]
        rows[FREE, c] = rows[NOW, c]
    if changed == NONE:
        return
    for c in range(rows.shape[1]):
        rows[REACHED, c] = (rows[REACHED, c] if lost == NONE else NONE) | kept.doors[0, c]
    flood(kept.reached, kept.free)


@inlined
def count_unreached(
    kept: KeptRoute,
    i: int,
    frames: Floats,
    access: Floats,
    inset: Floats,
    grid: RouteGrid,
    most: float,
) -> float:
    """:func:`scenewright.geometry.circulation.route` after a move of item ``i`` to where it stands
    in ``frames`` (n, 8)."""
    if grid.doors.shape[0] == 0:
        return 0.0
    try_cells(kept, grid, read_frame(frames, i), read_sides(inset, i))
    flood_again(kept, i)
    missed = 0.0
    for k in range(1, kept.doors.shape[0]):
        met = NONE
        for c in range(kept.rows.shape[1]):
            met |= kept.rows[REACHED, c] & kept.doors[k, c]
        missed += 1.0 if met == NONE else 0.0
    if missed > most:
        return missed
    return add_unreached(missed, frames, access, inset, grid, kept.reached, most)
