"""Doors and windows of a storey's rooms, on the middle lines of its walls."""

from __future__ import annotations

from math import hypot
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.floorplans.outlines import Ground
from scenewright.domains.home.floorplans.programme import ROWS

Floats = NDArray[np.float64]
WALL = 0.12
DOOR_TO_CORNER = 0.1
"""Least stretch of wall between a door and the corner beside it, metres."""
FREE_STRIP = 1.3
"""Floor beside the stairs from which doors of the hall open, metres."""
WINDOWS = {
    "living": (2.4, 0.5, 1.8),
    "open": (2.4, 0.5, 1.8),
    "studio": (2.2, 0.5, 1.8),
    "kitchen": (1.2, 1.1, 1.1),
    "bath": (0.6, 1.5, 0.7),
    "toilet": (0.5, 1.5, 0.7),
}
"""Width, sill and height of windows by kind of room in metres; of other rooms :data:`USUAL`."""
USUAL = (1.5, 0.9, 1.4)
BESIDE_WINDOW = 0.35
"""Least wall at either side of a window, between middle lines."""


class Run(NamedTuple):
    """A straight stretch of a wall: its ``side`` of the room (0 west, 1 south, 2 east, 3 north)
    and, along it, from ``low`` to ``high``."""

    side: int
    low: float
    high: float

    @property
    def length(self) -> float:
        return self.high - self.low


class PlacedDoor(NamedTuple):
    """Where a door stands: its middle (2,), the side of the room and the side of its hinges."""

    at: Floats
    side: int
    hinge: str


def shared_run(box: Floats, other: Floats) -> Run | None:
    """The border of a room (4,) with another, as a side of the first; None where they do not
    touch.

    >>> shared_run(np.array([0.0, 0, 4, 3]), np.array([4.0, 1, 6, 5]))
    Run(side=2, low=1.0, high=3.0)
    """
    for side in range(4):
        axis, far = side % 2, (side + 2) % 4
        if abs(box[side] - other[far]) < 1e-6:
            low = max(box[1 - axis], other[1 - axis])
            high = min(box[3 - axis], other[3 - axis])
            if high - low > 1e-6:
                return Run(side, float(low), float(high))
    return None


def outer_runs(box: Floats, others: Floats) -> list[Run]:
    """The stretches of a room's sides along no other room (n, 4), the longest first."""
    found = []
    for side in range(4):
        axis = side % 2
        covered = sorted(
            (run.low, run.high)
            for other in others
            if (run := shared_run(box, other)) is not None and run.side == side
        )
        start = float(box[1 - axis])
        for low, high in [*covered, (float(box[3 - axis]), float(box[3 - axis]))]:
            if low - start > 1e-6:
                found.append(Run(side, start, low))
            start = max(start, high)
    return sorted(found, key=lambda run: -run.length)


def point_on(box: Floats, side: int, along: float) -> Floats:
    """The point (2,) of a side of a room at a coordinate along it."""
    return np.array([box[side], along] if side % 2 == 0 else [along, box[side]])


def hinge_of(side: int, at_high: bool) -> str:
    """The side of the hinges, seen from inside facing the door, so that the leaf opens against the
    wall at the high or the low end of a side."""
    rises_to_left = side in (1, 2)  # facing east, north is to the left; facing south, east
    return "left" if rises_to_left == at_high else "right"


def place_door(box: Floats, other: Floats, width: float, free: Run | None) -> PlacedDoor | None:
    """Middle, side and hinges of a door between two rooms, beside the nearest corner of the first;
    None where their border is too short. ``free`` bounds where doors may be on a side of the first
    room."""
    run = shared_run(box, other)
    if run is None:
        return None
    low, high = run.low, run.high
    if free is not None and free.side == run.side:
        low, high = max(low, free.low), min(high, free.high)
    reach = WALL / 2 + DOOR_TO_CORNER + width / 2
    if high - low < 2 * reach - 1e-9:
        return None
    axis = run.side % 2
    at_high = box[3 - axis] - high < low - box[1 - axis]
    along = high - reach if at_high else low + reach
    return PlacedDoor(point_on(box, run.side, along), run.side, hinge_of(run.side, at_high))


def door_of(
    ground: Ground, kinds: list[str], boxes: Floats, room: int
) -> tuple[int, dict[str, Any]] | None:
    """The room that a room's door leads to and the door, as a brief has it; None where it borders
    none that it may be entered from."""
    row = ROWS[kinds[room]]
    for kind in row.joins:
        for other in (k for k, name in enumerate(kinds) if is_kind(name, kind)):
            free = _free_strip(ground, boxes[other]) if kind == "hall" else None
            placed = place_door(boxes[room], boxes[other], row.door, free)
            if placed is None:
                continue
            open_plan = kinds[room] == "kitchen" and kind == "living"
            swing = "none" if open_plan else "out" if kinds[room] == "toilet" else "in"
            door = {"at": placed.at, "width": row.door, "hinge": placed.hinge, "swing": swing}
            return other, door
    return None


def is_kind(kind: str, wanted: str) -> bool:
    """Whether a kind of room is the one wanted, rooms with a living part being living rooms."""
    return kind == wanted or (wanted == "living" and kind in ("open", "studio"))


def _free_strip(ground: Ground, hall: Floats) -> Run | None:
    """Where rooms west of a hall with stairs may have their doors: below the flight, as a stretch
    of their east side."""
    if ground.hall is None:
        return None
    return Run(2, float(hall[1]), float(hall[1]) + FREE_STRIP + WALL / 2)


def windows_of(ground: Ground, kind: str, box: Floats, others: Floats) -> list[dict[str, Any]]:
    """Windows of a room: one in the middle of its longest outer wall that may have any, in living
    rooms one more in another wall; none in halls and stores."""
    if kind in ("hall", "storage"):
        return []
    width, sill, height = WINDOWS.get(kind, USUAL)
    least = min(width, max(ROWS[kind].light - 2 * BESIDE_WINDOW, 0.5))
    runs = [run for run in outer_runs(box, others) if ground.lit_sides[run.side]]
    found = []
    for run in runs[: 2 if width > 2.0 else 1]:
        wide = min(width, run.length - 2 * BESIDE_WINDOW)
        if wide < least - 1e-9:
            continue
        at = point_on(box, run.side, (run.low + run.high) / 2)
        found.append({"at": at, "width": round(wide, 2), "sill": sill, "height": height})
    return found


def entrance_of(ground: Ground, box: Floats, others: Floats) -> dict[str, Any] | None:
    """The front door of a hall, in its longest outer wall; beside the foot of the stairs where it
    has any. None where no outer wall is long enough."""
    width = ROWS["hall"].door
    run = next(iter(outer_runs(box, others)), None)
    reach = WALL / 2 + DOOR_TO_CORNER + width / 2
    if ground.hall is not None:
        run = Run(3, float(box[0]), float(box[2]))
    if run is None or run.length < 2 * reach:
        return None
    along = run.high - reach if ground.hall is not None else (run.low + run.high) / 2
    at = point_on(box, run.side, along)
    hinge = hinge_of(run.side, True)
    return {"id": "entrance", "at": at, "width": width, "height": 2.1, "hinge": hinge}


def turned(ground: Ground, point: Floats, direction: Floats) -> float:
    """The heading of a direction of the plan at a point, on the ground."""
    start, end = ground.lay(np.array([point, point + 0.1 * direction]))
    dx, dy = (end - start) / hypot(*(end - start))
    return float(np.arctan2(dy, dx))
