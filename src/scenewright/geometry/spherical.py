"""Functions on the sphere: a shape as its farthest points, and spherical harmonics of them.

The grid is the paper's: θ_i = (2i + 1) π / (2N) from the pole, φ_j = 2π (2j + 1) / (2N), i and j
below N. Harmonics are orthonormal, Y_lm = √((2l + 1)(l − m)! / (4π (l + m)!)) P_lm(cos θ) e^{imφ}
(Kazhdan, Funkhouser and Rusinkiewicz 2003 for their energies as a descriptor).
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]


def sphere_directions(count: int) -> Floats:
    """Unit directions (N, N, 3) of the grid, by θ then φ.

    >>> sphere_directions(4).shape
    (4, 4, 3)
    """
    steps = (2 * np.arange(count) + 1) / (2 * count)
    theta, phi = np.meshgrid(np.pi * steps, 2 * np.pi * steps, indexing="ij")
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], -1)


def farthest_hits(mesh: Mesh, centre: Floats, count: int) -> Floats:
    """Distances (N, N) from ``centre`` (3,) to the farthest point of a surface along each
    direction of the grid, 0 where there is none: rays from outside inwards."""
    ways = sphere_directions(count).reshape(-1, 3)
    reach = 1.01 * float(np.linalg.norm(mesh.vertices - centre, axis=1).max(initial=1e-9)) + 1e-6
    distance, _, _ = rays.hits(rays.build(mesh.vertices, mesh.faces), centre + reach * ways, -ways)
    found = np.where(np.isfinite(distance) & (distance <= reach), reach - distance, 0.0)
    return np.asarray(np.maximum(found, 0.0), np.float64).reshape(count, count)


def _fejer(theta: Floats) -> Floats:
    """Weights (N,) that integrate polynomials of cos θ below degree N exactly (Fejér 1933)."""
    count = len(theta)
    j = np.arange(1, count // 2 + 1)
    sums = (np.cos(2 * j * theta[:, None]) / (4 * j**2 - 1)).sum(1)
    return np.asarray(2.0 / count * (1.0 - 2.0 * sums))


@lru_cache(maxsize=8)
def _basis(count: int, degrees: int) -> Complex:
    """Weighted conjugate harmonics (L, L, N, N) for m ≥ 0; zero above the diagonal."""
    steps = (2 * np.arange(count) + 1) / (2 * count)
    theta, phi = np.pi * steps, 2 * np.pi * steps
    x, sine = np.cos(theta), np.sin(theta)
    weights = _fejer(theta) * (2 * np.pi / count)
    legendre = np.zeros((degrees, degrees, count))
    for m in range(degrees):
        if m == 0:
            legendre[0, 0] = np.sqrt(1 / (4 * np.pi))
        else:
            legendre[m, m] = -np.sqrt((2 * m + 1) / (2 * m)) * sine * legendre[m - 1, m - 1]
        if m + 1 < degrees:
            legendre[m + 1, m] = np.sqrt(2 * m + 3) * x * legendre[m, m]
        for n in range(m + 2, degrees):
            a = np.sqrt((4 * n * n - 1) / (n * n - m * m))
            b = np.sqrt(((n - 1) ** 2 - m * m) / (4 * (n - 1) ** 2 - 1))
            legendre[n, m] = a * (x * legendre[n - 1, m] - b * legendre[n - 2, m])
    wave = np.exp(-1j * np.arange(degrees)[:, None] * phi)
    return np.asarray(np.einsum("lmt,mp,t->lmtp", legendre, wave, weights))


def harmonics(values: Floats, degrees: int) -> Complex:
    """Coefficients h_lm (L, L) for m ≥ 0 of a real function (N, N) on the grid, below ``degrees``.

    >>> found = harmonics(np.ones((16, 16)), 3)
    >>> round(float(abs(found[0, 0])), 6), float(np.abs(found[1:]).max()) < 1e-9
    (3.544908, True)
    """
    return np.asarray(np.einsum("lmtp,tp->lm", _basis(len(values), degrees), values))


def energies(coefficients: Complex) -> Floats:
    """t_l = √(Σ_m |h_lm|²) over all m from −l to l (L,): the same however the function is
    turned."""
    squares = np.abs(coefficients) ** 2
    return np.asarray(np.sqrt(2 * squares.sum(1) - squares[:, 0]))
