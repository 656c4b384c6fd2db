"""Compiled sums over the points near each point: Gaussian means at eight widths, peaks, lookups.

Points lie in the order of the cells of a uniform grid, so that a row of cells is one stretch of
memory. Lengths are in units of half the finest width. Each pair is met once.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Pair = tuple[float, float]

WIDTHS = (2, 3, 4, 5, 6, 8, 10, 12)
"""Standard deviations of the Gaussians, in units; each is cut off at twice its width."""
LEVELS = 5
CELL = 6.0
"""Side of a cell of the grid, in units."""


@inlined
def _shrink(t: float) -> float:
    """exp(-t) for t in [0, 0.5], to 3e-9, by its series; no division, and few steps in a row."""
    square = t * t
    fourth = square * square
    low = (1.0 - t) + square * (1 / 2 - t * (1 / 6))
    high = (1 / 24 - t * (1 / 120)) + square * (1 / 720 - t * (1 / 5040)) + fourth * (1 / 40320)
    return low + fourth * high


@inlined
def _add(sums: Floats, i: int, j: int, k: int, weight: float, own: Pair, other: Pair) -> None:
    """Let two points see what the other holds, at one width."""
    sums[i, k, 0] += weight * other[0]
    sums[i, k, 1] += weight * other[1]
    sums[j, k, 0] += weight * own[0]
    sums[j, k, 1] += weight * own[1]


@inlined
def _reach(points: Floats, i: int, row: int, layer: int, far: float) -> float:
    """Half the length in x, in units, over which a row of cells may be within ``far`` of a
    point; negative if it is too far."""
    y, z = points[i, 1], points[i, 2]
    dy = max(row * CELL - y, y - (row + 1) * CELL, 0.0)
    dz = max(layer * CELL - z, z - (layer + 1) * CELL, 0.0)
    rest = far * far - dy * dy - dz * dz
    return math.sqrt(rest) if rest >= 0.0 else -1.0


@compiled
def gaussian_sums(points: Floats, held: Floats, starts: Ints, shape: Ints, sums: Floats) -> None:
    """Sums ``(n, 8, 2)`` over the points within 2σ of exp(-d²/(2σ²)) times what they hold.

    ``points`` (n, 3) are measured from the grid's low corner and sorted by cell; ``held`` (n, 2)
    is area and curvature; ``starts`` (cells + 1,) is where each cell begins, x fastest.
    """
    far = 2.0 * WIDTHS[7]
    for i in range(points.shape[0]):
        for k in range(8):
            sums[i, k, 0] += held[i, 0]
            sums[i, k, 1] += held[i, 1]
        row, layer = int(points[i, 1] / CELL), int(points[i, 2] / CELL)
        for c in range(layer, min(layer + 5, shape[2])):
            for b in range(max(row - 4, 0) if c > layer else row, min(row + 5, shape[1])):
                half = _reach(points, i, b, c, far)
                if half < 0.0:
                    continue
                x = points[i, 0]
                line = (c * shape[1] + b) * shape[0]
                first = starts[line + max(int((x - half) / CELL), 0)]
                last = starts[line + min(int((x + half) / CELL), shape[0] - 1) + 1]
                for j in range(max(first, i + 1), last):
                    _meet(points, held, i, j, sums)


@inlined
def _meet(points: Floats, held: Floats, i: int, j: int, sums: Floats) -> None:
    """Both points' sums at all widths that reach. Powers of two roots of Gaussians give all."""
    dx, dy, dz = (
        points[i, 0] - points[j, 0],
        points[i, 1] - points[j, 1],
        points[i, 2] - points[j, 2],
    )
    square = dx * dx + dy * dy + dz * dz
    if square > 576.0:
        return
    a, b = (held[i, 0], held[i, 1]), (held[j, 0], held[j, 1])
    root = _shrink(square * (1 / 1152))
    second = root * root
    fourth = second * second
    _add(sums, i, j, 7, fourth, a, b)
    if square > 400.0:
        return
    other = _shrink(square * (1 / 800))
    other = other * other
    other = other * other
    _add(sums, i, j, 6, other, a, b)
    if square > 256.0:
        return
    eighth = fourth * fourth
    _add(sums, i, j, 5, eighth * root, a, b)
    if square > 144.0:
        return
    sixteenth = eighth * eighth
    _add(sums, i, j, 4, sixteenth, a, b)
    if square > 100.0:
        return
    other = other * other
    _add(sums, i, j, 3, other * other, a, b)
    if square > 64.0:
        return
    thirtieth = sixteenth * sixteenth
    _add(sums, i, j, 2, thirtieth * fourth, a, b)
    if square > 36.0:
        return
    sixtieth = thirtieth * thirtieth
    _add(sums, i, j, 1, sixtieth, a, b)
    if square <= 16.0:
        _add(sums, i, j, 0, sixtieth * sixtieth * sixteenth, a, b)


@compiled
def peaks(
    points: Floats, values: Floats, starts: Ints, shape: Ints, slack: float, top: NDArray[np.bool_]
) -> None:
    """Unmark in ``top`` (n, 5) each point that has a larger value within the level's width.

    Values (n, 5) that differ by less than ``slack`` are equal, and equal ones are all peaks.
    """
    for i in range(points.shape[0]):
        row, layer = int(points[i, 1] / CELL), int(points[i, 2] / CELL)
        for c in range(layer, min(layer + 2, shape[2])):
            for b in range(max(row - 1, 0) if c > layer else row, min(row + 2, shape[1])):
                half = _reach(points, i, b, c, 6.0)
                if half < 0.0:
                    continue
                x = points[i, 0]
                line = (c * shape[1] + b) * shape[0]
                first = starts[line + max(int((x - half) / CELL), 0)]
                last = starts[line + min(int((x + half) / CELL), shape[0] - 1) + 1]
                for j in range(max(first, i + 1), last):
                    _compare(points, values, i, j, slack, top)


@inlined
def _compare(
    points: Floats, values: Floats, i: int, j: int, slack: float, top: NDArray[np.bool_]
) -> None:
    square = 0.0
    for k in range(3):
        square += (points[i, k] - points[j, k]) ** 2
    for k in range(LEVELS):
        if square <= WIDTHS[k] ** 2:
            if values[i, k] < values[j, k] - slack:
                top[i, k] = False
            elif values[j, k] < values[i, k] - slack:
                top[j, k] = False


@compiled
def blend(
    points: Floats,
    values: Floats,
    starts: Ints,
    shape: Ints,
    width: float,
    places: Floats,
    out: Floats,
) -> None:
    """Values at other ``places`` (q, 3): the Gaussian mean, ``width`` units wide, of the points
    within four widths; 0 where there are none."""
    far = 4.0 * width
    for i in range(places.shape[0]):
        top = total = 0.0
        x, y, z = places[i, 0], places[i, 1], places[i, 2]
        for c in range(
            max(math.floor((z - far) / CELL), 0), min(math.floor((z + far) / CELL) + 1, shape[2])
        ):
            for b in range(
                max(math.floor((y - far) / CELL), 0),
                min(math.floor((y + far) / CELL) + 1, shape[1]),
            ):
                first = max(math.floor((x - far) / CELL), 0)
                last = min(math.floor((x + far) / CELL), shape[0] - 1)
                if first > last:
                    continue
                line = (c * shape[1] + b) * shape[0]
                for j in range(starts[line + first], starts[line + last + 1]):
                    square = 0.0
                    for k in range(3):
                        square += (places[i, k] - points[j, k]) ** 2
                    if square <= far * far:
                        weight = math.exp(-0.5 * square / (width * width))
                        top += weight * values[j]
                        total += weight
        out[i] = top / total if total > 0.0 else 0.0
