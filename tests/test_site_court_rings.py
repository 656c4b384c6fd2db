"""Rings of buildings round a court: as much floor as a plain search by areas finds."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from scenewright.core.layout import corners
from scenewright.domains.site.solvers.blocks.court_rings import RingRule, find_ring, make_ring_work
from scenewright.domains.site.solvers.blocks.distances import mark_shaded
from scenewright.domains.site.solvers.blocks.perimeter_block import HAIR, rim

GAP, WIDEST, NOON = 4.0, 11.0, -math.pi / 2


def plain_search(sides: np.ndarray, sizes: np.ndarray, sun: float) -> float:
    """The most floor of rings laid out side by side by :func:`rim` and judged by outlines."""
    best = 0.0
    for width, depth in sides.tolist():
        ring = 0.5 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * (width, depth)
        rows = np.hstack([ring, np.roll(ring, -1, axis=0)])
        numbers, boxes = rim(rows, sizes, list(range(len(sizes))), GAP, 1.0)
        shapes, dark = shapely.polygons(corners(boxes)), np.zeros(len(boxes), bool)
        if len(boxes) < 4 or shapely.distance(shapes, np.roll(shapes, -1)).max() > WIDEST:
            continue
        heights, work = sizes[numbers, 2], np.empty((len(boxes), 5))
        mark_shaded(boxes, heights, NOON, sun, work, dark)
        if sun <= 0.0 or not dark.any():
            best = max(best, float(boxes[:, 3] @ boxes[:, 4]))
    return best


@pytest.mark.parametrize("sun", [0.0, 0.55])
def test_the_ring_found_is_the_best_of_a_plain_search(sun: float) -> None:
    rng, closed = np.random.default_rng(3), 0
    for _ in range(40):
        sizes = np.column_stack(
            [rng.uniform(8, 24, 14), rng.uniform(8, 13, 14), rng.uniform(4, 9, 14)]
        )
        sides = rng.uniform(40.0, 75.0, (24, 2))
        rule = RingRule(GAP + HAIR, WIDEST, 4, sun, NOON)
        boxes, found = np.empty((14, 5)), np.empty(16, np.int64)
        count = find_ring(
            sides, np.full(24, math.inf), sizes[None], rule, make_ring_work(14), boxes, found
        )
        floor = float(sizes[found[2 : 2 + count], :2].prod(1).sum())
        assert floor == pytest.approx(plain_search(sides, sizes, sun), abs=1e-3)
        closed += count > 0
        if count:
            width, depth = sides[found[0]].tolist()
            inside = shapely.box(-width / 2, -depth / 2, width / 2, depth / 2)
            shapes = shapely.polygons(corners(boxes[:count]))
            assert shapely.area(shapely.difference(shapes, inside)).max() < 1e-5
            apart = shapely.distance(shapes[:, None], shapes[None]) + 1e9 * np.eye(count)
            assert apart.min() > GAP - 1e-9
    assert closed > 5
