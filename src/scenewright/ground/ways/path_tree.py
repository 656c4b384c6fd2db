"""Ways from many places to the nearest of many starts, joined where they run together.

Quickest ways form a tree (Dijkstra 1959). It is found twice: the second time what was used the
first time is cheap, so ways that ran beside each other become one. The tree is then cut where ways
meet, and each piece may be pulled straight between its ends.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.travel import string_pull
from scenewright.geometry.wavefront import find_quickest

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]

PAVED, LEAST = 0.45, 2
"""Cost of a metre that other ways use, as a share of the usual cost; rows and columns that a
stretch must cross to be aslant."""


def grow_paths(slow: Floats, cell: float, starts: Ints, goals: Ints, before: Ints) -> list[Ints]:
    """Pieces (k,) of cells of the ways from starts to all ``goals``, which can be reached; a piece
    ends where others begin. ``slow`` (rows, columns) seconds a metre, infinite where no way may
    lead; ``before`` (cells,) the cell each is come from on its quickest way."""
    if not len(goals):
        return []
    cheap = slow.copy().reshape(-1)
    used = {number for piece in cut_tree(before, goals.tolist()) for number in piece}
    cheap[sorted(used)] *= PAVED
    _, before = find_quickest(cheap.reshape(slow.shape), cell, starts)
    return [np.array(piece, np.int32) for piece in cut_tree(before, goals.tolist())]


def cut_tree(before: Ints, goals: Sequence[int]) -> list[list[int]]:
    """The ways from goals back to their starts as pieces that share only their ends; ``before``
    (cells,) is the cell each is reached from, -1 at a start.

    >>> cut_tree(np.array([-1, 0, 1, 1]), [2, 3])
    [[1, 0], [2, 1], [3, 1]]
    """
    known: set[int] = set()
    joined: Counter[int] = Counter()
    for goal in dict.fromkeys(goals):
        here = goal
        while here >= 0 and here not in known:
            known.add(here)
            here = int(before[here])
            joined[here] += 1
    knots = {*goals, *(cell for cell, count in joined.items() if count > 1 and cell >= 0)}
    return [piece for knot in sorted(knots) if len(piece := trace(before, knot, knots)) > 1]


def trace(before: Ints, goal: int, ends: Container[int]) -> list[int]:
    """The cells from a goal back to its start, or to the first of some ``ends`` on the way;
    ``before`` (cells,) as in :func:`cut_tree`.

    >>> trace(np.array([-1, 0, 1, 2]), 3, {1})
    [3, 2, 1]
    """
    piece = [goal]
    while before[piece[-1]] >= 0:
        piece.append(int(before[piece[-1]]))
        if piece[-1] in ends:
            break
    return piece


def straighten(piece: Sequence[int] | Ints, slow: Floats, cell: float) -> Ints:
    """A piece (k,) of cells without those between which a straight way is no slower; ``slow``
    (rows, columns) is what a metre takes, ``cell`` metres."""
    path, columns = np.array(piece, np.int32), slow.shape[1]
    step = np.hypot(np.diff(path // columns), np.diff(path % columns)) * cell
    rate = slow.reshape(-1)[path]
    times = np.concatenate([[0.0], np.cumsum(step * 0.5 * (rate[1:] + rate[:-1]))])
    kept = np.empty_like(path)
    count = string_pull(path, slow, times * (1.0 + 1e-9), cell, kept)
    return kept[:count]


def square_off(path: Ints, slow: Floats) -> Ints:
    """Cells (k,) of a straightened piece, with a corner for each stretch aslant to the raster where
    the ground along both legs is free: ways run along rows and across them. Of the two corners
    the one that goes on straight, else the quicker; never a cell the piece has anyway, which it
    would pass twice.

    >>> square_off(np.array([0, 10], np.int32), np.ones((3, 5))).tolist()
    [0, 10]
    >>> square_off(np.array([0, 14], np.int32), np.ones((3, 5))).tolist()
    [0, 4, 14]
    """
    columns, kept, knots = slow.shape[1], [int(path[0])], set(path.tolist())
    for here in path[1:].tolist():
        last = kept[-1]
        (r0, c0), (r1, c1) = divmod(last, columns), divmod(here, columns)
        if min(abs(r1 - r0), abs(c1 - c0)) >= LEAST:
            legs = {
                r0 * columns + c1: _time_of_legs(slow, r0, c0, c1, r1),
                r1 * columns + c0: _time_of_legs(slow.T, c0, r0, r1, c1),
            }
            before = kept[-2] if len(kept) > 1 else last
            onward = [k for k in legs if k // columns == before // columns == r0]
            onward += [k for k in legs if k % columns == before % columns == c0]
            free = [k for k in legs if np.isfinite(legs[k]) and k not in knots]
            best = [k for k in onward if k in free and before != last] or free
            kept += sorted(best, key=legs.__getitem__)[:1]
        kept.append(here)
    return np.array(kept, np.int32)


def _time_of_legs(slow: Floats, row: int, start: int, corner: int, end: int) -> float:
    """The cost of the cells along a row, then from its ``corner`` along that column."""
    first = slow[row, min(start, corner) : max(start, corner) + 1]
    second = slow[min(row, end) : max(row, end) + 1, corner]
    return float(first.sum() + second.sum())
