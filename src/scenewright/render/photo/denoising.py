"""Noise taken out of followed light: Open Image Denoise where it is installed, else our own filter.

Ours is the edge-avoiding à-trous wavelet of H. Dammertz and others (2010): five passes of a 5 × 5
B-spline with holes of 1, 2, 4, 8, 16 pixels, over light divided by the colour of the surface, that
do not reach across edges of normal, colour or light.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.core.extras import is_installed
from scenewright.geometry.compiled import compiled
from scenewright.render.photo.following import Exposure

Singles = NDArray[np.float32]
GUIDES = ((1, 9.0), (2, 2.0))
"""Passes, by hole and spread, that make the tones by which light is compared: noise is no edge."""
PASSES = ((1, 0.9), (2, 0.6), (4, 0.35), (8, 0.2), (16, 0.12))
LEAST_BODY = 0.02
SPLINE = (0.375, 0.25, 0.0625)


def take_out_noise(film: Exposure) -> Singles:
    """The light of a film ``(height, width, 3)`` without its noise."""
    if is_installed("pyoidn"):
        return _denoise_by_library(film)
    return smooth_film(film)


def smooth_film(film: Exposure) -> Singles:
    """The light of a film by our own filter."""
    body: Singles = np.maximum(film.body, np.float32(LEAST_BODY))
    light: Singles = np.ascontiguousarray(film.light / body)
    tones: Singles = light
    for hole, spread in GUIDES:
        tones = _smooth(light, tones, film, hole, spread)
    for hole, spread in PASSES:
        light = _smooth(light, tones, film, hole, spread)
        tones = light
    return light * body


def _denoise_by_library(film: Exposure) -> Singles:
    """Intel's Open Image Denoise, guided by colours and normals."""
    from pyoidn import denoise

    planes = [np.ascontiguousarray(plane) for plane in film]
    out: Singles = denoise(planes[0], albedo=planes[1], normal=planes[2], hdr=True)
    return out


def _smooth(light: Singles, tones: Singles, film: Exposure, hole: int, spread: float) -> Singles:
    out = np.empty_like(light)
    smooth_pass(light, tones, film.facing, film.body, hole, spread, out)
    return out


@compiled
def smooth_pass(
    light: Singles,
    tones: Singles,
    facing: Singles,
    body: Singles,
    hole: int,
    spread: float,
    out: Singles,
) -> None:
    """One pass: the mean over 25 pixels ``hole`` apart, each by its likeness. ``spread`` is how
    far the logarithms of ``tones`` may differ."""
    height, width = light.shape[0], light.shape[1]
    for y in range(height):
        for x in range(width):
            own = (tones[y, x, 0] + tones[y, x, 1] + tones[y, x, 2]) / 3.0
            red, green, blue = 0.0, 0.0, 0.0
            whole = 0.0
            for v in range(-2, 3):
                for u in range(-2, 3):
                    i, j = y + v * hole, x + u * hole
                    if i < 0 or j < 0 or i >= height or j >= width:
                        continue
                    even = 0.0
                    differ = 0.0
                    for k in range(3):
                        even += facing[i, j, k] * facing[y, x, k]
                        differ += abs(body[i, j, k] - body[y, x, k])
                    other = (tones[i, j, 0] + tones[i, j, 1] + tones[i, j, 2]) / 3.0
                    tone = abs(math.log((other + 1e-3) / (own + 1e-3))) / spread
                    near = SPLINE[abs(u)] * SPLINE[abs(v)]
                    weight = near * max(even, 0.0) ** 32 * math.exp(-differ * 12.0 - tone * tone)
                    whole += weight
                    red += weight * light[i, j, 0]
                    green += weight * light[i, j, 1]
                    blue += weight * light[i, j, 2]
            if whole > 1e-6:
                out[y, x, 0], out[y, x, 1], out[y, x, 2] = red / whole, green / whole, blue / whole
            else:
                for k in range(3):
                    out[y, x, k] = light[y, x, k]
