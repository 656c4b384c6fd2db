"""From light to a picture: exposure by the middle tone, a filmic curve, sRGB."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Singles = NDArray[np.float32]
Pixels = NDArray[np.uint8]

MIDDLE = 0.17
"""What the middle tone of a picture becomes."""
SUNLIT, DARKEST = 1.3, 0.8
"""What all but the brightest twentieth is kept below, and how far a picture is darkened for it."""
ADAPTED = 0.65
"""How far the eye is taken to adapt to the colour of the light: 1 makes the mean grey."""
WEIGHTS = np.array([0.2126, 0.7152, 0.0722], np.float32)


def develop(light: Singles) -> Pixels:
    """The picture of linear light ``(height, width, 3)`` of any brightness.

    Exposed so that the mean of the logarithms of luminance below the brightest fifth becomes
    :data:`MIDDLE` (E. Reinhard and others 2002); then K. Narkowicz's fit (2016) of the curve that
    films are shown with, which rolls off highlights.

    >>> develop(np.full((2, 2, 3), 7.0, np.float32)).ravel()[:3].tolist()
    [125, 125, 125]
    """
    light = light * _balance(light)
    bright = light @ WEIGHTS
    kept = bright[bright <= np.quantile(bright, 0.8)]
    middle = float(np.exp(np.log(kept + 1e-5).mean()))
    gain = 0.85 * MIDDLE / max(middle, 1e-5)
    less = SUNLIT / max(float(np.quantile(bright, 0.94)) * gain, 1e-5)
    x = light * gain * min(max(less, DARKEST), 1.0)
    shown = np.clip(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0)
    coded = np.where(shown < 0.0031308, 12.92 * shown, 1.055 * shown ** (1 / 2.4) - 0.055)
    return np.round(coded * 255).astype(np.uint8)


def _balance(light: Singles) -> Singles:
    """Factors (3,) by which colours are balanced: the mean hue is taken back in part (grey world,
    G. Buchsbaum 1980)."""
    mean = np.minimum(light, np.quantile(light, 0.95)).mean((0, 1)) + 1e-6
    factors = (float(mean @ WEIGHTS) / mean) ** ADAPTED
    return np.asarray(factors, np.float32)
