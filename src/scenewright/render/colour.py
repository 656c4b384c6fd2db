"""Colours: sRGB and linear light."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def linear_of(color: NDArray[np.float64]) -> NDArray[np.float64]:
    """Linear light of sRGB values in [0, 1] (IEC 61966-2-1).

    Any shape, such as (n, 3).

    >>> linear_of(np.array([0.0, 0.5, 1.0])).round(4).tolist()
    [0.0, 0.214, 1.0]
    """
    return np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)


def coded_of(light: NDArray[np.float64]) -> NDArray[np.float64]:
    """sRGB values of linear light in [0, 1] (IEC 61966-2-1), any shape.

    >>> coded_of(linear_of(np.array([0.0, 0.02, 0.5, 1.0]))).round(6).tolist()
    [0.0, 0.02, 0.5, 1.0]
    """
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
