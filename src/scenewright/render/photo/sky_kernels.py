"""Compiled: what is seen beyond everything, sky and trees on the horizon; random numbers."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import inlined

Singles = NDArray[np.float32]

STEPS = (0.7548776662466927, 0.5698402909980532)
"""Of even and odd dimensions: the sequence R2 fills the square evenly (M. Roberts 2018)."""


@inlined
def _random(pixel: int, sample: int, dimension: int) -> float:
    """A number in [0, 1) of a pixel's sequence."""
    h = np.uint32(pixel) * np.uint32(747796405) + np.uint32(dimension) * np.uint32(2891336453)
    h = (h ^ (h >> np.uint32(16))) * np.uint32(2246822519)
    h = (h ^ (h >> np.uint32(13))) * np.uint32(3266489917)
    h = h ^ (h >> np.uint32(16))
    step = STEPS[1] if dimension % 2 else STEPS[0]
    value = float(h) / 4294967296.0 + step * sample
    return value - math.floor(value)


@inlined
def _sky(way_z: float, sky: Singles, k: int) -> float:
    """Light from a direction beyond everything: ``sky`` rows are ground, horizon and zenith."""
    if way_z < 0.0:
        return float(sky[0, k])
    share = math.sqrt(way_z)
    return float(sky[1, k] + (sky[2, k] - sky[1, k]) * share)


@inlined
def _mottled(x: float, y: float) -> float:
    """A number in [0, 1] that changes smoothly over the plane, by values at whole places."""
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3.0 - 2.0 * u), v * v * (3.0 - 2.0 * v)
    found = 0.0
    for k in range(4):
        right, up = k % 2, k // 2
        value = _random(int(i) + 9000 + right, 0, int(j) + 9000 + up)
        found += value * (u if right else 1.0 - u) * (v if up else 1.0 - v)
    return found


@inlined
def _far_trees(x: float, y: float, z: float) -> float:
    """Share of the ground's light that trees on the horizon give back in a direction, 0 above
    their tops: 2 to 5 degrees high, lighter and darker by their leaves, darker below."""
    turn = math.atan2(y, x)
    if z > 0.1 or z < -0.06:
        return 0.0
    top = 0.028 + 0.034 * _mottled(8.0 * turn, 0.0) + 0.022 * _mottled(31.0 * turn, 1.0)
    top += 0.008 * _mottled(120.0 * turn, 2.0) + 0.004 * _mottled(400.0 * turn, 3.0)
    if z > top:
        return 0.0
    leaves = 0.5 * _mottled(70.0 * turn, 110.0 * z) + 0.5 * _mottled(240.0 * turn, 330.0 * z)
    return 0.1 + 0.5 * leaves * (0.35 + 0.65 * max(z, 0.0) / top)
