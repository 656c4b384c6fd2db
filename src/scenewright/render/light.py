"""Compiled passes over the pixels of a picture: rays out, light gathered, smoothed, shaded.

Pixels are rows, left to right and top to bottom. Each carries one ray to the sun and one to the
sky, taken from a set of 64 that repeats every 8 by 8 pixels; averaging each value over such a
window then gives every pixel all 64 (interleaved sampling, A. Keller and W. Heidrich, 2001). The
average only takes pixels with the same ``key``: the same plane or the same round part.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]

TILE = 8
OFFSET = 0.002
"""How far rays start off the surface they leave, in metres."""


def samples() -> Singles:
    """The 64 samples ``(64, 5)`` used in turn, stratified in every part: a point of the unit
    square, and the direction about +z, by the cosine, that belongs to it.

    The first coordinate is the rank of a Bayer matrix (ordered dithering, B. Bayer 1973), the
    second that rank with its bits mirrored (J. Hammersley's points).

    >>> points = samples()
    >>> points.shape, len(set(points[:, 0].tolist())), float(points[:, :2].mean().round(2))
    ((64, 5), 64, 0.5)
    """
    rank = np.zeros((1, 1), np.int64)
    for _ in range(3):
        rank = np.block([[4 * rank, 4 * rank + 2], [4 * rank + 3, 4 * rank + 1]])
    mirrored = sum(((rank >> bit) & 1) << (5 - bit) for bit in range(6))
    square = (np.stack([rank, mirrored], -1).reshape(-1, 2) + 0.5) / 64
    radius, angle = np.sqrt(square[:, 0]), 2 * np.pi * square[:, 1]
    way = [radius * np.cos(angle), radius * np.sin(angle), np.sqrt(1 - square[:, 0])]
    return np.column_stack([square, *way]).astype(np.float32)


@compiled
def camera_rays(
    axes: Singles,
    width: int,
    height: int,
    across: float,
    pixels: Ints,
    shift: Singles,
    out: Singles,
) -> None:
    """Directions through ``pixels`` (indices), moved by ``shift`` (k, 2) of a pixel in turn.

    ``axes`` rows are right, up and ahead; ``across`` is the tangent of half the view's width.
    """
    step = 2.0 * across / width
    for i in range(out.shape[0]):
        pixel, turn = pixels[i], i % shift.shape[0]
        x = (pixel % width + 0.5 + shift[turn, 0] - 0.5 * width) * step
        y = (0.5 * height - pixel // width - 0.5 - shift[turn, 1]) * step
        for k in range(3):
            out[i, k] = x * axes[0, k] + y * axes[1, k] + axes[2, k]


@compiled
def surface_hits(
    eye: Singles,
    ways: Singles,
    met: Ints,
    corners: Singles,
    normals: Singles,
    smooth: NDArray[np.bool_],
    names: Ints,
    near: Singles,
    points: Singles,
    facing: Singles,
    keys: Ints,
) -> None:
    """Where each ray meets its triangle, the normal there (turned to the eye) and the key.

    ``names`` are the keys of the triangles; points outside the box ``near`` (2, 3) get none, -1.
    """
    for i in range(met.shape[0]):
        f = met[i]
        if f < 0:
            keys[i] = -1
            continue
        keys[i] = names[f]
        ux, uy, uz = _cross(corners, f)
        top = low = 0.0
        for k in range(3):
            n = ux if k == 0 else (uy if k == 1 else uz)
            top += n * (corners[f, 0, k] - eye[k])
            low += n * ways[i, k]
        t = top / low if low != 0.0 else 0.0
        for k in range(3):
            points[i, k] = eye[k] + t * ways[i, k]
            if points[i, k] < near[0, k] or points[i, k] > near[1, k]:
                keys[i] = -1
        if smooth[f]:
            ux, uy, uz = _between(
                corners, normals, f, points[i, 0], points[i, 1], points[i, 2], ux, uy, uz
            )
        length = math.sqrt(ux * ux + uy * uy + uz * uz)
        length = -length if low > 0.0 else length
        facing[i, 0], facing[i, 1], facing[i, 2] = ux / length, uy / length, uz / length


@inlined
def _cross(corners: Singles, f: int) -> tuple[float, float, float]:
    ax, ay, az = corners[f, 0, 0], corners[f, 0, 1], corners[f, 0, 2]
    bx, by, bz = corners[f, 1, 0] - ax, corners[f, 1, 1] - ay, corners[f, 1, 2] - az
    cx, cy, cz = corners[f, 2, 0] - ax, corners[f, 2, 1] - ay, corners[f, 2, 2] - az
    return by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx


@inlined
def _between(
    corners: Singles,
    normals: Singles,
    f: int,
    x: float,
    y: float,
    z: float,
    ux: float,
    uy: float,
    uz: float,
) -> tuple[float, float, float]:
    """The normal at a point of a face, between those at its corners by their areas."""
    area = ux * ux + uy * uy + uz * uz
    nx = ny = nz = 0.0
    for k in range(3):
        p, q = (k + 1) % 3, (k + 2) % 3
        bx, by, bz = corners[f, p, 0] - x, corners[f, p, 1] - y, corners[f, p, 2] - z
        cx, cy, cz = corners[f, q, 0] - x, corners[f, q, 1] - y, corners[f, q, 2] - z
        share = (
            (by * cz - bz * cy) * ux + (bz * cx - bx * cz) * uy + (bx * cy - by * cx) * uz
        ) / area
        nx += share * normals[f, k, 0]
        ny += share * normals[f, k, 1]
        nz += share * normals[f, k, 2]
    return nx, ny, nz


@compiled
def light_samples(
    pixels: Ints,
    width: int,
    points: Singles,
    facing: Singles,
    sun: Singles,
    spread: float,
    sets: Singles,
    turn: int,
    starts: Singles,
    to_sun: Singles,
    to_sky: Singles,
) -> None:
    """For each of ``pixels`` a ray into the sun's disc and one into the sky by the cosine.

    ``sun`` rows are two directions across the sun and the one towards it; ``spread`` is the
    tangent of the disc's radius. ``turn`` counts the rays a pixel has had; only the first comes
    with one to the sky. For the sun every tile turns and shifts the samples by its own amounts,
    else shadows would have steps of a tile. ``points`` and ``facing`` (n, 3) of all pixels;
    ``pixels`` (k,), ``starts``, ``to_sun`` and ``to_sky`` (k, 3), ``sets`` (t, 5) random numbers
    of a tile, ``sun`` (3, 3).
    """
    for i in range(pixels.shape[0]):
        p = pixels[i]
        u, v = p % width, p // width
        rank = v % TILE * TILE + u % TILE
        own = u // TILE * 0.7548776662 + v // TILE * 0.5698402910
        other = u // TILE * 0.8191725134 + v // TILE * 0.6710436067
        share = sets[rank, 0] + own + 0.618034 * turn
        angle = 2.0 * math.pi * (sets[rank, 1] + other + 0.381966 * turn)
        radius = math.sqrt(share - math.floor(share))
        for k in range(3):
            starts[i, k] = points[p, k] + OFFSET * facing[p, k]
            to_sun[i, k] = sun[2, k] + spread * radius * (
                math.cos(angle) * sun[0, k] + math.sin(angle) * sun[1, k]
            )
        if turn:
            continue
        x, y, z = sets[rank, 2], sets[rank, 3], sets[rank, 4]
        nx, ny, nz = facing[p, 0], facing[p, 1], facing[p, 2]
        sign = 1.0 if nz >= 0.0 else -1.0
        a = -1.0 / (sign + nz)
        b = nx * ny * a
        to_sky[i, 0] = x * (1.0 + sign * nx * nx * a) + y * b + z * nx
        to_sky[i, 1] = x * sign * b + y * (sign + ny * ny * a) + z * ny
        to_sky[i, 2] = -x * sign * nx - y * ny + z * nz


@compiled
def average(keys: Ints, width: int, step: int, values: Singles, out: Singles) -> None:
    """Mean of ``values`` (n, 2) over 8 pixels in a row (``step`` 1) or column (``step`` width)
    that have the same key as the pixel; pixels with a negative key are left out."""
    count = keys.shape[0]
    for i in range(count):
        if keys[i] < 0:
            continue
        first = total = 0.0
        many = 0
        for k in range(-TILE // 2, TILE // 2):
            j = i + k * step
            if j < 0 or j >= count or keys[j] != keys[i]:
                continue
            if step == 1 and abs(j % width - i % width) >= TILE:
                continue
            first += values[j, 0]
            total += values[j, 1]
            many += 1
        out[i, 0], out[i, 1] = first / many, total / many


@compiled
def edges(keys: Ints, width: int, out: NDArray[np.bool_]) -> None:
    """Marks pixels beside one with another key: the ones to be drawn finer.

    ``keys`` (n,) row by row of a picture ``width`` pixels wide; ``out`` (n,).
    """
    count = keys.shape[0]
    for i in range(count):
        if i + 1 < count and (i + 1) % width and keys[i] != keys[i + 1]:
            out[i] = out[i + 1] = True
        if i + width < count and keys[i] != keys[i + width]:
            out[i] = out[i + width] = True


@compiled
def borrow(
    pixels: Ints, keys: Ints, width: int, light: Singles, wanted: Ints, out: Singles
) -> None:
    """Light for finer samples: the mean of pixels within two of ``pixels`` that have the
    ``wanted`` key, or the pixel's own if there is none.

    ``pixels`` and ``wanted`` (k,), ``keys`` (n,), ``light`` (n, 2) and ``out`` (k, 2) of sun and
    sky.
    """
    height = keys.shape[0] // width
    for i in range(pixels.shape[0]):
        x, y = pixels[i] % width, pixels[i] // width
        first = total = 0.0
        many = 0
        for v in range(max(y - 2, 0), min(y + 3, height)):
            for u in range(max(x - 2, 0), min(x + 3, width)):
                j = v * width + u
                if keys[j] == wanted[i]:
                    first += light[j, 0]
                    total += light[j, 1]
                    many += 1
        if many:
            out[i, 0], out[i, 1] = first / many, total / many
        else:
            out[i, 0], out[i, 1] = light[pixels[i], 0], light[pixels[i], 1]
