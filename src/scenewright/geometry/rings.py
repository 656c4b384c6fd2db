"""Polygons that move: exact areas they share with each other and with the ground.

A *ring* is a simple polygon in the frame of a box, as directed edges ``(e, 4)`` with the inside on
the left. The area under its edges is a sum with signs: edge e, from x0 to x1, counts the area below
it, positive where it runs to the left. So the area common to two polygons is the sum over all
pairs of edges, with the product of their signs, of what lies below both:

    area(A ∩ B) = Σ_e Σ_f s_e s_f ∫ min(y_e(x), y_f(x)) dx

over the x both cover. No clipping, no convex parts; what lies below all cancels, so no base is
needed (the idea of area by trapezoids, carried from one polygon to two).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.geometry.boxes import Frame, area_under
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MITRE = 2.0


class Rings(NamedTuple):
    """Rings of several things, each grown by several distances: ``edges`` (e, 4), those of thing i
    grown by the k-th distance being rows ``spans[i, k]``; ``facts`` (n, g, 4) are its greatest
    distances from the origin along x, along y and anyhow, in metres, and its area in square metres.
    Without any things (``spans`` of no rows) all are boxes."""

    edges: Floats
    spans: Ints
    facts: Floats


def make_rings(outlines: Sequence[Floats], distances: Sequence[float]) -> Rings:
    """The rings of outlines (k, 2), counter-clockwise, each grown with mitred corners by each of
    the distances.

    >>> square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    >>> make_rings([square], [0.0, 0.5]).facts[0, :, 3].tolist()
    [4.0, 9.0]
    """
    edges, spans, facts = [np.zeros((0, 4))], [], []
    start = 0
    for outline in outlines:
        for distance in distances:
            shape = shapely.Polygon(outline)
            grown = shape.buffer(distance, join_style="mitre", mitre_limit=MITRE)
            ring = _exterior(grown if distance else shape)
            edges.append(np.hstack([ring, np.roll(ring, -1, axis=0)]))
            spans.append((start, start + len(ring)))
            reach = np.abs(ring).max(0)
            area = shapely.Polygon(ring).area
            facts.append((*reach, np.hypot(*ring.T).max(), area))
            start += len(ring)
    shape = (len(outlines), len(distances))
    return Rings(
        np.concatenate(edges),
        np.array(spans, np.int64).reshape(*shape, 2),
        np.array(facts, np.float64).reshape(*shape, 4),
    )


def _exterior(shape: shapely.Polygon) -> Floats:
    """Corners of the outer ring of a polygon, counter-clockwise. A courtyard closed by growing
    counts as covered."""
    ring = shapely.get_coordinates(shape.exterior)[:-1]
    return ring if shapely.is_ccw(shape.exterior) else ring[::-1]


@inlined
def height_on(x: float, x0: float, y0: float, x1: float, y1: float) -> float:
    """The height at ``x`` of an edge that is not upright, reckoned from its nearer end."""
    slope = (y1 - y0) / (x1 - x0)
    y = y0 + (x - x0) * slope if abs(x - x0) <= abs(x - x1) else y1 + (x - x1) * slope
    return min(max(y, min(y0, y1)), max(y0, y1))


@inlined
def area_below(
    edges: Floats, first: int, last: int, u0: float, v0: float, u1: float, v1: float
) -> float:
    """Signed share of one directed edge of another polygon in the area it has in common with the
    ring of edges (e, 4) ``first`` to ``last`` - 1."""
    total = 0.0
    left, right = (u0, u1) if u0 < u1 else (u1, u0)
    for e in range(first, last):
        x0, y0, x1, y1 = edges[e, 0], edges[e, 1], edges[e, 2], edges[e, 3]
        low, high = (x0, x1) if x0 < x1 else (x1, x0)
        low, high = max(low, left), min(high, right)
        if low < high:
            a, b = height_on(low, x0, y0, x1, y1), height_on(high, x0, y0, x1, y1)
            c, d = height_on(low, u0, v0, u1, v1), height_on(high, u0, v0, u1, v1)
            before, after = a - c, b - d
            if before <= 0.0 and after <= 0.0:
                mean = 0.5 * (a + b)
            elif before >= 0.0 and after >= 0.0:
                mean = 0.5 * (c + d)
            else:
                t = before / (before - after)
                middle = a + t * (b - a)
                mean = (
                    0.5 * (t * (a + middle) + (1.0 - t) * (middle + d))
                    if before < 0.0
                    else 0.5 * (t * (c + middle) + (1.0 - t) * (middle + b))
                )
            same = (x0 < x1) == (u0 < u1)
            total += (high - low) * mean if same else (low - high) * mean
    return total


@compiled
def ring_in_polygon(frame: Frame, rings: Rings, i: int, grown: int, edges: Floats) -> float:
    """Area common to thing ``i``, its frame standing at ``frame``, and the polygon of directed
    edges (m, 4), square metres."""
    x, y, c, s, total = frame[0], frame[1], frame[2], frame[3], 0.0
    first, last = rings.spans[i, grown, 0], rings.spans[i, grown, 1]
    w, d = rings.facts[i, grown, 0], rings.facts[i, grown, 1]
    for e in range(edges.shape[0]):
        x0, y0, x1, y1 = edges[e, 0] - x, edges[e, 1] - y, edges[e, 2] - x, edges[e, 3] - y
        u0, v0, u1, v1 = x0 * s - y0 * c, x0 * c + y0 * s, x1 * s - y1 * c, x1 * c + y1 * s
        beside = max(u0, u1) <= -w or min(u0, u1) >= w
        if not beside and (v0 > -d or v1 > -d):
            total += area_below(rings.edges, first, last, u0, v0, u1, v1)
    return min(max(total, 0.0), rings.facts[i, grown, 3])


@compiled
def ring_in_ring(a: Frame, i: int, b: Frame, j: int, grown: int, rings: Rings) -> float:
    """Area common to things ``i`` at ``a`` and ``j`` at ``b``, both grown alike, square metres."""
    dx, dy, c, s = b[0] - a[0], b[1] - a[1], a[2], a[3]
    reach = rings.facts[i, grown, 2] + rings.facts[j, grown, 2]
    if dx * dx + dy * dy >= reach * reach:
        return 0.0
    u, v, total = dx * s - dy * c, dx * c + dy * s, 0.0
    c, s = b[2] * c + b[3] * s, b[3] * c - b[2] * s
    first, last = rings.spans[i, grown, 0], rings.spans[i, grown, 1]
    w, d = rings.facts[i, grown, 0], rings.facts[i, grown, 1]
    for e in range(rings.spans[j, grown, 0], rings.spans[j, grown, 1]):
        x0, y0, x1, y1 = (
            rings.edges[e, 0],
            rings.edges[e, 1],
            rings.edges[e, 2],
            rings.edges[e, 3],
        )
        u0, v0 = u + c * x0 - s * y0, v + s * x0 + c * y0
        u1, v1 = u + c * x1 - s * y1, v + s * x1 + c * y1
        beside = max(u0, u1) <= -w or min(u0, u1) >= w
        if not beside and (v0 > -d or v1 > -d):
            total += area_below(rings.edges, first, last, u0, v0, u1, v1)
    return min(max(total, 0.0), min(rings.facts[i, grown, 3], rings.facts[j, grown, 3]))


@compiled
def ring_in_box(a: Frame, i: int, grown: int, rings: Rings, b: Frame) -> float:
    """Area common to thing ``i`` at ``a`` and a box, square metres."""
    dx, dy, c, s, total = a[0] - b[0], a[1] - b[1], b[2], b[3], 0.0
    u, v = dx * s - dy * c, dx * c + dy * s
    c, s = a[2] * c + a[3] * s, a[3] * c - a[2] * s
    for e in range(rings.spans[i, grown, 0], rings.spans[i, grown, 1]):
        x0, y0, x1, y1 = (
            rings.edges[e, 0],
            rings.edges[e, 1],
            rings.edges[e, 2],
            rings.edges[e, 3],
        )
        u0, v0 = u + c * x0 - s * y0, v + s * x0 + c * y0
        u1, v1 = u + c * x1 - s * y1, v + s * x1 + c * y1
        total += area_under(u0, v0, u1, v1, b[4], b[5])
    return min(max(total, 0.0), 4.0 * b[4] * b[5])
