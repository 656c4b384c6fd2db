"""Stairs: pieces where one steps on or off, and levels that no stairs lead to."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from scenewright.check.bodies import HEAD_HEIGHT, TOLERANCE, Bodies, Rooms, Shape
from scenewright.check.spaces import lived_in, with_stairs
from scenewright.core.brief import Brief
from scenewright.core.report import Finding, Note
from scenewright.core.scene import STAIRS
from scenewright.core.space import StairEnd

LANDING = 0.6
"""Depth of the floor that is to be free before the foot and the head of stairs, in metres."""


def find_blocked_stairs(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """A finding for every piece that stands before the foot or head of stairs by more than 1 cm;
    a piece on stairs or in their well collides with the pieces that represent these."""
    found = []
    for number, space in enumerate(rooms.spaces):
        for end in space.stairs:
            zone = shapely.intersection(_landing(end), rooms.shapes[number])
            for row, shape in _standing(bodies, rooms, number, zone, HEAD_HEIGHT):
                found.append(_finding(bodies, rooms, number, end, row, shape))
    return found


def _standing(
    bodies: Bodies, rooms: Rooms, room: int, zone: Shape, height: float
) -> Iterator[tuple[int, Shape]]:
    """The rows of solid pieces of a room's level, lower than a height, that reach more than 1 cm
    into a zone, and what they take of it."""
    solid = ~bodies.flat & ~bodies.soft & (bodies.low < height)
    rows = np.flatnonzero(solid & (bodies.level == rooms.level[room]))
    shared = shapely.intersection(bodies.footprints[rows], zone.buffer(-TOLERANCE))
    for row, shape in zip(rows.tolist(), shared.tolist(), strict=True):
        if shape.area > 0.0:
            yield row, shape


def _landing(end: StairEnd) -> Shape:
    """The floor before an end."""
    ahead = np.array([np.cos(end.heading), np.sin(end.heading)])
    side = np.array([-ahead[1], ahead[0]]) * end.width / 2
    near = np.array([end.x, end.y])
    far = near + LANDING * ahead
    return shapely.Polygon([near - side, far - side, far + side, near + side])


def _finding(
    bodies: Bodies, rooms: Rooms, room: int, end: StairEnd, row: int, shape: Shape
) -> Finding:
    piece, space = bodies.pieces[row], rooms.spaces[room]
    gap = float(shape.distance(shapely.Point(end.x, end.y)))
    text = (
        f"{piece.id} stands {gap:.2f} m before the {end.kind} of {end.stairs} "
        f"({shape.area:.2f} m² of what should be free)"
    )
    return Finding(
        "blocked_stairs",
        space.level,
        space.id,
        piece.id,
        end.stairs,
        text,
        round(gap, 4),
        round(float(shape.area), 4),
        piece.fixed,
    )


def find_cut_off(brief: Brief, bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each lived-in level that no door from outside and no stairs lead to."""
    height = {level.id: level.elevation for level in brief.levels}
    if len(height) < 2:
        return []
    served = with_stairs(bodies, rooms)
    level_of = {space.id: space.level for space in rooms.spaces}
    reached = {level_of[space] for space in served}
    reached |= {
        s.level
        for s in rooms.spaces
        for o in s.openings
        if o.kind != "window" and len(o.spaces) == 1
    }
    reached |= _above(bodies, level_of, height)
    notes = []
    for level in brief.levels:
        here = [
            s
            for k, s in enumerate(rooms.spaces)
            if s.level == level.id and lived_in(s.functions, rooms.shapes[k])
        ]
        if here and level.id not in reached:
            name = level.name or level.id
            notes.append(
                Note(
                    here[0].id,
                    here[0].functions[0],
                    "stairs",
                    f"no stairs lead to the level {name}",
                )
            )
    return notes


def _above(bodies: Bodies, level_of: dict[str, str], height: dict[str, float]) -> set[str]:
    """The levels next above staircases that stand as fixed items, not as parts of stairs."""
    found = set()
    for piece in bodies.pieces:
        low = height.get(level_of.get(piece.space, ""))
        if piece.category == "staircase" and piece.function != STAIRS and low is not None:
            above = [name for name, tall in height.items() if tall > low]
            found |= {min(above, key=height.__getitem__)} if above else set()
    return found
