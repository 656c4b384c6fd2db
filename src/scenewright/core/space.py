"""Spaces: what is to be filled. Outlines, holes and openings as plain immutable values.

Metres and radians; x, y in plan, z up. Outlines run counter-clockwise, holes clockwise, so the
inside is always on the left of a directed edge.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]
OpeningKind = Literal["door", "window", "passage"]
OpeningUse = Literal["both", "entrance", "exit"]


@dataclass(frozen=True, slots=True)
class Opening:
    """One hole in a wall: a door, a window or an open passage; shared by the spaces it joins.

    ``(x, y)`` is the middle of the opening on the middle line of the wall; ``(ux, uy)`` the unit
    direction along the wall. The *left* of that direction is ``(-uy, ux)``.
    ``hinge`` is where the leaf hangs along the direction: ``-1`` at the start, ``+1`` at the end,
    ``0`` no leaf (sliding door, passage, window). ``swing`` tells the side the leaf opens to:
    ``+1`` left, ``-1`` right, ``0`` not at all.
    ``spaces`` are the ids of the spaces it touches, one (outside beyond) or two. ``use`` tells
    which way visitors go through it, seen from the first of the spaces. A window in a slope has
    ``roof``: how far inwards of the wall's inner face its lower and upper edges lie. ``ajar`` is
    how far the leaf stands open, in radians, where the brief says so.
    """

    id: str
    kind: OpeningKind
    level: str
    x: float
    y: float
    ux: float
    uy: float
    width: float
    thickness: float
    sill: float
    head: float
    hinge: int = 0
    swing: int = 0
    spaces: tuple[str, ...] = ()
    use: OpeningUse = "both"
    roof: tuple[float, float] | None = None
    ajar: float | None = None


class Slope(NamedTuple):
    """A ceiling that rises inwards from edge ``edge`` of the outline, from ``knee`` metres, by an
    angle of ``pitch``; the flat ceiling ends it."""

    edge: int
    knee: float
    pitch: float


class Outlet(NamedTuple):
    """Where something is connected: its kind, the point of the wall it is at, the direction into
    the room, and whether it must be used."""

    id: str
    kind: str
    x: float
    y: float
    heading: float
    required: bool = False


class Radiator(NamedTuple):
    """A radiator at a wall: the middle of its footprint, the direction into the room, its size,
    and the height of its underside."""

    id: str
    x: float
    y: float
    heading: float
    width: float
    depth: float
    height: float
    z: float


class StairEnd(NamedTuple):
    """Where one steps on or off stairs: their id, ``foot`` or ``head``, the middle of the edge,
    the way one looks when stepping off, the width; ``arrival`` if people come to this level so."""

    stairs: str
    kind: str
    x: float
    y: float
    heading: float
    width: float
    arrival: bool


class StairPart(NamedTuple):
    """What stairs take of a floor: id and category of the piece that stands for it, its box
    (x, y, heading, width, depth) and its height; an open well as high as its railing."""

    id: str
    category: str
    box: tuple[float, ...]
    height: float


@dataclass(frozen=True, slots=True)
class Space:
    """A room, hall or site to fill: outline, holes, openings, what it is for.

    ``outline`` is ``(m, 2)`` counter-clockwise, each of ``holes`` ``(k, 2)`` clockwise: the inner
    faces of the walls. ``main_wall`` is the index of an outline edge (from vertex i to i + 1) or
    ``None``. ``functions`` are room functions such as ``living`` or ``bedroom``; an open-plan
    room has several. ``height`` is floor to ceiling, where no ``slopes`` are lower. ``openings``
    are those that touch the space, ``outlets`` and ``radiators`` those at its walls, ``stairs``
    the ends of stairs in it, ``stair_parts`` what they take of its floor.
    """

    id: str
    name: str
    functions: tuple[str, ...]
    level: str
    outline: Points
    holes: tuple[Points, ...] = ()
    height: float = 2.6
    openings: tuple[Opening, ...] = field(default=())
    main_wall: int | None = None
    slopes: tuple[Slope, ...] = ()
    outlets: tuple[Outlet, ...] = ()
    radiators: tuple[Radiator, ...] = ()
    stairs: tuple[StairEnd, ...] = ()
    stair_parts: tuple[StairPart, ...] = ()


@dataclass(frozen=True, slots=True)
class Level:
    """A storey: its id, name, elevation of the floor and height to the ceiling, in metres."""

    id: str
    name: str
    elevation: float
    height: float
