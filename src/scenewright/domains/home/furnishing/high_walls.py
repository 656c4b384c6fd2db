"""Groups with one tall piece (the fridge of a kitchen): at which height they meet windows.

A worktop may run below a window, a fridge may not. Which end of a group the fridge is at is known
when it is dressed. So where some wall of the room is high and free enough for the whole group, the
search takes the group to be as tall as that piece; else as low as the rest, and dressing decides.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import heights
from scenewright.domains.home.problem import Ground, Items, KnownGround, known_ground
from scenewright.domains.home.programme import Wish

Floats = NDArray[np.float64]

TALL = {"kitchen": 1.9}
"""Height of the tallest piece a group cannot do without, by function, in metres."""
STEP, INSIDE = 0.1, 0.3  # between points tried along a wall, and how far before it, metres


def raise_tall_items(items: Items, wishes: tuple[Wish, ...], ground: Ground) -> Items:
    """Items, those with a tall piece as tall as it where a wall is free for it."""
    tall = items.height.copy()
    for i, wish in enumerate(wishes):
        if wish.group not in TALL:
            continue
        if _known_stretch(known_ground(ground), TALL[wish.group]) >= items.wish[i, 0]:
            tall[i] = TALL[wish.group]
    return items._replace(height=tall)


@lru_cache(maxsize=256)
def _known_stretch(known: KnownGround, height: float) -> float:
    return free_stretch(known.ground, height)


def free_stretch(ground: Ground, height: float) -> float:
    """The longest stretch of a wall, in metres, before which something of a height may stand:
    no door, window or fixed piece, and under the ceiling."""
    low = ground.windows[ground.windows[:, 5] < height, :5]
    taken = np.concatenate([ground.keep_free, ground.obstacles, low])
    longest = 0.0
    for x0, y0, x1, y1 in ground.walls:
        length = float(np.hypot(x1 - x0, y1 - y0))
        along = np.array([x1 - x0, y1 - y0]) / max(length, 1e-9)
        steps = np.arange(0.0, length + 1e-9, STEP)[:, None]
        points = (x0, y0) + steps * along + INSIDE * np.array([-along[1], along[0]])
        free = ~_inside(points, taken) & (heights(points, ground.slopes, np.inf) >= height)
        longest = max(longest, _run(free) * STEP)
    return longest


def _inside(points: Floats, boxes: Floats) -> NDArray[np.bool_]:
    """Which points (n, 2) lie in any of the boxes (k, 5)."""
    off = points[:, None] - boxes[:, :2]
    cos, sin = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    ahead = np.abs(off[..., 0] * cos + off[..., 1] * sin) < boxes[:, 4] / 2
    aside = np.abs(off[..., 0] * sin - off[..., 1] * cos) < boxes[:, 3] / 2
    return np.asarray((ahead & aside).any(1))


def _run(free: NDArray[np.bool_]) -> int:
    """How many steps the longest run of free points makes."""
    edges = np.flatnonzero(np.diff(np.r_[False, free, False].astype(int)))
    return int((edges[1::2] - edges[::2] - 1).max(initial=0))
