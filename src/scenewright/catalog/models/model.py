"""A model as read from a file: triangles in the project's frame, its size, and who made it.

Files have their own axes and units; :func:`set_up` turns what a file holds (:class:`RawModel`) into
the local frame of :mod:`scenewright.core.scene`: z up, front to +y, origin in the middle of the
footprint on the underside.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Material, Part
from scenewright.core.errors import InputError
from scenewright.core.scene import Size

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_FACES = 2_000_000
MOST_VERTICES = 3_000_000
FARTHEST = 1e9
"""Greatest coordinate of a file."""
LARGEST = 1e5
"""Greatest side of a model in metres."""
FLATTEST = 1e-5
"""Least side of a model, as a share of its greatest."""
LONGEST = 80
"""Characters of a name that are kept."""

PLAIN = Material("plain", (0.68, 0.67, 0.65))
"""What has no colour of its own."""

DIRECTIONS = {
    "+x": (1.0, 0.0, 0.0),
    "-x": (-1.0, 0.0, 0.0),
    "+y": (0.0, 1.0, 0.0),
    "-y": (0.0, -1.0, 0.0),
    "+z": (0.0, 0.0, 1.0),
    "-z": (0.0, 0.0, -1.0),
}


class ImportOptions(NamedTuple):
    """How to take models: which way of the file's axes is ``up`` and which the ``front`` looks
    (``+x`` to ``-z``; empty: as is usual for the format), metres a unit (``scale``), and the
    ``language`` of names (``de``, ``zh_CN``) where a library has several; ``buildings``: every
    building of a scene (.glb) is a model."""

    up: str = ""
    front: str = ""
    scale: float = 1.0
    language: str = ""
    buildings: bool = False


class RawModel(NamedTuple):
    """One model in the axes and units of its file; ``size`` (metres) if the file tells it."""

    id: str
    name: str
    parts: tuple[Part, ...]
    up: str
    front: str
    author: str = ""
    licence: str = ""
    category: str = ""
    size: Size | None = None
    elevation: float = 0.0
    tags: tuple[str, ...] = ()
    opening: bool = False


class SkippedModel(NamedTuple):
    """A model that could not be used, and why, in one line."""

    name: str
    reason: str


class Model(NamedTuple):
    """A model in the local frame; ``parts`` fill its ``size`` exactly.

    ``id`` is the stem of the file, followed by ``/`` and a name where a file holds several;
    ``category``, ``elevation`` (metres above the floor), ``tags`` (further words) and ``opening``
    (a door or window) are what the file says, if anything; ``sized`` if it tells the size.
    """

    id: str
    name: str
    parts: tuple[Part, ...]
    size: Size
    author: str
    licence: str
    source: str
    category: str = ""
    elevation: float = 0.0
    tags: tuple[str, ...] = ()
    opening: bool = False
    sized: bool = False


def set_up(found: RawModel, source: str, options: ImportOptions) -> Model:
    """The model in the local frame, in metres; InputError if it has no body.

    >>> corners = np.array([[0.0, 0, 0], [2, 0, 0], [0, 4, 0], [0, 0, 1]])
    >>> faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    >>> read = RawModel("kit", "kit", (Part(PLAIN, corners, faces),), "+y", "+z")
    >>> set_up(read, "kit.obj", ImportOptions()).size
    Size(width=2.0, depth=1.0, height=4.0)
    """
    axes = frame(options.up or found.up, options.front or found.front)
    parts = [compact_part(part) for part in found.parts if len(part.faces)]
    if not parts:
        raise InputError("holds no triangles", "give a model with surfaces")
    turned = [part.vertices @ axes.T * options.scale for part in parts]
    points = np.concatenate(turned)
    low, high = points.min(0), points.max(0)
    sides = high - low
    _check_sides(sides)
    size = np.array(found.size) if found.size else sides
    middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    scaled = [(own - middle) * (size / sides) for own in turned]
    made = tuple(
        Part(part.material, own, part.faces) for part, own in zip(parts, scaled, strict=True)
    )
    return Model(
        found.id,
        found.name,
        made,
        Size(*size.tolist()),
        found.author,
        found.licence,
        source,
        found.category,
        found.elevation,
        found.tags,
        found.opening,
        found.size is not None,
    )


def frame(up: str, front: str) -> Floats:
    """Rows are the file's directions that become our x, y and z.

    >>> frame("+y", "+z").tolist()
    [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]
    """
    for word in (up, front):
        if word not in DIRECTIONS:
            raise InputError(
                f"'{word}' is not a direction of a file's axes",
                f"use one of: {', '.join(DIRECTIONS)}",
            )
    if up[1] == front[1]:
        raise InputError(f"the front cannot be {front} where up is {up}", "choose another axis")
    above, ahead = np.array(DIRECTIONS[up]), np.array(DIRECTIONS[front])
    return np.stack([np.cross(ahead, above), ahead, above]) + 0.0


def part_of(material: Material, vertices: Floats, faces: Ints) -> Part:
    """A part of checked numbers: finite places, faces whose corners are there.

    ``vertices`` (n, 3) in metres, ``faces`` (m, 3).
    """
    vertices = np.asarray(vertices, np.float64).reshape(-1, 3)
    faces = np.asarray(faces, np.int64).reshape(-1, 3)
    if len(faces) and (faces.min() < 0 or faces.max() >= len(vertices)):
        raise InputError("a face has a corner that is not there", "export the model again")
    if not np.all(np.abs(vertices[faces]) <= FARTHEST):  # also false for what is not a number
        raise InputError("a corner is not at a finite place", "export the model again")
    return Part(material, vertices, faces)


def check_count(count: int, most: int, what: str) -> None:
    """Raise unless ``count`` things are few enough to be held."""
    if count > most:
        raise InputError(f"has more than {most:,} {what}", "simplify the model")


def clean(text: object, otherwise: str = "") -> str:
    """A name of printable characters in one line, cut to :data:`LONGEST`.

    >>> clean(" two\\nlines\\x1b[31m "), clean(3, "unnamed")
    ('two lines[31m', 'unnamed')
    """
    if not isinstance(text, str):
        return otherwise
    words = " ".join(text[: 8 * LONGEST].split())
    return "".join(c for c in words if c.isprintable())[:LONGEST] or otherwise


def merge_parts(parts: Sequence[Part]) -> tuple[Part, ...]:
    """One part a material, in the order in which the materials first appear."""
    by_material: dict[Material, list[Part]] = {}
    for part in parts:
        if len(part.faces):
            by_material.setdefault(part.material, []).append(part)
    return tuple(_join_parts(material, own) for material, own in by_material.items())


def _join_parts(material: Material, parts: Sequence[Part]) -> Part:
    starts = np.cumsum([0, *(len(part.vertices) for part in parts)])
    faces = [part.faces + start for part, start in zip(parts, starts, strict=False)]
    return Part(material, np.concatenate([p.vertices for p in parts]), np.concatenate(faces))


def compact_part(part: Part) -> Part:
    """Without vertices that no face has."""
    used, faces = np.unique(part.faces, return_inverse=True)
    return Part(part.material, part.vertices[used], faces.reshape(-1, 3).astype(np.int64))


def _check_sides(sides: Floats) -> None:
    greatest = float(sides.max())
    if not 0.0 < greatest <= LARGEST:
        raise InputError(
            f"is {greatest:.3g} m large" if greatest else "is a single point",
            f"models are up to {LARGEST:,.0f} m: give another scale",
        )
    for side, what in zip(sides.tolist(), ("width", "depth", "height"), strict=True):
        if not side > FLATTEST * greatest or not math.isfinite(side):
            raise InputError(f"is flat: it has no {what}", "give a model with a body")
