"""The pieces and rooms as arrays of exact shapes, built once and shared by every test."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.core.space import Space

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.int64]
Shapes = Any  # an array of shapely geometries
Shape = Any  # one shapely geometry

TOLERANCE = 0.01
"""Metres of overlap, or beyond the room, that are tolerated."""

WALL_GAP = 0.05
"""Greatest gap between the back of a piece at a wall and the wall, in metres."""

PARTITION = "partition"
"""The category of walls that were laid out with the pieces."""

HEAD_HEIGHT = 2.0
"""Height of an underside, in metres, from which a piece is in nobody's way."""

_FLATTEST = 0.05
_CURTAINS = ("curtain", "blind")
_SEATS = ("chair", "stool", "bench", "pouf")
_LARGEST, _SMALLEST = 1e5, 1e-6
_UNSEEN = 1e-3


class Rooms(NamedTuple):
    """Spaces with their free area (outline minus holes) as polygons, and the level of each."""

    spaces: tuple[Space, ...]
    shapes: Shapes
    level: Indices
    levels: tuple[str, ...]


class Bodies(NamedTuple):
    """Pieces as arrays, row by row: kind, oriented footprint, corners (n, 4, 2) from back right
    counter-clockwise, underside and top above the level's floor, index of the room and of the
    level, and what their use allows: ``flat`` lies on the floor, ``seat`` may be pushed aside
    and under a table, ``soft`` gives way (curtains, leaves), ``known`` the catalog has its kind.
    ``into`` (k, 2) are rows that stand in one room and reach into another, and that other room."""

    pieces: tuple[Piece, ...]
    kinds: tuple[Kind, ...]
    footprints: Shapes
    corners: Floats
    low: Floats
    high: Floats
    room: Indices
    level: Indices
    flat: Flags
    seat: Flags
    soft: Flags
    known: Flags
    into: Indices

    @property
    def underfoot(self) -> Flags:
        """Which rows take up floor a person needs: neither flat, soft nor above head height."""
        return ~self.flat & ~self.soft & (self.low < HEAD_HEIGHT)


def rooms_of(spaces: tuple[Space, ...]) -> Rooms:
    """The rooms of spaces; an outline that crosses itself counts as what it encloses."""
    levels = tuple(dict.fromkeys(space.level for space in spaces))
    number = {level: i for i, level in enumerate(levels)}
    shapes = np.empty(len(spaces), object)
    shapes[:] = [_free_area(space) for space in spaces]
    return Rooms(spaces, shapes, np.array([number[s.level] for s in spaces], np.int64), levels)


def _free_area(space: Space) -> Shape:
    free = shapely.Polygon(space.outline, [hole for hole in space.holes if len(hole) > 2])
    return free if free.is_valid else free.buffer(0)


def bodies_of(
    pieces: tuple[Piece, ...], rooms: Rooms, catalog: Catalog
) -> tuple[Bodies, list[Finding]]:
    """The sound pieces as bodies, and a finding for every piece that is not."""
    number = {space.id: i for i, space in enumerate(rooms.spaces)}
    faults = [(piece, _fault(piece, number)) for piece in pieces]
    findings = [
        Finding("malformed", "", p.space, p.id, "", f"{p.id or 'a piece'} {fault}", given=p.fixed)
        for p, fault in faults
        if fault
    ]
    sound = tuple(piece for piece, fault in faults if not fault)
    return _stack(sound, rooms, catalog, number), findings


def _fault(piece: Piece, number: dict[str, int]) -> str:
    values = np.array([*piece.pose, *piece.size], float)
    if not np.isfinite(values).all() or np.abs(values).max() > _LARGEST:
        return "has a pose or size that is not a number of metres"
    if (values[4:] < _SMALLEST).any():
        return f"has no size: {values[4]:g} x {values[5]:g} x {values[6]:g} m"
    return "" if piece.space in number else f"stands in {piece.space!r}, which is not a room"


def _stack(
    pieces: tuple[Piece, ...], rooms: Rooms, catalog: Catalog, number: dict[str, int]
) -> Bodies:
    rows = np.array([[*p.pose, *p.size] for p in pieces], float).reshape(-1, 7)
    kinds = tuple(catalog.kinds.get(p.category) or Kind(p.category) for p in pieces)
    corners = _corners(rows)
    footprints = footprints_of(pieces, corners)
    room = np.array([number[p.space] for p in pieces], np.int64)
    flat = np.array([k.flat for k in kinds], bool) & (rows[:, 6] <= _FLATTEST)
    return Bodies(
        pieces,
        kinds,
        footprints,
        corners,
        rows[:, 2],
        rows[:, 2] + rows[:, 6],
        room,
        rooms.level[room],
        flat,
        np.array([bool(k.under) and _matches_any(k.category, _SEATS) for k in kinds], bool),
        np.array([k.swings or _matches_any(k.category, _CURTAINS) for k in kinds], bool),
        np.array([p.category in catalog.kinds for p in pieces], bool),
        _reaching(footprints, room, rooms),
    )


def footprints_of(pieces: Sequence[Piece], corners: Floats) -> Shapes:
    """Footprints of pieces: the stated polygon, else the box by ``corners`` (n, 4, 2)."""
    found = shapely.polygons(corners) if len(pieces) else np.empty(0, object)
    for row in (k for k, piece in enumerate(pieces) if piece.footprint):
        back_right, front_right, _, back_left = corners[row]
        size, local = pieces[row].size, np.array(pieces[row].footprint, float)
        right = (back_right - back_left) / size.width
        ahead = (front_right - back_right) / size.depth
        middle = corners[row].mean(0)
        shape = shapely.Polygon(middle + local[:, :1] * right + local[:, 1:] * ahead)
        found[row] = shape if shape.is_valid else found[row]
    return found


def _reaching(footprints: Shapes, room: Indices, rooms: Rooms) -> Indices:
    """Rows that cover more than :data:`_UNSEEN` of another room of their level, and that room."""
    row, other = shapely.STRtree(rooms.shapes).query(footprints, predicate="intersects")
    keep = (room[row] != other) & (rooms.level[room[row]] == rooms.level[other])
    row, other = row[keep], other[keep]
    shared = shapely.area(shapely.intersection(footprints[row], rooms.shapes[other]))
    return np.stack([row, other], -1)[shared > _UNSEEN]


def standing_in(bodies: Bodies, rooms: Indices) -> Flags:
    """Which rows stand in some rooms, or in another and reach into one of them."""
    found = np.isin(bodies.room, rooms)
    found[bodies.into[np.isin(bodies.into[:, 1], rooms), 0]] = True
    return found


def _corners(rows: Floats) -> Floats:
    x, y, heading, width, depth = rows[:, 0], rows[:, 1], rows[:, 3], rows[:, 4], rows[:, 5]
    front = np.stack([np.cos(heading), np.sin(heading)], -1) * depth[:, None] / 2
    right = np.stack([np.sin(heading), -np.cos(heading)], -1) * width[:, None] / 2
    centre = np.stack([x, y], -1)
    signs = ((1, -1), (1, 1), (-1, 1), (-1, -1))
    return np.stack([centre + r * right + f * front for r, f in signs], 1)


def _matches_any(category: str, words: tuple[str, ...]) -> bool:
    return any(word in category for word in words)


class Members(NamedTuple):
    """A group: its id, the number of its zone (-1: none such) and the rows of its objects."""

    id: str
    zone: int
    rows: Indices
