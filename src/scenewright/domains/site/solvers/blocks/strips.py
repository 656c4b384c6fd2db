"""Strips of free ground: where rows of buildings of some depth fit in a block of any shape.

In a frame turned with the rows, x runs along a row and y towards its front. A strip y0 … y1 is
free between two values of x if no edge of the block passes between them and the middle is inside:
so a row placed there is inside by construction, holes and slanting borders included.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]

MANY = 64
"""Edges of a block that are worth a look at which of them a strip meets."""
STEP = 1.0
"""How far a strip is moved on when nothing fits, in metres."""


class Turned(NamedTuple):
    """Edges (e, 4) of a block in the frame of its rows, and the heading of the fronts."""

    edges: Floats
    heading: float


def rotate_block(edges: Floats, heading: float) -> Turned:
    """The block in a frame with x to the right of the fronts and y ahead.

    ``edges`` (e, 4) in metres, ``heading`` in radians.

    >>> square = np.array([[0, 0, 4, 0], [4, 0, 4, 2], [4, 2, 0, 2], [0, 2, 0, 0]], float)
    >>> rotate_block(square, np.pi / 2).edges[0].round(6).tolist()
    [0.0, 0.0, 4.0, 0.0]
    """
    c, s = math.cos(heading), math.sin(heading)
    matrix = np.array([[s, c], [-c, s]])
    return Turned(np.hstack([edges[:, :2] @ matrix, edges[:, 2:] @ matrix]), heading)


def back(x: Floats, y: Floats, heading: float) -> tuple[Floats, Floats]:
    """Points of the rows' frame in that of the site.

    ``x`` and ``y`` of one shape, such as (n,), in metres; ``heading`` in radians.
    """
    c, s = math.cos(heading), math.sin(heading)
    return x * s + y * c, -x * c + y * s


def free_spans(block: Turned, y0: float, y1: float) -> Floats:
    """Spans (k, 2) of x over which all of the strip between two heights is inside the block.

    >>> square = np.array([[0, 0, 4, 0], [4, 0, 4, 2], [4, 2, 0, 2], [0, 2, 0, 0]], float)
    >>> free_spans(rotate_block(square + 1.0, np.pi / 2), 1.5, 2.5).round(6).tolist()
    [[1.0, 5.0]]
    """
    edges = block.edges
    if len(edges) > MANY:  # only those of the strip matter, for what is inside as well
        ay, by = edges[:, 1], edges[:, 3]
        edges = edges[((ay < y1) | (by < y1)) & ((ay > y0) | (by > y0))]
    work, spans = np.empty((len(edges), 2)), np.empty((len(edges), 2))
    return spans[: write_spans(edges, y0, y1, work, spans) if len(edges) else 0]


@compiled
def write_spans(edges: Floats, y0: float, y1: float, work: Floats, spans: Floats) -> int:
    """Write the free spans of a strip to ``spans`` (e, 2), and say how many; ``work`` (e, 2) is
    scratch: what each edge takes of x in the strip, sorted by where it starts."""
    count = 0
    for k in range(edges.shape[0]):
        ax, ay, bx, by = edges[k, 0], edges[k, 1], edges[k, 2], edges[k, 3]
        if min(ay, by) >= y1 or max(ay, by) <= y0:
            continue
        if ay != by:
            t0 = min(max((y0 - ay) / (by - ay), 0.0), 1.0)
            t1 = min(max((y1 - ay) / (by - ay), 0.0), 1.0)
            ax, bx = ax + t0 * (bx - ax), ax + t1 * (bx - ax)
        low, high, place = min(ax, bx), max(ax, bx), count
        while place > 0 and work[place - 1, 0] > low:
            work[place, 0], work[place, 1] = work[place - 1, 0], work[place - 1, 1]
            place -= 1
        work[place, 0], work[place, 1] = low, high
        count += 1
    found, reach, middle = 0, work[0, 1], 0.5 * (y0 + y1)
    for k in range(1, count):
        if work[k, 0] > reach + 1e-9 and inside(edges, 0.5 * (reach + work[k, 0]), middle):
            spans[found, 0], spans[found, 1] = reach, work[k, 0]
            found += 1
        reach = max(reach, work[k, 1])
    return found


@compiled
def next_strip(
    edges: Floats,
    top: float,
    bottom: float,
    floor: tuple[float, float],
    work: Floats,
    spans: Floats,
) -> float:
    """The top of the first strip, going down by steps, with a span that holds a building; ``floor``
    the depth of the strip and the least width of those waiting, ``work`` and ``spans`` scratch.

    ``edges`` (e, 4); heights in metres.
    """
    deep, least = floor
    while top - deep >= bottom:
        for k in range(write_spans(edges, top - deep, top, work, spans)):
            if spans[k, 1] - spans[k, 0] >= least - 1e-9:
                return top
        top -= STEP
    return top


@inlined
def inside(edges: Floats, x: float, y: float) -> bool:
    """Whether a point lies inside: the outline goes round it once more than holes do. Holes may
    overlap each other and reach over the outline.

    ``edges`` (e, 4) x0, y0, x1, y1 in metres.
    """
    turns = 0
    for k in range(edges.shape[0]):
        ax, ay, bx, by = edges[k, 0], edges[k, 1], edges[k, 2], edges[k, 3]
        if (ay <= y) != (by <= y) and ax + (y - ay) / (by - ay) * (bx - ax) < x:
            turns += 1 if by < ay else -1
    return turns > 0
