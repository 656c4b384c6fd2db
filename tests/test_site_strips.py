"""Strips and rims of blocks: free spans as exact polygons say, rims that keep their distances."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from scenewright.building.outlines import edges, rings
from scenewright.core.layout import corners
from scenewright.domains.site.solvers.blocks.perimeter_block import rim
from scenewright.domains.site.solvers.blocks.rows import StripRule, rows
from scenewright.domains.site.solvers.blocks.strips import back, free_spans, rotate_block


def block(seed: int, holes: int = 3) -> shapely.Polygon:
    """A ragged block with some rectangles cut out of it."""
    rng = np.random.default_rng(seed)
    turn = np.sort(rng.uniform(0, 2 * np.pi, 9))
    ring = np.stack([np.cos(turn), np.sin(turn)], 1) * rng.uniform(40, 90, (9, 1))
    shape = shapely.Polygon(ring).buffer(0)
    for x, y, w, d in rng.uniform([-50, -50, 5, 5], [30, 30, 30, 30], (holes, 4)):
        shape = shape.difference(shapely.box(x, y, x + w, y + d))
    return max(shapely.get_parts(shape), key=lambda part: part.area)


def edges_of(shape: shapely.Polygon) -> np.ndarray:
    outline, holes = rings(shape)
    return np.concatenate([edges(ring) for ring in (outline, *holes)])


@given(st.integers(0, 10_000), st.floats(-70, 60), st.floats(0.5, 30), st.floats(-3.1, 3.1))
def test_free_spans_are_those_of_exact_polygons(
    seed: int, low: float, deep: float, heading: float
) -> None:
    view = rotate_block(edges_of(block(seed)), heading)
    found = free_spans(view, low, low + deep)
    lines = shapely.get_parts(
        shapely.polygonize(list(shapely.linestrings(view.edges.reshape(-1, 2, 2))))
    )
    floor = max(lines, key=lambda part: part.area)
    strip = shapely.box(-200.0, low, 200.0, low + deep)
    for x0, x1 in found:
        assert x1 > x0
        part = shapely.box(x0 + 1e-6, low + 1e-6, x1 - 1e-6, low + deep - 1e-6)
        assert floor.buffer(1e-5).covers(part)
    blocked = shapely.get_parts(strip.difference(floor))
    shut = [part.bounds[::2] for part in blocked if part.area > 1e-9]
    open_x = (
        400.0 - shapely.union_all([shapely.LineString([(a, 0), (b, 0)]) for a, b in shut]).length
    )
    assert (found[:, 1] - found[:, 0]).sum() == pytest.approx(open_x, abs=1e-4)


@pytest.mark.parametrize("around", [True, False])
@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10_000), gap=st.floats(0.0, 8.0))
@example(seed=9203, gap=0.08)  # neighbours whose corners meet at a bend
@example(seed=4222, gap=0.035)
def test_rims_and_rows_stand_inside_and_apart(around: bool, seed: int, gap: float) -> None:
    shape = block(seed)
    rng = np.random.default_rng(seed)
    sizes = rng.uniform([8, 8, 6], [30, 16, 40], (20, 3))
    queue = list(range(20))
    if around:
        numbers, boxes = rim(edges_of(shape), sizes, queue, gap, 0.7)
        assert len(numbers) <= 14
    else:
        heading = float(rng.uniform(-3, 3))
        placed = rows(
            rotate_block(edges_of(shape), heading),
            sizes,
            queue,
            StripRule(gap, 4.0, 0.0, 1.0, False, True),
        )
        numbers, at = [i for i, _, _ in placed], np.array(placed).reshape(-1, 3)[:, 1:]
        boxes = np.zeros((len(numbers), 5))
        boxes[:, 0], boxes[:, 1] = back(at[:, 0], at[:, 1], heading)
        boxes[:, 2], boxes[:, 3:] = heading, sizes[numbers, :2]
    assume(numbers)  # the first of the queue fits nowhere along a few rims
    assert len(set(numbers)) == len(numbers)
    shapes = shapely.polygons(corners(boxes))
    assert (shapely.area(shapely.difference(shapes, shape)) < 1e-4).all()
    for k in range(len(shapes)):
        others = np.delete(shapes, k)
        apart = shapely.distance(shapes[k], others).min(initial=np.inf)
        assert apart >= gap - 1e-6
