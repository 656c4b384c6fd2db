"""Continuous principal axes of a surface: weighted by area, not by how it is triangulated.

With triangles of areas S_i and corners A, B, C (Zhang and Fei 2017, section 1, after Vranić 2001):

    m = (1/S) Σ S_i (A + B + C)/3
    C = 1/(12 S) Σ S_i [f(A) + f(B) + f(C) + 9 f((A + B + C)/3)],  f(o) = (o − m)(o − m)ᵀ

which is the exact covariance of the surface.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.mesh import Mesh

Floats = NDArray[np.float64]


class PrincipalAxes(NamedTuple):
    """The centroid (3,), the axes as rows (3, 3) from the longest, right-handed, and the standard
    deviations along them (3,)."""

    centre: Floats
    axes: Floats
    spread: Floats


def principal_axes(mesh: Mesh) -> PrincipalAxes:
    """The principal axes of a surface. Each axis points to where its third moment is positive;
    the last makes the frame right-handed.

    >>> from scenewright.geometry.solids import block
    >>> found = principal_axes(block((0, 4), (0, 2), (0, 1)))
    >>> found.centre.round(9).tolist(), np.abs(found.axes).round(6).tolist()
    ([2.0, 1.0, 0.5], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    """
    corners = mesh.vertices[mesh.faces]
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    whole = max(float(area.sum()), 1e-300)
    middle = corners.mean(1)
    centre = (area[:, None] * middle).sum(0) / whole
    points = np.concatenate([corners, middle[:, None]], 1) - centre
    factor = np.array([1.0, 1.0, 1.0, 9.0])
    covariance = np.einsum("i,k,ika,ikb->ab", area, factor, points, points) / (12.0 * whole)
    values, vectors = np.linalg.eigh(covariance)
    axes = vectors.T[::-1].copy()
    skew = ((points[:, 3] @ axes.T) ** 3 * area[:, None]).sum(0)
    axes *= np.where(skew < 0, -1.0, 1.0)[:, None]
    axes[2] *= np.sign(np.linalg.det(axes))
    return PrincipalAxes(centre, axes, np.sqrt(np.maximum(values[::-1], 0.0)))
