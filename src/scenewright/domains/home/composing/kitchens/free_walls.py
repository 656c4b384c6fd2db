"""Where along the walls of a room something of a given depth and height would stand free."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.groups.fitted_kitchen import KitchenWall
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

AT_CORNER = 0.02  # a stretch that begins nearer than this to its corner reaches it, metres
SHALLOW = 0.02  # what reaches less deep into the strip before a wall does not take it, metres


class KitchenStretch(NamedTuple):
    """A free piece of a wall, from ``start`` to ``end`` metres from where that begins; ``number``
    is the wall's, ``length`` its own."""

    wall: KitchenWall
    start: float
    end: float
    number: int
    length: float


def list_stretches(
    ground: Ground, standing: StandingObstacles, depth: float, height: float, least: float
) -> list[KitchenStretch]:
    """The free stretches of walls of at least ``least`` metres, where something ``depth`` deep and
    ``height`` tall meets no wall, door zone, lower window or standing piece.

    Exact: of whatever reaches into the strip before a wall, the part within is cut out.
    """
    met = (standing.spans[:, 0] < height) & (standing.spans[:, 1] > 0.05)
    low = ground.windows[ground.windows[:, 5] < height, :5]
    boxes = np.concatenate([ground.keep_free, low, standing.boxes[met]])
    sides = np.concatenate([_sides_of(boxes), ground.edges])
    found = []
    for number, (x0, y0, x1, y1) in enumerate(ground.walls.tolist()):
        length = float(np.hypot(x1 - x0, y1 - y0))
        if length < least:
            continue
        wall = KitchenWall(x0, y0, (x1 - x0) / length, (y1 - y0) / length)
        first, last = _cut(wall, sides, depth)
        taken = 4 * len(boxes)
        starts = np.concatenate([first[:taken].reshape(-1, 4).min(1), first[taken:]])
        ends = np.concatenate([last[:taken].reshape(-1, 4).max(1), last[taken:]])
        spans = zip(starts[starts <= ends].tolist(), ends[starts <= ends].tolist(), strict=True)
        for start, end in _gaps(spans, length):
            if end - start >= least:
                found.append(KitchenStretch(wall, start, end, number, length))
    return found


def _sides_of(boxes: Floats) -> Floats:
    """The four sides of each box ``(n, 5)`` as segments ``(4 n, 4)``."""
    sin, cos = np.sin(boxes[:, 2])[:, None], np.cos(boxes[:, 2])[:, None]
    across = boxes[:, 3:4] / 2 * np.array([-1.0, 1.0, 1.0, -1.0])
    ahead = boxes[:, 4:5] / 2 * np.array([-1.0, -1.0, 1.0, 1.0])
    x = boxes[:, :1] + across * sin + ahead * cos
    y = boxes[:, 1:2] - across * cos + ahead * sin
    ends = np.stack([x, y, np.roll(x, -1, 1), np.roll(y, -1, 1)], axis=2)
    return ends.reshape(-1, 4)


def _cut(wall: KitchenWall, sides: Floats, depth: float) -> tuple[Floats, Floats]:
    """Of each segment ``(n, 4)`` the least and greatest place ``(n,)`` along the wall of its part
    in the strip before it; inf and -inf where there is none."""
    from_start = sides - np.array([wall.x, wall.y, wall.x, wall.y])
    along = from_start[:, ::2] * wall.ux + from_start[:, 1::2] * wall.uy
    out = from_start[:, 1::2] * wall.ux - from_start[:, ::2] * wall.uy
    rise = out[:, 1] - out[:, 0]
    level = np.abs(rise) < 1e-9
    slope = np.where(level, 1.0, rise)
    first, last = (SHALLOW - out[:, 0]) / slope, (depth - SHALLOW - out[:, 0]) / slope
    inside = (out[:, 0] > SHALLOW) & (out[:, 0] < depth - SHALLOW)
    low = np.where(level, np.where(inside, 0.0, 2.0), np.minimum(first, last).clip(0.0, None))
    high = np.where(level, np.where(inside, 1.0, -2.0), np.maximum(first, last).clip(None, 1.0))
    step = along[:, 1] - along[:, 0]
    one, other, met = along[:, 0] + low * step, along[:, 0] + high * step, low <= high
    least, most = np.minimum(one, other), np.maximum(one, other)
    return np.where(met, least, np.inf), np.where(met, most, -np.inf)


def _gaps(taken: Iterable[tuple[float, float]], length: float) -> list[tuple[float, float]]:
    """What of 0 to ``length`` is not taken.

    >>> _gaps([(1.0, 2.0), (1.5, 2.5)], 4.0)
    [(0.0, 1.0), (2.5, 4.0)]
    """
    ends = [0.0]
    for start, end in sorted((max(a, 0.0), min(b, length)) for a, b in taken):
        if end < 0.0 or start > length:
            continue
        if start > ends[-1]:
            ends += [start, end]
        else:
            ends[-1] = max(ends[-1], end)
    ends.append(length)
    return [(float(a), float(b)) for a, b in list(pairwise(ends))[::2] if b > a]


def end_of(stretch: KitchenStretch) -> tuple[float, float]:
    """Where the wall of a stretch ends."""
    wall = stretch.wall
    return wall.x + wall.ux * stretch.length, wall.y + wall.uy * stretch.length


def floor_length(metres: float) -> float:
    """A length in whole centimetres."""
    return int(metres * 100 + 1e-6) / 100
