"""Flood fill over bits: rows of words of 64 cells, a word at a time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Bits = NDArray[np.uint64]
NONE = np.uint64(0)


@inlined
def spread(seed: np.uint64, free: np.uint64) -> np.uint64:
    """Grow set bits both ways along the free bits of one word; they are free themselves.

    Upward by one addition: the carry of a set bit runs to the end of its stretch of free bits.
    Downward, where anything is left to gain, by doubling steps.
    """
    grown = (((free + seed) ^ free) | seed) & free
    if ((grown >> np.uint64(1)) & free & ~grown) != NONE:
        open_ = free
        for power in range(6):
            step = np.uint64(1 << power)
            grown |= open_ & (grown >> step)
            open_ &= open_ >> step
    return grown


@inlined
def fill_row(reached: Bits, free: Bits, row: int, source: int) -> bool:
    """Take over what is reached in the row ``source`` and grow it; true if anything was gained."""
    gained, count = False, free.shape[1]
    for k in range(count):
        seed = reached[row, k] | (reached[source, k] & free[row, k])
        if k > 0:
            seed |= (reached[row, k - 1] >> np.uint64(63)) & free[row, k]
        if seed != reached[row, k]:
            reached[row, k] = spread(seed, free[row, k])
            gained = True
    for k in range(count - 2, -1, -1):
        seed = reached[row, k] | ((reached[row, k + 1] << np.uint64(63)) & free[row, k])
        if seed != reached[row, k]:
            reached[row, k] = spread(seed, free[row, k])
            gained = True
    return gained


@inlined
def carry(reached: Bits, free: Bits, row: int, source: int) -> bool:
    """:func:`fill_row` where a row is one word."""
    seed = reached[row, 0] | (reached[source, 0] & free[row, 0])
    if seed == reached[row, 0]:
        return False
    reached[row, 0] = spread(seed, free[row, 0])
    return True


@inlined
def flood_narrow(reached: Bits, free: Bits) -> None:
    """:func:`flood` where a row is one word, as in all but wide rooms: about twice as fast."""
    rows, first, last = free.shape[0], free.shape[0], -1
    for row in range(rows):
        seed = reached[row, 0] & free[row, 0]
        reached[row, 0] = spread(seed, free[row, 0]) if seed != NONE else NONE
        if seed != NONE:
            first, last = min(first, row), row
    gained, turn = last >= 0, 0
    while gained or turn == 1:
        gained = False
        row = first + 1 if turn % 2 == 0 else last - 1
        while turn % 2 == 0 and row < rows and row <= last + 1:
            if carry(reached, free, row, row - 1):
                gained, last = True, max(last, row)
            row += 1
        while turn % 2 == 1 and row >= 0 and row >= first - 1:
            if carry(reached, free, row, row + 1):
                gained, first = True, min(first, row)
            row -= 1
        turn += 1


@compiled
def flood(reached: Bits, free: Bits) -> None:
    """Grow the set cells of ``reached`` over the free cells, four neighbours, in place.

    Sweeps go down and up by turns, from the first to the last row that holds a set cell and on
    for as long as they gain; the first that gains nothing is the last.
    """
    rows, first, last = free.shape[0], free.shape[0], -1
    if free.shape[1] == 1:
        flood_narrow(reached, free)
        return
    for row in range(rows):
        for k in range(free.shape[1]):
            seed = reached[row, k] & free[row, k]
            if reached[row, k] != NONE:
                reached[row, k] = spread(seed, free[row, k])
            if seed != NONE:
                first, last = min(first, row), row
    for row in range(first, last + 1):
        fill_row(reached, free, row, row)
    gained, turn = last >= 0, 0
    while gained or turn == 1:
        gained = False
        if turn % 2 == 0:
            row = first + 1
            while row < rows and (row <= last + 1):
                grown = fill_row(reached, free, row, row - 1)
                gained |= grown
                last = max(last, row) if grown else last
                row += 1
        else:
            row = last - 1
            while row >= 0 and row >= first - 1:
                grown = fill_row(reached, free, row, row + 1)
                gained |= grown
                first = min(first, row) if grown else first
                row -= 1
        turn += 1
