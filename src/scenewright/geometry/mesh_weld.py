"""Meshes from files made sound: corners joined, faces without area and doubled faces left out.

Files often give every face its own corners, write a sheet once for each side, or hold triangles
that are lines. What is kept remembers where it came from. Nothing is moved: a joined corner is one
of the given ones.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled
from scenewright.geometry.mesh import Mesh

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

CLOSE = 1e-6
"""Corners nearer than this share of the mesh's size are one."""
CELL = 8.0
"""Side of a cell of the hash grid, in lengths within which corners are joined."""
_MIX = np.array([0x2545F4914F6CDD1D, 0x369DEA0F31A53F85, 0x5851F42D4C957F2D], np.int64)


class CleanMesh(NamedTuple):
    """A sound mesh about the origin, and where it came from.

    ``mesh`` holds the kept corners, moved by ``-centre``; ``vertex`` (n,) gives each given vertex
    its number there, -1 if no kept face has it; ``face`` (m,) the given number of each kept face.
    ``size`` is twice the greatest distance of a corner from the centroid of the surface.
    """

    mesh: Mesh
    vertex: Ints
    face: Ints
    centre: Floats
    size: float


def clean_mesh(mesh: Mesh) -> CleanMesh:
    """The mesh with corners joined and useless faces left out.

    ``size`` stands for the diagonal of the bounding box (they are equal for a cuboid), but does
    not change when the mesh is turned, and does not depend on how a surface is cut in triangles.

    Raises :class:`ValueError`, in one line, if there is nothing to make sound: no face with an
    area, corners that are not there or not at a finite place.

    >>> sheet = Mesh(np.array([[0.0, 0, 0], [3, 0, 0], [3, 4, 0], [0, 0, 0], [3, 4, 0], [0, 4, 0]]),
    ...              np.array([[0, 1, 2], [3, 4, 5], [2, 1, 0], [0, 0, 1]]))
    >>> found = clean_mesh(sheet)
    >>> found.vertex.tolist(), found.face.tolist(), found.size
    ([0, 1, 2, 0, 2, 3], [0, 1], 5.0)
    """
    vertices, faces = _check_mesh(mesh)
    about, rough = _extent(vertices, faces)
    local = vertices - about
    number, kept = _join_points(local, faces, CLOSE * rough)
    triangles = number[faces]
    alive = _alive(local[kept], triangles, CLOSE * rough)
    if not len(alive):
        raise ValueError("the mesh has no face with an area")
    used = np.zeros(len(kept) + 1, np.bool_)
    used[triangles[alive].reshape(-1)] = True
    renamed = np.where(used, np.cumsum(used) - 1, -1)
    points, names = local[kept][used[:-1]], renamed[triangles[alive]]
    middle, size = _extent(points, names)  # doubled faces no longer count twice
    return CleanMesh(Mesh(points - middle, names), renamed[number], alive, about + middle, size)


def _check_mesh(mesh: Mesh) -> tuple[Floats, Ints]:
    vertices = np.asarray(mesh.vertices, np.float64)
    faces = np.asarray(mesh.faces, np.int64)
    if not len(faces) or not len(vertices):
        raise ValueError("the mesh has no faces")
    if vertices.ndim != 2 or vertices.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 3:
        raise ValueError("the mesh is not made of triangles in space")
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise ValueError("a face has a corner that is not there")
    used = np.zeros(len(vertices), np.bool_)
    used[faces.reshape(-1)] = True
    if not np.all(np.abs(vertices[used]) < 1e15):  # also false for what is not a number
        raise ValueError("a corner of the mesh is not at a finite place")
    return np.where(used[:, None], vertices, 0.0), faces


def _extent(vertices: Floats, faces: Ints) -> tuple[Floats, float]:
    """Centroid of the surface, and twice the greatest distance of a corner from it."""
    used = vertices[faces]
    near = 0.5 * (used.min((0, 1)) + used.max((0, 1)))  # far from the origin digits run out
    corners = used - near
    double = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    if not double.sum() > 0.0:
        raise ValueError("the mesh has no face with an area")
    middle = double @ corners.mean(1) / double.sum()
    reach = float(np.sqrt(((corners - middle) ** 2).sum(2).max()))
    return near + middle, 2.0 * reach


def _join_points(points: Floats, faces: Ints, close: float) -> tuple[Ints, Ints]:
    """For each point the number of the one it is joined to, and the given numbers of those."""
    room = 1 << max(4, math.ceil(math.log2(2 * len(points))))
    heads, following = np.full(room, -1, np.int64), np.full(len(points), -1, np.int64)
    number, kept = np.full(len(points), -1, np.int64), np.empty(len(points), np.int64)
    used = np.zeros(len(points), np.bool_)
    used[faces.reshape(-1)] = True
    count = join(points, used, close, _MIX, heads, following, number, kept)
    return number, kept[:count]


@compiled
def join(
    points: Floats,
    used: NDArray[np.bool_],
    close: float,
    mix: Ints,
    heads: Ints,
    following: Ints,
    number: Ints,
    kept: Ints,
) -> int:
    """Number the points in turn: that of a kept point nearer than ``close``, else a new one.

    ``heads`` and ``following`` are the lists of a hash grid; kept points lie ``close`` apart, so
    no cell can hold many. Returns how many were kept. ``points`` (n, 3), ``used`` and ``number``
    (n,), ``mix`` (3,) factors of the hash.
    """
    cell = CELL * close
    mask = heads.shape[0] - 1
    count = 0
    for i in range(points.shape[0]):
        if not used[i]:
            continue
        x, y, z = points[i, 0], points[i, 1], points[i, 2]
        found = -1
        for a in range(math.floor((x - close) / cell), math.floor((x + close) / cell) + 1):
            for b in range(math.floor((y - close) / cell), math.floor((y + close) / cell) + 1):
                for c in range(math.floor((z - close) / cell), math.floor((z + close) / cell) + 1):
                    spot = a * mix[0] + b * mix[1] + c * mix[2]
                    k = heads[(spot ^ (spot >> 29)) & mask]
                    while k >= 0 and found < 0:
                        j = kept[k]
                        u, v, w = points[j, 0] - x, points[j, 1] - y, points[j, 2] - z
                        if u * u + v * v + w * w <= close * close:
                            found = k
                        k = following[k]
        if found < 0:
            spot = (
                math.floor(x / cell) * mix[0]
                + math.floor(y / cell) * mix[1]
                + math.floor(z / cell) * mix[2]
            )
            place = (spot ^ (spot >> 29)) & mask
            kept[count], following[count], heads[place] = i, heads[place], count
            found = count
            count += 1
        number[i] = found
    return count


def _alive(points: Floats, faces: Ints, close: float) -> Ints:
    """Numbers of the faces with an area, each set of three corners once."""
    a, b, c = (points[faces[:, k]] for k in range(3))
    double = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    sides = np.stack([((b - a) ** 2).sum(1), ((c - b) ** 2).sum(1), ((a - c) ** 2).sum(1)])
    wide = np.flatnonzero(double > close * np.sqrt(sides.max(0)))
    ordered = np.sort(faces[wide], axis=1)
    _, first = np.unique(ordered @ _MIX, return_index=True)
    return np.asarray(wide[np.sort(first)], np.int64)
