"""Thin plates over curved grids of points: panes and lamps that follow a body."""

from __future__ import annotations

import numpy as np

from scenewright.geometry.mesh import Floats, Mesh
from scenewright.geometry.solids import mesh_is_inside_out


def shell(grid: Floats, out: float, thick: float) -> Mesh:
    """A plate whose outer face lies ``out`` metres before a curved grid ``(n, k, 3)`` of points and
    that is ``thick`` metres thick; before is away from the axis x.

    >>> flat = np.array([[(x, 1.0, z) for z in (0.0, 1.0)] for x in (0.0, 1.0)])
    >>> shell(flat, 0.1, 0.3).vertices[:, 1].round(6).tolist()[::4]
    [1.1, 0.8]
    """
    n, k = grid.shape[:2]
    normal = np.cross(np.gradient(grid, axis=0), np.gradient(grid, axis=1))
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-12)
    away = grid.mean((0, 1)) * (0, 1, 1)
    normal *= np.sign(normal.mean((0, 1)) @ away) or 1.0
    points = np.concatenate([(grid + out * normal).reshape(-1, 3),
                             (grid + (out - thick) * normal).reshape(-1, 3)])  # fmt: skip
    i, j = (v.ravel() for v in np.meshgrid(np.arange(n - 1), np.arange(k - 1), indexing="ij"))
    a, b, c, d = i * k + j, (i + 1) * k + j, (i + 1) * k + j + 1, i * k + j + 1
    face = np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)])
    rim = [*(r * k for r in range(n)), *((n - 1) * k + r for r in range(1, k)),
           *(r * k + k - 1 for r in range(n - 2, -1, -1)), *range(k - 2, 0, -1)]  # fmt: skip
    p, q, below = np.array(rim), np.roll(rim, -1), n * k
    edge = np.concatenate(
        [np.stack([q, p, p + below], -1), np.stack([q, p + below, q + below], -1)]
    )
    found = Mesh(points, np.concatenate([face, face[:, ::-1] + below, edge]))
    return Mesh(points, found.faces[:, ::-1]) if mesh_is_inside_out(found) else found
