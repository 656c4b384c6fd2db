"""A part of fewer triangles, by the collapse of edges that moves the surface least.

M. Garland, P. Heckbert, *Surface simplification using quadric error metrics* (1997), as the
library fast-simplification does it. Corners in one place are joined first: most files give every
face its own.
"""

from __future__ import annotations

import fast_simplification
import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.model import compact_part
from scenewright.core.catalog import Part

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

CLOSE = 1e-6
"""Corners of one cell of so small a share of the longest side are one."""
MOST_AROUND, MOST_FOLDED = 2048, 0.1
"""Faces round one corner, and the share of edges of more than two faces, up to which collapsing
edges leads anywhere."""


def decimate(part: Part, most: int) -> Part:
    """The part with at most ``most`` triangles; its bounding box stays what it was.

    Where faces meet so wildly that no edge can go, and where not enough edges can, the ``most``
    largest are kept.
    """
    if len(part.faces) <= most:
        return part
    vertices, faces = _join_corners(part)
    if len(faces) > most:
        if not _is_wild(faces):
            found = fast_simplification.simplify(
                vertices, faces.astype(np.int32), target_count=most
            )
            vertices, faces = np.asarray(found[0], np.float64), found[1].astype(np.int64)
        faces = faces[np.sort(np.argsort(-_areas(vertices, faces), kind="stable")[:most])]
    if not len(faces):
        return Part(part.material, part.vertices, part.faces[:0])
    thin = compact_part(Part(part.material, vertices, faces))
    low, high = part.vertices.min(0), part.vertices.max(0)
    return Part(part.material, _stretch_corners(thin.vertices, low, high), thin.faces)


def _join_corners(part: Part) -> tuple[Floats, Ints]:
    """Corners of one place made one, without faces that thereby are lines."""
    low, high = part.vertices.min(0), part.vertices.max(0)
    cells = np.rint((part.vertices - low) / max(float((high - low).max()) * CLOSE, 1e-300))
    _, first, joined = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    faces = joined.ravel()[part.faces]
    faces = faces[(faces != np.roll(faces, 1, axis=1)).all(1)]
    return part.vertices[first], faces


def _is_wild(faces: Ints) -> bool:
    """Whether too many faces meet in one corner, or too often more than two in an edge."""
    if np.bincount(faces.ravel()).max() > MOST_AROUND:
        return True
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    _, count = np.unique(edges @ [int(faces.max()) + 1, 1], return_counts=True)
    return bool((count > 2).mean() > MOST_FOLDED)


def _areas(vertices: Floats, faces: Ints) -> Floats:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    areas: Floats = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return areas


def _stretch_corners(vertices: Floats, low: Floats, high: Floats) -> Floats:
    """Corners stretched so that they fill the box from ``low`` to ``high``."""
    least, most = vertices.min(0), vertices.max(0)
    span = np.where(most > least, most - least, 1.0)
    scale = np.where(most > least, (high - low) / span, 1.0)
    return np.clip(low + (vertices - least) * scale, low, high)
