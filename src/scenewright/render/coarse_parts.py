"""Coarser forms of a model, and what of it one runs into: for engines that draw from afar.

Models are made of bodies (walls, slopes, panes, crowns), each a closed mesh of its own. A coarser
form leaves out the thin and the small ones, of plates shows the outer face and draws round ones
with fewer faces, so that of a house its box and roof are left, of a tree a stem and lumps.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.finishes import UNKNOWN
from scenewright.catalog.models.decimation import decimate
from scenewright.catalog.models.model import compact_part
from scenewright.core.catalog import Material, Part
from scenewright.geometry.mesh import Mesh, merge
from scenewright.geometry.prisms import box, face_normals
from scenewright.render.textures.projection import boards_of

Floats = NDArray[np.float64]


class Coarseness(NamedTuple):
    """What a form leaves out: bodies whose second longest side is under ``thin`` metres and those
    whose box is under a ``share`` of the model's, but for posts as long as half of it. A body has
    at most ``most`` faces, or ``kept`` of those it had. The form is drawn where the model covers
    less than ``below`` of the screen."""

    thin: float
    share: float
    most: int
    kept: float
    below: float


LEVELS = (Coarseness(0.25, 0.0, 36, 0.1, 0.06), Coarseness(0.25, 0.01, 16, 0.0, 0.008))
"""From near to far; the model as it is comes before them."""
GONE = 0.0002
"""The share of the screen below which a thing need not be drawn at all."""
FEWER = 0.8
"""A form is worth having with at most this share of the triangles of the one before."""
CLOSED = 4
"""Faces a body has at least: a model whose corners are not joined is one body."""
LONG = 0.5
"""The share of the height of a model from which a body is a post."""
UPRIGHT = 0.9
"""The cosine of the angle within which a face looks along an axis."""
STEM, FOOT = 0.002, 0.3
"""The share of a model's box from which a body counts, be it ever so thin, and metres above the
ground up to which one begins that stands on it."""


class Bodies(NamedTuple):
    """The bodies of a model (n,) as parts, and the lowest and highest corners (n, 3) of their boxes
    in metres."""

    low: Floats
    high: Floats
    parts: tuple[Part, ...]


def list_coarser(parts: Sequence[Part]) -> list[tuple[Coarseness, tuple[Part, ...]]]:
    """The forms of a model from near to far, each with markedly fewer triangles than the one
    before; none of what is plain already.

    >>> from scenewright.core.catalog import Material
    >>> walls = Part(Material("render", (1, 1, 1)), *box((0, 0, 0), (9, 8, 6)))
    >>> bar = Part(Material("oak", (1, 1, 1)), *box((1, -0.1, 1), (1.1, 0, 2)))
    >>> [[len(part.faces) for part in form] for _, form in list_coarser([walls, bar])]
    [[12]]
    """
    found: list[tuple[Coarseness, tuple[Part, ...]]] = []
    faces, bodies = count_faces(parts), split_into_bodies(parts)
    for level in LEVELS if faces else ():
        form = tuple(_coarsen(bodies, level))
        if form and count_faces(form) <= FEWER * faces:
            found.append((level, form))
            faces = count_faces(form)
    return found


def obstacle_of(parts: Sequence[Part]) -> tuple[Part, ...]:
    """The boxes about the bodies of a model that stand on the ground: of a tree its stem, not its
    crown; none of what hangs."""
    bodies = split_into_bodies(parts)
    if not bodies.parts:
        return ()
    stands = (bodies.low[:, 2] < FOOT) & (_shares(bodies) >= STEM)
    rows = [box(bodies.low[k].tolist(), bodies.high[k].tolist()) for k in np.flatnonzero(stands)]
    if not rows:
        return ()
    joined = merge(rows)
    return (Part(UNKNOWN, joined.vertices, joined.faces),)


def count_faces(parts: Sequence[Part]) -> int:
    """The triangles of some parts."""
    return sum(len(part.faces) for part in parts)


def split_into_bodies(parts: Sequence[Part]) -> Bodies:
    """The bodies of some parts: faces that share corners are one."""
    rows = [one for part in parts if len(part.faces) for one in _bodies_of(part)]
    low = np.array([row.vertices.min(0) for row in rows]).reshape(-1, 3)
    high = np.array([row.vertices.max(0) for row in rows]).reshape(-1, 3)
    return Bodies(low, high, tuple(rows))


def _bodies_of(part: Part) -> Iterator[Part]:
    number = boards_of(part.faces, len(part.vertices))[part.faces[:, 0]]
    names, number = np.unique(number, return_inverse=True)
    if CLOSED * len(names) > len(part.faces):
        yield compact_part(part)
        return
    for k in range(len(names)):
        yield compact_part(Part(part.material, part.vertices, part.faces[number == k]))


def _coarsen(bodies: Bodies, level: Coarseness) -> Iterator[Part]:
    """The bodies that are left at a level, those of a material as one part. The largest stays,
    however thin."""
    sides, size = np.sort(bodies.high - bodies.low, axis=1), _shares(bodies)
    high = bodies.high[:, 2] - bodies.low[:, 2]
    post = (high >= LONG * (bodies.high[:, 2].max() - bodies.low[:, 2].min())) & (size >= STEM)
    left = post | ((sides[:, 1] >= level.thin) & (size >= level.share))
    left[int(np.argmax(size))] = True
    kept: dict[Material, list[Part]] = {}
    for k in np.flatnonzero(left).tolist():
        plate = sides[k, 0] < level.thin <= sides[k, 1]
        body = _outer_face(bodies, k) if plate else bodies.parts[k]
        thin = decimate(body, max(level.most, int(level.kept * len(body.faces))))
        kept.setdefault(body.material, []).append(thin)
    for rows in kept.values():
        joined = merge([Mesh(row.vertices, row.faces) for row in rows])
        yield Part(rows[0].material, joined.vertices, joined.faces)


def _shares(bodies: Bodies) -> Floats:
    """The boxes (n,) about bodies as shares of that about all."""
    whole = np.maximum(bodies.high.max(0) - bodies.low.min(0), 1e-6)
    return np.asarray(np.prod((bodies.high - bodies.low) / whole, axis=1))


def _outer_face(bodies: Bodies, number: int) -> Part:
    """The faces of a plate (a pane, a door) that look away from the middle of the model, or all of
    them where the plate lies askew."""
    body, low, high = bodies.parts[number], bodies.low[number], bodies.high[number]
    axis = int(np.argmin(high - low))
    middle = (bodies.low.min(0) + bodies.high.max(0))[axis]
    ahead = 1.0 if low[axis] + high[axis] >= middle else -1.0
    outer = ahead * face_normals(body.vertices, body.faces)[:, axis] > UPRIGHT
    return compact_part(replace(body, faces=body.faces[outer])) if outer.any() else body
