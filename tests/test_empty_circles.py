"""The largest empty circle of each part of a floor, against every point and box in turn."""

from __future__ import annotations

import numpy as np

from scenewright.geometry.boxes import frames_of
from scenewright.geometry.empty_circles import add_far_floor, find_empty_circles


def distances(points: np.ndarray, box: np.ndarray) -> np.ndarray:
    """How far points (k, 2) are from a box (5,), 0 inside."""
    off = points - box[:2]
    ahead = off @ (np.cos(box[2]), np.sin(box[2]))
    aside = off @ (np.sin(box[2]), -np.cos(box[2]))
    beyond = np.stack([np.abs(aside) - 0.5 * box[3], np.abs(ahead) - 0.5 * box[4]])
    return np.hypot(*np.maximum(beyond, 0.0))


def test_the_circles_are_those_of_looking_at_every_point_and_box() -> None:
    rng = np.random.default_rng(3)
    for count in (0, 1, 7, 60):
        points, parts = rng.uniform(0, 40, (500, 2)), rng.integers(0, 3, 500)
        boxes = rng.uniform([0, 0, -3, 0.3, 0.3], [40, 40, 3, 5, 5], (count, 5))
        far, circles = rng.uniform(0, 20, 500), np.zeros((4, 3))
        find_empty_circles(points, parts, far, frames_of(boxes), circles)
        radius = np.min([far, *(distances(points, box) for box in boxes)], axis=0)
        for part in range(3):
            best = np.flatnonzero(parts == part)[radius[parts == part].argmax()]
            np.testing.assert_allclose(circles[part], (*points[best], radius[best]))
        assert not circles[3].any()
        least, sums = np.array([1.0, 4.0, 0.0, 2.0]), np.zeros(4)
        add_far_floor(points, parts, far, frames_of(boxes), least, sums)
        beyond = np.maximum(radius - least[parts], 0.0)
        np.testing.assert_allclose(sums, np.bincount(parts, beyond, 4), atol=1e-9)
