"""Quickest ways over a raster: search, straighten, round off.

Going over a cell takes ``slow`` seconds a metre, infinite where nobody can walk. The travel time u
solves |∇u| = slow; here on the graph of eight neighbours (Dijkstra 1959; with a goal, A*: Hart,
Nilsson, Raphael 1968), and the way found is then pulled straight wherever that is no slower.
A search that stops at its goal looks at a small part of a hall, which sweeping over all of it
(Zhao 2005) cannot.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.distance_raster import DistanceRaster

Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]
FASTEST = 1.0  # least seconds a metre: what the search may hope for


class TravelSearch(NamedTuple):
    """State of a search over n cells: travel ``times`` (n,), the cell each was come ``before``
    from (-1: none), the number of the ``source`` it belongs to, and a heap of cells by key:
    ``keys`` and ``heap`` (n,), with the ``place`` of every cell in it."""

    times: Floats
    before: Ints
    source: Ints
    keys: Floats
    heap: Ints
    place: Ints


def make_search(cells: int) -> TravelSearch:
    """A search over ``cells`` cells, nothing reached yet."""
    numbers = np.full((4, cells), -1, np.int32)
    return TravelSearch(
        np.full(cells, np.inf), numbers[0], numbers[1], np.empty(cells), numbers[2], numbers[3]
    )


@inlined
def settle_in(search: TravelSearch, key: float, cell: int, hole: int) -> None:
    """Let a cell rise from a hole in the heap to where its key belongs."""
    while hole > 0:
        above = (hole - 1) >> 1
        if search.keys[above] <= key:
            break
        search.keys[hole], search.heap[hole] = search.keys[above], search.heap[above]
        search.place[search.heap[hole]] = hole
        hole = above
    search.keys[hole], search.heap[hole] = key, cell
    search.place[cell] = hole


@inlined
def take_first(search: TravelSearch, size: int) -> int:
    """Remove the cell of least key from a heap of ``size`` cells."""
    first, hole, end = search.heap[0], 0, size - 1
    key, cell = search.keys[end], search.heap[end]
    while 2 * hole + 1 < end:
        child = 2 * hole + 1
        if child + 1 < end and search.keys[child + 1] < search.keys[child]:
            child += 1
        if search.keys[child] >= key:
            break
        search.keys[hole], search.heap[hole] = search.keys[child], search.heap[child]
        search.place[search.heap[hole]] = hole
        hole = child
    search.keys[hole], search.heap[hole] = key, cell
    search.place[cell] = hole
    search.place[first] = -1
    return first


@compiled
def spread(search: TravelSearch, slow: Floats, cell: float, starts: Ints, goal: int) -> None:
    """Travel times from the nearest of the cells ``starts`` to every cell, or until ``goal`` (a
    cell, -1: none) is reached; ``slow`` (rows, columns), ``cell`` in metres."""
    columns, size = slow.shape[1], starts.shape[0]
    gx, gy = goal % columns, goal // columns
    hope = FASTEST * cell if goal >= 0 else 0.0
    for k in range(search.times.shape[0]):
        search.times[k] = math.inf
    for k in range(starts.shape[0]):
        search.times[starts[k]], search.before[starts[k]] = 0.0, -1
        search.source[starts[k]] = k
        x, y = starts[k] % columns, starts[k] // columns
        settle_in(search, hope * math.hypot(x - gx, y - gy), starts[k], k)
    while size > 0:
        here = take_first(search, size)
        size -= 1
        if here == goal:
            return
        row, column = here // columns, here % columns
        for near in range(9):
            r, c = row + near // 3 - 1, column + near % 3 - 1
            if near == 4 or r < 0 or c < 0 or r >= slow.shape[0] or c >= columns:
                continue
            length = cell * (1.0 if near % 2 == 1 else math.sqrt(2.0))
            time = search.times[here] + 0.5 * length * (slow[row, column] + slow[r, c])
            other = r * columns + c
            if time < search.times[other]:
                fresh = search.times[other] == math.inf
                hole = size if fresh else search.place[other]
                if hole < 0:
                    continue  # settled; less only by rounding
                size += 1 if fresh else 0
                search.times[other], search.before[other] = time, here
                search.source[other] = search.source[here]
                settle_in(search, time + hope * math.hypot(c - gx, r - gy), other, hole)


@inlined
def straight_time(slow: Floats, cell: float, a: int, b: int) -> float:
    """Seconds along the straight line between the centres of two cells.

    ``slow`` (rows, columns) in seconds a metre, ``cell`` in metres.
    """
    columns = slow.shape[1]
    ax, ay, bx, by = a % columns, a // columns, b % columns, b // columns
    steps = 2 * max(abs(bx - ax), abs(by - ay), 1)
    total = 0.0
    for k in range(steps):
        share = (k + 0.5) / steps
        r, c = int(ay + share * (by - ay) + 0.5), int(ax + share * (bx - ax) + 0.5)
        total += slow[r, c]
    return total / steps * cell * math.hypot(bx - ax, by - ay)


@compiled
def shorten(times: Floats, slow: Floats, cell: float, cells: Ints) -> None:
    """Lower travel times (n, n) between cells to those along straight lines."""
    for i in range(cells.shape[0]):
        for j in range(i):
            time = min(times[i, j], straight_time(slow, cell, cells[i], cells[j]))
            times[i, j], times[j, i] = time, time


@compiled
def mark_near(
    near: Flags, slow: Floats, cell: float, places: Ints, others: Ints, reach: float
) -> None:
    """Mark which of the ``others`` (m,) can be walked to from each of the ``places`` (k,)
    straight, over at most ``reach`` metres."""
    columns, most = slow.shape[1], (reach / cell) ** 2
    for i in range(places.shape[0]):
        for j in range(others.shape[0]):
            x = places[i] % columns - others[j] % columns
            y = places[i] // columns - others[j] // columns
            near[i, j] = (
                x * x + y * y <= most and straight_time(slow, cell, places[i], others[j]) < math.inf
            )


@compiled
def string_pull(path: Ints, slow: Floats, times: Floats, cell: float, kept: Ints) -> int:
    """Leave out cells of a path where the straight line is no slower; how many are ``kept``.

    ``path`` (k,) cells in order, ``times`` at each of them. From each cell kept the line is
    drawn to ever later ones, until a few in a row are slower than the path.
    """
    here, count = 0, 1
    kept[0] = path[0]
    while here < path.shape[0] - 1:
        best, ahead, slower = here + 1, here + 2, 0
        while ahead < path.shape[0] and slower < 8:
            if straight_time(slow, cell, path[here], path[ahead]) <= times[ahead] - times[here]:
                best, slower = ahead, 0
            else:
                slower += 1
            ahead += 1
        here = best
        kept[count] = path[here]
        count += 1
    return count


@inlined
def between_cells(raster: DistanceRaster, x: float, y: float) -> float:
    """The value at a point, bilinear between the four cell centres around it."""
    u, v = (x - raster.x0) / raster.cell - 0.5, (y - raster.y0) / raster.cell - 0.5
    rows, columns = raster.values.shape
    c, r = min(max(int(u), 0), columns - 2), min(max(int(v), 0), rows - 2)
    u, v = min(max(u - c, 0.0), 1.0), min(max(v - r, 0.0), 1.0)
    low = raster.values[r, c] * (1.0 - u) + raster.values[r, c + 1] * u
    high = raster.values[r + 1, c] * (1.0 - u) + raster.values[r + 1, c + 1] * u
    return low * (1.0 - v) + high * v


@compiled
def round_off(
    points: Floats, home: Floats, clear: DistanceRaster, least: float, reach: float, rounds: int
) -> None:
    """Move every point but the ends towards the middle of its neighbours, again and again.

    It stays within ``reach`` of where it was, its ``home`` (k, 2), and keeps a clearance of
    ``least``, or the one it has where that is less; there it also moves away from what is near.
    """
    for _round in range(rounds):
        for i in range(1, points.shape[0] - 1):
            x, y = points[i, 0], points[i, 1]
            now = between_cells(clear, x, y)
            nx = 0.5 * x + 0.25 * (points[i - 1, 0] + points[i + 1, 0])
            ny = 0.5 * y + 0.25 * (points[i - 1, 1] + points[i + 1, 1])
            if now < least:
                h = clear.cell
                nx += 0.25 * (between_cells(clear, x + h, y) - between_cells(clear, x - h, y))
                ny += 0.25 * (between_cells(clear, x, y + h) - between_cells(clear, x, y - h))
            far = math.hypot(nx - home[i, 0], ny - home[i, 1])
            back = min(reach / far, 1.0) if far > 0.0 else 1.0
            nx, ny = home[i, 0] + back * (nx - home[i, 0]), home[i, 1] + back * (ny - home[i, 1])
            if between_cells(clear, nx, ny) >= min(least, now):
                points[i, 0], points[i, 1] = nx, ny
