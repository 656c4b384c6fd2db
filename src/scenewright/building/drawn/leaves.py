"""Leaves of doors: quarter circles with a line from their middle to one of their ends."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import STRtree

from scenewright.building.drawn.drawing import Arc, Segments

AWAY = 0.12
"""How far the line may lie from the middle and end of its arc, as a share of the radius."""


def find_leaves(arcs: Sequence[Arc], lines: Segments) -> tuple[Arc, ...]:
    """The arcs that a leaf sweeps; all if none has a leaf.

    >>> arc = Arc((0.0, 0.0), 1.0, (1.0, 0.0), (0.0, 1.0))
    >>> other = Arc((5.0, 5.0), 0.2, (5.2, 5.0), (5.0, 5.2))
    >>> find_leaves([arc, other], np.array([[[0.0, 0.0], [0.0, 1.0]]])) == (arc,)
    True
    """
    if not len(lines) or not arcs:
        return tuple(arcs)
    tree = STRtree(shapely.points(lines.reshape(-1, 2)))
    found = tuple(arc for arc in arcs if _has_leaf(arc, lines, tree))
    return found or tuple(arcs)


def _has_leaf(arc: Arc, lines: Segments, tree: STRtree) -> bool:
    """Whether a line joins the middle of an arc to one of its ends."""
    reach = AWAY * arc.radius
    near = tree.query(shapely.Point(arc.middle), predicate="dwithin", distance=reach)
    for number in near.tolist():
        other = lines[number // 2, 1 - number % 2]
        ends = np.array([arc.start, arc.end])
        if np.hypot(*(ends - other).T).min() <= 1.5 * reach:
            return True
    return False
