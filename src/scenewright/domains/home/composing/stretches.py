"""The longest free stretch of any wall: what is wider need not be tried along it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.furnishing.whole import RAISED
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

STEP = 0.05  # between points looked at along a wall, metres
DEEP, SHALLOW = 0.29, 0.09  # how far before their wall points are looked at, metres
INSIDE = 0.01  # what is less deep in something than this is not in it, metres


class Reach(NamedTuple):
    """How deep before its wall and how tall a case is at least."""

    depth: float
    height: float


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
    longest = 0.0
    for x0, y0, x1, y1 in ground.walls:
        length = float(np.hypot(x1 - x0, y1 - y0))
        if length <= longest:
            continue
        ux, uy = (x1 - x0) / length, (y1 - y0) / length
        t = np.arange(STEP / 2, length, STEP)
        px, py = x0 + ux * t - uy * reach.depth, y0 + uy * t + ux * reach.depth
        longest = max(longest, min(length, _longest_run(~_lie_in(px, py, boxes)) * STEP + STEP))
    return longest


def _lie_in(x: Floats, y: Floats, boxes: Floats) -> NDArray[np.bool_]:
    """Which of the points (n,) lie well inside any of the boxes (k, 5)."""
    dx, dy = x[:, None] - boxes[:, 0], y[:, None] - boxes[:, 1]
    cos, sin = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    ahead = np.abs(dx * cos + dy * sin) < boxes[:, 4] / 2 - INSIDE
    aside = np.abs(dx * sin - dy * cos) < boxes[:, 3] / 2 - INSIDE
    return np.asarray((ahead & aside).any(1))


def _longest_run(free: NDArray[np.bool_]) -> int:
    edges = np.flatnonzero(np.diff(np.r_[False, free, False].astype(np.int8)))
    return int((edges[1::2] - edges[::2]).max(initial=0))
