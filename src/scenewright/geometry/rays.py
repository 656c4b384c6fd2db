"""Rays against triangles, through embree: what a ray meets first, and whether it meets anything.

Origins and directions are ``(n, 3)`` and must be finite: embree walks the whole tree for a ray
that is not. Distances are in lengths of the direction given. Single precision.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from numpy.typing import ArrayLike, NDArray

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]


class Caster(NamedTuple):
    """Triangles ``(m, 3, 3)`` and embree's tree over them (``None`` if there are none)."""

    triangles: Singles
    tree: Any


def build(vertices: ArrayLike, faces: ArrayLike) -> Caster:
    """A caster for the triangles ``faces`` (m, 3) over ``vertices`` (n, 3)."""
    points = np.ascontiguousarray(vertices, np.float32).reshape(-1, 3)
    indices = np.ascontiguousarray(faces, np.int32).reshape(-1, 3)
    if not len(indices):
        return Caster(np.zeros((0, 3, 3), np.float32), None)
    tree = EmbreeScene()
    TriangleMesh(tree, points, indices)
    return Caster(points[indices], tree)


def first(caster: Caster, origins: ArrayLike, directions: ArrayLike) -> Ints:
    """Index ``(n,)`` of the first triangle each ray meets, -1 if none."""
    start, way = _rays(origins, directions)
    if caster.tree is None or not len(start):
        return np.full(len(start), -1, np.int32)
    met: Ints = caster.tree.run(start, way)
    return met


def hits(
    caster: Caster, origins: ArrayLike, directions: ArrayLike
) -> tuple[Singles, Ints, Singles]:
    """Distance ``(n,)`` (infinite if nothing is met), triangle and its unit normal ``(n, 3)``.

    >>> roof = build([[0, 0, 2], [1, 0, 2], [0, 1, 2]], [[0, 1, 2]])
    >>> distance, face, normal = hits(roof, [[0.2, 0.2, 0], [5, 5, 0]], [[0, 0, 1], [0, 0, 1]])
    >>> distance.tolist(), face.tolist(), normal[0].tolist()
    ([2.0, inf], [0, -1], [0.0, 0.0, 1.0])
    """
    start, way = _rays(origins, directions)
    met = first(caster, start, way)
    distance = np.full(len(start), np.inf, np.float32)
    normal = np.zeros((len(start), 3), np.float32)
    hit = np.flatnonzero(met >= 0)
    a, b, c = (caster.triangles[met[hit], k].astype(np.float64) for k in range(3))
    across = np.cross(b - a, c - a)
    facing = np.einsum("ij,ij->i", across, way[hit])
    distance[hit] = np.einsum("ij,ij->i", across, a - start[hit]) / facing
    normal[hit] = across / np.linalg.norm(across, axis=1, keepdims=True)
    return distance, met, normal


def is_occluded(
    caster: Caster, origins: ArrayLike, directions: ArrayLike, reach: ArrayLike = np.inf
) -> NDArray[np.bool_]:
    """Whether each ray meets anything nearer than ``reach``, one for all or ``(n,)``; faster than
    :func:`hits`.

    >>> roof = build([[0, 0, 2], [1, 0, 2], [0, 1, 2]], [[0, 1, 2]])
    >>> [bool(is_occluded(roof, [[0.2, 0.2, 0]], [[0, 0, 1]], reach)[0]) for reach in (3.0, 1.0)]
    [True, False]
    """
    start, way = _rays(origins, directions)
    if caster.tree is None or not len(start):
        return np.zeros(len(start), np.bool_)
    far = np.empty(len(start), np.float32)
    far[:] = np.minimum(reach, 1e30)
    blocked: NDArray[np.bool_] = caster.tree.run(start, way, far, query="OCCLUDED") >= 0
    return blocked


def _rays(origins: ArrayLike, directions: ArrayLike) -> tuple[Singles, Singles]:
    start = np.ascontiguousarray(origins, np.float32).reshape(-1, 3)
    way = np.ascontiguousarray(directions, np.float32).reshape(-1, 3)
    return start, way
