"""The light a surface sends back: sun, sky, a little gloss; and patterns of floors.

Linear light; 1 is the white of the page. Patterns are laid in plan, in metres.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]

PLAIN, PLANKS, SLABS, TILES, DECK, PAGE, GRASS, GRIT, LEAVES = 0, 1, 2, 3, 4, 5, 6, 7, 8
"""Patterns: none, oak planks, 0.6 m slabs, 0.3 m tiles, outdoor boards, the page itself, uneven
ground that grows, uneven ground that does not, crowns of trees."""

SUN = (1.24, 1.18, 1.08)
SKY = (0.62, 0.65, 0.70)
BOUNCE = (0.52, 0.51, 0.495)
"""Light from the sun, the open sky, and surroundings that hide the sky."""


@compiled
def shade(
    eye: Singles,
    points: Singles,
    facing: Singles,
    finishes: Ints,
    table: Singles,
    light: Singles,
    to_sun: Singles,
    grain: float,
    out: Singles,
) -> None:
    """Colours ``(n, 3)`` of surface points.

    ``table`` rows are colour, roughness, metallic, emission and pattern, picked by
    ``finishes`` (n,); ``light`` (n, 2) the share of sun and of sky that arrives; ``grain`` the
    width of a pixel as a share of its distance.
    """
    for i in range(out.shape[0]):
        m = finishes[i]
        nx, ny, nz = facing[i, 0], facing[i, 1], facing[i, 2]
        facing_sun = max(nx * to_sun[0] + ny * to_sun[1] + nz * to_sun[2], 0.0) * light[i, 0]
        pattern = int(table[m, 6])
        if pattern == PAGE:
            dark = 0.62 * (1.0 - light[i, 0]) + 0.38 * (1.0 - light[i, 1])
            for k in range(3):
                out[i, k] = table[m, k] * (1.0 - (0.50 - 0.03 * k) * dark)
            continue
        tone = 1.0
        if pattern != PLAIN and (nz > 0.9 or pattern == LEAVES):
            lift = points[i, 2] if pattern == LEAVES else 0.0
            tone = _tone(
                pattern,
                points[i, 0] + 0.83 * lift,
                points[i, 1] - 0.61 * lift,
                grain * _away(eye, points, i),
            )
        gloss_sun, gloss_sky, facet = _gloss(eye, points, facing, i, to_sun, table[m, 3])
        metal = table[m, 4]
        weight = metal * 0.6 + (1.0 - metal) * (0.04 + 0.5 * facet) * (1.0 - table[m, 3])
        open_sky = light[i, 1]
        for k in range(3):
            falling = SUN[k] * facing_sun + SKY[k] * open_sky * (0.72 + 0.28 * nz)
            falling += BOUNCE[k] * (1.0 - open_sky)
            body = table[m, k] * tone * (falling * (1.0 - 0.55 * metal) + 1.3 * table[m, 5])
            tint = metal * table[m, k] + 1.0 - metal
            out[i, k] = body + tint * (
                weight * gloss_sky * (0.35 + 0.65 * open_sky) + gloss_sun * light[i, 0]
            )


@inlined
def _away(eye: Singles, points: Singles, i: int) -> float:
    x, y, z = points[i, 0] - eye[0], points[i, 1] - eye[1], points[i, 2] - eye[2]
    return math.sqrt(x * x + y * y + z * z)


@inlined
def _gloss(
    eye: Singles, points: Singles, facing: Singles, i: int, to_sun: Singles, rough: float
) -> tuple[float, float, float]:
    """Sun and sky seen in a surface, and how much more it mirrors at a grazing view.

    C. Schlick's approximation for the last (1994), a power of the cosine for the first.
    """
    wx, wy, wz = points[i, 0] - eye[0], points[i, 1] - eye[1], points[i, 2] - eye[2]
    length = math.sqrt(wx * wx + wy * wy + wz * wz)
    wx, wy, wz = wx / length, wy / length, wz / length
    nx, ny, nz = facing[i, 0], facing[i, 1], facing[i, 2]
    along = -(wx * nx + wy * ny + wz * nz)
    rx, ry, rz = wx + 2.0 * along * nx, wy + 2.0 * along * ny, wz + 2.0 * along * nz
    shine = (1.0 - rough) ** 2
    towards = max(rx * to_sun[0] + ry * to_sun[1] + rz * to_sun[2], 0.0)
    sun = 0.55 * shine * towards ** (4.0 + 120.0 * shine)
    sky = 0.25 + 0.6 * max(rz, 0.0)
    return sun, sky, (1.0 - max(min(along, 1.0), 0.0)) ** 5


@inlined
def _tone(pattern: int, x: float, y: float, grain: float) -> float:
    """How bright a floor is at a place: boards and tiles differ a little, joints are darker."""
    if pattern == PLANKS:
        return _boards(x, y, 0.16, 1.5, 0.10, 0.004, 0.30, grain)
    if pattern == DECK:
        return _boards(x, y, 0.14, 2.4, 0.10, 0.010, 0.55, grain)
    if pattern == SLABS:
        return _boards(x, y, 0.6, 0.6, 0.035, 0.006, 0.20, grain)
    if pattern == TILES:
        return _boards(x, y, 0.3, 0.3, 0.025, 0.006, 0.20, grain)
    if pattern == GRASS:
        spots = _patches(x, y, 7.0, 0.10, grain) + _patches(x, y, 1.3, 0.13, grain)
        return 1.0 + spots + _patches(x, y, 0.16, 0.22, grain) + _patches(x, y, 0.03, 0.3, grain)
    if pattern == LEAVES:
        spots = _patches(x, y, 0.9, 0.25, grain) + _patches(x, y, 0.31, 0.6, grain)
        return 1.0 + spots + _patches(x, y, 0.11, 0.6, grain)
    if pattern == GRIT:
        spots = _patches(x, y, 5.0, 0.07, grain) + _patches(x, y, 0.5, 0.05, grain)
        return 1.0 + spots + _patches(x, y, 0.03, 0.14, grain)
    return 1.0


@inlined
def _patches(x: float, y: float, size: float, vary: float, grain: float) -> float:
    """Smooth random spots of some size, -``vary`` / 2 to ``vary`` / 2, none where a pixel is
    as large as they are (value noise, after K. Perlin 1985)."""
    clear = min(max(2.0 - 2.0 * grain / size, 0.0), 1.0)
    if clear == 0.0:
        return 0.0
    u, v = x / size, y / size
    i, j = math.floor(u), math.floor(v)
    u, v = u - i, v - j
    u, v = u * u * (3.0 - 2.0 * u), v * v * (3.0 - 2.0 * v)
    low = _noise(i, j) * (1.0 - u) + _noise(i + 1.0, j) * u
    high = _noise(i, j + 1.0) * (1.0 - u) + _noise(i + 1.0, j + 1.0) * u
    return clear * vary * (low * (1.0 - v) + high * v - 0.5)


@inlined
def _boards(
    x: float,
    y: float,
    wide: float,
    long: float,
    vary: float,
    joint: float,
    dark: float,
    grain: float,
) -> float:
    """Boards along x, each row shifted if they are longer than wide."""
    row = math.floor(y / wide)
    shifted = x + (_noise(row, 7.0) * long if long > wide else 0.0)
    column = math.floor(shifted / long)
    across = y - row * wide
    along = shifted - column * long
    near = min(min(across, wide - across), min(along, long - along))
    line = max(0.0, min(1.0, (joint / 2.0 + grain / 2.0 - near) / grain))
    tone = 1.0 + vary * (_noise(row, column) - 0.5)
    if long > wide:
        streak = _noise(math.floor(y / 0.012), math.floor(shifted / 0.35) + 31.0 * column)
        tone += 0.25 * vary * (streak - 0.5)
    return tone * (1.0 - dark * line)


@inlined
def _noise(a: float, b: float) -> float:
    """A number in [0, 1) that depends on two whole ones in no visible way."""
    wave = math.sin(a * 127.1 + b * 311.7) * 43758.5453
    return wave - math.floor(wave)
