"""Where a piece may be put by hand: in a room of its level, in no wall and on no stairs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.piece_edits import frame_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space

Frame = tuple[float, float, float]
STICKS_OUT = 0.1  # how far a piece put by hand may stick out of its room, metres


def room_at(piece: Piece, to: Frame, rooms: Sequence[Space]) -> str:
    """The id of the room of the piece's level that a point lies in; InputError where the piece
    cannot stand there."""
    level = {room.id: room.level for room in rooms}
    point = shapely.Point(to[:2])
    here = [r for r in rooms if r.level == level.get(piece.space)]
    for room in sorted(here, key=lambda r: r.id != piece.space):
        if shapely.Polygon(room.outline, list(room.holes)).covers(point):
            _check_inside(piece, to, room)
            return room.id
    raise InputError(
        f"'{piece.id}' cannot stand at ({to[0]:g}, {to[1]:g}): no room of its level is there",
        _extent(next((r for r in here if r.id == piece.space), None)),
    )


def check_along(main: Piece, along: Sequence[Piece], rooms: Sequence[Space]) -> None:
    """InputError where a piece that goes along with another, placed already, sticks out."""
    for piece in along:
        room = next(room for room in rooms if room.id == piece.space)
        if _reach_out(piece, frame_of(piece), room) > STICKS_OUT:
            raise InputError(
                f"'{main.id}' takes the {piece.category} along, which would stick "
                f"{_reach_out(piece, frame_of(piece), room):.2f} m out of its room",
                f"turn it or give a point further inside; {_extent(room)}",
            )


def _reach_out(piece: Piece, to: Frame, room: Space) -> float:
    """How far a piece sticks out of a room, metres."""
    box = shapely.Polygon(corners(np.array([[*to, piece.size.width, piece.size.depth]]))[0])
    floor = shapely.Polygon(room.outline, list(room.holes))
    return max(floor.distance(shapely.Point(c)) for c in shapely.get_coordinates(box))


def _check_inside(piece: Piece, to: Frame, room: Space) -> None:
    """A piece put by hand lies on the floor of its room: in no wall, and on no stairs."""
    box = shapely.Polygon(corners(np.array([[*to, piece.size.width, piece.size.depth]]))[0])
    out = _reach_out(piece, to, room)
    text = f"'{piece.id}' of {piece.size.width:.2f} x {piece.size.depth:.2f} m"
    if out > STICKS_OUT:
        raise InputError(
            f"{text} at ({to[0]:g}, {to[1]:g}) would stick {out:.2f} m out of its room",
            f"turn it or give a point further inside; {_extent(room)}",
        )
    if len(room.stair_parts):
        taken = corners(np.array([part.box for part in room.stair_parts]))
        if shapely.union_all(shapely.polygons(taken)).intersection(box).area > STICKS_OUT**2:
            raise InputError(
                f"{text} at ({to[0]:g}, {to[1]:g}) would stand in the stairs",
                "give a point beside them",
            )


def _extent(room: Space | None) -> str:
    if room is None:
        return "give a point inside a room"
    (x0, y0), (x1, y1) = room.outline.min(0), room.outline.max(0)
    return f"'{room.id}' lies within {x0:.2f} to {x1:.2f} and {y0:.2f} to {y1:.2f}"
