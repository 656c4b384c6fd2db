"""Places along walls that touch a neighbour: between two pieces that touch no floor is lost.

Places are looked for in steps along each wall; what should stand beside something else, as a
washing machine beside the units of a kitchen, stands there exactly.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.grounds.wall_places import WallRows

Floats = NDArray[np.float64]

AT = 0.06  # what begins nearer to a wall than this stands at it, metres
FLUSH_GAP = 0.001  # between pieces that touch, metres
NARROWEST, WIDEST = 0.03, 0.4  # between these a gap is a slot, metres
LOW = 0.05  # what begins so low stands on the floor, metres


def list_flush(
    case: Group, walls: WallRows, standing: StandingObstacles, beside: frozenset[str]
) -> Floats:
    """The boxes ``(n, 5)`` of a case with its back at a wall and a side at something of the kinds
    ``beside`` that stands at the same wall; whether they are free is not asked.

    >>> from scenewright.domains.home.cases.library import cases
    >>> rows = np.array([[0.0, 0.0, 1.0, 0.0, 4.0]])
    >>> turns = np.array([[1.0, 0.0]])
    >>> wall = WallRows(rows, np.array([np.pi / 2]), turns, 4.0)
    >>> box, span = np.array([[2.0, 0.3, np.pi / 2, 1.0, 0.6]]), np.array([[0.0, 0.9]])
    >>> unit = StandingObstacles(box, span, ("fridge",))
    >>> found = list_flush(cases("washer").groups[0], wall, unit, frozenset(("fridge",)))
    >>> found[:, 0].round(2).tolist()
    [2.81, 1.19]
    """
    named = np.array([name in beside for name in standing.names], bool)
    boxes = standing.boxes[named & (standing.spans[:, 0] < LOW)]
    found = []
    for (x, y, ux, uy, length), heading in zip(walls.rows, walls.heading, strict=True):
        along, out, half, deep = seen_from(boxes, x, y, ux, uy)
        there = (out - deep < AT) & (out > 0) & (along + half > 0) & (along - half < length)
        after = (along + half)[there] + FLUSH_GAP + case.width / 2
        before = (along - half)[there] - FLUSH_GAP - case.width / 2
        middles = np.concatenate([after, before])
        middles = middles[(middles >= case.width / 2) & (middles <= length - case.width / 2)]
        found.append(boxes_along(middles, (x, y, ux, uy), heading, case))
    return np.concatenate(found) if found else np.empty((0, 5))


def seen_from(boxes: Floats, x: float, y: float, ux: float, uy: float) -> tuple[Floats, ...]:
    """Middle of each box along a wall and out from it, and half of what it takes of both."""
    dx, dy = boxes[:, 0] - x, boxes[:, 1] - y
    across = np.abs(np.sin(boxes[:, 2]) * ux - np.cos(boxes[:, 2]) * uy)
    turned = np.abs(np.cos(boxes[:, 2]) * ux + np.sin(boxes[:, 2]) * uy)
    half = (boxes[:, 3] * across + boxes[:, 4] * turned) / 2
    deep = (boxes[:, 4] * across + boxes[:, 3] * turned) / 2
    return dx * ux + dy * uy, dy * ux - dx * uy, half, deep


def boxes_along(
    middles: Floats, wall: tuple[float, float, float, float], heading: float, case: Group
) -> Floats:
    """The boxes ``(n, 5)`` of a case with its back at a wall (x, y of its start, its unit
    direction) and its middle at ``middles`` (n,) metres along it."""
    x, y, ux, uy = wall
    found = np.empty((len(middles), 5))
    found[:, 0] = x + ux * middles - uy * case.depth / 2
    found[:, 1] = y + uy * middles + ux * case.depth / 2
    found[:, 2:] = heading, case.width, case.depth
    return found
