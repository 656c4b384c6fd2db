"""Outlines of storeys: rectangles a storey is divided within, and how they lie on the ground."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.outline_forms import OutlineName, interpolate, skew_corners

Floats = NDArray[np.float64]
HALL_LONG, HALL_DEEP = 6.3, 2.45
"""Middle lines of a hall with stairs: a straight flight of 17 steps with 1.5 m at its foot and
0.9 m at its head, and 1.3 m to walk beside it."""
HALL_SHARE = 0.7
"""Least share of a home's width that such a hall borders."""
LEAST_SIDE = 2.0
"""Least width of a block beside the hall, metres: a bathroom's."""


class Ground(NamedTuple):
    """Where a plan is made and where it lies.

    ``parts`` (k, 4) are rectangles x0, y0, x1, y1 that a storey is divided within; ``hall`` one
    more, the hall of all storeys (None: among the rooms). ``lit_sides`` (4,) is 1 for sides (west,
    south, east, north) that may have windows. ``corners`` (4, 2) are where the corners of the
    rectangle of ``size`` lie, from (0, 0) counter-clockwise.
    """

    parts: Floats
    hall: Floats | None
    lit_sides: Floats
    size: tuple[float, float]
    corners: Floats

    def lay(self, points: Floats) -> Floats:
        """Points (..., 2) of the rectangle on the ground, by bilinear interpolation: lines along
        the sides of the rectangle stay straight."""
        return interpolate(points / np.array(self.size), self.corners)


def draw_ground(
    outline: OutlineName, area: float, storeys: int, rng: np.random.Generator
) -> Ground:
    """An outline of ``area`` square metres on middle lines. A flat of one storey may have
    neighbours on one side or two; a home of several has its hall and stairs at the front."""
    ratio = rng.uniform(1.05, 1.6 if storeys == 1 else 1.3)
    gap = rng.uniform(0.14, 0.24) if outline == "l" else 0.0
    width = float(np.sqrt(area * ratio / (1 - gap)))
    if storeys > 1:
        width = max(width, HALL_LONG)
    depth = area / (1 - gap) / width
    divide = _divide_flat if storeys == 1 else _divide_house
    parts, hall = divide(width, depth, gap, rng)
    depth = float(max(parts[:, 3].max(), 0.0 if hall is None else hall[3]))
    lit = np.ones(4)
    if storeys == 1 and outline != "l":
        lit[[0, 2]] = rng.random(2) < 0.6
    corners = np.array([[0, 0], [width, 0], [width, depth], [0, depth]], dtype=float)
    if outline == "skew":
        corners = skew_corners(corners, rng)
    return Ground(parts, hall, lit, (width, depth), corners)


def _divide_flat(
    width: float, depth: float, gap: float, rng: np.random.Generator
) -> tuple[Floats, Floats | None]:
    """The rectangle, or the two of an L with its notch, a share ``gap`` of the whole, at the upper
    right."""
    if not gap:
        return np.array([[0.0, 0.0, width, depth]]), None
    x = width * (1 - np.sqrt(gap) * rng.uniform(0.85, 1.15))
    y = depth - gap * width * depth / (width - x)
    return np.array([[0, 0, x, depth], [x, 0, width, y]]), None


def _divide_house(
    width: float, depth: float, gap: float, rng: np.random.Generator
) -> tuple[Floats, Floats]:
    """A block along the garden, the hall in the front and a block beside it; of an L the notch is
    beside the hall."""
    front = max(HALL_LONG, width * (1 - 1.5 * gap))
    back = (width * depth * (1 - gap) - front * HALL_DEEP) / width
    depth = back + HALL_DEEP
    long = max(HALL_LONG, HALL_SHARE * width)
    if front - long < LEAST_SIDE:
        return np.array([[0.0, 0, width, back]]), np.array([0, back, front, depth])
    left = front - long if not gap and rng.random() < 0.5 else 0.0
    side = [0, back, left, depth] if left else [long, back, front, depth]
    hall = np.array([left, back, left + long, depth])
    return np.array([[0, 0, width, back], side], dtype=float), hall
