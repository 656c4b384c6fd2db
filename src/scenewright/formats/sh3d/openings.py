"""Doors and windows of a Sweet Home 3D level, put on the walls of its rooms."""

from __future__ import annotations

import math
import re
from typing import Literal, NamedTuple

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from scenewright.building.outlines import edges, project, rings, run_lengths, wall_runs
from scenewright.core.brief import Door, Window
from scenewright.core.space import Points
from scenewright.formats.sh3d.floors import grow_shape
from scenewright.formats.sh3d.xml import HomePiece, Sash

PARALLEL = 0.9
FARTHEST = 0.3
LEAST_DOOR = 0.5
LEAST_WINDOW = 0.15
TOUCHING = 0.03
LEAST_SIDE = 0.6
DOOR_SILL = 0.3
DOOR_HEIGHT = 1.6

Swing = Literal["in", "out", "slide", "none"]


class OpeningSpot(NamedTuple):
    """Where an opening may go: the room's number, its middle on the outline, the direction along
    (inside on the left), the width that fits and how far its wall is from the piece."""

    room: int
    at: tuple[float, float]
    along: tuple[float, float]
    width: float
    away: float


class PlacedOpening(NamedTuple):
    """A door or window of the brief, with the room it is listed in and the number of its piece."""

    room: int
    opening: Door | Window
    piece: int = -1


class Openings(NamedTuple):
    """Doors and windows ``placed``, and the numbers of the pieces that are in the place of another
    and of those that lie in no wall of a room."""

    placed: list[PlacedOpening]
    doubled: frozenset[int]
    elsewhere: frozenset[int]


def place_openings(pieces: list[HomePiece], outlines: list[Points]) -> Openings:
    """Every piece on the nearest wall along it, narrowed to fit; what finds none is left out.

    Of pieces at the same place (a frame and the door in it) the one with leaves is taken.
    """
    runs = [(number, run) for number, outline in enumerate(outlines) for run in wall_runs(outline)]
    tree = shapely.STRtree([shapely.LineString(run) for _, run in runs])
    found: list[PlacedOpening] = []
    taken: list[HomePiece] = []
    doubled, elsewhere = set[int](), set[int]()
    reaches = np.zeros((len(pieces), 3))
    for piece in sorted(pieces, key=lambda piece: -len(piece.sashes)):
        reach = piece.width + piece.depth
        spot = _spot(piece, [runs[k] for k in _walls_near(piece, tree)])
        close = reaches[: len(taken)] - [piece.x, piece.y, 0.0]
        beside = np.flatnonzero(np.hypot(close[:, 0], close[:, 1]) < close[:, 2] + reach + 1.0)
        if spot is None or any(_collide(piece, taken[k]) for k in beside.tolist()):
            (elsewhere if spot is None else doubled).add(piece.number)
            continue
        opening = _door(piece, spot) if is_door(piece) else _window(piece, spot)
        found.append(PlacedOpening(spot.room, opening, piece.number))
        reaches[len(taken)] = piece.x, piece.y, reach
        taken.append(piece)
    return Openings(found, frozenset(doubled), frozenset(elsewhere))


def _walls_near(piece: HomePiece, tree: shapely.STRtree) -> list[int]:
    """The walls a piece can be in, in their order."""
    at = shapely.Point(piece.x, piece.y)
    near = tree.query(at, predicate="dwithin", distance=piece.depth / 2 + FARTHEST + 1e-6)
    return sorted(near.tolist())


def open_sides(
    floors: list[shapely.Polygon], placed: list[PlacedOpening], height: float
) -> list[PlacedOpening]:
    """Open passages where two rooms are drawn side by side without a wall between them."""
    found = []
    tree = shapely.STRtree(floors)
    for number, floor in enumerate(floors):
        near = np.sort(tree.query(floor, predicate="dwithin", distance=TOUCHING)).tolist()
        for other in (floors[k] for k in near if k > number):
            zone = grow_shape(other, TOUCHING)
            for edge in edges(rings(floor)[0]):
                shared = shapely.LineString(edge.reshape(2, 2)).intersection(zone)
                if LEAST_SIDE <= shared.length <= 20 and not _taken(shared, placed):
                    x, y = shared.interpolate(0.5, normalized=True).coords[0]
                    width = shared.length
                    door = Door(at=(x, y), width=width, height=height, swing="none")
                    found.append(PlacedOpening(number, door))
    return found


def _taken(side: BaseGeometry, placed: list[PlacedOpening]) -> bool:
    return any(side.distance(shapely.Point(entry.opening.at)) < TOUCHING for entry in placed)


def is_door(piece: HomePiece) -> bool:
    """Whether one can walk through: it reaches the floor, is high enough and not fixed glass."""
    glass = not piece.sashes and re.search(
        r"fixed|fixe|fest|固定", f"{piece.catalog} {piece.name}", re.I
    )
    return piece.z <= DOOR_SILL and piece.height >= DOOR_HEIGHT and not glass


def _spot(piece: HomePiece, runs: list[tuple[int, Points]]) -> OpeningSpot | None:
    """The best wall: long enough beside the piece, then nearest."""
    spots = [spot for number, run in runs if (spot := _on(piece, number, run)) is not None]
    least = LEAST_DOOR if is_door(piece) else LEAST_WINDOW
    fitting = [spot for spot in spots if spot.width >= min(least, 0.9 * piece.width)]
    return min(fitting, key=lambda spot: spot.away + piece.width - spot.width, default=None)


def _on(piece: HomePiece, number: int, run: Points) -> OpeningSpot | None:
    at = np.array([piece.x, piece.y])
    s, away = project(run, at)
    lengths = run_lengths(run)
    if piece.number < 0 and lengths[-1] > piece.width:  # a gap: no element of the file
        s = float(np.clip(s, piece.width / 2, lengths[-1] - piece.width / 2))
    low = min(max(s - piece.width / 2, 0.0), lengths[-1])
    high = min(s + piece.width / 2, lengths[-1])
    if away > piece.depth / 2 + FARTHEST or high - low < 0.1:
        return None
    ends = np.array([[np.interp(t, lengths, run[:, k]) for k in (0, 1)] for t in (low, high)])
    along = ends[1] - ends[0]
    width = float(np.hypot(*along))
    along = along / width
    if abs(along @ np.array([math.cos(piece.turn), math.sin(piece.turn)])) < PARALLEL:
        return None
    middle = [np.interp((low + high) / 2, lengths, run[:, k]) for k in (0, 1)]
    return OpeningSpot(
        number,
        (float(middle[0]), float(middle[1])),
        (float(along[0]), float(along[1])),
        width,
        away,
    )


def _door(piece: HomePiece, spot: OpeningSpot) -> Door:
    swing, hinge = _leaf(piece, spot)
    return Door(
        at=spot.at,
        width=min(max(spot.width, 0.3), 20.0),
        height=piece.height + piece.z,
        hinge=hinge,
        swing=swing,
    )


def _window(piece: HomePiece, spot: OpeningSpot) -> Window:
    width = min(max(spot.width, 0.1), 30.0)
    return Window(at=spot.at, width=width, height=piece.height, sill=max(piece.z, 0.0))


def _leaf(piece: HomePiece, spot: OpeningSpot) -> tuple[Swing, Literal["left", "right"]]:
    """Swing and hinge as seen from inside the room. Two leaves take little room and are read as
    sliding; so are garage doors. A frame without a leaf is an open passage."""
    name = f"{piece.catalog} {piece.name}".casefold()
    if re.search(r"slid|coulissant|schiebe|garage|推拉|移门|引き戸", name) or len(piece.sashes) > 1:
        return "slide", "left"
    if not piece.sashes:
        frame = re.search(r"frame|opening|passage|arch|cadre|ouverture|rahmen|门框|門框|垭口", name)
        return ("none" if frame else "in"), "left"
    return _hung(piece, spot, piece.sashes[0])


def _hung(
    piece: HomePiece, spot: OpeningSpot, sash: Sash
) -> tuple[Swing, Literal["left", "right"]]:
    ux, uy = spot.along
    c, s = math.cos(piece.turn), math.sin(piece.turn)
    hinge = (c * sash.x - s * sash.y) * ux + (s * sash.x + c * sash.y) * uy
    opened = piece.turn + sash.open
    inwards = -uy * math.cos(opened) + ux * math.sin(opened)
    return ("in" if inwards > 0 else "out"), ("left" if hinge > 0 else "right")


def _collide(one: HomePiece, other: HomePiece) -> bool:
    """Whether two pieces claim the same part of a wall."""
    c, s = math.cos(one.turn), math.sin(one.turn)
    dx, dy = other.x - one.x, other.y - one.y
    if abs(c * math.cos(other.turn) + s * math.sin(other.turn)) < PARALLEL:
        return abs(dx) + abs(dy) < 0.3
    beside = abs(dx * c + dy * s) < (one.width + other.width) / 2 - 0.04
    through = abs(-dx * s + dy * c) < (one.depth + other.depth) / 2 + 0.1
    upright = min(one.z + one.height, other.z + other.height) - max(one.z, other.z) > 0.04
    return beside and through and upright
