"""A model as a string of slabs: the storeys of a tower, the bays of a front; and grown by them.

Along an axis the heights at which faces begin and end cut a model into slabs. Two slabs are alike
if they are as thick and hold faces of the same outlines; each kind of slab is a symbol. So the
string of a tower is read off its mesh, and a longer string is a taller tower: what lies within a
slab is copied with it, what spans it is drawn out.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.mesh import Mesh

Floats = NDArray[np.float64]
SAME = 0.02
"""The share of the extent along the axis within which heights are one."""
GRAIN = 0.02
"""The share of the extent to which outlines are rounded when slabs are compared."""


class ModelSlabs(NamedTuple):
    """The cuts (n + 1,) of a model along an axis, and the symbol of each slab between them."""

    axis: int
    cuts: Floats
    symbols: tuple[str, ...]


def slabs_of(mesh: Mesh, axis: int = 2) -> ModelSlabs:
    """The slabs of a model along an axis (0, 1 or 2).

    >>> from scenewright.geometry.solids import block
    >>> from scenewright.geometry.mesh import merge
    >>> tower = [block((0, 8), (0, 6), (0, 9.0))]
    >>> tower += [block((3, 5), (-0.1, 0), (z + 1, z + 2.0)) for z in (0, 3, 6)]
    >>> slabs_of(merge(tower)).symbols
    ('a', 'b', 'c', 'b', 'c', 'b', 'a')
    """
    along = mesh.vertices[:, axis][mesh.faces]
    low, high = along.min(1), along.max(1)
    extent = float(np.ptp(mesh.vertices[:, axis])) if len(mesh.vertices) else 0.0
    cuts = _levels(np.concatenate([low, high]), SAME * extent / 4 + 1e-9)
    if len(cuts) < 2:
        return ModelSlabs(axis, cuts, ())
    known: dict[tuple[object, ...], str] = {}
    symbols = []
    for a, b in pairwise(cuts.tolist()):
        key = _signature(mesh, axis, (a, b), low, high, extent)
        symbols.append(known.setdefault(key, chr(97 + len(known) % 26) * (1 + len(known) // 26)))
    return ModelSlabs(axis, cuts, tuple(symbols))


def _levels(values: Floats, near: float) -> Floats:
    """Distinct values, those nearer than ``near`` as one."""
    found = np.sort(values)
    if not len(found):
        return found
    first = np.concatenate([[True], np.diff(found) > near])
    groups = np.cumsum(first) - 1
    return np.asarray(np.bincount(groups, found) / np.bincount(groups))


def _signature(
    mesh: Mesh, axis: int, span: tuple[float, float], low: Floats, high: Floats, extent: float
) -> tuple[object, ...]:
    """What a slab is known by: its thickness and the outlines of the faces that lie in it."""
    slack = SAME * extent / 2
    within = (low > span[0] - slack) & (high < span[1] + slack) & (high - low > slack)
    across = [k for k in range(3) if k != axis]
    grain = max(GRAIN * extent, 1e-9)
    corners = mesh.vertices[:, across][mesh.faces[within]]
    boxes = np.round(np.concatenate([corners.min(1), corners.max(1)], 1) / grain).astype(int)
    rows = sorted({tuple(row) for row in boxes.tolist()})
    return (round((span[1] - span[0]) / max(2 * slack, 1e-9)), tuple(rows))


def grow_slabs(mesh: Mesh, slabs: ModelSlabs, first: int, last: int, times: int) -> Mesh:
    """The model with the slabs from ``first`` up to ``last`` there ``times`` times instead of once.

    Faces within them are copied, those beyond moved on, those that span them drawn out.

    >>> from scenewright.geometry.solids import block
    >>> from scenewright.geometry.mesh import merge
    >>> tower = [block((0, 8), (0, 6), (0, 9.0))]
    >>> tower += [block((3, 5), (-0.1, 0), (z + 1, z + 2.0)) for z in (0, 3, 6)]
    >>> made = grow_slabs(merge(tower), slabs_of(merge(tower)), 2, 4, 3)
    >>> float(made.vertices[:, 2].max())
    15.0
    """
    axis = slabs.axis
    start, end = float(slabs.cuts[first]), float(slabs.cuts[last])
    thick, slack = end - start, 1e-6 + SAME * float(np.ptp(slabs.cuts)) / 4
    along = mesh.vertices[:, axis][mesh.faces]
    inside = (along.min(1) > start - slack) & (along.max(1) < end + slack)
    inside &= along.max(1) - along.min(1) > 0
    inside |= (along.min(1) > start + slack) & (along.max(1) < end - slack)
    moved = mesh.vertices.copy()
    moved[:, axis] += (times - 1) * thick * (mesh.vertices[:, axis] >= end - slack)
    vertices, faces = [moved], [mesh.faces[~inside]]
    count = len(moved)
    for k in range(times):
        copy = mesh.vertices.copy()
        copy[:, axis] += k * thick
        vertices.append(copy)
        faces.append(mesh.faces[inside] + count * (k + 1))
    return _keep_used(np.concatenate(vertices), np.concatenate(faces))


def _keep_used(vertices: Floats, faces: NDArray[np.int64]) -> Mesh:
    """Only the vertices that faces use."""
    used, inverse = np.unique(faces, return_inverse=True)
    return Mesh(vertices[used], inverse.reshape(-1, 3))


def repeated_part(symbols: Sequence[str]) -> tuple[int, int, int]:
    """The part of a string that repeats longest without a gap: its start, its end, and how often
    it stands there; (0, 0, 0) if nothing does.

    >>> repeated_part("abcbcba")
    (1, 3, 2)
    """
    best, found = 0, (0, 0, 0)
    for length in range(1, len(symbols) // 2 + 1):
        for start in range(len(symbols) - 2 * length + 1):
            times = 1
            while list(symbols[start : start + length]) == list(
                symbols[start + times * length : start + (times + 1) * length]
            ):
                times += 1
            if times > 1 and (times * length, -length) > (best, -(found[1] - found[0])):
                best, found = times * length, (start, start + length, times)
    return found
