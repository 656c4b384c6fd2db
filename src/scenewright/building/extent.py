"""How far the rooms and walls of a brief lie apart: a building is one place.

A wall or room kilometres away is a slip of the hand; drawn to scale it would leave all others
too small to be seen.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]

FARTHEST = 300.0
"""Metres between neighbouring parts of a building, along x or y; and that walls reach beyond its
rooms."""


def check_extent(brief: Brief, floors: Sequence[shapely.Polygon]) -> None:
    """InputError where rooms lie far apart, or a wall far from every room."""
    bounds = shapely.bounds(np.array(floors, object)).reshape(-1, 4)
    lone, gap = _apart(bounds)
    if gap > FARTHEST:
        raise InputError(
            f"lies {gap:,.0f} m from all other rooms",
            "lengths are metres: move it there, or make a brief of its own",
            place=f"rooms[{lone}]",
        )
    ends = np.array([[*wall.start, *wall.end] for wall in brief.walls]).reshape(-1, 2, 2)
    low, high = bounds[:, :2].min(0), bounds[:, 2:].max(0)
    beyond = np.maximum(low - ends, ends - high).max((1, 2), initial=0.0)
    if len(ends) and beyond.max() > FARTHEST:
        raise InputError(
            f"reaches {beyond.max():,.0f} m beyond all rooms",
            "lengths are metres: correct its ends or leave it out",
            place=f"walls[{int(beyond.argmax())}]",
        )


def _apart(bounds: Floats) -> tuple[int, float]:
    """The widest gap between boxes ``(n, 4)`` along x or y that no box spans, and a box on the
    side of it where there are fewer.

    >>> _apart(np.array([[0.0, 0, 1, 1], [2.0, 0, 3, 1], [9.0, 0, 10, 1]]))
    (2, 6.0)
    """
    lone, widest = 0, 0.0
    for axis in (0, 1):
        order = np.argsort(bounds[:, axis], kind="stable")
        starts = bounds[order[1:], axis]
        reached = np.maximum.accumulate(bounds[order, axis + 2])[:-1]
        gaps = starts - reached
        if len(gaps) and gaps.max() > widest:
            k, widest = int(gaps.argmax()), float(gaps.max())
            lone = int(order[k + 1] if k + 1 > len(order) // 2 else order[k])
    return lone, widest
