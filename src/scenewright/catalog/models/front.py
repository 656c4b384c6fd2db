"""Which side of a model is its front, by its shape.

Seats, beds and basins are high at the back; cupboards and shelves have a plain flat back. Both
are read off the triangles: where the upper ones lie, and how much of a side's face is filled.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Part
from scenewright.core.scene import Size

Floats = NDArray[np.float64]

UPPER = 0.55
"""Above this share of the height is the upper part."""
LEANS = 0.12
"""By what share of half its side the upper part of a high back lies behind the lower."""
FILLED = 0.1
"""By what share of the face a flat back is fuller than the front."""
SKIN = 0.03
"""How near a side's face a triangle is part of it, as a share of the depth."""
OBLONG = 1.15
PLAIN = 3000
"""Number of triangles up to which each is cut finely, so that large ones count where they are."""


class Front(NamedTuple):
    """Quarter turns counter-clockwise that bring the front to +y, and how sure that is (0: the
    shape does not say)."""

    turn: int
    sure: float


SIDES = ((0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0))
"""Where the front may look, by the number of quarter turns that bring it to +y."""


def front(parts: Sequence[Part], size: Size, kind: str) -> Front:
    """The front of a model of a kind, by its shape.

    >>> from scenewright.catalog.assets import shipped
    >>> asset = shipped().assets["armchair"]
    >>> front(asset.mesh(asset.usual), asset.usual, "armchair").turn
    0
    """
    corners = np.concatenate([part.vertices[part.faces] for part in parts])
    crossed = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(crossed, axis=1) / 2
    back = KINDS[kind].back if kind in KINDS else ""
    if back == "high":
        scores, least = _leaning(corners, areas, size), LEANS
    elif back == "flat":
        scores, least = _filling(corners, crossed, areas, size), FILLED
    else:
        return Front(0, 0.0)
    best = int(np.argmax(scores))
    if scores[best] < least:
        return Front(0, 0.0)
    return Front(best, min(1.0, 0.5 + 0.5 * float(scores[best] - least) / least))


def _leaning(corners: Floats, areas: Floats, size: Size) -> list[float]:
    """How far the upper part lies away from each side, as a share of half the way to it."""
    fine = 1 if len(corners) > PLAIN else 8
    middles = (corners.transpose(0, 2, 1) @ _places(fine).T).transpose(0, 2, 1).reshape(-1, 3)
    weights = np.repeat(areas, fine * fine)
    upper = middles[:, 2] > UPPER * size.height
    if not weights[upper].sum() > 0 or not weights[~upper].sum() > 0:
        return [0.0] * 4
    high, low = (np.average(middles[s, :2], axis=0, weights=weights[s]) for s in (upper, ~upper))
    shift = (low - high) / (np.array([size.width, size.depth]) / 2)
    return [float(np.dot(shift, side)) for side in SIDES]


def _places(fine: int) -> Floats:
    """The middles of the ``fine`` x ``fine`` equal triangles one is cut into, as shares of its
    corners ``(fine * fine, 3)``."""
    cuts = range(fine)
    ahead = [(3 * i + 1, 3 * j + 1) for i in cuts for j in cuts if i + j < fine]
    back = [(3 * i + 2, 3 * j + 2) for i in cuts for j in cuts if i + j < fine - 1]
    shares = np.array([*ahead, *back]) / (3 * fine)
    return np.column_stack([1 - shares.sum(1), shares])


def _filling(corners: Floats, crossed: Floats, areas: Floats, size: Size) -> list[float]:
    """How much fuller the face opposite each side is than its own; only across a long body."""
    filled = []
    half = np.array([size.width / 2, size.depth / 2])
    for side in SIDES:
        axis = int(side[0] == 0)
        reach, across = half[axis], half[1 - axis] * 2
        near = (corners[:, :, axis] * side[axis] > reach * (1 - 2 * SKIN)).all(1)
        flat = np.abs(crossed[:, axis]) > 0.95 * 2 * areas
        filled.append(min(1.0, float(areas[near & flat].sum()) / (across * size.height)))
    scores = [filled[(k + 2) % 4] - filled[k] for k in range(4)]
    long = (size.width > OBLONG * size.depth, size.depth > OBLONG * size.width)
    return [-1.0 if long[(k + 1) % 2] else score for k, score in enumerate(scores)]
