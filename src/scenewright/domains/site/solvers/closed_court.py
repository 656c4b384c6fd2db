"""Courts that close: buildings round a rectangle of a block, no opening wider than asked for.

The rectangle is drawn in from the largest one in the block, along either side, until the buildings
waiting go round it. Of those that close, that with the most floor round it is taken, then the one
with the largest court.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.settings import CourtSettings
from scenewright.domains.site.solvers.distances import mark_shaded, noon
from scenewright.domains.site.solvers.perimeter_block import rim
from scenewright.domains.site.solvers.strips import back, rotate_block
from scenewright.geometry.rectangles import largest_rectangle

CELL = 1.0
"""Side of the cells in which the largest rectangle is looked for, in metres."""


class ClosedCourt(NamedTuple):
    """Buildings round a court, numbers and boxes (k, 5), and the ring (4, 2) they stand in."""

    numbers: list[int]
    boxes: Floats
    ring: Floats


def close_court(
    problem: SiteProblem, edges: Floats, queue: list[int], gap: float
) -> ClosedCourt | None:
    """Buildings of a queue round a court in a block of ``edges`` (e, 4), ``gap`` metres apart at
    least and ``court_gap`` at most; ``None`` if they close none."""
    whole, rule = find_rectangle(edges), problem.settings.courts
    if whole is None or len(queue) < rule.fewest:
        return None
    middle, sides, heading = whole
    best, most, sizes = None, (0.0, 0.0), problem.buildings.sizes
    wide = sorted(queue, key=lambda i: (-sizes[i, 0], i))
    orders = list(dict.fromkeys((tuple(queue), tuple(wide), tuple(wide[::-1]))))
    shares = _list_shares(sides, rule)
    bounds = _bound_floor(2.0 * (sides * shares).sum(1), sizes[queue])
    for share, bound in zip(shares, bounds.tolist(), strict=True):
        if bound < most[0]:
            continue
        ring = _ring(middle, sides * share, heading)
        rows = np.hstack([ring, np.roll(ring, -1, axis=0)])
        for order in orders:
            numbers, boxes = rim(rows, sizes, [*order], gap, 1.0)
            floor = float(boxes[:, 3] @ boxes[:, 4]) if len(numbers) >= rule.fewest else 0.0
            worth = (round(floor, 3), float((sides * share).prod()))
            if floor and worth > most and _closes(problem, numbers, boxes):
                best, most = ClosedCourt(numbers, boxes, ring), worth
    return best


def _bound_floor(around: Floats, sizes: Floats) -> Floats:
    """Square metres (n,) that buildings of some sizes cover at most along so many metres
    ``around`` (n,): as if each could be cut, the deepest first, and a trifle more."""
    deepest = sizes[np.argsort(-sizes[:, 1], kind="stable"), :2]
    long, floor = np.cumsum(deepest[:, 0]), np.cumsum(deepest.prod(1))
    most: Floats = np.interp(around, [0.0, *long], [0.0, *floor]) + 2e-3
    return most


def find_rectangle(edges: Floats) -> tuple[Floats, Floats, float] | None:
    """Middle (2,), sides (2,) and heading of the largest rectangle in a block along its longest
    edge, to a metre; ``None`` if there is none."""
    along = edges[:, 2:] - edges[:, :2]
    longest = along[int(np.argmax(np.hypot(along[:, 0], along[:, 1])))]
    heading = math.atan2(longest[0], -longest[1])
    turned = rotate_block(edges, heading).edges
    low, high = turned.reshape(-1, 2).min(0), turned.reshape(-1, 2).max(0)
    cell = max(CELL, float((high - low).max()) / 200.0)
    x, y = (np.arange(a + 1e-6, b, cell) for a, b in zip(low, high, strict=True))
    if len(x) < 3 or len(y) < 3:
        return None
    grid = np.stack(np.meshgrid(x, y), -1)
    free = _lie_inside(turned, grid.reshape(-1, 2)).reshape(len(y), len(x))
    held = free[:-1, :-1] & free[1:, :-1] & free[:-1, 1:] & free[1:, 1:]
    r0, r1, c0, c1 = largest_rectangle(held)
    if r1 <= r0 or c1 <= c0:
        return None
    first, last = np.array([x[c0], y[r0]]), np.array([x[c1], y[r1]])
    x0, y0 = 0.5 * (first + last)[:, None]
    middle = np.stack(back(x0, y0, heading), -1)[0]
    return middle, last - first, heading


def _lie_inside(edges: Floats, points: Floats) -> Flags:
    """Which of points (k, 2) the outline of directed edges (e, 4) goes round once more than holes,
    which may overlap, do."""
    (ax, ay), (bx, by) = edges[:, :2].T, edges[:, 2:].T
    x, y = points[:, :1], points[:, 1:]
    across = (ay <= y) != (by <= y)
    left = ax + (y - ay) / np.where(ay == by, 1.0, by - ay) * (bx - ax) < x
    turns: Flags = ((across & left) * np.where(by < ay, 1, -1)).sum(1) > 0
    return turns


def _list_shares(sides: Floats, rule: CourtSettings) -> Floats:
    """Shares (n, 2) of both sides of a rectangle to be tried."""
    rows = [
        np.linspace(
            1.0, rule.least, min(rule.tried, int(side * (1.0 - rule.least) / rule.drawn_in) + 2)
        )
        for side in sides
    ]
    return np.stack(np.meshgrid(*rows), -1).reshape(-1, 2)


def _ring(middle: Floats, sides: Floats, heading: float) -> Floats:
    """The corners (4, 2) of a rectangle, counter-clockwise."""
    at = 0.5 * sides * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return middle + np.column_stack(back(at[:, 0], at[:, 1], heading))


def _closes(problem: SiteProblem, numbers: list[int], boxes: Floats) -> bool:
    """Whether neighbours round a court are near enough and none stands in another one's shade."""
    shapes = shapely.polygons(corners(boxes))
    if shapely.distance(shapes, np.roll(shapes, -1)).max() > problem.court_gap - 1e-3:
        return False
    if problem.sun_spacing <= 0.0:
        return True
    heights, dark = problem.buildings.sizes[numbers, 2], np.empty(len(boxes), bool)
    work = np.empty((len(boxes), 5))
    mark_shaded(boxes, heights, noon(problem), problem.sun_spacing, work, dark)
    return not dark.any()
