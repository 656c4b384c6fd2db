"""Courts that close: buildings round a rectangle of a block, no opening wider than asked for.

The rectangle is drawn in from the largest one in the block, along either side, until the buildings
waiting go round it. Of those that close, that with the most floor round it is taken, then the one
with the largest court.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.settings import CourtSettings
from scenewright.domains.site.solvers.blocks.court_rings import RingRule, find_ring, make_ring_work
from scenewright.domains.site.solvers.blocks.distances import noon
from scenewright.domains.site.solvers.blocks.perimeter_block import HAIR
from scenewright.domains.site.solvers.blocks.strips import back, rotate_block
from scenewright.geometry.compiled import compiled
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
    sizes, sides = problem.buildings.sizes, sides * _list_shares(sides, rule)
    wide = sorted(queue, key=lambda i: (-sizes[i, 0], i))
    orders = np.array(list(dict.fromkeys((tuple(queue), tuple(wide), tuple(wide[::-1])))))
    toward = noon(problem) - heading + 0.5 * math.pi
    widest = problem.court_gap - 1e-3
    ring_rule = RingRule(gap + HAIR, widest, rule.fewest, problem.sun_spacing, toward)
    bounds, places = _bound_floor(2.0 * sides.sum(1), sizes[queue]), np.empty((len(queue), 5))
    found, work = np.empty(2 + len(queue), np.int64), make_ring_work(len(queue))
    count = find_ring(sides, bounds, sizes[orders], ring_rule, work, places, found)
    if not count:
        return None
    boxes = places[:count]
    boxes[:, 0], boxes[:, 1] = back(boxes[:, 0], boxes[:, 1], heading)
    boxes[:, :2] += middle
    boxes[:, 2] = (boxes[:, 2] + heading + 0.5 * math.pi) % (2.0 * math.pi) - math.pi
    numbers = orders[found[1], found[2 : 2 + count]].tolist()
    return ClosedCourt(numbers, boxes, _ring(middle, sides[found[0]], heading))


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
    free = np.empty((len(y), len(x)), np.bool_)
    mark_inside(turned, x, y, np.empty(len(x)), free)
    held = free[:-1, :-1] & free[1:, :-1] & free[:-1, 1:] & free[1:, 1:]
    r0, r1, c0, c1 = largest_rectangle(held)
    if r1 <= r0 or c1 <= c0:
        return None
    first, last = np.array([x[c0], y[r0]]), np.array([x[c1], y[r1]])
    x0, y0 = 0.5 * (first + last)[:, None]
    middle = np.stack(back(x0, y0, heading), -1)[0]
    return middle, last - first, heading


@compiled
def mark_inside(edges: Floats, x: Floats, y: Floats, turns: Floats, free: Flags) -> None:
    """Mark which points of a grid (rows ``y``, columns ``x``) the outline of directed edges (e, 4)
    goes round once more than holes, which may overlap, do; ``turns`` (columns,) is scratch."""
    for row in range(y.shape[0]):
        turns[:] = 0.0
        for e in range(edges.shape[0]):
            ax, ay, bx, by = edges[e, 0], edges[e, 1], edges[e, 2], edges[e, 3]
            if (ay <= y[row]) == (by <= y[row]):
                continue
            left, way = ax + (y[row] - ay) / (by - ay) * (bx - ax), 1.0 if by < ay else -1.0
            for column in range(x.shape[0]):
                turns[column] += way if left < x[column] else 0.0
        for column in range(x.shape[0]):
            free[row, column] = turns[column] > 0.0


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
