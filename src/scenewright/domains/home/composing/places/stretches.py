"""The longest free stretch of any wall: what is wider need not be tried along it."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.problem import Ground
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]

STEP = 0.05  # between points looked at along a wall, metres
DEEP, SHALLOW = 0.29, 0.09  # how far before their wall points are looked at, metres
INSIDE = 0.01  # what is less deep in something than this is not in it, metres


class Reach(NamedTuple):
    """How deep before its wall and how tall a case is at least."""

    depth: float
    height: float


@lru_cache(maxsize=4096)
def reach_of(case: Group) -> Reach:
    """What of a case is certainly there: the point before the wall it covers all along, and the
    height of its lowest member on the floor.

    >>> from scenewright.domains.home.cases.library import cases
    >>> reach_of(cases("wardrobe").groups[0])
    Reach(depth=0.09, height=2.2)
    """
    low = [m.size.height for m in case.members if m.on < 0 and m.z < RAISED and m.size.height > 0.1]
    return Reach(DEEP if case.depth >= 2 * DEEP else SHALLOW, min(low, default=0.0))


def longest_stretch(ground: Ground, standing: StandingObstacles, reach: Reach) -> float:
    """The longest stretch of a wall, in metres, along which no door zone, window or standing piece
    takes the points at the depth of ``reach``; never less than what a case of it may be wide."""
    low = ground.windows[ground.windows[:, 5] < reach.height, :5]
    met = (standing.spans[:, 0] < reach.height) & (standing.spans[:, 1] > 0.05)
    boxes = np.concatenate([ground.keep_free, low, standing.boxes[met]])
    turns = np.column_stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])])
    return float(find_longest(ground.walls, boxes, turns, reach.depth))


@compiled
def find_longest(walls: Floats, boxes: Floats, turns: Floats, depth: float) -> float:
    """The longest stretch, in metres, of ``walls`` (w, 4) along which no point ``depth`` metres
    before the wall lies well inside one of the ``boxes`` (k, 5); ``turns`` (k, 2) are cosine and
    sine of their headings."""
    longest = 0.0
    for w in range(walls.shape[0]):
        x0, y0 = walls[w, 0], walls[w, 1]
        dx, dy = walls[w, 2] - x0, walls[w, 3] - y0
        length = math.hypot(dx, dy)
        if length <= longest:
            continue
        ux, uy = dx / length, dy / length
        count, best, run = math.ceil((length - STEP / 2) / STEP), 0, 0
        for i in range(count):
            t = STEP / 2 + i * STEP
            x, y = x0 + ux * t - uy * depth, y0 + uy * t + ux * depth
            run = 0 if _lies_in(x, y, boxes, turns) else run + 1
            best = max(best, run)
        longest = max(longest, min(length, best * STEP + STEP))
    return longest


@inlined
def _lies_in(x: float, y: float, boxes: Floats, turns: Floats) -> bool:
    """Whether a point lies well inside any of the boxes (k, 5)."""
    for k in range(boxes.shape[0]):
        dx, dy, cos, sin = x - boxes[k, 0], y - boxes[k, 1], turns[k, 0], turns[k, 1]
        ahead = abs(dx * cos + dy * sin) < boxes[k, 4] / 2 - INSIDE
        if ahead and abs(dx * sin - dy * cos) < boxes[k, 3] / 2 - INSIDE:
            return True
    return False
