"""Depth maps of a model: how deep the first surface lies behind its box, seen from any side.

A light field (Chen, Tian, Shen and Ouhyoung 2003) is such maps from the corners of a dodecahedron
all around. We take the ten of its upper half: things stand, so that nobody sees them from below.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry import rays
from scenewright.geometry.mesh import Mesh

Floats = NDArray[np.float64]
ASIDE = 1e-3
"""How far before the box rays begin, as a share of its depth."""
SIDES = np.array([[1.0, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
"""Ways (4, 3) towards the eye: from the four sides."""


def light_field_ways() -> Floats:
    """Unit ways (10, 3) towards the eye: the corners of a dodecahedron of the upper half, by
    height and then around.

    >>> ways = light_field_ways()
    >>> ways.shape, bool((ways[:, 2] > 0).all())
    ((10, 3), True)
    """
    golden = (1 + 5**0.5) / 2
    corners = [list(corner) for corner in product((-1.0, 1.0), repeat=3)]
    for a, b in product((-1 / golden, 1 / golden), (-golden, golden)):
        corners += [[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]
    turn = np.arctan2(1.0, golden**2)  # so that no corner lies on the horizon
    cosine, sine = np.cos(turn), np.sin(turn)
    ways = np.array(corners) / 3**0.5
    ways = ways @ np.array([[1.0, 0, 0], [0, cosine, -sine], [0, sine, cosine]])
    upper = ways[ways[:, 2] > 1e-9]
    order = np.lexsort((np.arctan2(upper[:, 1], upper[:, 0]), -np.round(upper[:, 2], 6)))
    return np.asarray(upper[order])


def depth_maps(mesh: Mesh, ways: Floats, count: int, stretched: bool = True) -> Floats:
    """Depth (w, N, N) of what is seen from each way (w, 3) by parallel rays, by height from below
    and then from the left: 0 at the near side of the model's box in that view, 1 at the far one,
    infinite where nothing is. ``stretched`` maps fill the box of the view; others keep the
    proportions and have room at the sides.

    >>> from scenewright.geometry.solids import block
    >>> wall = block((0, 4), (0, 1), (0, 2))
    >>> bool(np.isfinite(depth_maps(wall, SIDES, 8)).all())
    True
    """
    caster = rays.build(mesh.vertices, mesh.faces)
    steps = (np.arange(count) + 0.5) / count
    across, upwards = np.meshgrid(steps, steps)
    found = []
    for way in ways:
        frame = _frame(way)
        low, high = (mesh.vertices @ frame.T).min(0), (mesh.vertices @ frame.T).max(0)
        size = np.maximum(high - low, 1e-9)
        pane = size[:2] if stretched else np.full(2, size[:2].max())
        corner = (low + high)[:2] / 2 - pane / 2
        start = high[2] + ASIDE * size[2]
        places = np.stack(
            [corner[0] + across * pane[0], corner[1] + upwards * pane[1]], -1
        ).reshape(-1, 2)
        origins = np.concatenate([places, np.full((count**2, 1), start)], 1) @ frame
        distance, _, _ = rays.hits(caster, origins, np.tile(-way, (count**2, 1)))
        depth = np.clip(distance / size[2] - ASIDE, 0.0, 1.0)
        found.append(np.where(np.isfinite(distance), depth, np.inf).reshape(count, count))
    return np.array(found, np.float64)


def _frame(way: Floats) -> Floats:
    """Rows (3, 3): to the right, upwards, towards the eye."""
    up = np.array([0.0, 0, 1]) if abs(way[2]) < 0.999 else np.array([0.0, 1, 0])
    right = np.cross(up, way)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(way, right), way])
