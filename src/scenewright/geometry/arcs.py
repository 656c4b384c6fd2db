"""Walls that curve, drawn as many short ones: the chords that a straight back can stand along."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

BEND = np.deg2rad(25.0)
"""Greatest angle between neighbouring parts of one curve; more is a corner."""
LEAST_BEND = np.deg2rad(0.5)
FEWEST = 3
"""Parts of a curve; fewer are walls of their own."""
LONGEST_PART = 1.0
"""Longer parts are straight walls of their own, metres."""
BEHIND = 0.15
"""Greatest distance of a curve from its chord, metres."""
HANGING = 0.03
"""Greatest distance of a curve from a chord on which something hangs, metres."""
LEAST_CHORD = 0.3


def chords_of(ring: Floats, behind: float = BEHIND) -> Floats:
    """Chords ``(n, 4)`` x0, y0, x1, y1 of the parts of a counter-clockwise ``ring`` (m, 2) that
    curve around its inside, in its direction: over two parts, three, four, six, eight and so on,
    a new one after half as many, while the curve is nowhere more than ``behind`` metres from it.

    With radius r and chord c that is r - sqrt(r² - c²/4), about c² / (8 r).

    >>> turns = np.linspace(0, 2 * np.pi, 73)[:-1]
    >>> chords = chords_of(2.0 * np.column_stack([np.cos(turns), np.sin(turns)]))
    >>> np.unique(np.hypot(*(chords[:, 2:] - chords[:, :2]).T).round(2)).tolist()
    [0.35, 0.52, 0.69, 1.04, 1.37]
    >>> len(chords_of(np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]])))
    0
    """
    found = [
        chord
        for points, starts in _curves(ring)
        for parts in _counts(min(len(points) - 1, starts))
        for chord in _over(points, starts, parts, behind)
    ]
    return np.array(found, np.float64).reshape(-1, 4)


def true_walls(walls: Floats, edges: Floats, away: float = HANGING) -> Floats:
    """Of ``walls`` (w, 4) those whose middle is at most ``away`` metres from one of the ``edges``
    (e, 4) of the room: no chords so far inside a curve that pieces hung there hang in the air.
    """
    if len(walls) <= len(edges):
        return walls
    middle = (walls[:, :2] + walls[:, 2:]) / 2
    start, way = edges[:, :2], edges[:, 2:] - edges[:, :2]
    off = middle[:, None] - start
    share = (off * way).sum(-1) / np.maximum((way * way).sum(-1), 1e-12)
    gap = np.linalg.norm(off - np.clip(share, 0.0, 1.0)[..., None] * way, axis=-1)
    return walls[gap.min(1, initial=np.inf) <= away]


def _curves(ring: Floats) -> Iterator[tuple[Floats, int]]:
    """The curves of a ring as polylines ``(k, 2)`` with both ends, and on how many of their points
    a chord may start: a closed one goes round twice."""
    along = np.roll(ring, -1, 0) - ring
    before = np.roll(along, 1, 0)
    turn = np.arctan2(
        before[:, 0] * along[:, 1] - before[:, 1] * along[:, 0], (before * along).sum(1)
    )
    short = np.hypot(along[:, 0], along[:, 1]) < LONGEST_PART
    bends = (turn > LEAST_BEND) & (turn < BEND) & short & np.roll(short, 1)
    if bends.all():
        yield np.vstack([ring, ring]), len(ring)
        return
    first = int(np.argmin(bends))
    order = np.roll(np.arange(len(ring)), -first)
    edges = np.flatnonzero(np.diff(np.r_[False, bends[order], False].astype(int)))
    for start, end in edges.reshape(-1, 2).tolist():
        if end - start + 1 >= FEWEST:
            curve = ring[order[np.arange(start - 1, end + 1) % len(ring)]]
            yield curve, len(curve)


def _counts(most: int) -> Iterator[int]:
    """2, 3, 4, 6, 8, 12 … up to a number of parts."""
    k = 2
    while k <= most:
        yield from (n for n in (k, k + k // 2) if n <= most)
        k *= 2


def _over(points: Floats, starts: int, parts: int, behind: float) -> Iterator[Floats]:
    """The chords over a number of parts of a curve that are near enough to it."""
    for start in range(0, min(starts, len(points) - parts), max(parts // 2, 1)):
        curve = points[start : start + parts + 1]
        way = curve[-1] - curve[0]
        length = float(np.hypot(*way))
        if length < LEAST_CHORD:
            continue
        off = (curve - curve[0]) @ np.array([way[1], -way[0]]) / length
        if off.max() <= behind:
            yield np.concatenate([curve[0], curve[-1]])
