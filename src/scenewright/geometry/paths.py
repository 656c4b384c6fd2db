"""Where a body of a given width can walk: a grid of bits, filled row by row.

A cell is free if a disc at its centre, half the route wide and half a cell more, touches nothing.
The extra half cell makes it conservative: between two free neighbours the way is free as well.
Rows are words of 64 cells, so a flood fill handles 64 cells at a time.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import Floats, Frame, make_frame, part_of, read_frame
from scenewright.geometry.compiled import compiled, compiled_entry

Bits = NDArray[np.uint64]
ALL = np.uint64(0xFFFFFFFFFFFFFFFF)
NONE = np.uint64(0)
ONE = np.uint64(1)


class Grid(NamedTuple):
    """Corner ``x0, y0`` and ``cell`` size in metres, ``radius`` things are kept off by,
    ``free`` (h, k) bits of cells free of walls and fixed pieces, ``doors`` (d, h, k)."""

    x0: float
    y0: float
    cell: float
    radius: float
    free: Bits
    doors: Bits


@compiled
def rounded_span(frame: Frame, radius: float, y: float) -> tuple[float, float]:
    """Least and greatest x at height ``y`` within ``radius`` of a box; (inf, -inf) if none.

    The box grown by a disc is convex, so a row of it is one interval: its ends lie on a corner's
    circle or on an edge moved out by the radius.
    """
    low, high = math.inf, -math.inf
    x, c, s, w, d = frame[0], frame[2], frame[3], frame[4], frame[5]
    dy = y - frame[1]
    for quarter in range(4):  # the edge ahead: outward normal (c, s), from its right end leftward
        px, py = s * w + c * d, -c * w + s * d
        qx, qy = -s * w + c * d, c * w + s * d
        rest = radius * radius - (dy - py) ** 2
        if rest >= 0.0:
            reach = math.sqrt(rest)
            low, high = min(low, px - reach), max(high, px + reach)
        py, qy = py + radius * s, qy + radius * s
        if (py <= dy) != (qy <= dy):
            cross = px + radius * c + (qx - px) * (dy - py) / (qy - py)
            low, high = min(low, cross), max(high, cross)
        c, s = -s, c
        w, d = d, w
    return x + low, x + high


@compiled
def word_mask(first: int, last: int, word: int) -> np.uint64:
    """Bits of one word for the cells ``first`` to ``last`` of a row."""
    low, high = max(first - 64 * word, 0), min(last - 64 * word, 63)
    if low > high:
        return NONE
    return (ALL << np.uint64(low)) & (ALL >> np.uint64(63 - high))


@compiled
def mark_span(
    bits: Bits, row: int, low: float, high: float, x0: float, cell: float, put: bool
) -> None:
    """Set or clear the cells of a row whose centres lie in [low, high]."""
    count = bits.shape[1]
    if not (low <= high):
        return
    first = max(int(math.ceil((low - x0) / cell - 0.5)), 0)
    last = min(int(math.floor((high - x0) / cell - 0.5)), 64 * count - 1)
    for k in range(first >> 6, (last >> 6) + 1 if last >= first else 0):
        mask = word_mask(first, last, k)
        if put:
            bits[row, k] |= mask
        else:
            bits[row, k] &= ~mask


@compiled
def rows_of(frame: Frame, radius: float, y0: float, cell: float, count: int) -> tuple[int, int]:
    """First row and end of the rows a grown box may touch."""
    tall = abs(frame[2]) * frame[4] + abs(frame[3]) * frame[5] + radius
    first = int(math.floor((frame[1] - tall - y0) / cell - 0.5))
    return max(first, 0), min(int(math.ceil((frame[1] + tall - y0) / cell + 0.5)), count)


@compiled
def mark_box(
    bits: Bits, x0: float, y0: float, cell: float, frame: Frame, radius: float, put: bool
) -> None:
    """Set or clear the cells whose centres lie within ``radius`` of a box."""
    first, end = rows_of(frame, radius, y0, cell, bits.shape[0])
    for row in range(first, end):
        low, high = rounded_span(frame, radius, y0 + (row + 0.5) * cell)
        mark_span(bits, row, low, high, x0, cell, put)


@compiled
def touches(bits: Bits, x0: float, y0: float, cell: float, frame: Frame) -> bool:
    """True if the centre of some set cell lies in a box."""
    first, end = rows_of(frame, 0.0, y0, cell, bits.shape[0])
    for row in range(first, end):
        low, high = rounded_span(frame, 0.0, y0 + (row + 0.5) * cell)
        if low <= high:
            left = max(int(math.ceil((low - x0) / cell - 0.5)), 0)
            right = min(int(math.floor((high - x0) / cell - 0.5)), 64 * bits.shape[1] - 1)
            for k in range(left >> 6, (right >> 6) + 1 if right >= left else 0):
                if bits[row, k] & word_mask(left, right, k) != NONE:
                    return True
    return False


@compiled
def spread(seed: np.uint64, free: np.uint64) -> np.uint64:
    """Grow set bits both ways along the free bits of one word."""
    up, down, up_free, down_free = seed, seed, free, free
    for power in range(6):
        step = np.uint64(1 << power)
        up |= up_free & (up << step)
        down |= down_free & (down >> step)
        up_free &= up_free << step
        down_free &= down_free >> step
    return up | down


@compiled
def fill_row(reached: Bits, free: Bits, row: int, source: int) -> bool:
    """Take over what is reached in the row ``source`` and grow it; true if anything was gained."""
    gained = False
    count = free.shape[1]
    for turn in range(2 * count):
        k = turn if turn < count else 2 * count - 1 - turn
        seed = reached[row, k] | (reached[source, k] & free[row, k])
        if k > 0:
            seed |= (reached[row, k - 1] >> np.uint64(63)) & free[row, k]
        if k + 1 < count:
            seed |= (reached[row, k + 1] << np.uint64(63)) & free[row, k]
        if seed != reached[row, k]:
            reached[row, k] = spread(seed, free[row, k])
            gained = True
    return gained


@compiled
def flood(reached: Bits, free: Bits) -> None:
    """Grow the set cells of ``reached`` over the free cells, four neighbours, in place."""
    rows = free.shape[0]
    for row in range(rows):
        for k in range(free.shape[1]):
            reached[row, k] = spread(reached[row, k] & free[row, k], free[row, k])
    gained = True
    while gained:
        gained = False
        for row in range(rows):
            gained |= fill_row(reached, free, row, max(row - 1, 0))
        for row in range(rows - 1, -1, -1):
            gained |= fill_row(reached, free, row, min(row + 1, rows - 1))


@compiled
def mark_inside(bits: Bits, x0: float, y0: float, cell: float, edges: Floats) -> None:
    """Set the cells whose centres lie inside the outline and outside the holes.

    Every edge a row crosses flips all cells to its right.
    """
    for row in range(bits.shape[0]):
        y = y0 + (row + 0.5) * cell
        for e in range(edges.shape[0]):
            if (edges[e, 1] <= y) != (edges[e, 3] <= y):
                share = (y - edges[e, 1]) / (edges[e, 3] - edges[e, 1])
                x = edges[e, 0] + share * (edges[e, 2] - edges[e, 0])
                first = max(int(math.ceil((x - x0) / cell - 0.5)), 0)
                for k in range(first >> 6, bits.shape[1]):
                    bits[row, k] ^= word_mask(first, 64 * bits.shape[1], k)


@compiled
def share_in_box(edge: Floats, frame: Frame) -> tuple[float, float]:
    """Part [t0, t1] of an edge x0, y0, x1, y1 that lies in a box; t0 >= t1 if none."""
    c, s = frame[2], frame[3]
    px, py, qx, qy = edge[0] - frame[0], edge[1] - frame[1], edge[2] - edge[0], edge[3] - edge[1]
    low, high = 0.0, 1.0
    for axis in range(2):
        a, b, half = (px * s - py * c, qx * s - qy * c, frame[4])
        if axis == 1:
            a, b, half = (px * c + py * s, qx * c + qy * s, frame[5])
        if abs(b) < 1e-12:
            if abs(a) > half:
                return 1.0, 0.0
        else:
            t0, t1 = (-half - a) / b, (half - a) / b
            low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
    return low, high


@compiled
def clear_wall(
    bits: Bits, x0: float, y0: float, cell: float, radius: float, edge: Floats, doors: Floats
) -> None:
    """Clear the cells near an edge, leaving out its parts in door boxes (at least as wide as
    the route)."""
    here = 0.0
    while here < 1.0:
        stop, after = 1.0, 1.0
        for k in range(doors.shape[0]):
            door = read_frame(doors, k)
            wide = part_of(door, 0.0, 0.0, max(door[4], radius + cell), door[5])
            t0, t1 = share_in_box(edge, wide)
            if t1 > max(t0, here) and t0 < stop:
                stop, after = max(t0, here), t1
        ax, ay = edge[0] + here * (edge[2] - edge[0]), edge[1] + here * (edge[3] - edge[1])
        bx, by = edge[0] + stop * (edge[2] - edge[0]), edge[1] + stop * (edge[3] - edge[1])
        length = math.sqrt((bx - ax) ** 2 + (by - ay) ** 2)
        if stop > here:
            heading = math.atan2(by - ay, bx - ax)
            part = make_frame(0.5 * (ax + bx), 0.5 * (ay + by), heading, 0.0, length)
            mark_box(bits, x0, y0, cell, part, radius, False)
        here = after


@compiled_entry
def make_grid(
    edges: Floats, obstacles: Floats, doors: Floats, bounds: Floats, cell: float, width: float
) -> Grid:
    """The grid of a room: what is free of walls and fixed pieces for a route of this width.

    ``obstacles`` and ``doors`` are frames (k, 8). A door box is free of its own wall.
    """
    x0, y0, x1, y1 = bounds[0], bounds[1], bounds[2], bounds[3]
    for k in range(doors.shape[0]):
        reach = doors[k, 6]
        x0, y0 = min(x0, doors[k, 0] - reach), min(y0, doors[k, 1] - reach)
        x1, y1 = max(x1, doors[k, 0] + reach), max(y1, doors[k, 1] + reach)
    rows = int(math.ceil((y1 - y0) / cell)) + 1
    words = (int(math.ceil((x1 - x0) / cell)) >> 6) + 1
    radius = 0.5 * width + 0.5 * cell
    free, ways = np.zeros((rows, words), np.uint64), np.zeros((len(doors), rows, words), np.uint64)
    mark_inside(free, x0, y0, cell, edges)
    for e in range(edges.shape[0]):
        clear_wall(free, x0, y0, cell, radius, edges[e], doors)
    for k in range(doors.shape[0]):
        mark_box(free, x0, y0, cell, read_frame(doors, k), 0.0, True)
        mark_box(ways[k], x0, y0, cell, read_frame(doors, k), 0.0, True)
    for k in range(obstacles.shape[0]):
        mark_box(free, x0, y0, cell, read_frame(obstacles, k), radius, False)
    return Grid(x0, y0, cell, radius, free, ways)
