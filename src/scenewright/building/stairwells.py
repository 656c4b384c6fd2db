"""Stairs in the rooms of a brief: what they take of each floor, and where one steps on and off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely

from scenewright.brief import Brief
from scenewright.brief.stairs import StairsBrief
from scenewright.errors import InputError
from scenewright.layout import corners
from scenewright.space import Level, Space, StairEnd, StairPart
from scenewright.stairs import Box, End, Stairs, built

LOWEST, HIGHEST = 0.3, 8.0
"""Between what differences of height stairs are made, metres."""
BEYOND = 0.35
"""Floor that one needs where one steps off, metres."""
RAILING = 0.9
HERE = 0.5
"""Share of a part that must lie in a room to be of it."""
BASEMENT = -0.5
"""Levels lower than this are not entered from outside if others are, metres."""


def stairs_of(brief: Brief, storeys: Sequence[Level]) -> tuple[Stairs, ...]:
    """The stairs of a brief, in the order listed."""
    known = {level.id: level for level in storeys}
    found: list[Stairs] = []
    for number, asked in enumerate(brief.stairs):
        place = f"stairs[{number}]" + f" '{asked.name or asked.id}'" * bool(asked.name or asked.id)
        lower, upper = _levels(asked, storeys, known, place)
        height = upper.elevation - lower.elevation
        if not LOWEST <= height <= HIGHEST:
            raise InputError(
                f"the level '{upper.id}' is {height:.2f} m above '{lower.id}'",
                f"give stairs between {LOWEST} and {HIGHEST} m", place=place,
            )  # fmt: skip
        name = asked.id or ("stairs" if number == 0 else f"stairs-{number + 1}")
        if any(name == other.id for other in found):
            raise InputError(f"the id '{name}' is used twice", "give all stairs their own id",
                             place=place)  # fmt: skip
        found.append(built(asked, name, lower.id, upper.id, height))
    return tuple(found)


def _levels(
    asked: StairsBrief, storeys: Sequence[Level], known: dict[str, Level], place: str
) -> tuple[Level, Level]:
    """The lower and upper level of stairs."""
    for name in (asked.level, asked.to):
        if name and name not in known:
            raise InputError(f"the level '{name}' does not exist",
                             f"use one of: {', '.join(known)}", place=place)  # fmt: skip
    lower = known[asked.level] if asked.level else min(storeys, key=lambda lv: lv.elevation)
    above = [lv for lv in storeys if lv.elevation > lower.elevation + LOWEST]
    if not asked.to and not above:
        raise InputError(f"there is no level above '{lower.id}'",
                         "list it under levels, with its elevation", place=place)  # fmt: skip
    return lower, known[asked.to] if asked.to else min(above, key=lambda lv: lv.elevation)


def with_stairs(
    brief: Brief, spaces: Sequence[Space], storeys: Sequence[Level]
) -> tuple[Space, ...]:
    """Spaces with the ends and parts of the stairs in them."""
    found = stairs_of(brief, storeys)
    if not found:
        return tuple(spaces)
    floors = [shapely.Polygon(space.outline, space.holes) for space in spaces]
    entered = _entered(spaces, storeys)
    height = {level.id: level.elevation for level in storeys}
    rise = {s.id: height[s.upper] - height[s.level] for s in found}
    ends: list[list[StairEnd]] = [[] for _ in spaces]
    parts: list[list[StairPart]] = [[] for _ in spaces]
    for number, stairs in enumerate(found):
        place = f"stairs[{number}] '{stairs.name or stairs.id}'"
        for kind, end, level in (("foot", stairs.foot, stairs.level),
                                 ("head", stairs.head, stairs.upper)):  # fmt: skip
            room = _room_of(end, level, spaces, floors)
            if room is None:
                raise InputError(
                    f"the {kind} at ({end.x:.2f}, {end.y:.2f}) leads into no room of the level "
                    f"'{level}'", "move the stairs or turn them, or draw the room they lead into",
                    place=place,
                )  # fmt: skip
            arrival = height[level] > entered if kind == "head" else height[level] < entered
            ends[room].append(StairEnd(stairs.id, kind, *end, arrival))
        for level, boxes, kind in ((stairs.level, stairs.taken, "staircase"),
                                   (stairs.upper, stairs.open, "stairwell")):  # fmt: skip
            for room, part in _parts(stairs, boxes, kind, rise[stairs.id], level, spaces, floors):
                parts[room].append(part)
    return tuple(
        replace(space, stairs=tuple(e), stair_parts=tuple(p))
        for space, e, p in zip(spaces, ends, parts, strict=True)
    )


def _parts(
    stairs: Stairs, boxes: Sequence[Box], kind: str, rise: float, level: str,
    spaces: Sequence[Space], floors: Sequence[shapely.Polygon],
) -> Iterator[tuple[int, StairPart]]:  # fmt: skip
    """What stairs take of the floors of a level, where rooms have not been drawn round it; the
    first box holds the foot, the last the head."""
    main = 0 if kind == "staircase" else len(boxes) - 1
    name = stairs.id if kind == "staircase" else f"{stairs.id}/well"
    for k, box in enumerate(boxes):
        shape = shapely.Polygon(corners(np.array([box]))[0])
        shared = [
            floor.intersection(shape).area if space.level == level else 0.0
            for space, floor in zip(spaces, floors, strict=True)
        ]
        room = int(np.argmax(shared))
        if shared[room] > HERE * shape.area:
            part = name if k == main else f"{name}/{k + 1}"
            category = "staircase" if k == main else "obstacle"
            tall = min(rise, spaces[room].height) if kind == "staircase" else RAILING
            yield room, StairPart(part, category, tuple(box), tall)


def _room_of(
    end: End, level: str, spaces: Sequence[Space], floors: Sequence[shapely.Polygon]
) -> int | None:
    """The room one steps into."""
    way = np.array([np.cos(end.heading), np.sin(end.heading)])
    at = shapely.Point(np.array([end.x, end.y]) + BEYOND * way)
    inside = (k for k, floor in enumerate(floors) if spaces[k].level == level and floor.covers(at))
    return next(inside, None)


def _entered(spaces: Sequence[Space], storeys: Sequence[Level]) -> float:
    """The elevation of the level that is entered from outside: the lowest with a door to the
    outside, but a basement only if no other has one; else the lowest."""
    doors = {s.level for s in spaces for o in s.openings
             if o.kind != "window" and len(o.spaces) == 1}  # fmt: skip
    heights = sorted(level.elevation for level in storeys if level.id in doors)
    above = [height for height in heights if height >= BASEMENT]
    return next(iter(above or heights), min(level.elevation for level in storeys))
