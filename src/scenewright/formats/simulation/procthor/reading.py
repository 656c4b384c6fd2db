"""A house of ProcTHOR, of Holodeck or of ours as a brief.

Where floors of rooms meet without a wall between them, their outlines are the middle of walls.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from math import pi, remainder, tau
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from pydantic import ValidationError

from scenewright.building.room_names import functions_from_name
from scenewright.catalog.kinds import KINDS
from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import Fate, report_input
from scenewright.core.document_faults import to_input_error
from scenewright.formats.simulation.procthor.document import (
    DEEPEST,
    Corner,
    House,
    HouseHole,
    HouseObject,
    HouseRoom,
    HouseWall,
    OwnWords,
    children_of,
    load_house,
)
from scenewright.formats.simulation.procthor.words import FUNCTIONS, category_of_type

Row = dict[str, Any]
ANEW = "planned anew"
TOUCHING = 1e-3
"""Floors nearer to each other than this, in metres, share the middle line of a wall."""
WALL = 0.1
"""Thickness of walls that are drawn without, in metres."""
LEAST = 0.02
"""Least side of an object, in metres."""


def read_house(path: Path, keep: bool = False) -> Brief:
    """The brief of a house; ``keep`` leaves its objects where they stand."""
    house = load_house(path)
    levels = {room.id: _storey(room) for room in house.rooms}
    fates: list[Fate] = [Fate(room.id, "room", "used") for room in house.rooms]
    rooms = {room.id: _room(room, house, levels) for room in house.rooms}
    fates += _add_openings(house, rooms)
    fates += _add_objects(house, rooms, levels, keep)
    try:
        brief = Brief.model_validate(
            {
                "name": path.name.partition(".")[0][:80],
                "levels": [
                    {"id": str(z), "elevation": z, "height": _height(house, z)}
                    for z in sorted(set(levels.values()))
                ],
                "rooms": [*rooms.values()],
                **_outlines(house, levels),
            }
        )
    except ValidationError as error:
        raise to_input_error(error) from None
    area = sum(shapely.Polygon(room["outline"]).area for room in rooms.values())
    report = report_input(
        fates,
        format="ProcTHOR house",
        system="its own; z of the file is y here",
        unit="metre",
        drawn_floor=round(area, 3),
        read_floor=round(area, 3),
    )
    return brief.model_copy(update={"input_report": report})


def _plan(point: Corner) -> tuple[float, float]:
    return point.x, point.z


def _storey(room: HouseRoom) -> float:
    """The height of a floor, which stands for its level."""
    return round(min(point.y for point in room.floor_polygon), 3)


def _height(house: House, floor: float) -> float:
    """The highest wall of a level, 2.6 m where none is drawn."""
    tops = (
        max(point.y for point in wall.polygon) - floor
        for wall in house.walls
        if abs(min(point.y for point in wall.polygon) - floor) < TOUCHING
    )
    return round(max(max(tops, default=2.6), 1.0), 4)


def _outlines(house: House, levels: Mapping[str, float]) -> Row:
    """Whether outlines are inner faces of walls or their middle lines."""
    floors = [
        (levels[room.id], shapely.Polygon([_plan(p) for p in room.floor_polygon]))
        for room in house.rooms
    ]
    shared = any(a.distance(b) < TOUCHING for (i, a), (j, b) in combinations(floors, 2) if i == j)
    return {"outlines": "centre", "wall_thickness": WALL} if shared else {"outlines": "inner"}


def _room(room: HouseRoom, house: House, levels: Mapping[str, float]) -> Row:
    """A room as keys of the brief."""
    own = room.own
    function = FUNCTIONS.get(room.room_type)
    functions = own.functions or ([function] if function else [])
    if not functions and room.room_type:
        functions = [*functions_from_name(room.room_type)]
    tops = [p.y for wall in house.walls if wall.room_id == room.id for p in wall.polygon]
    height = max(tops, default=0.0) - levels[room.id]
    return {
        "id": own.id or room.id,
        "name": (own.name or room.room_type or room.id)[:80],
        **({"function": functions} if functions else {}),
        "level": str(levels[room.id]),
        "outline": [_plan(point) for point in room.floor_polygon],
        **({"height": round(height, 4)} if height >= 1.0 else {}),
        "doors": [],
        "windows": [],
        "fixed": [],
    }


def _add_openings(house: House, rooms: Mapping[str, Row]) -> Iterator[Fate]:
    """Doors, windows, and walls that are only a gap, each in the first of its rooms."""
    walls = {wall.id: wall for wall in house.walls}
    for kind, holes in (("door", house.doors), ("window", house.windows)):
        for hole in holes:
            wall = walls.get(hole.wall0 or "")
            room = rooms.get(hole.room0 or "") or rooms.get(wall.room_id if wall else "")
            if wall is None or room is None or len(hole.corners) < 2:
                reason = "it is in no wall of a room"
                yield Fate(hole.id, kind, "left out", reason, stands=kind == "door")
                continue
            row = _opening(hole, wall)
            if kind == "window":
                sill = min(point.y for point in hole.corners)
                room["windows"].append(row | {"sill": round(max(sill, 0.0), 4)})
            else:
                room["doors"].append(row | _door(hole, rooms))
            yield Fate(hole.id, kind, "used")
    yield from _add_gaps(house, rooms)


def _opening(hole: HouseHole, wall: HouseWall) -> Row:
    """The middle of a hole in plan, its width and height."""
    start, end = (np.array(_plan(point)) for point in wall.polygon[:2])
    across, up = ([getattr(point, axis) for point in hole.corners] for axis in "xy")
    way = (end - start) / max(float(np.linalg.norm(end - start)), 1e-9)
    at = start + (min(across) + max(across)) / 2 * way
    name = hole.own.id if hole.own else ""
    return {
        "id": name or hole.id,
        "at": tuple(at.tolist()),
        "width": round(max(across) - min(across), 4),
        "height": round(max(up) - min(up), 4),
    }


def _door(hole: HouseHole, rooms: Mapping[str, Row]) -> Row:
    """How a door opens, and where to."""
    frame = hole.asset_id.startswith("Doorframe")
    own = hole.own or OwnWords(swing="none" if frame else "in")
    beyond = rooms.get(hole.room1 or "") if hole.room1 != hole.room0 else None
    return {"hinge": own.hinge, "swing": own.swing, **({"to": beyond["id"]} if beyond else {})}


def _add_gaps(house: House, rooms: Mapping[str, Row]) -> Iterator[Fate]:
    """A passage for each gap between two rooms; of its two sides the first is read."""
    seen: set[frozenset[tuple[float, ...]]] = set()
    for wall in (wall for wall in house.walls if wall.empty):
        ends = [_plan(point) for point in wall.polygon[:2]]
        place = frozenset((round(x, 3), round(y, 3)) for x, y in ends)
        width = float(np.linalg.norm(np.subtract(ends[0], ends[1])))
        if wall.room_id not in rooms or place in seen or not 0.3 <= width <= 20.0:
            yield Fate(wall.id, "open wall", "left out", "the same as its other side, or no gap")
            continue
        seen.add(place)
        high = max(p.y for p in wall.polygon) - min(p.y for p in wall.polygon)
        row = {"id": wall.id, "at": tuple(np.mean(ends, axis=0).tolist()), "swing": "none"}
        rooms[wall.room_id]["doors"].append(
            row | {"width": round(width - 2 * WALL, 4), "height": round(high or 2.05, 4)}
        )
        yield Fate(wall.id, "open wall", "changed", "read as a passage")


def _add_objects(
    house: House, rooms: Mapping[str, Row], levels: Mapping[str, float], keep: bool
) -> Iterator[Fate]:
    """Objects as fixed items of the rooms they stand in, or a line that they are planned anew."""
    floors = [(name, shapely.Polygon(room["outline"])) for name, room in rooms.items()]
    for one, bearer in _every(house.objects, None, DEEPEST):
        if not keep:
            yield Fate(one.id, "object", "left out", ANEW)
            continue
        point = shapely.Point(_plan(one.position))
        near = [
            (floor.distance(point), abs(one.position.y - levels[name]), name)
            for name, floor in floors
            if one.position.y > levels[name] - 0.1
        ]
        if not near or min(near)[0] > WALL:
            yield Fate(one.id, "object", "left out", "it stands in no room")
            continue
        name = min(near)[2]
        rooms[name]["fixed"].append(_item(one, bearer, levels[name]))
        yield Fate(one.id, "object", "used")


def _every(
    objects: Sequence[HouseObject], bearer: HouseObject | None, deep: int
) -> Iterator[tuple[HouseObject, HouseObject | None]]:
    """All objects, each with the one it stands on."""
    for one in objects:
        yield one, bearer
        if deep:
            yield from _every(children_of(one), one, deep - 1)


def _item(one: HouseObject, bearer: HouseObject | None, floor: float) -> Row:
    """An object as a fixed item. Theirs have no size: it is the usual one of their kind;
    on the floor they are twice as high as their middle."""
    own = one.own or OwnWords()
    category = own.category or category_of_type(one.id.partition("|")[0])
    kind = KINDS.get(category)
    usual = kind.sizes[1] if kind and kind.sizes else (0.5, 0.5, 0.5)
    middle = one.position.y - floor
    width, depth, height = own.size or (*usual[:2], usual[2] if bearer else max(2 * middle, LEAST))
    base = max(middle - height / 2, 0.0)
    heading = remainder(pi / 2 - np.deg2rad(one.rotation.y), tau)
    return {
        "id": own.id or one.id,
        "name": one.id,
        "category": category if kind or own.category else "obstacle",
        "at": _plan(one.position),
        "heading": heading,
        "size": (width, depth, height),
        "z": round(base, 4) if base > TOUCHING else 0.0,
        **({"on": _id(bearer)} if bearer else {}),
        **({"group": own.group} if own.group else {}),
        **({"function": own.function} if own.function else {}),
        **({"asset": own.asset} if own.asset else {}),
    }


def _id(one: HouseObject) -> str:
    return (one.own.id if one.own else "") or one.id
