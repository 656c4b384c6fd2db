"""Where a body of a given width can walk: a grid of bits, filled row by row.

A cell is free if a disc at its centre, half the route wide and half a cell more, touches nothing.
The extra half cell makes it conservative: between two free neighbours the way is free as well.
Rows are words of 64 cells, filled by :mod:`.flood`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.geometry.boxes import Floats, Frame, make_frame, part_of, read_frame
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.flood import NONE, Bits

ALL = np.uint64(0xFFFFFFFFFFFFFFFF)
SQUARE = 1e-12
# Plain integers would make numba compile each function once for every value.
CLEAR, SET, LOOK = np.int64(0), np.int64(1), np.int64(2)


class RouteGrid(NamedTuple):
    """Corner ``x0, y0`` and ``cell`` size in metres, ``radius`` things are kept off by,
    ``free`` (h, k) bits of cells free of walls and fixed pieces, ``doors`` (d, h, k)."""

    x0: float
    y0: float
    cell: float
    radius: float
    free: Bits
    doors: Bits


@inlined
def square_span(
    x: float, dy: float, along: float, across: float, radius: float
) -> tuple[float, float]:
    """:func:`rounded_span` of a box square to the grid, as most are: ``dy`` above its middle, which
    is at ``x``, of half width ``along`` a row and half depth ``across`` it."""
    over = max(abs(dy) - across, 0.0)
    if over > radius:
        return math.inf, -math.inf
    along += math.sqrt(radius * radius - over * over)
    return x - along, x + along


@compiled
def rounded_span(frame: Frame, radius: float, y: float) -> tuple[float, float]:
    """Least and greatest x at height ``y`` within ``radius`` of a box; (inf, -inf) if none.

    The box grown by a disc is convex, so a row of it is one interval: its ends lie on a corner's
    circle or on an edge moved out by the radius.
    """
    low, high = math.inf, -math.inf
    x, c, s, w, d = frame[0], frame[2], frame[3], frame[4], frame[5]
    dy = y - frame[1]
    if abs(c) < SQUARE or abs(s) < SQUARE:
        along, across = (w, d) if abs(c) < abs(s) else (d, w)
        return square_span(x, dy, along, across, radius)
    for _quarter in range(4):  # the edge ahead: outward normal (c, s), from its right end leftward
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


@inlined
def word_mask(first: int, last: int, word: int) -> np.uint64:
    """Bits of one word for the cells ``first`` to ``last`` of a row."""
    low, high = max(first - 64 * word, 0), min(last - 64 * word, 63)
    if low > high:
        return NONE
    return (ALL << np.uint64(low)) & (ALL >> np.uint64(63 - high))


@inlined
def cells_within(low: float, high: float, x0: float, scale: float, most: int) -> tuple[int, int]:
    """First and last of the ``most`` cells of a row whose centres lie in [low, high]; ``scale`` of
    them make a metre."""
    if not (low <= high):
        return 0, -1
    first = max(math.ceil((low - x0) * scale - 0.5), 0)
    return first, min(math.floor((high - x0) * scale - 0.5), most - 1)


@inlined
def sweep_word(bits: Bits, row: int, k: int, mask: np.uint64, task: np.int64) -> bool:
    """Clear (0), set (1) or only look at (2) some cells of a word; true if one of them was set
    before."""
    before = bits[row, k]
    if task == CLEAR:
        bits[row, k] = before & ~mask
    elif task == SET:
        bits[row, k] = before | mask
    return (before & mask) != NONE


@inlined
def sweep_cells(bits: Bits, row: int, first: int, last: int, task: np.int64) -> bool:
    """The same for the cells of a row from ``first`` to ``last``."""
    met = False
    for k in range(first >> 6, (last >> 6) + 1 if last >= first else 0):
        met |= sweep_word(bits, row, k, word_mask(first, last, k), task)
    return met


@inlined
def sweep_box(bits: Bits, grid: RouteGrid, frame: Frame, radius: float, task: np.int64) -> bool:
    """Clear (0), set (1) or only look at (2) the cells whose centres lie within ``radius`` of a
    box; true if one of them was set before.

    Between the ends of a box that stands square to the grid all rows are alike.
    """
    tall = abs(frame[2]) * frame[4] + abs(frame[3]) * frame[5]
    square = min(abs(frame[2]), abs(frame[3])) < SQUARE
    first = math.floor((frame[1] - tall - radius - grid.y0) / grid.cell - 0.5)
    end = math.ceil((frame[1] + tall + radius - grid.y0) / grid.cell + 0.5)
    met, known, a, b, mask, narrow = False, False, 0, -1, NONE, bits.shape[1] == 1
    scale = 1.0 / grid.cell
    w, d = frame[4], frame[5]
    along, across = (w, d) if abs(frame[2]) < abs(frame[3]) else (d, w)
    for row in range(max(first, 0), min(end, bits.shape[0])):
        y = grid.y0 + (row + 0.5) * grid.cell
        alike = square and abs(y - frame[1]) <= tall
        if not (alike and known):
            if square:
                low, high = square_span(frame[0], y - frame[1], along, across, radius)
            else:
                low, high = rounded_span(frame, radius, y)
            a, b = cells_within(low, high, grid.x0, scale, 64 * bits.shape[1])
            mask, known = word_mask(a, b, 0), alike
        if narrow:
            met |= sweep_word(bits, row, 0, mask, task)
        else:
            met |= sweep_cells(bits, row, a, b, task)
        if met and task == LOOK:
            break
    return met


@inlined
def mark_inside(bits: Bits, grid: RouteGrid, edges: Floats) -> None:
    """Set the cells whose centres lie inside the outline and outside the holes.

    Every edge a row crosses flips all cells to its right. ``bits`` (h, k) words of cells,
    ``edges`` (e, 4) x0, y0, x1, y1 in metres.
    """
    for row in range(bits.shape[0]):
        y = grid.y0 + (row + 0.5) * grid.cell
        for e in range(edges.shape[0]):
            if (edges[e, 1] <= y) != (edges[e, 3] <= y):
                share = (y - edges[e, 1]) / (edges[e, 3] - edges[e, 1])
                x = edges[e, 0] + share * (edges[e, 2] - edges[e, 0])
                first = max(math.ceil((x - grid.x0) / grid.cell - 0.5), 0)
                for k in range(first >> 6, bits.shape[1]):
                    bits[row, k] ^= word_mask(first, 64 * bits.shape[1], k)


@inlined
def share_in_box(edge: Floats, frame: Frame) -> tuple[float, float]:
    """Part [t0, t1] of an edge x0, y0, x1, y1 that lies in a box; t0 >= t1 if none.

    ``edge`` (4,) in metres.
    """
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


@inlined
def clear_wall(bits: Bits, grid: RouteGrid, edge: Floats, doors: Floats) -> None:
    """Clear the cells near an edge, leaving out its parts in door boxes (at least as wide as
    the route).

    ``bits`` (h, k) words of cells, ``edge`` (4,), ``doors`` (d, 8) frames; metres.
    """
    here = 0.0
    while here < 1.0:
        stop, after = 1.0, 1.0
        for k in range(doors.shape[0]):
            door = read_frame(doors, k)
            wide = part_of(door, 0.0, 0.0, max(door[4], grid.radius + grid.cell), door[5])
            t0, t1 = share_in_box(edge, wide)
            if t1 > max(t0, here) and t0 < stop:
                stop, after = max(t0, here), t1
        ax, ay = edge[0] + here * (edge[2] - edge[0]), edge[1] + here * (edge[3] - edge[1])
        bx, by = edge[0] + stop * (edge[2] - edge[0]), edge[1] + stop * (edge[3] - edge[1])
        length = math.sqrt((bx - ax) ** 2 + (by - ay) ** 2)
        if stop > here:
            heading = math.atan2(by - ay, bx - ax)
            part = make_frame(0.5 * (ax + bx), 0.5 * (ay + by), heading, 0.0, length)
            sweep_box(bits, grid, part, grid.radius, CLEAR)
        here = after


@compiled
def fill_grid(edges: Floats, obstacles: Floats, doors: Floats, grid: RouteGrid) -> None:
    """Write what is free of walls and fixed pieces, and the cells of the doors.

    ``obstacles`` and ``doors`` are frames (k, 8). A door box is free of its own wall.
    """
    mark_inside(grid.free, grid, edges)
    for e in range(edges.shape[0]):
        clear_wall(grid.free, grid, edges[e], doors)
    for k in range(doors.shape[0]):
        sweep_box(grid.free, grid, read_frame(doors, k), 0.0, SET)
        sweep_box(grid.doors[k], grid, read_frame(doors, k), 0.0, SET)
    for k in range(obstacles.shape[0]):
        sweep_box(grid.free, grid, read_frame(obstacles, k), grid.radius, CLEAR)


def make_grid(
    edges: Floats, obstacles: Floats, doors: Floats, bounds: Floats, cell: float, width: float
) -> RouteGrid:
    """The grid of a room for a route of some width: over its bounds (x0, y0, x1, y1) and doors.

    ``edges`` (e, 4), ``obstacles`` and ``doors`` as frames (k, 8). Without doors it is empty.
    """
    if not len(doors):
        return RouteGrid(
            0.0,
            0.0,
            cell,
            0.5 * width + 0.5 * cell,
            np.zeros((0, 0), np.uint64),
            np.zeros((0, 0, 0), np.uint64),
        )
    low = np.minimum(bounds[:2], (doors[:, :2] - doors[:, 6:7]).min(axis=0))
    high = np.maximum(bounds[2:], (doors[:, :2] + doors[:, 6:7]).max(axis=0))
    columns, rows = (np.ceil((high - low) / cell).astype(int) + 1).tolist()
    shape = (rows, (columns + 63) // 64)
    grid = RouteGrid(
        float(low[0]),
        float(low[1]),
        cell,
        0.5 * width + 0.5 * cell,
        np.zeros(shape, np.uint64),
        np.zeros((len(doors), *shape), np.uint64),
    )
    fill_grid(edges, obstacles, doors, grid)
    return grid
