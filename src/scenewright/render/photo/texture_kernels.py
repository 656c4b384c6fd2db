"""Compiled look-up of textures where rays from the eye land."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined
from scenewright.render.light import _cross

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Flags = NDArray[np.bool_]


@inlined
def _share_of(corners: Singles, f: int, k: int, x: float, y: float, z: float) -> float:
    """The share of corner ``k`` in a point of a face, by areas."""
    ux, uy, uz = _cross(corners, f)
    p, q = (k + 1) % 3, (k + 2) % 3
    bx, by, bz = corners[f, p, 0] - x, corners[f, p, 1] - y, corners[f, p, 2] - z
    cx, cy, cz = corners[f, q, 0] - x, corners[f, q, 1] - y, corners[f, q, 2] - z
    top = (by * cz - bz * cy) * ux + (bz * cx - bx * cz) * uy + (bx * cy - by * cx) * uz
    return top / (ux * ux + uy * uy + uz * uz)


@inlined
def _texel(texels: Singles, first: int, high: int, wide: int, u: float, v: float, k: int) -> float:
    """A texture of one size between its four nearest texels; ``u``, ``v`` in repeats."""
    x, y = (u - math.floor(u)) * wide - 0.5, (v - math.floor(v)) * high - 0.5
    i, j = math.floor(y), math.floor(x)
    fy, fx = y - i, x - j
    up, down = (int(i) + high) % high, (int(i) + 1) % high
    left, right = (int(j) + wide) % wide, (int(j) + 1) % wide
    top = texels[first + up * wide + left, k] * (1 - fx) + texels[first + up * wide + right, k] * fx
    low = (
        texels[first + down * wide + left, k] * (1 - fx)
        + texels[first + down * wide + right, k] * fx
    )
    return top * (1 - fy) + low * fy


@inlined
def _place(
    corners: Singles, places: Singles, f: int, x: float, y: float, z: float, k: int
) -> float:
    """Where a point of a face lies on its texture."""
    a, b = _share_of(corners, f, 0, x, y, z), _share_of(corners, f, 1, x, y, z)
    return a * places[f, 0, k] + b * places[f, 1, k] + (1 - a - b) * places[f, 2, k]


@compiled
def paint_hits(
    met: Ints,
    bare: Flags,
    starts: Singles,
    points: Singles,
    facing: Singles,
    ways: Singles,
    corners: Singles,
    worn: Ints,
    places: Singles,
    rows: Longs,
    fine: Singles,
    texels: Singles,
    step: float,
    body: Singles,
) -> None:
    """Multiply the colours of what rays from the eye hit by the texture there, of the size at
    which a texel is about half a pixel: ``step`` is the width of a pixel at distance 1. Light that
    saw a rough surface before gets the mean of a texture, which is 1."""
    for i in range(met.shape[0]):
        f = met[i]
        if f < 0 or worn[f] < 0 or not bare[i]:
            continue
        row = worn[f]
        square = steep = 0.0
        for k in range(3):
            square += (points[i, k] - starts[i, k]) ** 2
            steep -= facing[i, k] * ways[i, k]
        wide_pixel = step * math.sqrt(square / max(steep, 0.1)) * fine[row] * 0.5
        first, high, wide = rows[row, 0], rows[row, 1], rows[row, 2]
        while wide_pixel > 1.0 and high > 1 and wide > 1:
            first += high * wide
            high, wide, wide_pixel = high // 2, wide // 2, wide_pixel / 2.0
        u = _place(corners, places, f, points[i, 0], points[i, 1], points[i, 2], 0)
        v = _place(corners, places, f, points[i, 0], points[i, 1], points[i, 2], 1)
        for k in range(3):
            body[i, k] = min(body[i, k] * _texel(texels, first, high, wide, u, v, k), 0.92)
