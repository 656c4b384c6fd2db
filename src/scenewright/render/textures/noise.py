"""Noise that repeats without a seam: values on a torus, by filters of its spectrum and by cells."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating[Any]]
Ints = NDArray[np.int64]
Shape = tuple[int, int]


class Cells(NamedTuple):
    """The cells of points strewn on a torus, ``(h, w)`` each: how far the nearest point is and the
    one after it, in cells, and a number of the cell one is in."""

    near: Floats
    next: Floats
    cell: Ints


def spectral_noise(
    rng: np.random.Generator, shape: Shape, scale: tuple[float, float], slope: float = 2.0
) -> Floats:
    """Noise ``(h, w)`` of mean 0 and deviation 1 whose largest spots are about ``scale`` long
    (down, across) as shares of the picture: white noise with its amplitudes multiplied by
    ``(1 + (f_y s_y)^2 + (f_x s_x)^2) ** (-slope / 2)``; frequencies in waves a picture.

    Being a sum of whole waves it goes on beyond each edge as it began at the other one
    (R. Voss, *Random Fractal Forgeries*, 1985).

    >>> n = spectral_noise(np.random.default_rng(0), (32, 64), (0.2, 0.2))
    >>> n.shape, round(float(n.std()), 4), abs(round(float(n.mean()), 4))
    ((32, 64), 1.0, 0.0)
    """
    down = np.fft.fftfreq(shape[0], 1 / shape[0])[:, None] * scale[0]
    across = np.fft.rfftfreq(shape[1], 1 / shape[1])[None] * scale[1]
    strength = (1.0 + down**2 + across**2) ** (-slope / 2)
    strength[0, 0] = 0.0
    white = np.fft.rfft2(rng.standard_normal(shape, np.float32))
    found = np.fft.irfft2(white * strength.astype(np.float32), s=shape)
    return np.asarray(found / found.std(), np.float32)


def cell_noise(rng: np.random.Generator, shape: Shape, count: tuple[int, int]) -> Cells:
    """Cells about one point in each square of a grid ``count`` (down, across) that repeats
    (S. Worley, *A Cellular Texture Basis Function*, 1996).

    >>> cells = cell_noise(np.random.default_rng(0), (16, 16), (4, 4))
    >>> bool((cells.near <= cells.next).all()), int(cells.cell.max()) < 16
    (True, True)
    """
    rows, columns = count
    jitter = rng.random((rows, columns, 2))
    y = (np.arange(shape[0]) + 0.5)[:, None] * rows / shape[0] + np.zeros(shape)
    x = (np.arange(shape[1]) + 0.5)[None] * columns / shape[1] + np.zeros(shape)
    near, after = np.full(shape, np.inf), np.full(shape, np.inf)
    cell = np.zeros(shape, np.int64)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            row, column = np.floor(y).astype(int) + i, np.floor(x).astype(int) + j
            point = jitter[row % rows, column % columns]
            away = np.hypot(row + point[..., 0] - y, column + point[..., 1] - x)
            after = np.minimum(after, np.maximum(near, away))
            cell = np.where(away < near, (row % rows) * columns + column % columns, cell)
            near = np.minimum(near, away)
    return Cells(near, after, cell)


def grid_of(shape: Shape) -> tuple[Floats, Floats]:
    """Places of the middles of pixels, ``(h, w)`` each: down and across, as shares in [0, 1)."""
    y, x = (((np.arange(n) + 0.5) / n).astype(np.float32) for n in shape)
    return np.broadcast_to(y[:, None], shape), np.broadcast_to(x[None], shape)
