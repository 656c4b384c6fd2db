"""What became of what is drawn on one level of a Sweet Home 3D home."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from scenewright.core.brief.input_report import Fate
from scenewright.formats.sh3d.floors import LEAST_ROOM, DrawnFloor, area_of
from scenewright.formats.sh3d.functions import is_brought
from scenewright.formats.sh3d.kinds import LANDMARKS, kind_of
from scenewright.formats.sh3d.openings import Openings
from scenewright.formats.sh3d.pieces import KITCHEN, stays
from scenewright.formats.sh3d.report import HIDDEN, Fates, fate_of
from scenewright.formats.sh3d.slopes import is_sloping
from scenewright.formats.sh3d.xml import Home, HomeLevel, HomePiece, HomeWall

ROOF = 0.05
"""Metres below the ceiling within which a piece that begins there is left out."""
WHOLE = "part of a group that stays whole"
CUT = 0.05
"""Share of a room's floor lost to walls and other rooms from which on it is reported."""


def is_kept(piece: HomePiece, keep: bool, height: float) -> bool:
    """Whether a piece stays where it is in a room of that ``height``: what is built in, or all, to
    ``keep``, that begins below the ceiling."""
    return (keep or stays(piece)) and piece.z < height - ROOF


def fates_of_walls(home: Home, level: str) -> Fates:
    """What became of the walls of a level."""
    return {wall.number: _of_wall(wall) for wall in home.walls if wall.level == level}


def _of_wall(wall: HomeWall) -> Fate:
    if wall.thickness <= 0:
        return fate_of(wall, "it has no thickness")
    if wall.arc:
        return fate_of(wall, "an arc, as straight pieces", kept=True)
    return fate_of(wall, "its sloping top, as a sloped ceiling" * is_sloping(wall), kept=True)


def fates_of_rooms(home: Home, level: str, found: Sequence[DrawnFloor]) -> Fates:
    """What became of the rooms drawn on a level."""
    read = {floor.number: floor.polygon.area for floor in found}
    fates = {}
    for room in (room for room in home.rooms if room.level == level):
        drawn, area = area_of(room), read.get(room.number, 0.0)
        if not area:
            why = f"less than {LEAST_ROOM:g} m² of it lies clear of walls and smaller rooms"
            fates[room.number] = fate_of(room, why, stands=drawn >= LEAST_ROOM)
        else:
            cut = "cut by walls or smaller rooms" * (area < (1 - CUT) * drawn)
            fates[room.number] = fate_of(room, cut, kept=True)
    return fates


def fates_of_openings(pieces: Sequence[HomePiece], placed: Openings, level: HomeLevel) -> Fates:
    """What became of the doors and windows of a level."""
    sills = {e.piece: getattr(e.opening, "sill", 0.0) for e in placed.placed}
    fates = {}
    for piece in pieces:
        why = "it lies in no wall of a room" * (piece.number in placed.elsewhere)
        why = why or "another is in its place" * (piece.number in placed.doubled)
        high = sills.get(piece.number, 0.0) >= level.height - ROOF
        fates[piece.number] = fate_of(piece, why or "it is above the ceiling" * high)
    return fates


def fates_of_furniture(
    home: Home,
    level: HomeLevel,
    inside: Sequence[Sequence[HomePiece]],
    functions: Sequence[Sequence[str]],
    keep: bool,
) -> Fates:
    """What became of the furniture of a level and of its groups."""
    fates = {
        piece.number: _of_piece(piece, functions[number], keep, level.height)
        for number, pieces in enumerate(inside)
        for piece in pieces
    }
    others = _of_others(home.pieces, level.id)
    return {n: fate for at, n, fate in others if at == level.id} | fates


def _of_others(
    pieces: Sequence[HomePiece], level: str, whole: str = ""
) -> Iterator[tuple[str, int, Fate]]:
    """The level, number and fate of pieces as if each stood in no room; of groups with what is in
    them, if they are opened, hidden, or part of a ``whole``."""
    for piece in pieces:
        here = piece.level or level
        why = whole or HIDDEN * (not piece.visible)
        opened = piece.kind == "furnitureGroup" and kind_of(piece) not in LANDMARKS
        outside = "it stands in no room" * (not opened)
        yield here, piece.number, fate_of(piece, why or outside, kept=why == WHOLE)
        yield from _of_others(piece.members, here, why or WHOLE * (not opened))


def _of_piece(piece: HomePiece, functions: Sequence[str], keep: bool, height: float) -> Fate:
    if piece.z >= height - ROOF:
        return fate_of(piece, "it is above the ceiling")
    if is_kept(piece, keep, height):
        return fate_of(piece, "tilted, as the box around it" * piece.tilted, kept=True)
    if not is_brought(piece, functions):
        return fate_of(piece, "its room is not furnished with the like; --keep keeps it")
    if kind_of(piece) in KITCHEN:
        return fate_of(piece, "the kitchen is planned anew", kept=True)
    return fate_of(piece, "movable, arranged anew", kept=True)
