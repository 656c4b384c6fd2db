"""Stairs: what stands where one steps on or off, and levels that no stairs lead to."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.brief import Brief
from scenewright.check.bodies import HEAD_HEIGHT, TOLERANCE, Bodies, Rooms, Shape
from scenewright.check.complete import lived_in, with_stairs
from scenewright.check.report import Finding, Note
from scenewright.space import StairEnd

LANDING = 0.6
"""Depth of the floor that is to be free before the foot and the head of stairs, in metres."""


def find_blocked_stairs(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """A finding for every piece that stands before the foot or head of stairs by more than 1 cm."""
    found = []
    for number, space in enumerate(rooms.spaces):
        for end in space.stairs:
            zone = shapely.intersection(_landing(end), rooms.shapes[number])
            level = bodies.level == rooms.level[number]
            solid = ~bodies.flat & ~bodies.soft & (bodies.low < HEAD_HEIGHT)
            rows = np.flatnonzero(level & solid)
            shared = shapely.intersection(bodies.footprints[rows], zone.buffer(-TOLERANCE))
            for row, shape in zip(rows.tolist(), shared.tolist(), strict=True):
                if shape.area > 0.0:
                    found.append(_finding(bodies, rooms, number, end, row, shape))
    return found


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
    told = (f"{piece.id} stands {gap:.2f} m before the {end.kind} of {end.stairs} "
            f"({shape.area:.2f} m² of what should be free)")  # fmt: skip
    return Finding("blocked_stairs", space.level, space.id, piece.id, end.stairs, told,
                   round(gap, 4), round(float(shape.area), 4), piece.fixed)  # fmt: skip


def find_cut_off(brief: Brief, bodies: Bodies, rooms: Rooms) -> list[Note]:
    """A note for each lived-in level of a home that no door from outside and no stairs lead to."""
    height = {level.id: level.elevation for level in brief.levels}
    if brief.domain != "home" or len(height) < 2:
        return []
    served = with_stairs(bodies, rooms)
    level_of = {space.id: space.level for space in rooms.spaces}
    reached = {level_of[space] for space in served}
    reached |= {s.level for s in rooms.spaces for o in s.openings
                if o.kind != "window" and len(o.spaces) == 1}  # fmt: skip
    reached |= _above(bodies, level_of, height)
    notes = []
    for level in brief.levels:
        here = [s for k, s in enumerate(rooms.spaces)
                if s.level == level.id and lived_in(s.functions, rooms.shapes[k])]  # fmt: skip
        if here and level.id not in reached:
            name = level.name or level.id
            notes.append(Note(here[0].id, here[0].functions[0], "stairs",
                              f"no stairs lead to the level {name}"))  # fmt: skip
    return notes


def _above(bodies: Bodies, level_of: dict[str, str], height: dict[str, float]) -> set[str]:
    """The levels next above staircases that stand as fixed items."""
    found = set()
    for piece in bodies.pieces:
        low = height.get(level_of.get(piece.space, ""))
        if piece.category == "staircase" and low is not None:
            above = [name for name, tall in height.items() if tall > low]
            found |= {min(above, key=height.__getitem__)} if above else set()
    return found
