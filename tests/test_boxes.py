"""Areas and distances of boxes against shapely, for any polygon with holes."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from rooms import ring
from scenewright.core.layout import corners
from scenewright.geometry.boxes import (
    area_in_polygon,
    beyond,
    common_area,
    distance_to_box,
    distance_to_segment,
    make_frame,
    wrap,
)

coordinate = st.floats(-5, 5).map(lambda x: round(x, 3))
length = st.floats(0.01, 6).map(lambda x: round(x, 3))
heading = st.floats(-7, 7) | st.integers(-4, 4).map(lambda k: k * np.pi / 2)
boxes = st.tuples(coordinate, coordinate, heading, length, length)


@st.composite
def polygons(draw):
    """A star-shaped polygon, sometimes on whole coordinates, sometimes with a hole."""
    count = draw(st.integers(3, 12))
    angles = np.sort(draw(st.lists(st.floats(0, 6.2), min_size=count, max_size=count, unique=True)))
    radii = np.array(draw(st.lists(st.floats(1, 6), min_size=count, max_size=count)))
    points = np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=1)
    points = np.round(points) if draw(st.booleans()) else points
    holes = [[(0.1, 0.1), (0.1, 0.3), (0.4, 0.2)]] if draw(st.booleans()) else []
    shape = shapely.Polygon(points, holes)
    return shapely.geometry.polygon.orient(shape) if shape.is_valid else shapely.box(-1, -1, 1, 1)


def edges_of(shape):
    rings = [shape.exterior, *shape.interiors]
    return np.concatenate([ring(np.array(r.coords)[:-1]) for r in rings])


def polygon_of(box):
    return shapely.Polygon(corners(np.array(box, float)))


@given(boxes, polygons())
def test_area_in_a_polygon_is_exact(box, shape):
    ours = area_in_polygon(make_frame(*box), np.ascontiguousarray(edges_of(shape)))
    assert ours == pytest.approx(polygon_of(box).intersection(shape).area, abs=1e-9)


@given(boxes, boxes)
def test_area_of_two_boxes_is_exact_and_symmetric(a, b):
    exact = polygon_of(a).intersection(polygon_of(b)).area
    assert common_area(make_frame(*a), make_frame(*b)) == pytest.approx(exact, abs=1e-9)
    assert common_area(make_frame(*b), make_frame(*a)) == pytest.approx(exact, abs=1e-9)


@given(boxes, coordinate, coordinate)
def test_distances_agree_with_shapely(box, x, y):
    point, sides = shapely.Point(x, y), corners(np.array(box, float))
    assert distance_to_box(x, y, make_frame(*box)) == pytest.approx(
        polygon_of(box).distance(point), abs=1e-9
    )
    segment = shapely.LineString(sides[:2])
    assert distance_to_segment(x, y, *sides[0], *sides[1]) == pytest.approx(
        segment.distance(point), abs=1e-9
    )


@given(boxes, st.integers(0, 3), length)
def test_zones_touch_their_side_from_outside(box, side, depth):
    frame = make_frame(*box)
    zone = beyond(frame, side, depth)
    turn = np.array([np.cos(box[2] + side * np.pi / 2), np.sin(box[2] + side * np.pi / 2)])
    away = np.array([zone[0] - box[0], zone[1] - box[1]])
    half = box[4] / 2 if side % 2 == 0 else box[3] / 2
    assert away == pytest.approx(turn * (half + depth / 2), abs=1e-9)
    assert common_area(frame, zone) == pytest.approx(0.0, abs=1e-9)
    assert 4 * zone[4] * zone[5] == pytest.approx(depth * (box[3] if side % 2 == 0 else box[4]))


@given(st.floats(-50, 50))
def test_wrap_keeps_the_direction(angle):
    assert abs(wrap(angle)) <= np.pi + 1e-9
    assert np.cos(wrap(angle)) == pytest.approx(np.cos(angle), abs=1e-9)
    assert np.sin(wrap(angle)) == pytest.approx(np.sin(angle), abs=1e-9)
