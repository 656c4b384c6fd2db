"""Ways out: how far everyone has to walk to a door that leads outside, and how wide the doors are.

The walking distance is measured on a square raster over where a person 0.4 m wide can be, moving
to the 16 nearest cells, so it is at most 2.8 % longer than the shortest way (and a cell more).
Doors and outline come with the brief, so what is found is a note. The limits follow
common fire codes (NFPA 101: 45 m to an exit in shops without sprinklers, 5 mm of exit width a
person on the level, two exits for more than 50 people); they are no substitute for the local one.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import Flags, Floats, Indices, Shape
from scenewright.check.routes import JoinedFloor
from scenewright.core.report import Note
from scenewright.core.space import Opening
from scenewright.domains.hall.check.halls import JudgedHall

FARTHEST = 45.0
"""How far the nearest exit may be, in metres of walking."""

EXIT_PER_PERSON = 0.005
"""Clear width of exits needed for each person, in metres."""

FEW_PEOPLE = 50
"""How many people one exit is enough for."""

_CELL = 0.25
_MOST_CELLS = 100_000
_STEPS = ((0, 1), (1, 0), (1, 1), (1, -1), (1, 2), (2, 1), (2, -1), (1, -2))


class Field(NamedTuple):
    """Walking distance to the nearest way out at the middles (n, 2) of the cells of a raster, in
    metres; infinite where none can be walked to."""

    points: Floats
    distance: Floats


def field_of(ground: JoinedFloor, free: Shape) -> Field | None:
    """Walking distances over ``free``, where the middle of a person can be in a ground; none if
    it has no door to the outside."""
    if not ground.outer or free.is_empty:
        return None
    x0, y0, x1, y1 = shapely.bounds(free)
    cell = max(_CELL, float(np.sqrt((x1 - x0) * (y1 - y0) / _MOST_CELLS)))
    x, y = (np.arange(a + cell / 2, b + cell, cell) for a, b in ((x0, x1), (y0, y1)))
    grid = np.stack(np.meshgrid(x, y, indexing="ij"), -1)
    shapely.prepare(free)
    inside = shapely.contains_xy(free, grid[..., 0], grid[..., 1])
    start = np.full(inside.shape, np.inf)
    for door in ground.outer:
        start = np.minimum(start, _from_door(door, ground.floor, grid, inside, 3 * cell))
    return Field(grid[inside], walking_distance(inside, start, cell)[inside])


def _from_door(door: Opening, floor: Shape, grid: Floats, inside: Flags, reach: float) -> Floats:
    """Distance to the middle of a door from the cells before it, in a straight line."""
    middle = np.array([door.x, door.y])
    apart = np.hypot(*np.moveaxis(grid - middle, -1, 0))
    near = inside & (apart <= door.thickness / 2 + reach)
    lines = shapely.linestrings(
        np.stack([np.broadcast_to(middle, grid[near].shape), grid[near]], 1)
    )
    near[near] = shapely.covered_by(lines, floor)
    return np.where(near, apart, np.inf)


def walking_distance(free: Flags, start: Floats, cell: float) -> Floats:
    """Least of ``start`` plus the length of the way there through ``free`` cells, for each cell of
    a raster (w, h) of square cells; metres.

    >>> free = np.ones((1, 5), bool)
    >>> start = np.where(np.arange(5) == 0, 0.0, np.inf)[None]
    >>> walking_distance(free, start, 0.5).tolist()
    [[0.0, 0.5, 1.0, 1.5, 2.0]]
    """
    padded, open_ = np.pad(start, 2, constant_values=np.inf), np.pad(free, 2)
    height = int(padded.shape[1])
    distance, passable = padded.ravel(), open_.ravel()
    steps = [
        (sign * (a * height + b), [sign * o for o in _between(a, b, height)], cell * np.hypot(a, b))
        for a, b in _STEPS
        for sign in (1, -1)
    ]
    front: Indices = np.flatnonzero(np.isfinite(distance))
    while len(front):
        before = distance.copy()
        for offset, between, length in steps:
            ways = passable[front + offset]
            for over in between:
                ways = ways & passable[front + over]
            ahead = front[ways]
            np.minimum.at(distance, ahead + offset, distance[ahead] + length)
        front = np.flatnonzero(distance < before - 1e-9)
    return np.asarray(distance.reshape(padded.shape)[2:-2, 2:-2])


def _between(a: int, b: int, height: int) -> list[int]:
    """Offsets of the two cells one walks over on the way to cell (a, b) of the neighbourhood.

    >>> _between(2, -1, 100), _between(1, 1, 100), _between(0, 1, 100)
    ([100, 99], [100, 1], [])
    """
    if abs(a) + abs(b) == 1:
        return []
    i, j = int(np.sign(a)), int(np.sign(b))
    if abs(a) == abs(b):
        return [i * height, j]
    return [i * height if abs(a) > abs(b) else j, i * height + j]


def escape_figures(hall: JudgedHall, field: Field | None, people: int | None) -> dict[str, Any]:
    """Farthest walking distance from a place of the hall to the nearest way out (none if not
    known), where it is, the number of doors of the hall and their width, and what is needed."""
    exits = exits_of(hall)
    figures: dict[str, Any] = {
        "distance": None,
        "at": None,
        "exits": len(exits),
        "exit_width": round(sum(o.width for o in exits), 3),
        "people": people,
        "exit_width_needed": round(EXIT_PER_PERSON * people, 3) if people else None,
    }
    if field is not None:
        shapely.prepare(hall.shape)
        here = shapely.contains_xy(hall.shape, field.points[:, 0], field.points[:, 1])
        rows = np.flatnonzero(here & np.isfinite(field.distance))
        if len(rows):
            far = rows[int(np.argmax(field.distance[rows]))]
            figures["distance"] = round(float(field.distance[far]), 2)
            figures["at"] = [round(float(v), 2) for v in field.points[far]]
    return figures


def exits_of(hall: JudgedHall) -> list[Opening]:
    """Doors and passages of a hall; in an emergency every one is a way out."""
    return [opening for opening in hall.space.openings if opening.kind != "window"]


def escape_notes(hall: JudgedHall, figures: dict[str, Any]) -> list[Note]:
    """Notes on a long way out, and on too few or too narrow exits for the people stated."""
    name, notes, people = hall.space.id, [], figures["people"] or 0
    if figures["distance"] is not None and figures["distance"] > FARTHEST:
        x, y = figures["at"]
        message = (
            f"{name}: from ({x:.1f}, {y:.1f}) it is {figures['distance']:.0f} m to the nearest"
        )
        notes.append(
            Note(name, "long_escape", "a nearer exit", f"{message} exit, over {FARTHEST:g}")
        )
    if people > FEW_PEOPLE and figures["exits"] < 2:
        message = f"{name} has {figures['exits']} exit for {people} people; two are usual above 50"
        notes.append(Note(name, "narrow_exits", "a second exit", message))
    if people and figures["exit_width"] < figures["exit_width_needed"]:
        message = (
            f"{name} has exits {figures['exit_width']:.2f} m wide in all; {people} people need"
        )
        message += f" {figures['exit_width_needed']:.2f}"
        notes.append(Note(name, "narrow_exits", "wider exits", message))
    return notes
