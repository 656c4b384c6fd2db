"""Forms of outlines that plans are generated in: a rectangle, an L, one without right angles."""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
OutlineName = Literal["rectangle", "l", "skew"]
NAMES: tuple[OutlineName, ...] = get_args(OutlineName)
SHARES = (0.6, 0.25, 0.15)
"""How often each is drawn where none is asked for."""
SKEW = 0.1
"""Most a corner is moved along either axis, of the side."""


def check_outline(name: str | None, seed: int) -> None:
    """Refuse a form that is not known (None: drawn by the seed) and a seed that cannot be used."""
    if name not in (None, *NAMES):
        raise InputError(f"there is no outline '{name}'", f"choose {', '.join(NAMES)}")
    if seed < 0:
        raise InputError(f"the seed {seed} is negative", "give 0 or more")


def draw_outline(rng: np.random.Generator) -> OutlineName:
    """One of the forms by how usual they are."""
    return NAMES[int(rng.choice(len(NAMES), p=SHARES))]


def interpolate(points: Floats, corners: Floats) -> Floats:
    """Points (..., 2) of the unit square within a quadrilateral (4, 2), counter-clockwise, by
    bilinear interpolation: lines along the sides of the square stay straight.

    >>> interpolate(np.array([0.5, 0.5]), np.array([[0.0, 0], [4, 0], [5, 3], [0, 2]])).tolist()
    [2.25, 1.25]
    """
    u, v = np.moveaxis(points, -1, 0)
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=-1)
    found: Floats = weights @ corners
    return found


def skew_corners(corners: Floats, rng: np.random.Generator) -> Floats:
    """The corners (4, 2) of a rectangle from (0, 0) moved so that no angle is right, with the same
    area.

    >>> corners = np.array([[0.0, 0], [4, 0], [4, 3], [0, 3]])
    >>> round(area_of(skew_corners(corners, np.random.default_rng(0))), 9)
    12.0
    """
    size = corners[2]
    moved = corners + rng.uniform(-SKEW, SKEW, (4, 2)) * size
    scaled: Floats = moved * np.sqrt(size.prod() / area_of(moved))
    return scaled


def area_of(corners: Floats) -> float:
    """Area of a polygon (n, 2), counter-clockwise."""
    following = np.roll(corners, -1, axis=0)
    return float((corners[:, 0] * following[:, 1] - corners[:, 1] * following[:, 0]).sum() / 2)
