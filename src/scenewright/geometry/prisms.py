"""Triangles of polygons with holes, of prisms over them and of boxes; normals of any mesh."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import mapbox_earcut
import numpy as np

from scenewright.geometry.mesh import Floats, Ints, Mesh

AT_ONCE = 50_000
"""Faces of several meshes whose normals are found together."""
MOST_PLANES = 256
"""Planes that may meet at a point whose normals are made smooth."""


def triangles(outline: Floats, holes: Sequence[Floats] = ()) -> Ints:
    """Triangles ``(t, 3)`` of a polygon, as indices into outline and holes stacked.

    Ear clipping with bridges to the holes (after D. Eberly, *Triangulation by Ear Clipping*).

    >>> triangles(np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])).shape
    (2, 3)
    """
    corners = np.ascontiguousarray(np.vstack([outline, *holes]), np.float64)
    ends = np.cumsum([len(ring) for ring in (outline, *holes)]).astype(np.uint32)
    found = mapbox_earcut.triangulate_float64(corners, ends).reshape(-1, 3).astype(np.int64)
    (ax, ay), (bx, by), (cx, cy) = (corners[found[:, k]].T for k in range(3))
    clockwise = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0
    found[clockwise] = found[clockwise][:, ::-1]
    return found


def sheet(outline: Floats, holes: Sequence[Floats] = (), height: float = 0.0) -> Mesh:
    """A flat polygon seen from above at ``height``.

    ``outline`` and each of ``holes`` (n, 2), metres.
    """
    corners = np.vstack([outline, *holes])
    return Mesh(
        np.column_stack([corners, np.full(len(corners), height)]), triangles(outline, holes)
    )


def prism(outline: Floats, base: float, top: float, holes: Sequence[Floats] = ()) -> Mesh:
    """A vertical prism: outline counter-clockwise, holes clockwise; closed.

    Rings (n, 2), heights in metres.

    >>> from scenewright.geometry.mesh import volume
    >>> round(volume(prism(np.array([[0.0, 0], [2, 0], [2, 1], [0, 1]]), 0.0, 3.0)), 9)
    6.0
    """
    vertices, faces, _ = mound(outline, base, top, holes)
    upper, sides = np.split(faces, [len(faces) - len(vertices)])
    return Mesh(vertices, np.vstack([upper, upper[:, ::-1] - len(vertices) // 2, sides]))


def mound(outline: Floats, base: float, top: float, holes: Sequence[Floats] = ()) -> Mesh:
    """A vertical prism without its lower face, for what stands in the ground.

    >>> len(mound(np.array([[0.0, 0], [2, 0], [2, 1], [0, 1]]), -0.1, 0.2).faces)
    10
    """
    upper, flat, _ = sheet(outline, holes, top)
    count = len(upper)
    lower = upper.copy()
    lower[:, 2] = base
    sides, start = [], 0
    for ring in (outline, *holes):
        here = np.arange(start, start + len(ring))
        there = np.roll(here, -1)
        sides += [
            np.stack([here, there, there + count], 1),
            np.stack([here, there + count, here + count], 1),
        ]
        start += len(ring)
    return Mesh(np.vstack([lower, upper]), np.vstack([flat + count, *sides]))


def box(low: Sequence[float], high: Sequence[float]) -> Mesh:
    """The box between two opposite corners.

    >>> box((0, 0, 0), (1, 2, 3)).faces.shape
    (12, 3)
    """
    (x0, y0, z0), (x1, y1, z1) = low, high
    return prism(np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]], float), z0, z1)


def face_normals(vertices: Floats, faces: Ints) -> Floats:
    """Unit normals ``(m, 3)``; zero for faces without area."""
    return _unit(_across(vertices, faces))


def corner_normals(
    vertices: Floats, faces: Ints, bodies: Ints | None = None, crease: float = np.deg2rad(46.0)
) -> Floats:
    """Normals ``(m, 3, 3)`` at the corners of each face, smooth across edges below ``crease``.

    Each is the mean, weighted by area, of the faces that meet at the same point and whose normal
    is within ``crease`` radians of this face's own. Points count as the same within 0.01 mm, and
    if they belong to the same body (``bodies`` (n,), default all one). Faces of one plane count
    together, and where more than :data:`MOST_PLANES` meet each keeps its own normal, so that a
    fan of thousands costs no square of them.
    """
    across = _across(vertices, faces)
    own = _unit(across)
    keys = row_keys(
        vertices / 1e-5 if bodies is None else np.column_stack([vertices / 1e-5, bodies])
    )
    points = np.unique(keys, return_inverse=True)[1][faces.reshape(-1)]
    planes = np.repeat(np.unique(row_keys(own * 1e9), return_inverse=True)[1], 3)
    _, first, fan = np.unique(
        points * (planes.max(initial=0) + 1) + planes, return_index=True, return_inverse=True
    )
    areas = _sum_by(fan, across[np.arange(faces.size) // 3], len(first))
    here, there = _meetings(points[first])
    normals = own[first // 3]
    alike = np.einsum("ij,ij->i", normals[here], normals[there]) >= np.cos(crease) - 1e-9
    found = _unit(_sum_by(here[alike], areas[there[alike]], len(first)))
    smooth = np.where(np.abs(found).max(1, keepdims=True, initial=0.0) > 0, found, normals)
    return smooth[fan].reshape(-1, 3, 3)


def _sum_by(groups: Ints, rows: Floats, count: int) -> Floats:
    """The sum ``(count, 3)`` of the rows ``(n, 3)`` of each group."""
    return np.stack([np.bincount(groups, rows[:, axis], count) for axis in range(3)], -1)


def normals_of(meshes: Sequence[tuple[Floats, Ints]]) -> Iterator[Floats]:
    """The :func:`corner_normals` of many meshes, found for :data:`AT_ONCE` faces together, which
    is far faster than one by one and takes no more memory however many there are.

    Meshes as vertices (n, 3) and faces (m, 3); normals (m, 3, 3).
    """
    ends = np.cumsum([len(faces) for _, faces in meshes], dtype=np.int64)
    bounds = np.arange(0, ends[-1], AT_ONCE) if meshes else ends
    batches = {0, *np.searchsorted(ends, bounds).tolist(), len(meshes)}
    for start, end in itertools.pairwise(sorted(batches)):
        yield from _normals_of(meshes[start:end])


def _normals_of(meshes: Sequence[tuple[Floats, Ints]]) -> list[Floats]:
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in meshes)])
    vertices = np.concatenate([vertices for vertices, _ in meshes])
    faces = np.concatenate([f + start for (_, f), start in zip(meshes, starts, strict=False)])
    bodies = np.repeat(np.arange(len(meshes)), np.diff(starts))
    ends = np.cumsum([len(f) for _, f in meshes])[:-1]
    return np.split(corner_normals(vertices, faces, bodies), ends)


def _across(vertices: Floats, faces: Ints) -> Floats:
    """The cross product of two sides of each face: its normal, twice its area long."""
    a = vertices[faces[:, 0]]
    (ux, uy, uz), (vx, vy, vz) = (vertices[faces[:, 1]] - a).T, (vertices[faces[:, 2]] - a).T
    return np.stack([uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx], 1)


def _unit(rows: Floats) -> Floats:
    length = np.sqrt(np.einsum("ij,ij->i", rows, rows))[:, None]
    return np.where(length > 1e-14, rows / np.maximum(length, 1e-14), 0.0)


def row_keys(rows: Floats) -> Ints:
    """One integer a row of ``(n, k)``, equal for rows that round to the same integers.

    A sum with odd 64-bit multipliers: different rows meet by chance about once in 1e19 pairs.

    >>> keys = row_keys(np.array([[1.0, 2.0], [1.2, 1.9], [2.0, 1.0]]))
    >>> bool(keys[0] == keys[1]), bool(keys[0] == keys[2])
    (True, False)
    """
    odd = np.array(
        [
            -7046029254386353131,
            -4417276706812531889,
            1609587929392839161,
            -8796714831421723037,
            2870177450012600261,
            6620516959819538809,
        ]
    )
    whole = np.round(rows).astype(np.int64)
    mixed = np.zeros(len(rows), np.int64)
    with np.errstate(over="ignore"):
        for axis in range(rows.shape[1]):
            mixed = (mixed ^ (mixed >> 29)) * odd[(axis + 3) % 6] + whole[:, axis] * odd[axis % 6]
    return mixed


def _meetings(points: Ints) -> tuple[Ints, Ints]:
    """All ordered pairs ``(i, j)`` that lie at the same point, i = j included; where more than
    :data:`MOST_PLANES` lie at one point only ``(i, i)``."""
    order = np.argsort(points, kind="stable")
    _, first, count = np.unique(points[order], return_index=True, return_counts=True)
    shared = np.repeat(count, count)
    crowded = shared > MOST_PLANES
    sizes = np.where(crowded, 1, shared)
    here = np.repeat(order, sizes)
    begin = np.where(crowded, np.arange(len(order)), np.repeat(first, count))
    within = np.arange(len(here)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    return here, order[np.repeat(begin, sizes) + within]
