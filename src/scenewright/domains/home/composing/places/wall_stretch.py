"""The free stretch of wall that something stands in, and places in it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import cos
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.composing.places.flush import (
    AT,
    FLUSH_GAP,
    NARROWEST,
    WIDEST,
    boxes_along,
    seen_from,
)
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.grounds.wall_places import read_walls
from scenewright.domains.home.measures import ALIKE
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

INSIDE = 0.01  # what is less deep in something than this is not in it, metres
STOOD_OVER = 0.1  # what ends lower is stood over, metres


class FreeStretch(NamedTuple):
    """A free stretch of a wall: x, y of its start and its unit direction (``row``), the heading of
    pieces with their back there, its ``length``, and the middle of the piece in it (``at``),
    metres from its start."""

    row: tuple[float, float, float, float]
    heading: float
    length: float
    at: float

    def boxes_at(self, starts: Floats, form: Group) -> Floats:
        """The boxes ``(n, 5)`` of a form that begins at ``starts`` (n,) metres along the
        stretch."""
        return boxes_along(starts + form.width / 2, self.row, self.heading, form)

    def slots_beside(self, start: float, width: float) -> float:
        """Metres beside a piece of ``width`` from ``start`` on that are too narrow for anything."""
        gaps = (start, self.length - width - start)
        return sum(gap for gap in gaps if NARROWEST < gap < WIDEST)


def list_taken(ground: Ground, standing: StandingObstacles, more: Floats, height: float) -> Floats:
    """The boxes (k, 5) in which nothing of that height stands: what is there already and ``more``
    (m, 5), doors, and windows that begin lower."""
    met = (standing.spans[:, 0] < height) & (standing.spans[:, 1] > STOOD_OVER)
    low = ground.windows[ground.windows[:, 5] < height, :5]
    return np.concatenate([standing.boxes[met], more, ground.keep_free, low])


def find_stretch(
    ground: Ground, box: Floats, depth: float, taken: Floats, beyond: float = INSIDE
) -> FreeStretch | None:
    """The stretch of the wall behind a box (5,) on which nothing ``taken`` (k, 5) stands within
    ``depth`` metres of the wall, except what ends within ``beyond`` metres of it; None for a box at
    no wall.

    >>> class Room: walls = np.array([[0.0, 0.0, 4.0, 0.0]])
    >>> box, other = np.array([1.0, 0.2, np.pi / 2, 0.5, 0.4]), np.array([[2.0, 0.3, 0, 0.6, 1.0]])
    >>> stretch = find_stretch(Room, box, 0.4, other)
    >>> round(stretch.length, 3), stretch.at
    (1.499, 1.0)
    """
    return next(find_deeper(ground, box, (depth,), taken, beyond), None)


def find_deeper(
    ground: Ground, box: Floats, depths: Iterable[float], taken: Floats, beyond: float = INSIDE
) -> Iterator[FreeStretch]:
    """The stretches of :func:`find_stretch` for several depths in turn."""
    walls = read_walls(ground)
    x, y, heading, _, deep = box.tolist()
    for row, turn in zip(walls.rows.tolist(), walls.heading.tolist(), strict=True):
        ux, uy, length = row[2:]
        out, at = ((y - row[1]) * ux - (x - row[0]) * uy, (x - row[0]) * ux + (y - row[1]) * uy)
        behind = cos(turn - heading) > ALIKE and abs(out - deep / 2) < AT
        if behind and 0.0 <= at <= length:
            seen = _list_seen(taken, row)
            for depth in depths:
                spans = _list_spans(seen, depth, beyond)
                start = max((high for _, high in spans if high <= at), default=0.0)
                end = min((low for low, high in spans if low + high > 2 * at), default=length)
                start, end = max(start, 0.0), min(end, length)
                there = (row[0] + ux * start, row[1] + uy * start, ux, uy)
                yield FreeStretch(there, turn, end - start, at - start)
            return


def list_free_stretches(
    ground: Ground, depth: float, taken: Floats, least: float
) -> Iterator[FreeStretch]:
    """All stretches of walls of a least length on which nothing ``taken`` (k, 5) stands
    near the wall."""
    walls = read_walls(ground)
    for row, heading in zip(walls.rows.tolist(), walls.heading.tolist(), strict=True):
        x, y, ux, uy, length = row
        if length < least:
            continue
        start = 0.0
        spans = _list_spans(_list_seen(taken, row), depth)
        for a, b in sorted([*spans, (length, length)]):
            if min(a, length) - start >= least:
                there = (x + ux * start, y + uy * start, ux, uy)
                yield FreeStretch(there, heading, min(a, length) - start, 0.0)
            start = max(start, b)


def _list_seen(taken: Floats, row: list[float]) -> list[tuple[float, float, float, float]]:
    """Each of boxes (k, 5) as a wall sees it: from where to where along it and before it."""
    along, ahead, half, deep = (part.tolist() for part in seen_from(taken, *row[:4]))
    rows = zip(along, ahead, half, deep, strict=True)
    return [(a - h - FLUSH_GAP, a + h + FLUSH_GAP, o - d, o + d) for a, o, h, d in rows]


def _list_spans(
    seen: list[tuple[float, float, float, float]], depth: float, beyond: float = INSIDE
) -> list[tuple[float, float]]:
    """The extents along a wall of things nearer to it than ``depth`` metres that end farther than
    ``beyond``."""
    reach = depth - INSIDE
    return [(low, high) for low, high, near, far in seen if near < reach and far > beyond]


def measure_front(ground: Ground, box: Floats) -> float:
    """Metres from the front of a box (5,) to the nearest wall before its middle and its ends."""
    x, y, heading, width, depth = box.tolist()
    c, s = np.cos(heading), np.sin(heading)
    start, way = ground.edges[:, :2], ground.edges[:, 2:] - ground.edges[:, :2]
    least = np.inf
    for aside in (-0.49 * width, 0.0, 0.49 * width):
        dx, dy = start[:, 0] - x - aside * s, start[:, 1] - y + aside * c
        across = way[:, 1] * c - way[:, 0] * s
        across = np.where(np.abs(across) < 1e-9, np.inf, across)
        far, t = (dx * way[:, 1] - dy * way[:, 0]) / across, (dx * s - dy * c) / across
        hit = (t >= 0.0) & (t <= 1.0) & (far > 0.0)
        least = min(least, far[hit].min(initial=np.inf))
    return float(least) - depth / 2
