"""How alike two layouts are to a person: a linear, an additive and a Gaussian part."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Kernel(NamedTuple):
    """Variances of the three parts, and the length scale of the two curved ones, in standard
    deviations of a feature."""

    linear: float = 1.5
    additive: float = 0.9
    joint: float = 0.3
    length: float = 1.5


def kernel_matrix(kernel: Kernel, one: Floats, other: Floats) -> Floats:
    """k(x, y) = l Σ_d x_d y_d / D + a Σ_d exp(-(x_d - y_d)² / 2λ²) / D
    + g exp(-Σ_d (x_d - y_d)² / 2Dλ²) for rows of ``one`` (n, D) and ``other`` (m, D), (n, m).

    The linear part finds directions from few choices (more sun is better), the additive part
    optima of single features (neither dense nor empty; Duvenaud, Nickisch, Rasmussen 2011, order
    one), the joint part what only comes together.

    >>> kernel_matrix(Kernel(1, 0, 0), np.array([[1.0, 2.0]]), np.array([[3.0, 1.0]])).tolist()
    [[2.5]]
    """
    dims = max(one.shape[1], 1)
    apart = one[:, None, :] - other[None, :, :]
    squares = np.square(apart, out=apart) / (2.0 * kernel.length**2)
    joint = np.exp(-squares.sum(-1) / dims)
    additive = np.exp(-squares).sum(-1) / dims
    matrix: Floats = (
        kernel.linear * (one @ other.T) / dims + kernel.additive * additive + kernel.joint * joint
    )
    return matrix


def kernel_diagonal(kernel: Kernel, points: Floats) -> Floats:
    """k(x, x) of every row of ``points`` (n, D), (n,)."""
    dims = max(points.shape[1], 1)
    own: Floats = kernel.linear * (points**2).sum(1) / dims + kernel.additive + kernel.joint
    return own
