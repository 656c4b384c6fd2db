"""A small k-d tree over points of any number of coordinates (J. L. Bentley 1975), in plain Python.

Points come nearest first, as far as they are asked for, by a queue of branches and points ordered
by distance (G. R. Hjaltason and H. Samet 1999). For some dozens of points this takes microseconds.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from heapq import heappop, heappush
from typing import NamedTuple

Point = Sequence[float]


class KdNode(NamedTuple):
    """A point by its number, the coordinate it parts by, and what lies below and above it there."""

    number: int
    point: Point
    axis: int
    below: KdNode | None
    above: KdNode | None


def plant(points: Sequence[Point]) -> KdNode | None:
    """The balanced tree of some points; ``None`` without any."""
    return _build_tree(points, list(range(len(points))), 0)


def nearest_first(tree: KdNode | None, place: Point, most: Point | None = None) -> Iterator[int]:
    """Indices of the points by their distance from ``place``, the lower index first where equal.

    ``most`` leaves out every point with a coordinate greater than its own.

    >>> tree = plant([(0.0, 0.0), (5.0, 1.0), (2.0, 2.0)])
    >>> list(nearest_first(tree, (4.0, 0.0))), list(nearest_first(tree, (4.0, 0.0), (4.0, 9.0)))
    ([1, 2, 0], [2, 0])
    """
    queue: list[tuple[float, int, KdNode | None]] = [(0.0, -1, tree)]
    while queue:
        distance, index, node = heappop(queue)
        if index >= 0:
            yield index
        elif node is not None:
            at, here = node.point[node.axis], place[node.axis]
            below, above = max(here - at, 0.0), max(at - here, 0.0)
            heappush(queue, (max(distance, below), -2 - 2 * node.number, node.below))
            if most is None or at <= most[node.axis]:
                heappush(queue, (max(distance, above), -3 - 2 * node.number, node.above))
            if most is None or all(a <= b for a, b in zip(node.point, most, strict=True)):
                heappush(queue, (math.dist(node.point, place), node.number, None))


def _build_tree(points: Sequence[Point], chosen: list[int], axis: int) -> KdNode | None:
    if not chosen:
        return None
    chosen.sort(key=lambda i: points[i][axis])
    half = len(chosen) // 2
    other = (axis + 1) % len(points[0])
    return KdNode(
        chosen[half],
        points[chosen[half]],
        axis,
        _build_tree(points, chosen[:half], other),
        _build_tree(points, chosen[half + 1 :], other),
    )
