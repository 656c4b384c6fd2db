"""A surface as points with area and mean curvature, close enough together for any Gaussian.

Small faces hand what they hold to their corners. Large faces, as of buildings, get
points inside, a strip at a time, and sharp edges get points along them, so that it does not
matter how coarse the mesh is. Curvature of edges too blunt to be meant is spread over the faces.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.curvature import Bends, bends
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.mesh_edges import sum_by_name

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

BLUNT, SHARP = np.pi / 9, np.pi / 4.5
"""Edges that turn by less than the first are taken for a round surface cut into flats, those that
turn by more than the second for meant; in between, for a share of each."""
SMALL = 2.0
"""Faces and edges up to this many steps long hand what they hold to their corners."""
ALONG = 0.5
"""How far apart points on sharp edges are, in steps: they are few and hold much."""
ROUNDS = 40


class Samples(NamedTuple):
    """Points ``(k, 3)`` on a surface.

    ``area`` (k,) in square metres and ``bend`` (k,) in metres, the integral of mean curvature,
    add up to those of the surface. The first points are the mesh's vertices; ``face`` (k,) is the
    face a point lies inside, -1 for vertices and points on edges. ``step`` is how far apart
    points within a large face are, in metres.
    """

    points: Floats
    area: Floats
    bend: Floats
    face: Ints
    step: float


def sample_surface(mesh: Mesh, step: float, most: int = 60_000) -> Samples:
    """Points for a sound mesh, ``step`` apart at most, or more if ``most`` would not do.

    >>> square = Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
    ...               np.array([[0, 1, 2], [0, 2, 3]]))
    >>> found = sample_surface(square, 0.25)
    >>> len(found.points), round(float(found.area.sum()), 9), float(abs(found.bend).max())
    (22, 1.0, 0.0)
    """
    corners = mesh.vertices[mesh.faces]
    lengths = np.linalg.norm(np.roll(corners, -1, 1) - corners, axis=2)
    longest = lengths.max(1)
    area = 0.5 * np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    found = bends(mesh)
    for _ in range(ROUNDS):
        large = longest > SMALL * step
        if _estimate_count(area[large], longest[large], found, step) <= most:
            break
        step *= 1.25
    dense = _spread_bend(found, len(area)) / area
    inside = _inside(corners[large], lengths[large], area[large], step)
    number = np.flatnonzero(large)[inside[2]]
    edges = _along(mesh, found, step)
    small = ~large
    names = mesh.faces[small].reshape(-1)
    count = len(mesh.vertices)
    own_area = sum_by_name(names, np.repeat(area[small] / 3, 3), count)
    own_bend = sum_by_name(names, np.repeat((dense * area)[small] / 3, 3), count)
    return Samples(
        np.concatenate([mesh.vertices, inside[0], edges[0]]),
        np.concatenate([own_area, inside[1], np.zeros(len(edges[1]))]),
        np.concatenate([own_bend + edges[2], inside[1] * dense[number], edges[1]]),
        np.concatenate([np.full(count, -1), number, np.full(len(edges[1]), -1)]),
        step,
    )


def _estimate_count(area: Floats, longest: Floats, found: Bends, step: float) -> float:
    """About how many points the large faces and the sharp edges would get."""
    rows, columns = np.ceil(2 * area / longest / step), np.ceil(longest / step)
    long = found.length[np.abs(found.angle) > BLUNT] / (ALONG * step)
    return float((rows * (columns + 1.0) / 2.0).sum() + long[long > SMALL].sum())


def _sharpness(found: Bends) -> Floats:
    """Share (e,) of each edge's curvature that stays on the edge."""
    return np.clip((np.abs(found.angle) - BLUNT) / (SHARP - BLUNT), 0.0, 1.0)


def _spread_bend(found: Bends, faces: int) -> Floats:
    """What each face (m,) gets of its edges' curvature as far as they are blunt: half of each."""
    half = 0.5 * found.total() * (1.0 - _sharpness(found))
    one, other = found.seams.faces.T
    return sum_by_name(one, half, faces) + sum_by_name(other, half, faces)


def _inside(
    corners: Floats, lengths: Floats, area: Floats, step: float
) -> tuple[Floats, Floats, Ints]:
    """Points, their areas and the number of their triangle.

    Each triangle is cut into strips along its longest side, each strip into equal cells; a point
    is the middle of its cell, so that points and areas give the triangle's centroid exactly.
    """
    count = len(area)
    k = np.argmax(lengths, axis=1)
    every = np.arange(count)
    apex, start, end = (corners[every, (k + shift) % 3] for shift in (2, 0, 1))
    longest = lengths[every, k]
    rows = np.maximum(np.ceil(2 * area / longest / step), 1).astype(np.int64)
    face = np.repeat(every, rows)
    row = np.arange(len(face)) - np.repeat(np.cumsum(rows) - rows, rows)
    low, high = row / rows[face], (row + 1) / rows[face]
    columns = np.maximum(np.ceil(longest[face] * 0.5 * (low + high) / step), 1).astype(np.int64)
    strip = np.repeat(np.arange(len(face)), columns)
    column = np.arange(len(strip)) - np.repeat(np.cumsum(columns) - columns, columns)
    down = ((high**3 - low**3) / (high**2 - low**2) * (2 / 3))[strip, None]
    across = ((column + 0.5) / columns[strip])[:, None]
    face = face[strip]
    base = start[face] + across * (end[face] - start[face])
    share = ((high**2 - low**2) / columns)[strip]
    return apex[face] + down * (base - apex[face]), share * area[face], face


def _along(mesh: Mesh, found: Bends, step: float) -> tuple[Floats, Floats, Floats]:
    """Points on long sharp edges with the curvature they hold, and what short sharp edges hand
    to the vertices ``(n,)``."""
    total = found.total() * _sharpness(found)
    sharp = np.flatnonzero(total)
    bend = total[sharp]
    parts = np.ceil(found.length[sharp] / (ALONG * step)).astype(np.int64)
    few = found.length[sharp] <= SMALL * ALONG * step
    ends = found.seams.ends[sharp]
    handed = sum_by_name(ends[few].reshape(-1), np.repeat(0.5 * bend[few], 2), len(mesh.vertices))
    sharp, parts, bend, ends = sharp[~few], parts[~few], bend[~few], ends[~few]
    edge = np.repeat(np.arange(len(sharp)), parts)
    part = np.arange(len(edge)) - np.repeat(np.cumsum(parts) - parts, parts)
    share = ((part + 0.5) / parts[edge])[:, None]
    start, end = mesh.vertices[ends[edge, 0]], mesh.vertices[ends[edge, 1]]
    return start + share * (end - start), (bend / parts)[edge], handed
