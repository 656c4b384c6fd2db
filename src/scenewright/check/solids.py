"""How deep two solids are in each other: convex ones exactly, others by points of their surface.

Solids are the connected pieces of closed meshes, ``vertices`` (n, 3) and ``faces`` (m, 3).
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

FLAT = 1e-3
"""Metres by which a corner may stand out of the plane of a face of a convex solid."""
STEP = 0.018
"""Greatest distance in metres between points taken of a surface."""
FEW = 12
"""Directions of edges up to which their cross products are tried: boxes, wedges, prisms."""


class Solid:
    """One closed, connected mesh; what is derived of it is computed once, when it is asked for."""

    def __init__(self, vertices: Floats, faces: Ints, convex: bool | None = None) -> None:
        self.vertices, self.faces = vertices, faces
        self.low, self.high = vertices.min(0), vertices.max(0)
        if convex is not None:
            self.convex = convex

    def moved(self, turn: Floats, shift: Floats) -> Solid:
        """The same solid, each point p of it at ``turn`` (3, 3) p + ``shift`` (3,)."""
        return Solid(self.vertices @ turn.T + shift, self.faces, self.convex)

    @cached_property
    def corners(self) -> Floats:
        """The triangles (m, 3, 3)."""
        found: Floats = self.vertices[self.faces]
        return found

    @cached_property
    def normals(self) -> Floats:
        """The directions (k, 3) its faces look, each once."""
        a, b, c = (self.corners[:, k] for k in range(3))
        return _distinct(np.cross(b - a, c - a))

    @cached_property
    def edges(self) -> Floats:
        """The directions (k, 3) of its edges, each once, whichever way."""
        found = np.concatenate([self.corners[:, k] - self.corners[:, k - 1] for k in range(3)])
        found = found * np.where(found @ np.array([1.0, 0.618, 0.382]) < 0, -1.0, 1.0)[:, None]
        return _distinct(found)

    @cached_property
    def convex(self) -> bool:
        """Whether no corner stands out of the plane of a face."""
        a, b, c = (self.corners[:, k] for k in range(3))
        across = np.cross(b - a, c - a)
        size = np.linalg.norm(across, axis=1)
        kept = size > 1e-12
        unit = across[kept] / size[kept, None]
        out = unit @ self.vertices.T - np.einsum("ij,ij->i", unit, a[kept])[:, None]
        return bool((out <= FLAT).all())


def _distinct(found: Floats) -> Floats:
    length = np.linalg.norm(found, axis=1)
    unit = found[length > 1e-12] / length[length > 1e-12, None]
    kept: Floats = unit[np.unique(np.round(unit, 3), axis=0, return_index=True)[1]]
    return kept


def is_closed(vertices: Floats, faces: Ints) -> bool:
    """Whether each edge of a mesh belongs to two faces that run through it in opposite directions,
    equal points (to 1 µm) being one.

    >>> tetrahedron = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    >>> points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    >>> is_closed(points, tetrahedron), is_closed(points, tetrahedron[:3])
    (True, False)
    """
    _, joined = np.unique(np.round(vertices, 6), axis=0, return_inverse=True)
    named = joined.reshape(-1)[faces]
    ways = np.concatenate([named[:, [k, (k + 1) % 3]] for k in range(3)])
    ways = ways[ways[:, 0] != ways[:, 1]]
    there, counts = np.unique(ways, axis=0, return_counts=True)
    back, others = np.unique(ways[:, ::-1], axis=0, return_counts=True)
    return bool(np.array_equal(there, back) and np.array_equal(counts, others))


def solids_of(vertices: Floats, faces: Ints) -> Iterator[Solid]:
    """The connected pieces of a mesh."""
    label = np.arange(len(vertices))
    while True:
        least = label[faces].min(1)
        new = label.copy()
        for k in range(3):
            np.minimum.at(new, faces[:, k], least)
        new = new[new]
        if np.array_equal(new, label):
            break
        label = new
    of_face = label[faces[:, 0]]
    for one in np.unique(of_face):
        mine = faces[of_face == one]
        used, inverse = np.unique(mine, return_inverse=True)
        yield Solid(vertices[used], inverse.reshape(-1, 3).astype(np.int64))


def penetration_depth(a: Solid, b: Solid, least: float) -> float:
    """How deep two solids are in each other, metres; 0 if not by more than ``least``.

    Convex ones: the shortest move that parts them, the least overlap of their shadows on the
    normals of faces and, of prisms, the cross products of edges (Gottschalk et al. 1996). Others:
    the greatest depth of a point of either's surface below the other's.
    """
    if (np.minimum(a.high, b.high) - np.maximum(a.low, b.low) <= least).any():
        return 0.0
    found = _parting_move(a, b)
    if found > least and not (a.convex and b.convex):  # their hulls are in each other
        found = max(_deepest(a, b, least), _deepest(b, a, least))
    return found if found > least else 0.0


def _parting_move(a: Solid, b: Solid) -> float:
    axes = [a.normals, b.normals]
    if len(a.edges) <= FEW and len(b.edges) <= FEW:
        axes.append(_distinct(np.cross(a.edges[:, None], b.edges[None]).reshape(-1, 3)))
    middle = (b.low + b.high - a.low - a.high)[None]
    axes.append(middle / max(float(np.linalg.norm(middle)), 1e-9))
    tried = np.concatenate(axes)
    one, other = tried @ a.vertices.T, tried @ b.vertices.T
    overlap = np.minimum(one.max(1) - other.min(1), other.max(1) - one.min(1))
    return float(overlap.min())


def _deepest(a: Solid, b: Solid, least: float) -> float:
    """The greatest depth of points of the surface of ``a`` inside ``b``."""
    low, high = np.maximum(a.low, b.low), np.minimum(a.high, b.high)
    near = ((a.corners.min(1) <= high) & (a.corners.max(1) >= low)).all(1)
    points = _points_on(a.corners[near])
    points = points[((points > b.low + least) & (points < b.high - least)).all(1)]
    deepest = 0.0
    for some in np.array_split(points, max(len(points) * len(b.faces) // 400_000, 1)):
        inside = some[winding(some, b.corners) > 0.5]
        if len(inside):
            deepest = max(deepest, float(distance(inside, b.corners).max()))
    return deepest


def _points_on(corners: Floats) -> Floats:
    """Points of triangles, not more than :data:`STEP` apart."""
    sides = np.linalg.norm(corners - np.roll(corners, 1, 1), axis=2).max(1)
    found = [corners.reshape(-1, 3)]
    count = np.minimum(np.ceil(sides / STEP), 80).astype(int)
    for n in np.unique(count[count > 1]):
        i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
        share = np.stack([i, j, n - i - j], -1).reshape(-1, 3)
        share = share[share[:, 2] >= 0] / n
        found.append(np.einsum("kc,mcx->mkx", share, corners[count == n]).reshape(-1, 3))
    return np.unique(np.round(np.concatenate(found), 5), axis=0)


def winding(points: Floats, corners: Floats) -> Any:
    """Winding numbers (n,) of triangles (m, 3, 3) about points: the solid angles the triangles
    take up, over 4 π (Van Oosterom, Strackee 1983); 1 inside, 0 outside of a closed mesh."""
    a, b, c = (corners[None, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    volume = np.einsum("nmx,nmx->nm", a, np.cross(b, c))
    dot = np.einsum("nmx,nmx->nm", a, b) * lc + np.einsum("nmx,nmx->nm", b, c) * la
    dot += np.einsum("nmx,nmx->nm", c, a) * lb
    return 2 * np.arctan2(volume, la * lb * lc + dot).sum(1) / (4 * np.pi)


def distance(points: Floats, corners: Floats) -> Any:
    """Distance (n,) of points from the nearest of triangles (m, 3, 3) (Ericson 2004, 5.1.5)."""
    a, b, c = (corners[None, :, k] for k in range(3))
    p = points[:, None]
    near = [_from_edge(p, a, b), _from_edge(p, b, c), _from_edge(p, c, a)]
    normal = np.cross(b - a, c - a)
    length = np.maximum(np.linalg.norm(normal, axis=2, keepdims=True), 1e-15)
    unit = normal / length
    off = ((p - a) * unit).sum(2)
    foot = p - off[..., None] * unit
    within = np.ones(off.shape, bool)
    for start, end in ((a, b), (b, c), (c, a)):
        within &= (
            np.einsum("nmx,nmx->nm", np.cross(end - start, foot - start), unit + 0 * foot) >= 0
        )
    best = np.minimum(np.minimum(near[0], near[1]), near[2])
    return np.where(within, np.minimum(best, np.abs(off)), best).min(1)


def _from_edge(p: Floats, start: Floats, end: Floats) -> Any:
    along = end - start
    square = np.maximum((along**2).sum(2), 1e-18)
    share = np.clip(((p - start) * along).sum(2) / square, 0, 1)
    return np.linalg.norm(p - start - share[..., None] * along, axis=2)
