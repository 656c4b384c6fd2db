"""How layouts of boxes are composed: what does not change, and plain cases by hand."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from scenewright.geometry.composition import NAMES, box_distances, measure_composition
from scenewright.geometry.composition import _enclosure as enclosure

FLOOR = shapely.box(0.0, 0.0, 12.0, 8.0)
TURNING = {"axis_straight", "axis_diagonal", "facing_east", "facing_north", "off_east", "off_north"}


def some_boxes(seed: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    at = rng.uniform((1, 1), (11, 7), (9, 2))
    turn = rng.uniform(0, 2 * np.pi, 9)
    return np.c_[at, turn, rng.uniform(0.5, 1.5, (9, 2))], rng.integers(0, 3, 9)


def polygon_of(box: np.ndarray) -> shapely.Polygon:
    """A box as a polygon, by turning and moving one at the origin."""
    x, y, turn, width, depth = box
    upright = shapely.box(-depth / 2, -width / 2, depth / 2, width / 2)
    turned = shapely.affinity.rotate(upright, turn, origin=(0, 0), use_radians=True)
    return shapely.affinity.translate(turned, x, y)


def compose(boxes: np.ndarray, kinds: np.ndarray, floor: shapely.Polygon) -> dict[str, float]:
    return dict(zip(NAMES, measure_composition(boxes, kinds, floor).tolist(), strict=True))


@pytest.mark.parametrize("seed", range(3))
def test_order_place_and_size_do_not_matter(seed: int) -> None:
    boxes, kinds = some_boxes(seed)
    known = measure_composition(boxes, kinds, FLOOR)
    order = np.random.default_rng(seed).permutation(len(boxes))
    assert measure_composition(boxes[order], kinds[order], FLOOR) == pytest.approx(known)
    moved = boxes + np.array([100.0, -50.0, 0.0, 0.0, 0.0])
    there = shapely.affinity.translate(FLOOR, 100.0, -50.0)
    assert measure_composition(moved, kinds, there) == pytest.approx(known, abs=1e-6)
    larger = boxes * [3.0, 3.0, 1.0, 3.0, 3.0]
    wide = shapely.affinity.scale(FLOOR, 3.0, 3.0, origin=(0, 0))
    assert measure_composition(larger, kinds, wide) == pytest.approx(known, abs=1e-6)


def test_half_a_turn_changes_only_what_has_a_direction() -> None:
    boxes, kinds = some_boxes(1)
    turned = boxes * [-1, -1, 1, 1, 1] + np.array([12.0, 8.0, np.pi, 0, 0])
    one, other = compose(boxes, kinds, FLOOR), compose(turned, kinds, FLOOR)
    for name in NAMES:
        if name not in TURNING:
            assert other[name] == pytest.approx(one[name], abs=1e-6), name
    assert other["facing_east"] == pytest.approx(-one["facing_east"])
    assert other["off_north"] == pytest.approx(-one["off_north"])


def test_plain_cases() -> None:
    row = np.array([[2.0, 4.0, 0.0, 1.0, 1.0], [5.0, 4.0, 0.0, 1.0, 1.0], [8.0, 4.0, 0, 1.0, 1.0]])
    row[:, 2] = np.pi / 2
    told = compose(row, np.array([0, 0, 1]), FLOOR)
    assert told["density"] == pytest.approx(3 / 96)
    assert told["gaps"] == pytest.approx(3 / 96**0.5)
    assert told["uneven_gaps"] == pytest.approx(0.0)
    assert told["alignment"] == pytest.approx(1.0)
    assert told["rows"] == 1.0
    assert told["mixing"] == pytest.approx(1 / 3)
    assert compose(np.zeros((0, 5)), np.zeros(0, int), FLOOR)["open"] == 0.0


def test_distances_are_those_of_polygons() -> None:
    boxes, _ = some_boxes(2)
    points = np.random.default_rng(3).uniform(-2, 14, (40, 2))
    for k, box in enumerate(boxes):
        exact = shapely.distance(shapely.points(points), polygon_of(box))
        assert box_distances(points, boxes)[:, k] == pytest.approx(exact, abs=1e-9)


def test_enclosure_is_what_rays_meet() -> None:
    """Against lines and polygons, ray by ray."""
    boxes, _ = some_boxes(4)
    eyes = np.array([[6.0, 4.0], [1.0, 1.0]])
    shapes = [polygon_of(box) for box in boxes]
    angles = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    ways = np.stack([np.cos(angles), np.sin(angles)], 1)
    rays = [shapely.LineString([eye, eye + 3 * way]) for eye in eyes for way in ways]
    met = [any(ray.intersects(shape) for shape in shapes) for ray in rays]
    assert enclosure(eyes, boxes, 3.0) == pytest.approx(np.mean(met))
