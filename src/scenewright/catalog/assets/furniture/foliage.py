"""Plants: pots, rosettes of leaves, crowns of small trees."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.objects import wobble
from scenewright.geometry.mesh import Mesh, map_points
from scenewright.geometry.solids import Spot, ball, disc, lathe, leaf, tube

GOLDEN = pi * (3 - 5**0.5)
"""Angle in radians between one leaf and the next on most plants (Vogel 1979)."""


def pot(radius: float, high: float, at: Spot = (0.0, 0.0)) -> tuple[Mesh, Mesh]:
    """A tapered pot with a rim, and the soil in it."""
    wall = [(0.72, 0), (1, high), (0.88, high), (0.84, 0.88 * high)]
    body = lathe([(r * radius, z) for r, z in wall], at, 16)
    return body, disc(0.85 * radius, (0.84 * high, 0.9 * high), at, 12)


def rosette(
    count: int,
    length: float,
    wide: float,
    low: float,
    at: Spot = (0.0, 0.0),
    rise: tuple[float, float] = (0.5, 1.35),
    droop: float = 1.2,
) -> list[Mesh]:
    """Leaves from one root, the inner ones upright, the outer ones bending over."""
    found = []
    for k in range(count):
        share = (k + 0.5) / count
        slope = rise[1] + (rise[0] - rise[1]) * share
        long = length * (0.75 + 0.25 * wobble(k))
        found.append(leaf(long, wide, slope, droop, k * GOLDEN, (*at, low)))
    return found


def tree(low: float, high: float, radius: float, leaves: int) -> tuple[list[Mesh], list[Mesh]]:
    """A slender trunk that forks, with broad leaves around the crown: wood and leaves."""
    fork = low + 0.4 * (high - low)
    wood = [
        tube([(0, 0, low), (0.01, 0.01, fork), (0.0, 0.0, high - 0.12 * (high - low))], 0.014, 5)
    ]
    green = []
    for k in range(4):
        angle = k * GOLDEN + 0.4
        out = 0.4 * radius
        tip = (out * cos(angle), out * sin(angle), fork + (0.35 + 0.12 * k) * (high - fork))
        wood.append(tube([(0, 0, fork - 0.05 + 0.05 * k), tip], 0.008, 4))
    for k in range(leaves):
        share = (k + 0.5) / leaves
        angle, z = k * GOLDEN, fork + (0.9 - 0.95 * share) * (high - fork)
        out = 0.5 * radius * sin(pi * min(0.2 + 0.75 * share, 1.0))
        long = 0.72 * radius * (0.85 + 0.3 * wobble(k))
        place = (out * cos(angle), out * sin(angle), z)
        green.append(leaf(long, 0.55 * long, 0.9 - 1.1 * share, 0.9, angle, place))
    return wood, green


def grown(w: float, d: float, z: tuple[float, float], *groups: list[Mesh]) -> list[list[Mesh]]:
    """Groups of foliage stretched together to fill ``[-w, w] x [-d, d]`` between two heights."""
    points = np.concatenate([m.vertices for group in groups for m in group])
    source = (points.min(0), points.max(0))
    low, high = np.array([-w, -d, z[0]]), np.array([w, d, z[1]])
    return [
        [Mesh(map_points(m.vertices, source, low, high), m.faces) for m in group]
        for group in groups
    ]


def bush(x: float, y: float, z: float, radius: float, high: float) -> Mesh:
    """A low round clump."""
    return ball(radius, radius, high / 2, (x, y, z + high / 2), 8, 4)
