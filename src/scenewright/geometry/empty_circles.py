"""How empty floor is, part by part: the largest circle with nothing in it, and all that lies far
from everything."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import distance_to_box, read_frame
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@compiled
def find_empty_circles(
    points: Floats, parts: Ints, far: Floats, frames: Floats, circles: Floats
) -> None:
    """Fill ``circles`` (z, 3), zeros before, with the middle and radius in metres of the largest
    circle of each part round one of its ``points`` (k, 2) that holds nothing of boxes, whose frames
    are ``frames`` (n, 8), and is no wider than the point's ``far`` (k,); ``parts`` (k,) says
    whose each point is. Of equal circles the first.

    A point is left as soon as a box is nearer than the best of its part so far, and the box that
    ended the last search, with those beside it in the list, is looked at first: so few are.
    """
    nearest = 0
    for i in range(points.shape[0]):
        best = circles[parts[i], 2]
        radius, nearest = _clear_radius(points[i, 0], points[i, 1], far[i], best, frames, nearest)
        if radius > best:
            circles[parts[i], 0] = points[i, 0]
            circles[parts[i], 1] = points[i, 1]
            circles[parts[i], 2] = radius


@compiled
def add_far_floor(
    points: Floats, parts: Ints, far: Floats, frames: Floats, least: Floats, sums: Floats
) -> None:
    """Add to ``sums`` (z,), for each of some ``points`` (k, 2) of a part, the metres by which it is
    farther than the ``least`` (z,) of its part from all boxes, whose frames are ``frames`` (n, 8);
    at most ``far`` (k,); ``parts`` (k,) says whose each point is."""
    nearest = 0
    for i in range(points.shape[0]):
        most = least[parts[i]]
        radius, nearest = _clear_radius(points[i, 0], points[i, 1], far[i], most, frames, nearest)
        sums[parts[i]] += max(radius - most, 0.0)


@inlined
def _clear_radius(
    x: float, y: float, far: float, best: float, frames: Floats, start: int
) -> tuple[float, int]:
    """Distance of a point to the nearest box, at most ``far``, and the number of that box; or any
    distance up to ``best`` as soon as one is known. Boxes by their distance in the list from
    number ``start``."""
    radius, nearest, count = far, start, frames.shape[0]
    for step in range(2 * count):
        if radius <= best:
            break
        k = start - (step + 1) // 2 if step % 2 else start + step // 2
        if 0 <= k < count:
            distance = distance_to_box(x, y, read_frame(frames, k))
            if distance < radius:
                radius, nearest = distance, k
    return radius, nearest
