"""The free stretch of wall that something stands in, and places in it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import cos
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.composing.flush import (
    ALIKE,
    APART,
    AT,
    NARROWEST,
    WIDEST,
    boxes_along,
    seen_from,
)
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.wall_places import read_walls

Floats = NDArray[np.float64]

INSIDE = 0.01  # what is less deep in something than this is not in it, metres
ON_FLOOR = 0.1  # what ends lower is stood over, metres


class WallStretch(NamedTuple):
    """A free stretch of a wall: x, y of its start and its unit direction (``row``), the heading of
    what has its back there, its ``length``, and the middle of what stands in it (``at``), metres
    from its start."""

    row: tuple[float, float, float, float]
    heading: float
    length: float
    at: float

    def boxes_at(self, starts: Floats, form: Group) -> Floats:
        """The boxes ``(n, 5)`` of a form that begins so many metres (n,) along the stretch."""
        return boxes_along(starts + form.width / 2, self.row, self.heading, form)

    def slots_beside(self, starts: Floats, width: float) -> Floats:
        """Metres ``(n,)`` that are too narrow for anything beside what is so wide and begins at
        ``starts`` (n,)."""
        gaps = np.column_stack([starts, self.length - width - starts])
        slots = np.where((gaps > NARROWEST) & (gaps < WIDEST), gaps, 0.0)
        return np.asarray(slots.sum(1))


def list_taken(ground: Ground, standing: StandingObstacles, more: Floats, height: float) -> Floats:
    """The boxes (k, 5) in which nothing of that height stands: what is there already and ``more``
    (m, 5), doors, and windows that begin lower."""
    met = (standing.spans[:, 0] < height) & (standing.spans[:, 1] > ON_FLOOR)
    low = ground.windows[ground.windows[:, 5] < height, :5]
    return np.concatenate([standing.boxes[met], more, ground.keep_free, low])


def find_stretch(ground: Ground, box: Floats, depth: float, taken: Floats) -> WallStretch | None:
    """The stretch of the wall behind a box (5,) on which nothing ``taken`` (k, 5) stands within so
    many metres of the wall; None for what stands at no wall.

    >>> class Room: walls = np.array([[0.0, 0.0, 4.0, 0.0]])
    >>> box, other = np.array([1.0, 0.2, np.pi / 2, 0.5, 0.4]), np.array([[2.0, 0.3, 0, 0.6, 1.0]])
    >>> stretch = find_stretch(Room, box, 0.4, other)
    >>> round(stretch.length, 3), stretch.at
    (1.499, 1.0)
    """
    return next(find_deeper(ground, box, (depth,), taken), None)


def find_deeper(
    ground: Ground, box: Floats, depths: Iterable[float], taken: Floats
) -> Iterator[WallStretch]:
    """The stretches of :func:`find_stretch` for several depths in turn."""
    walls = read_walls(ground)
    x, y, heading, _, deep = box.tolist()
    for row, turn in zip(walls.rows.tolist(), walls.heading.tolist(), strict=True):
        ux, uy, length = row[2:]
        out, at = ((y - row[1]) * ux - (x - row[0]) * uy, (x - row[0]) * ux + (y - row[1]) * uy)
        behind = cos(turn - heading) > ALIKE and abs(out - deep / 2) < AT
        if behind and 0.0 <= at <= length:
            seen = seen_from(taken, *row[:4])
            for depth in depths:
                low, high = _list_spans(seen, depth)
                start = max(high[high <= at].max(initial=0.0), 0.0)
                end = min(low[(low + high) / 2 > at].min(initial=length), length)
                there = (row[0] + ux * start, row[1] + uy * start, ux, uy)
                yield WallStretch(there, turn, float(end - start), float(at - start))
            return


def list_stretches(
    ground: Ground, depth: float, taken: Floats, least: float
) -> Iterator[WallStretch]:
    """All stretches of walls, at least so long, on which nothing ``taken`` (k, 5) stands within so
    many metres of the wall."""
    walls = read_walls(ground)
    for row, heading in zip(walls.rows.tolist(), walls.heading.tolist(), strict=True):
        x, y, ux, uy, length = row
        if length < least:
            continue
        start = 0.0
        low, high = _list_spans(seen_from(taken, *row[:4]), depth)
        for a, b in sorted([*zip(low.tolist(), high.tolist(), strict=True), (length, length)]):
            if min(a, length) - start >= least:
                there = (x + ux * start, y + uy * start, ux, uy)
                yield WallStretch(there, heading, min(a, length) - start, 0.0)
            start = max(start, b)


def _list_spans(seen: tuple[Floats, ...], depth: float) -> tuple[Floats, Floats]:
    """From where to where along a wall boxes, as ``seen`` from it, stand within so many metres."""
    along, ahead, half, deep = seen
    near = (ahead - deep < depth - INSIDE) & (ahead + deep > INSIDE)
    return (along - half - APART)[near], (along + half + APART)[near]


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
