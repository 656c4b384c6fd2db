"""Rows of buildings: who stands beside whom with the fronts in line, and the strings they are.

A row runs to the right of a viewer who looks along the fronts' headings. Its string has the
letter of the kind of each building, and ``-`` where the gap to the next is more than usual.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.buildings.built import BuiltFrames, to_frames

Floats = NDArray[np.float64]
TURN, STEP, FARTHEST = float(np.deg2rad(12.0)), 4.0, 40.0
"""How far fronts of neighbours may turn from each other and stand before each other (metres), and
the widest gap in a row."""
WIDE, LEAST_WIDE = 1.8, 1.5
"""How many times the usual gap, and how many metres more, make a gap a passage."""
LEAST = 3
"""Buildings of the shortest row."""
PASSAGE = "-"


class BuildingRow(NamedTuple):
    """One row: the numbers of its ``members`` in order, gaps (n - 1,) between them in metres, the
    heading of its front, and its ``pitch``, the median distance from one middle to the next."""

    members: tuple[int, ...]
    gaps: tuple[float, ...]
    heading: float
    pitch: float


def find_rows(frames: BuiltFrames) -> tuple[BuildingRow, ...]:
    """The rows of some buildings, the longest first.

    >>> from scenewright.ground.buildings.built import BuiltBuilding, frames_of
    >>> def hut(x, y):
    ...     ring = np.array([[x, y], [x + 8, y], [x + 8, y + 6], [x, y + 6.0]])
    ...     return BuiltBuilding("", "", ring, 6.0)
    >>> rows = find_rows(frames_of([hut(12 * k, 0) for k in range(5)] + [hut(3, 40)]))
    >>> [row.members for row in rows], rows[0].pitch
    ([(4, 3, 2, 1, 0)], 12.0)
    """
    right = _right_neighbours(frames)
    mutual = {a: b for a, b in right.items() if b not in right or right[b] != a}
    taken: dict[int, int] = {}
    for a, b in sorted(mutual.items(), key=lambda pair: _gap(frames, *pair)):
        if b not in taken.values():
            taken[a] = b
    rows = [_row(frames, chain) for chain in _chains(taken) if len(chain) >= LEAST]
    return tuple(sorted(rows, key=lambda row: (-len(row.members), row.members)))


def _gap(frames: BuiltFrames, a: int, b: int) -> float:
    return float(shapely.distance(frames.shapes[a], frames.shapes[b]))


def _right_neighbours(frames: BuiltFrames) -> dict[int, int]:
    """For each building the nearest to its right whose front is in line."""
    boxes = frames.boxes
    found: dict[int, int] = {}
    if len(boxes) < 2:
        return found
    i, j = shapely.STRtree(frames.shapes).query(
        frames.shapes, predicate="dwithin", distance=FARTHEST
    )
    for k in np.unique(i).tolist():
        others = j[(i == k) & (j != k)]
        local = to_frames(boxes[others, :2], boxes[k][None])
        turn = (boxes[others, 2] - boxes[k, 2] + np.pi) % (2 * np.pi) - np.pi
        front = local[:, 1] + boxes[others, 4] / 2 - boxes[k, 4] / 2
        aside = local[:, 0] - (boxes[k, 3] + boxes[others, 3]) / 2
        good = (np.abs(turn) < TURN) & (np.abs(front) < STEP) & (aside > -2.0) & (local[:, 0] > 0)
        if good.any():
            rows = others[good]
            found[k] = int(rows[np.argmin(aside[good])])
    return found


def _chains(after: dict[int, int]) -> list[list[int]]:
    heads = sorted(set(after) - set(after.values()))
    found = []
    for head in heads:
        chain = [head]
        while chain[-1] in after and after[chain[-1]] not in chain:
            chain.append(after[chain[-1]])
        found.append(chain)
    return found


def _row(frames: BuiltFrames, chain: Sequence[int]) -> BuildingRow:
    middles = frames.boxes[list(chain), :2]
    steps = np.hypot(*np.diff(middles, axis=0).T)
    gaps = tuple(_gap(frames, a, b) for a, b in pairwise(chain))
    heading = float(np.angle(np.exp(1j * frames.boxes[list(chain), 2]).mean()))
    return BuildingRow(tuple(chain), gaps, heading, float(np.median(steps)))


def string_of(row: BuildingRow, letters: Sequence[str]) -> tuple[str, ...]:
    """The string of a row; ``letters`` (n,) are those of all buildings.

    >>> string_of(BuildingRow((0, 1, 2, 3), (0.0, 3.0, 0.0), 0.0, 8.0), "AABA")
    ('A', 'A', '-', 'B', 'A')
    """
    usual = float(np.median(row.gaps)) if row.gaps else 0.0
    found = [letters[row.members[0]]]
    for gap, member in zip(row.gaps, row.members[1:], strict=True):
        if gap > max(WIDE * usual, usual + LEAST_WIDE):
            found.append(PASSAGE)
        found.append(letters[member])
    return tuple(found)
