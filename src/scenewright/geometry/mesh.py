"""Triangle meshes as plain arrays: lofting, extruding, moving, merging, fitting into a box.

Every mesh is closed and its faces run counter-clockwise seen from outside, so its signed volume
is positive. Metres, z up.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.geometry.joints import Joint, transform_joint

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


_MIX = np.array([0x9E3779B97F4A7C15, 0x3C6EF372FE94F82B, 0x5851F42D4C957F2D], np.uint64).astype(
    np.int64
)  # odd numbers without pattern


class Mesh(NamedTuple):
    """Triangles: ``vertices`` (n, 3) in metres and ``faces`` (m, 3) of indices into them; of what
    moves its ``joint``."""

    vertices: Floats
    faces: Ints
    joint: Joint | None = None


def volume(mesh: Mesh) -> float:
    """Signed volume in cubic metres: the sum of a·(b x c)/6 over the faces."""
    a, b, c = (mesh.vertices[mesh.faces[:, i]] for i in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def loft(rings: ArrayLike) -> Mesh:
    """Skin over rings ``(k, n, 3)``, each counter-clockwise seen from where the next ones lie.

    The first and last ring are closed by fans, so they must be convex. Rings may rise outside
    and fall again inside (a bowl); equal points are joined, so a ring may shrink to a point.

    >>> square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> cube = loft([[(x, y, z) for x, y in square] for z in (0.0, 1.0)])
    >>> len(cube.faces), volume(cube)
    (12, 1.0)
    """
    stack = np.asarray(rings, np.float64)
    count, size = stack.shape[:2]
    base = np.arange(count - 1)[:, None] * size
    i, j = np.arange(size)[None], np.roll(np.arange(size), -1)[None]
    a, b, c, d = base + i, base + j, base + size + j, base + size + i
    sides = np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], 2).reshape(-1, 3)
    fan = np.stack([np.zeros(size - 2, int), np.arange(1, size - 1), np.arange(2, size)], -1)
    faces = np.concatenate([fan[:, ::-1], sides, fan + (count - 1) * size])
    return weld_mesh(Mesh(stack.reshape(-1, 3), faces.astype(np.int64)))


def weld_mesh(mesh: Mesh) -> Mesh:
    """The mesh with equal vertices joined (to 1e-9 m) and faces that vanish by it dropped.

    Vertices are told apart by a 64-bit mix of their rounded coordinates.
    """
    keys = np.round(mesh.vertices * 1e9).astype(np.int64) @ _MIX
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    if len(first) == len(keys):
        return mesh
    faces = inverse.reshape(-1)[mesh.faces]
    kept = (
        (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    )
    return Mesh(mesh.vertices[first], faces[kept].astype(np.int64))


def extrude(outline: ArrayLike, low: float, high: float) -> Mesh:
    """A simple polygon ``(n, 2)``, counter-clockwise, between two heights; n - 2 triangles a cap.

    >>> ell = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
    >>> round(volume(extrude(ell, 0.0, 1.0)), 9)
    3.0
    """
    points = np.asarray(outline, np.float64)
    n = len(points)
    caps = clipped_ears(points)
    i, j = np.arange(n), np.roll(np.arange(n), -1)
    sides = np.concatenate([np.stack([i, j, j + n], -1), np.stack([i, j + n, i + n], -1)])
    vertices = np.concatenate(
        [np.column_stack([points, np.full(n, low)]), np.column_stack([points, np.full(n, high)])]
    )
    return Mesh(vertices, np.concatenate([caps[:, ::-1], sides, caps + n]).astype(np.int64))


def clipped_ears(points: Floats) -> Ints:
    """Triangles (n - 2, 3) of a simple counter-clockwise polygon (Meisters 1975, two ears)."""
    left = list(range(len(points)))
    found: list[tuple[int, int, int]] = []
    while len(left) > 3:
        count = len(left)
        best = next((k for k in range(count) if _is_ear(points, left, k)), 0)
        found.append((left[best - 1], left[best], left[(best + 1) % count]))
        del left[best]
    found.append((left[0], left[1], left[2]))
    return np.array(found, np.int64)


def _is_ear(points: Floats, left: list[int], k: int) -> bool:
    a, b, c = points[left[k - 1]], points[left[k]], points[left[(k + 1) % len(left)]]
    if _cross(a, b, c) <= 1e-14:
        return False
    ends = {left[k - 1], left[k], left[(k + 1) % len(left)]}
    rest = points[[i for i in left if i not in ends]]
    inside = (_cross(a, b, rest) >= 0) & (_cross(b, c, rest) >= 0) & (_cross(c, a, rest) >= 0)
    return not bool(np.any(inside))


def _cross(a: Floats, b: Floats, c: Floats) -> Floats:
    return np.asarray(
        (b[0] - a[0]) * (c[..., 1] - a[1]) - (b[1] - a[1]) * (c[..., 0] - a[0]), np.float64
    )


def merge(meshes: Sequence[Mesh]) -> Mesh:
    """Several meshes as one that stands still, nothing joined."""
    starts = np.cumsum([0, *(len(m.vertices) for m in meshes)])
    return Mesh(
        np.concatenate([m.vertices for m in meshes]),
        np.concatenate([m.faces + s for m, s in zip(meshes, starts, strict=False)]),
    )


def translate_mesh(mesh: Mesh, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Mesh:
    """The mesh shifted."""
    joint = mesh.joint and transform_joint(mesh.joint, np.eye(3), (x, y, z))
    return Mesh(mesh.vertices + np.array([x, y, z]), mesh.faces, joint)


def rotate_mesh(mesh: Mesh, axis: str, angle: float, about: ArrayLike = (0.0, 0.0, 0.0)) -> Mesh:
    """The mesh turned by ``angle`` radians about the x, y or z axis through a point."""
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    centre, cos, sin = np.asarray(about, np.float64), np.cos(angle), np.sin(angle)
    local = mesh.vertices - centre
    out = local.copy()
    out[:, i], out[:, j] = (
        cos * local[:, i] - sin * local[:, j],
        sin * local[:, i] + cos * local[:, j],
    )
    joint = mesh.joint and _rotate_joint(mesh.joint, i, j, angle, centre)
    return Mesh(out + centre, mesh.faces, joint)


def _rotate_joint(joint: Joint, i: int, j: int, angle: float, centre: Floats) -> Joint:
    turn = np.eye(3)
    turn[i, i] = turn[j, j] = np.cos(angle)
    turn[i, j], turn[j, i] = -np.sin(angle), np.sin(angle)
    return transform_joint(joint, turn, centre - turn @ centre)


def map_points(points: Floats, source: tuple[Floats, Floats], low: Floats, high: Floats) -> Floats:
    """Points taken affinely, axis by axis, from the box ``source`` to the box ``low``, ``high``.

    ``points`` (n, 3); all corners of boxes (3,).
    """
    start, end = source
    scale = (high - low) / np.maximum(end - start, 1e-12)
    return np.clip(low + (points - start) * scale, low, high)
