"""From the triangles of a part to convex solids: boxes, cylinders and hulls, as physics needs them.

A part is many meshes side by side. Each that hangs together is a solid of its own: a box or a
cylinder where it is one, else its convex hull; one with a hollow is cut in halves, along the axis
that leaves the shallowest hollows, until these are shallow. One hull for a whole table would
swallow the chairs under it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, NamedTuple

import numpy as np

from scenewright.core.catalog import Part
from scenewright.geometry.mesh import Floats, Ints

HOLLOW = 0.02
"""How deep a hollow may be that a hull fills, metres."""
DEEPEST = 3
"""How often a solid is cut in halves."""
THIN = 0.0004
"""Least thickness of what can be touched, metres: slivers make a model that does not load."""
ROUND = 8
"""Corners of a circle from which on it is taken for one."""


class ConvexSolid(NamedTuple):
    """A solid that can be touched: of a box half its sides, of a cylinder radius, half its length
    and 0, and the ``axes`` (3, 3) in rows they are along; of a hull its corners (k, 3) about the
    ``middle``; and the ``volume`` and ``area`` of the mesh it is of, as a share."""

    form: Literal["box", "cylinder", "hull"]
    middle: Floats
    axes: Floats
    sides: tuple[float, float, float]
    corners: Floats
    volume: float
    area: float


def solids_of(part: Part, hollow: float = HOLLOW) -> tuple[ConvexSolid, ...]:
    """The convex solids of a part; hulls fill hollows no deeper than ``hollow`` metres."""
    return tuple(
        solid for vertices, faces in _components(part) for solid in _solid(vertices, faces, hollow)
    )


def column_of(ring: Floats, low: float, high: float) -> ConvexSolid | None:
    """The solid over a convex polygon (k, 2) between two heights; none where it is a sliver.

    >>> column_of(np.array([(0.0, 0), (2, 0), (2, 1), (0, 1)]), 0.0, 3.0).form
    'box'
    """
    if _cross(ring, np.roll(ring, -1, axis=0)).sum() < 0:
        ring = ring[::-1]
    edges = np.roll(ring, -1, axis=0) - ring
    bent = _cross(np.roll(edges, 1, axis=0), edges) > 1e-9
    ring = ring[bent]
    edges = np.roll(ring, -1, axis=0) - ring
    lengths = np.linalg.norm(edges, axis=1)
    flat = float(_cross(ring, np.roll(ring, -1, axis=0)).sum() / 2)
    if len(ring) < 3 or 2 * flat < THIN * lengths.max() or high - low < THIN:
        return None
    volume, area = flat * (high - low), 2 * flat + float(lengths.sum()) * (high - low)
    middle = np.array([*(ring.min(0) + ring.max(0)) / 2, (low + high) / 2])
    x, y = edges[0] / lengths[0]
    if len(ring) == 4 and np.abs(np.abs(edges @ (x, y)) - (lengths * (1, 0, 1, 0))).max() < 1e-6:
        axes = np.array([(x, y, 0.0), (-y, x, 0.0), (0.0, 0.0, 1.0)])
        sides = np.array([*lengths[:2], high - low]) / 2
        found = _placed("box", middle, axes, sides)
        return found._replace(volume=volume, area=area)
    corners = np.array([(*corner, z) for z in (low, high) for corner in ring]) - middle
    return ConvexSolid("hull", middle, np.eye(3), (0.0, 0.0, 0.0), corners, volume, area)


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def _components(part: Part) -> Iterator[tuple[Floats, Ints]]:
    """The meshes of a part that hang together by their corners, without faces that have no area."""
    corners = part.vertices[part.faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    faces = part.faces[np.linalg.norm(across, axis=1) > 1e-12]
    label = np.arange(len(part.vertices))
    while len(faces):
        least = label[faces].min(1)
        before = label.copy()
        np.minimum.at(label, faces, least[:, None])
        label = label[label]
        if (label == before).all():
            break
    owner = label[faces[:, 0]]
    order = np.argsort(owner, kind="stable")
    ends = np.flatnonzero(np.diff(owner[order])) + 1
    for rows in np.split(order, ends):
        if len(rows):
            used, own = np.unique(faces[rows], return_inverse=True)
            yield part.vertices[used], own.reshape(-1, 3)


def _solid(vertices: Floats, faces: Ints, hollow: float) -> Iterator[ConvexSolid]:
    corners = vertices[faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = float(np.linalg.norm(across, axis=1).sum() / 2)
    centre = vertices.mean(0)
    volume = abs(float(np.einsum("ij,ij->", corners[:, 0] - centre, across) / 6))
    normals = across / np.linalg.norm(across, axis=1, keepdims=True)
    found = _box(vertices, normals) or _cylinder(vertices, normals)
    if found is not None:
        yield found._replace(volume=volume, area=area)
        return
    pieces = [p for p in _convex(_faces(corners, normals), hollow, DEEPEST) if _is_thick(p)]
    for piece in pieces:
        share = 1 / len(pieces)
        middle = (piece.min(0) + piece.max(0)) / 2
        yield ConvexSolid(
            "hull", middle, np.eye(3), (0.0, 0.0, 0.0), piece - middle, volume * share, area * share
        )


def _is_thick(points: Floats) -> bool:
    """Whether points span a solid: their spread across the plane they lie nearest to."""
    if len(points) < 4:
        return False
    local = points - points.mean(0)
    _, _, axes = np.linalg.svd(local, full_matrices=False)
    return bool(np.ptp(local @ axes.T, axis=0).min() > THIN)


def _frame(normals: Floats) -> Floats | None:
    """Three axes at right angles, of the directions faces look in; none where they look
    elsewhere."""
    first = normals[0]
    across = np.flatnonzero(np.abs(normals @ first) < 1e-4)
    if not len(across):
        return None
    second = normals[across[0]] - (normals[across[0]] @ first) * first
    second /= np.linalg.norm(second)
    axes = np.array([first, second, np.cross(first, second)])
    along = np.abs(normals @ axes.T).max(1)
    return axes if bool((along > 1 - 1e-6).all()) else None


def _box(vertices: Floats, normals: Floats) -> ConvexSolid | None:
    axes = _frame(normals)
    if axes is None:
        return None
    local = vertices @ axes.T
    low, high = local.min(0), local.max(0)
    at_ends = np.minimum(local - low, high - local) < 1e-6
    if not at_ends.all() or (high - low).min() < THIN:
        return None
    return _placed("box", (low + high) / 2 @ axes, axes, (high - low) / 2)


def _placed(
    form: Literal["box", "cylinder"], middle: Floats, axes: Floats, sides: Floats
) -> ConvexSolid:
    a, b, c = (float(side) for side in sides)
    return ConvexSolid(form, middle, axes, (a, b, c), np.zeros((0, 3)), 0.0, 0.0)


def _cylinder(vertices: Floats, normals: Floats) -> ConvexSolid | None:
    """A prism over a regular polygon of many corners: the two rings of a cylinder."""
    if len(vertices) < 2 * ROUND:
        return None
    for axis in (normals[0], normals[-1]):
        along = vertices @ axis
        low, high = along.min(), along.max()
        if high - low < THIN or (np.minimum(along - low, high - along) > 1e-6).any():
            continue
        flat = vertices - np.outer(along, axis)
        middle = flat.mean(0)
        radii = np.linalg.norm(flat - middle, axis=1)
        if np.ptp(radii) < 0.01 * radii.max() and radii.min() > THIN:
            side = (flat[0] - middle) / radii[0]
            axes = np.array([side, np.cross(axis, side), axis])
            x, y, _ = axes @ (flat - middle).T
            if _goes_round(np.arctan2(y, x)):
                sides = np.array([radii.mean(), (high - low) / 2, 0.0])
                return _placed("cylinder", middle + (low + high) / 2 * axis, axes, sides)
    return None


def _goes_round(angles: Floats) -> bool:
    """Whether directions go round without a gap: the corners of a rounded square do not."""
    ordered = np.sort(angles)
    gaps = np.diff(ordered, append=ordered[0] + 2 * np.pi)
    return bool(gaps.max() < 2 * np.pi / ROUND + 1e-6)


class _Faces(NamedTuple):
    """Faces as their edges (n, 2, 3) with the number of the face each is of (n,); the planes of all
    by number: ``normals`` (m, 3) and ``offsets`` (m,)."""

    edges: Floats
    owner: Ints
    normals: Floats
    offsets: Floats


def _faces(corners: Floats, normals: Floats) -> _Faces:
    edges = np.stack([corners, np.roll(corners, -1, axis=1)], 2).reshape(-1, 2, 3)
    offsets = np.einsum("ij,ij->i", corners[:, 0], normals)
    return _Faces(edges, np.repeat(np.arange(len(corners)), 3), normals, offsets)


def _points(faces: _Faces) -> Floats:
    return np.unique(faces.edges.reshape(-1, 3).round(7), axis=0)


def _depth(faces: _Faces) -> float:
    """How deep the hollows are: how far corners stand before the planes of faces."""
    if not len(faces.edges):
        return 0.0
    own = np.unique(faces.owner)
    ahead = faces.edges[:, 0] @ faces.normals[own].T - faces.offsets[own]
    return float(ahead.max())


def _convex(faces: _Faces, hollow: float, left: int) -> Iterator[Floats]:
    """The corners of the convex pieces of a solid."""
    if not left or _depth(faces) <= hollow:
        yield _points(faces)
        return
    low, high = faces.edges.min((0, 1)), faces.edges.max((0, 1))
    best, halves = np.inf, list[_Faces]()
    for axis in np.flatnonzero(high - low > 4 * HOLLOW).tolist():
        at = (low[axis] + high[axis]) / 2
        both = [_clip(faces, axis, at, sign) for sign in (-1.0, 1.0)]
        worst = sum(_depth(half) for half in both)
        if worst < best - 1e-9:
            best, halves = worst, both
    if not halves:
        yield _points(faces)
    for half in halves:
        if len(half.edges):
            yield from _convex(half, hollow, left - 1)


def _clip(faces: _Faces, axis: int, at: float, sign: float) -> _Faces:
    """What of faces lies on one side of a plane across an axis, with the edges the plane cuts."""
    away = sign * (faces.edges[:, :, axis] - at)
    inside = away >= 0
    whole, cut = inside.all(1), inside[:, 0] != inside[:, 1]
    share = away[cut, 0] / (away[cut, 0] - away[cut, 1])
    start, end = faces.edges[cut, 0], faces.edges[cut, 1]
    on = start + share[:, None] * (end - start)
    kept = np.where(inside[cut, :1], start, end)
    owner = faces.owner[cut]
    order = np.argsort(owner, kind="stable")
    ids, first, count = np.unique(owner[order], return_index=True, return_counts=True)
    pairs = first[count == 2]
    new = np.stack([on[order][pairs], on[order][pairs + 1]], 1)
    edges = np.concatenate([faces.edges[whole], np.stack([kept, on], 1), new])
    owners = np.concatenate([faces.owner[whole], owner, ids[count == 2]])
    return faces._replace(edges=edges, owner=owners)
