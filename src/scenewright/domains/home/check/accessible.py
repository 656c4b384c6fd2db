"""Homes for wheelchairs: can one turn in every room, and get from the chair to bed and toilet?

A wheelchair turns in a circle of 1.5 m, needs a route of 0.9 m, doors 0.8 m clear and free floor
of 0.9 m beside a bed and a toilet (ISO 21542; DIN 18040-2 asks the like of dwellings).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import Bodies, Rooms, Shape, standing_in
from scenewright.check.routes import TURNING, JoinedFloor, Walk, room_for
from scenewright.check.spaces import inscribed_width
from scenewright.core.report import Finding, Note

DOOR = 0.8
"""Least clear width of a door, in metres."""

BESIDE = 0.9
"""Free floor beside a bed or a toilet, in metres."""

ALONG = 1.2
"""Length of it along a bed, from its foot, in metres; along a toilet all of it."""

BEDS = frozenset(("double_bed", "single_bed"))
TOILETS = frozenset(("toilet",))
APART = frozenset(("storage", "balcony", "other"))
"""Functions of rooms in which nobody needs to turn."""

_SLACK = 0.01


class Barriers(NamedTuple):
    """What is wrong, what cannot be helped, and by room where one turns (``turning``: x, y)."""

    findings: list[Finding]
    notes: list[Note]
    figures: dict[str, Any]


def find_barriers(
    bodies: Bodies, given: Bodies, rooms: Rooms, grounds: list[JoinedFloor], walks: list[Walk]
) -> Barriers:
    """All that keeps a wheelchair from turning or from getting to bed and toilet.

    Findings are what another layout could mend: where the room with only what came fixed allows
    it. Notes are what only the building could: rooms too narrow, doors too tight. ``given`` are
    the fixed pieces alone, ``walks`` the routes of the home's stated width.
    """
    found = Barriers([], [], {"turning": {}})
    for ground, walk in zip(grounds, walks, strict=True):
        circles = room_for(bodies, ground, TURNING / 2)
        bare = room_for(given, ground, TURNING / 2)
        for room in map(int, ground.rooms):
            if not set(rooms.spaces[room].functions) & APART:
                _turning(found, rooms, room, circles, bare, walk)
                _transfers(found, bodies, rooms, room)
    _doors(found, rooms)
    return found


def _turning(
    found: Barriers, rooms: Rooms, room: int, circles: Shape, bare: Shape, walk: Walk
) -> None:
    """Whether a free circle that can be rolled into lies in a room, and where."""
    space, shape = rooms.spaces[room], rooms.shapes[room]
    here = shapely.intersection(shapely.intersection(circles, walk.reached), shape)
    if not here.is_empty:
        parts = shapely.get_parts(here)
        areas = shapely.area(parts)
        at = parts[int(np.argmax(areas))].representative_point()
        found.figures["turning"][space.id] = [round(at.x, 3), round(at.y, 3)]
        return
    text = f"no wheelchair can turn in {space.id}: a free circle of {TURNING:g} m"
    if shapely.intersects(shapely.intersection(bare, walk.bare_reached), shape):
        found.findings.append(
            Finding(
                "no_turning",
                space.level,
                space.id,
                "",
                "",
                f"{text} would fit without the furniture",
                TURNING,
            )
        )
        return
    why = f"does not fit in it ({inscribed_width(shape):.2f} m wide)"
    if shapely.intersects(bare, shape):
        why = f"is there, but no route of {2 * walk.radius:g} m leads to it even without furniture"
    function = space.functions[0] if space.functions else ""
    found.notes.append(Note(space.id, function, "turning", f"{text} {why}"))


def _transfers(found: Barriers, bodies: Bodies, rooms: Rooms, room: int) -> None:
    """Whether there is free floor on one side of every bed and toilet of a room."""
    space, shape = rooms.spaces[room], rooms.shapes[room]
    rows = np.flatnonzero(standing_in(bodies, np.array([room])) & bodies.underfoot)
    wide = inscribed_width(shape)
    for row in rows:
        piece = bodies.pieces[row]
        if piece.category not in BEDS | TOILETS:
            continue
        others = shapely.union_all(bodies.footprints[rows[rows != row]])
        free = shapely.buffer(shapely.difference(shape, others), _SLACK, join_style="mitre")
        if any(shapely.covers(free, strip) for strip in strips(bodies, int(row))):
            continue
        what = bodies.kinds[row].name
        text = f"{piece.id}: no {BESIDE:g} m of free floor beside the {what} to get to it"
        narrow = wide < min(piece.size.width, piece.size.depth) + BESIDE
        if narrow:
            function = space.functions[0] if space.functions else ""
            found.notes.append(Note(space.id, function, "transfer", text + ": too narrow a room"))
        else:
            found.findings.append(
                Finding(
                    "no_transfer",
                    space.level,
                    space.id,
                    piece.id,
                    "",
                    text,
                    BESIDE,
                    given=piece.fixed,
                )
            )


def strips(bodies: Bodies, row: int) -> list[Shape]:
    """The floor to the right and left of a bed or toilet from which one gets to it."""
    back_right, front_right, front_left, back_left = bodies.corners[row]
    found = []
    for back, front, away in (
        (back_right, front_right, front_left),
        (back_left, front_left, front_right),
    ):
        out = (front - away) / np.hypot(*(front - away))
        along = back - front
        length = float(np.hypot(*along))
        bed = bodies.pieces[row].category in BEDS
        end = front + along * (min(ALONG, length) / length if bed else 1.0)
        found.append(shapely.Polygon([front, front + BESIDE * out, end + BESIDE * out, end]))
    return found


def _doors(found: Barriers, rooms: Rooms) -> None:
    """A note for every door too tight for a wheelchair, reported once."""
    reported = set()
    for space in rooms.spaces:
        for opening in space.openings:
            tight = opening.kind != "window" and opening.width < DOOR - 1e-6
            if tight and opening.id not in reported:
                reported.add(opening.id)
                found.notes.append(
                    Note(
                        space.id,
                        space.functions[0] if space.functions else "",
                        "door",
                        f"{opening.id} is {opening.width:.2f} m wide: a wheelchair needs "
                        f"{DOOR:g} m",
                    )
                )
