"""How alike two layouts are to a person: a linear, an additive and a joint part."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Kernel(NamedTuple):
    """Variances: of the ``linear`` part and of the ``bent`` one, each a number for all features or
    one for each (D,), and of the ``joint`` part with its ``length``, in standard deviations of a
    feature."""

    linear: float | Floats = 8.0
    bent: float | Floats = 4.0
    joint: float = 0.3
    length: float = 1.5


def kernel_matrix(kernel: Kernel, one: Floats, other: Floats) -> Floats:
    """k(x, y) = Σ_d (l_d x_d y_d + b_d q(x_d) q(y_d)) / D + g exp(-Σ_d (x_d - y_d)² / 2Dλ²) for
    rows of ``one`` (n, D) and ``other`` (m, D), (n, m), with q of :func:`bend`.

    The linear part finds directions from few choices (more sun is better); the bent one makes it
    additive (Duvenaud, Nickisch, Rasmussen 2011, order one, of parabolas): optima of single
    features (neither dense nor empty); the joint part is for what only comes together.

    >>> kernel_matrix(Kernel(1, 0, 0), np.array([[1.0, 2.0]]), np.array([[3.0, 1.0]])).tolist()
    [[2.5]]
    """
    dims = max(one.shape[1], 1)
    squares = (one**2).sum(1)[:, None] + (other**2).sum(1)[None] - 2.0 * one @ other.T
    near = np.exp(-np.maximum(squares, 0.0) / (2.0 * dims * kernel.length**2))
    straight = (kernel.linear * one) @ other.T
    matrix: Floats = (
        straight + (kernel.bent * bend(one)) @ bend(other).T
    ) / dims + kernel.joint * near
    return matrix


def kernel_diagonal(kernel: Kernel, points: Floats) -> Floats:
    """k(x, x) of every row of ``points`` (n, D), (n,)."""
    dims = max(points.shape[1], 1)
    own: Floats = (kernel.linear * points**2 + kernel.bent * bend(points) ** 2).sum(1) / dims
    return own + kernel.joint


def bend(points: Floats) -> Floats:
    """q(x) = (x² - 1) / √2, of mean 0 and variance 1 where x is normal, and not correlated to x.

    >>> bend(np.array([1.0, -1.0])).tolist()
    [0.0, 0.0]
    """
    bent: Floats = (points**2 - 1.0) / np.sqrt(2.0)
    return bent
