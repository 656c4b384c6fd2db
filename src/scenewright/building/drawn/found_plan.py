"""The plan that lines of walls make in the unit that fits, and whether it may be taken for one."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon
from shapely.affinity import affine_transform

from scenewright.building.drawn.drawing import Drawn
from scenewright.building.drawn.faces import (
    Faces,
    entered_groups,
    find_faces,
    is_plan,
    with_painted,
    without_solid,
)
from scenewright.building.drawn.openings import Found, find_openings
from scenewright.building.drawn.sheet import Sheet
from scenewright.building.drawn.span import missed_floor
from scenewright.building.drawn.units import UnitFound
from scenewright.core.errors import InputError

SHARE = 0.3
"""Rooms that lie apart are a storey if they have this share of the floor of the largest."""
LEAST_READ, LEAST_ENTERED = 0.3, 0.3
"""The least share that rooms take of the floor that walls span, and that rooms with doors take of
the rooms, for a plan to be taken as read."""


class DrawnPlan(NamedTuple):
    """A drawing in metres with its unit and its origin in units, the faces and openings found in
    it, the rooms of each storey, and the floor in m² that its walls span and no room has."""

    drawn: Drawn
    unit: UnitFound
    origin: NDArray[np.float64]
    faces: Faces
    openings: list[Found]
    storeys: list[list[int]]
    missed: float

    @property
    def floor(self) -> float:
        """The floor of the rooms in m²."""
        return sum(self.faces.rooms[k].area for group in self.storeys for k in group)


def marked_plan(sheet: Sheet, chosen: Drawn, scale: float) -> DrawnPlan | None:
    """The plan of a file that Scenewright has written: its rooms are marked."""
    if not sheet.rooms:
        return None
    unit = UnitFound("m", (sheet.unit or 1.0) * scale, True)
    shift = np.vstack([points for _, _, points in sheet.rooms]).min(0)
    rooms = [Polygon((points - shift) * unit.metres) for _, _, points in sheet.rooms]
    if not all(room.is_valid and room.area > 0 for room in rooms):
        return None
    drawn = chosen.scaled(unit.metres, shift)
    faces = find_faces(drawn)._replace(rooms=rooms, around=[], small=[])
    openings = find_openings(drawn, rooms, faces.gaps)
    return DrawnPlan(drawn, unit, shift, faces, openings, _storeys(faces, drawn), 0.0)


def find_plan(
    sheet: Sheet, chosen: Drawn, units_of: Callable[[Drawn], list[UnitFound]]
) -> DrawnPlan:
    """The plan in the first unit that makes one, of two that nearly do; no room lies within what is
    solid.

    Raises :class:`InputError` where no unit does, or too little of the plan was read.
    """
    shift = chosen.walls.reshape(-1, 2).min(0) if len(chosen.walls) else np.zeros(2)
    refusal: InputError | None = None
    for unit in units_of(chosen) if len(chosen.walls) else ():
        drawn = chosen.scaled(unit.metres, shift)
        move = [k := unit.metres, 0, 0, k, *(-k * shift)]
        faces = find_faces(drawn)
        if sheet.solid is not None:
            faces = without_solid(faces, affine_transform(sheet.solid, move))
        if not is_plan(faces, drawn):
            continue
        painted = [affine_transform(area, move) for area in sheet.painted]
        faces = with_painted(faces, painted, drawn.words)
        plan = _measured(drawn, unit, shift, faces)
        fault = _fault(plan)
        if not fault:
            return plan
        remedy = "draw walls, doors and notes on layers or with pens of their own"
        if refusal is not None:
            break
        refusal = InputError(fault, f"{remedy}, or give the --scale")
    raise refusal or _no_plan(chosen)


def _measured(
    drawn: Drawn, unit: UnitFound, origin: NDArray[np.float64], faces: Faces
) -> DrawnPlan:
    storeys = _storeys(faces, drawn)
    grouped = [[faces.rooms[k] for k in group] for group in storeys]
    lines = shapely.linestrings(drawn.walls)
    floors = [shapely.MultiPolygon(rooms).envelope for rooms in grouped]
    nearest = np.argmin([shapely.distance(lines, floor) for floor in floors], axis=0)
    missed = sum(
        missed_floor(drawn.walls[nearest == number], rooms, faces.around)
        for number, rooms in enumerate(grouped)
    )
    openings = find_openings(drawn, faces.rooms, faces.gaps)
    return DrawnPlan(drawn, unit, origin, faces, openings, storeys, missed)


def _fault(plan: DrawnPlan) -> str:
    """Why too little of a plan was read to be taken for it; empty where enough was."""
    if plan.floor < LEAST_READ * (plan.floor + plan.missed):
        return (
            f"holds no floor plan that can be told: its walls close rooms of {plan.floor:.1f} m² "
            f"of the {plan.floor + plan.missed:.1f} m² that they span"
        )
    doors = [opening for opening in plan.openings if opening.kind == "door"]
    entered = {door.room for door in doors} | {door.beyond for door in doors}
    kept = [k for group in plan.storeys for k in group]
    floor = sum(plan.faces.rooms[k].area for k in kept if k in entered)
    if floor < LEAST_ENTERED * plan.floor:
        count = sum(k in entered for k in kept)
        return f"holds no floor plan that can be told: {count} of {len(kept)} rooms have doors"
    return ""


def _storeys(faces: Faces, drawn: Drawn) -> list[list[int]]:
    """The rooms of each storey, from left to right: groups that lie apart, large enough."""
    rooms = faces.rooms
    groups = entered_groups(faces, drawn)
    areas = [sum(rooms[k].area for k in group) for group in groups]
    kept = [g for g, area in zip(groups, areas, strict=True) if area >= SHARE * max(areas)]
    return sorted(kept, key=lambda group: min(rooms[k].bounds[0] for k in group))


def _no_plan(chosen: Drawn) -> InputError:
    if not len(chosen.walls):
        remedy = "save the model of a storey with its walls, from the program it was drawn in"
        return InputError("holds no floor plan: no lines that may be walls", remedy)
    size = np.ptp(chosen.walls.reshape(-1, 2), axis=0)
    extent = f"{len(chosen.walls):,} lines, {size[0]:,.4g} x {size[1]:,.4g} units"
    return InputError(
        f"holds no floor plan: in no unit do its walls ({extent}) enclose rooms with doors",
        "give the plan of a storey, or its --scale",
    )
