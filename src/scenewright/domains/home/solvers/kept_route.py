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
from scenewright.geometry.circulation import count_missed, solid_part
from scenewright.geometry.compiled import inlined
from scenewright.geometry.flood import NONE, Bits, flood
from scenewright.geometry.paths import SET, RouteGrid, sweep_box


class KeptRoute(NamedTuple):
    """The cells ``taken`` (n, h, k) by each item and by the one last ``tried`` (h, k); those that
    were ``free`` when last looked at (h, k), and of these the ``reached`` ones (h, k)."""

    taken: NDArray[np.uint64]
    tried: Bits
    free: Bits
    reached: Bits


def make_route(n: int, grid: RouteGrid) -> KeptRoute:
    """Room for the route among ``n`` items."""
    shape = grid.free.shape
    sizes = ((n, *shape), shape, shape, shape)
    return KeptRoute(*(np.zeros(size, np.uint64) for size in sizes))


@inlined
def try_cells(kept: KeptRoute, grid: RouteGrid, frame: Frame, inset: Sides) -> None:
    """Find the cells that an item at ``frame`` takes."""
    for row in range(kept.tried.shape[0]):
        for word in range(kept.tried.shape[1]):
            kept.tried[row, word] = NONE
    sweep_box(kept.tried, grid, solid_part(frame, inset), grid.radius, SET)


@inlined
def keep_cells(kept: KeptRoute, i: int) -> None:
    """Take over the cells last tried for item ``i``."""
    for row in range(kept.tried.shape[0]):
        for word in range(kept.tried.shape[1]):
            kept.taken[i, row, word] = kept.tried[row, word]


@inlined
def keep_all(kept: KeptRoute, grid: RouteGrid, frames: Floats, inset: Floats) -> None:
    """Find and keep the cells of all items."""
    for i in range(frames.shape[0]):
        try_cells(kept, grid, read_frame(frames, i), read_sides(inset, i))
        keep_cells(kept, i)


@inlined
def flood_again(kept: KeptRoute, grid: RouteGrid, i: int) -> None:
    """What is reached with item ``i`` on the cells tried."""
    same, within = True, True
    for row in range(kept.free.shape[0]):
        for word in range(kept.free.shape[1]):
            taken = kept.tried[row, word]
            for j in range(kept.taken.shape[0]):
                taken |= kept.taken[j, row, word] if j != i else NONE
            free = grid.free[row, word] & ~taken
            same &= free == kept.free[row, word]
            within &= (kept.reached[row, word] & ~free) == NONE
            kept.free[row, word] = free
    if same:
        return
    for row in range(kept.free.shape[0]):
        for word in range(kept.free.shape[1]):
            before = kept.reached[row, word] if within else NONE
            kept.reached[row, word] = before | grid.doors[0, row, word]
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
    flood_again(kept, grid, i)
    return count_missed(frames, access, inset, grid, kept.reached, most)
