"""Edges of a triangle mesh: which two faces meet there, and one side for all faces of a part.

An edge with one face is open; one with more than two is no seam of a surface and joins none.
Files do not always wind their faces alike; here they are given a side that their neighbours share.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled
from scenewright.geometry.mesh import Mesh

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Signs = NDArray[np.int8]


class FaceAdjacency(NamedTuple):
    """Edges with exactly two faces.

    ``ends`` (e, 2) run as the first face's winding does, ``faces`` (e, 2) are the two faces, and
    ``alike`` (e,) is true where both are wound the same way round the surface. ``beside`` (m, 3)
    is the face across the edge from corner k to corner k + 1, -1 if there is not one.
    """

    ends: Ints
    faces: Ints
    alike: NDArray[np.bool_]
    beside: Ints


def seams(faces: Ints) -> FaceAdjacency:
    """Edges where exactly two faces meet.

    ``faces`` (m, 3) indices of vertices.

    >>> found = seams(np.array([[0, 1, 2], [2, 1, 3], [2, 4, 0], [2, 5, 0]]))
    >>> found.ends.tolist(), found.faces.tolist(), found.alike.tolist()
    ([[1, 2]], [[0, 1]], [True])
    """
    start = faces.reshape(-1)
    end = faces[:, [1, 2, 0]].reshape(-1)
    low, high = np.minimum(start, end), np.maximum(start, end)
    key = low * (int(high.max()) + 1) + high
    order = np.argsort(key, kind="stable")
    firsts = np.flatnonzero(np.diff(key[order], prepend=-1))
    counts = np.diff(firsts, append=len(order))
    one = order[firsts[counts == 2]]
    other = order[firsts[counts == 2] + 1]
    beside = np.full(len(start), -1, np.int64)
    beside[one], beside[other] = other // 3, one // 3
    return FaceAdjacency(
        np.stack([start[one], end[one]], 1),
        np.stack([one // 3, other // 3], 1),
        start[one] == end[other],
        beside.reshape(-1, 3),
    )


def sides(mesh: Mesh, found: FaceAdjacency) -> Signs:
    """1 for each face (m,) wound counter-clockwise seen from outside, -1 for the others.

    Neighbours agree as far as the surface has two sides. The outside of a closed part is where
    its volume is positive, and of an open part where most of its area already says.
    """
    count = len(mesh.faces)
    differs = np.zeros((count, 3), np.bool_)
    _mark(found, mesh.faces, differs)
    side, part = np.zeros(count, np.int8), np.full(count, -1, np.int64)
    parts = spread(found.beside, differs, np.empty(count, np.int64), side, part)
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    area = sum_by_name(part, side * np.linalg.norm(across, axis=1), parts)
    volume = sum_by_name(part, side * np.einsum("ij,ij->i", a, across), parts)
    is_open = sum_by_name(part, np.sum(found.beside < 0, axis=1) * 1.0, parts) > 0
    wrong = np.where(is_open, area, volume) < 0.0
    turned: Signs = np.where(wrong[part], -side, side).astype(np.int8)
    return turned


def sum_by_name(names: Ints, values: Floats, count: int) -> Floats:
    """The sum ``(count,)`` of the values under each name.

    >>> sum_by_name(np.array([0, 2, 0]), np.array([1.0, 2.0, 3.0]), 3).tolist()
    [4.0, 0.0, 2.0]
    """
    return np.asarray(np.bincount(names, weights=values, minlength=count), np.float64)


def _mark(found: FaceAdjacency, faces: Ints, differs: NDArray[np.bool_]) -> None:
    """Mark both half edges of every seam whose faces are wound differently."""
    unlike = ~found.alike
    for k in range(3):
        for face in found.faces[unlike].T:
            at = np.stack([faces[face, k], faces[face, (k + 1) % 3]])
            same = (np.sort(at, 0) == np.sort(found.ends[unlike].T, 0)).all(0)
            differs[face[same], k] = True


@compiled
def spread(beside: Ints, differs: NDArray[np.bool_], stack: Ints, side: Signs, part: Ints) -> int:
    """Walk over the faces of each part, giving each the side its neighbour has (or the other
    where they differ), and the number of its part. Returns how many parts there are.

    ``beside`` and ``differs`` (m, 3), ``stack``, ``side`` and ``part`` (m,).
    """
    parts = 0
    for seed in range(part.shape[0]):
        if part[seed] >= 0:
            continue
        part[seed], side[seed], stack[0] = parts, 1, seed
        waiting = 1
        while waiting:
            waiting -= 1
            face = stack[waiting]
            for k in range(3):
                other = beside[face, k]
                if other >= 0 and part[other] < 0:
                    part[other] = parts
                    side[other] = -side[face] if differs[face, k] else side[face]
                    stack[waiting] = other
                    waiting += 1
        parts += 1
    return parts
