"""A part of fewer triangles: corners of one cell of a grid become one (vertex clustering).

J. Rossignac, P. Borrel, Multi-resolution 3D approximations for rendering complex scenes (1993).
Quick, and safe on meshes of any quality; the finest grid that is coarse enough is taken.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

FINEST, COARSEST, FINER = 1024.0, 4.0, 2**0.25
"""Cells along the longest side of a mesh, and the steps from the finest grid down."""


def decimate(part: Part, most: int) -> Part:
    """The part with at most ``most`` triangles; its bounding box stays what it was.

    A cell's corners become the one nearest to their mean, so flat sides stay flat. Triangles that
    become lines go, and so do doubles.
    """
    if len(part.faces) <= most:
        return part
    cells = FINEST
    found = cluster_corners(part, cells)
    while len(found.faces) > most and cells > COARSEST:
        cells /= FINER
        found = cluster_corners(part, cells)
    return found


def cluster_corners(part: Part, cells: float) -> Part:
    """The part with the corners of each cell made one; ``cells`` along its longest side."""
    low, high = part.vertices.min(0), part.vertices.max(0)
    side = float((high - low).max()) / cells
    grid = np.minimum((part.vertices - low) / side, cells - 1e-6).astype(np.int64)
    _, cell = np.unique(grid, axis=0, return_inverse=True)
    cell = cell.ravel()
    chosen = _middle_ones(part.vertices, cell)
    faces = cell[part.faces]
    faces = _once(faces[(faces != np.roll(faces, 1, axis=1)).all(1)])
    return Part(part.material, _stretch_corners(part.vertices[chosen], faces, low, high), faces)


def _middle_ones(vertices: Floats, cell: Ints) -> Ints:
    """Of each cell the corner nearest to the mean of its corners."""
    count = np.bincount(cell).astype(np.float64)
    means = np.stack([np.bincount(cell, vertices[:, k]) for k in range(3)], 1) / count[:, None]
    away = ((vertices - means[cell]) ** 2).sum(1)
    order = np.lexsort((away, cell))
    first = np.r_[True, np.diff(cell[order]) > 0]
    return order[first].astype(np.int64)


def _once(faces: Ints) -> Ints:
    """Faces without those that have the same corners in the same sense as an earlier one."""
    if not len(faces):
        return faces
    start = faces.argmin(1)
    turned = faces[np.arange(len(faces))[:, None], (start[:, None] + np.arange(3)) % 3]
    _, first = np.unique(turned, axis=0, return_index=True)
    return faces[np.sort(first)]


def _stretch_corners(vertices: Floats, faces: Ints, low: Floats, high: Floats) -> Floats:
    """Corners stretched so that the faces fill the box that they filled."""
    if not len(faces):
        return vertices
    used = vertices[faces.ravel()]
    least, most = used.min(0), used.max(0)
    span = np.where(most > least, most - least, 1.0)
    scale = np.where(most > least, (high - low) / span, 1.0)
    return np.clip(low + (vertices - least) * scale, low, high)
