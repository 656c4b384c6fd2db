"""Buckets: which of many boxes lie near a place, in constant time.

A uniform grid of linked lists. A box is filed by the middle of its circle; boxes with a circle
larger than ``reach`` are filed in one list that is always looked at, so cells can stay small.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Ints = NDArray[np.int64]


class Buckets(NamedTuple):
    """Corner and ``cell`` size in metres, ``columns`` and ``rows``, the greatest ``reach`` of
    boxes in cells; ``heads`` (cells + 1,) first box of each list (-1: none), the last one of large
    boxes; ``after``, ``before`` (n,) neighbours in the list; ``place`` (n,) list of each box, -1
    if it is in none."""

    x0: float
    y0: float
    cell: float
    columns: int
    rows: int
    reach: float
    heads: Ints
    after: Ints
    before: Ints
    place: Ints


def make_buckets(bounds: NDArray[np.float64], radii: NDArray[np.float64]) -> Buckets:
    """Empty buckets over ``bounds`` (x0, y0, x1, y1) for boxes with circles of ``radii`` (n,)."""
    reach = float(np.quantile(radii, 0.9)) * 1.001 if len(radii) else 1.0
    x0, y0, x1, y1 = map(float, bounds)
    cell = max(2.0 * reach, 0.5, ((x1 - x0) * (y1 - y0) / 40_000) ** 0.5)
    columns, rows = int((x1 - x0) / cell) + 1, int((y1 - y0) / cell) + 1
    n = len(radii)
    return Buckets(
        x0,
        y0,
        cell,
        columns,
        rows,
        reach,
        np.full(columns * rows + 1, -1, np.int64),
        np.full(n, -1, np.int64),
        np.full(n, -1, np.int64),
        np.full(n, -1, np.int64),
    )


@inlined
def column_of(b: Buckets, x: float) -> int:
    """The column of an x coordinate, at the rim for what lies outside."""
    return min(max(int((x - b.x0) / b.cell), 0), b.columns - 1)


@inlined
def row_of(b: Buckets, y: float) -> int:
    """The row of a y coordinate, at the rim for what lies outside."""
    return min(max(int((y - b.y0) / b.cell), 0), b.rows - 1)


@compiled
def insert(b: Buckets, i: int, x: float, y: float, radius: float) -> None:
    """File box ``i`` whose circle has its middle at x, y."""
    inner = row_of(b, y) * b.columns + column_of(b, x)
    place = b.columns * b.rows if radius > b.reach else inner
    first = b.heads[place]
    b.after[i], b.before[i], b.place[i] = first, -1, place
    if first >= 0:
        b.before[first] = i
    b.heads[place] = i


@compiled
def remove(b: Buckets, i: int) -> None:
    """Take box ``i`` out."""
    if b.place[i] < 0:
        return
    if b.before[i] >= 0:
        b.after[b.before[i]] = b.after[i]
    else:
        b.heads[b.place[i]] = b.after[i]
    if b.after[i] >= 0:
        b.before[b.after[i]] = b.before[i]
    b.place[i] = -1
