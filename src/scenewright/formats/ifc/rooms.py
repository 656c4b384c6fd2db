"""Rooms of a building model while it is read, and the floor a product covers in plan."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.core.brief.input_report import Fate

Row = dict[str, Any]
"""A product as :mod:`scenewright.formats.ifc.extract` gives it, or keys of a brief."""

LEAST_ROOM = 0.5
"""Floor in m² below which a space is no room."""
OUTSIDE = ("roof", "dach", "toit", "tejado", "cubierta", "屋根", "site", "plot")
"""Words of spaces that are no rooms."""
SPACE = "room (IfcSpace)"
WALLS = ("IfcWall", "IfcWallStandardCase", "IfcWallElementedCase", "IfcCurtainWall")
FILLING = ("IfcDoor", "IfcDoorStandardCase", "IfcWindow", "IfcWindowStandardCase")
REACHES = (0.02, 0.15)
"""Half the width in metres of gaps between walls that are closed, the first that encloses rooms."""
OVERLAP = 0.02
"""Floor in m² that two spaces may share."""
STEP = 0.1
"""Height in metres that two spaces above each other may share."""
WHOLE = ("GFA",)
"""Types of spaces that are areas of a whole storey."""


class DrawnRoom(NamedTuple):
    """A room with its floor in metres, the level it is on and the height of that floor."""

    row: Row
    floor: shapely.Polygon
    level: int
    low: float
    height: float


def floor_of(row: Row, move: np.ndarray) -> shapely.Polygon:
    """The outline of a product in plan."""
    if not row["rings"]:
        return shapely.Polygon()
    outline, *holes = (np.asarray(ring) - move for ring in row["rings"])
    return largest(shapely.Polygon(outline, holes).buffer(0))


def largest(region: shapely.Geometry) -> shapely.Polygon:
    """The largest polygon of a region."""
    parts = [part for part in shapely.get_parts(region) if part.geom_type == "Polygon"]
    return max(parts, key=lambda part: part.area, default=shapely.Polygon())


def find_rooms(document: Row, move: np.ndarray) -> tuple[list[DrawnRoom], list[Fate]]:
    """The rooms of a model by its spaces, else by its walls, and what became of each space."""
    found: list[tuple[DrawnRoom, str]] = []
    for row in document["products"]:
        if row["kind"] == "IfcSpace":
            floor = floor_of(row, move)
            height = min(row.get("high", 0.0) - row.get("low", 0.0), 100.0)
            room = DrawnRoom(row, floor, row["storey"], row.get("low", 0.0), height)
            found.append((room, _no_room(row, floor)))
    free = _part_overlaps([room for room, fault in found if not fault])
    rooms, fates = [], []
    for room, fault in found:
        row, floor = room.row, free.get(room.row["number"], shapely.Polygon())
        name = f"{row['name']} {row['long_name']}".strip() or row["id"]
        if fault or floor.area < room.floor.area / 2:
            lost = not fault
            why = fault or "other spaces take more than half of it"
            fates.append(Fate(name, SPACE, "left out", why, stands=lost))
            continue
        rooms.append(room._replace(floor=floor))
        cut = room.floor.area - floor.area > OVERLAP
        why = "less what another takes" * cut
        fates.append(Fate(name, SPACE, "changed" if cut else "used", why))
    if rooms:
        return rooms, fates
    return list(_enclosed(document, move)), fates


def _part_overlaps(rooms: Sequence[DrawnRoom]) -> dict[int, shapely.Polygon]:
    """The floor that each room has for itself, by its number: where two overlap the smaller has
    it."""
    free: dict[int, shapely.Polygon] = {}
    done: list[DrawnRoom] = []
    for room in sorted(rooms, key=lambda one: one.floor.area):
        others = [
            other.floor
            for other in done
            if other.level == room.level
            and min(other.low + other.height, room.low + room.height)
            > max(other.low, room.low) + STEP
        ]
        floor = room.floor
        taken = shapely.union_all([other for other in others if other.intersects(floor)])
        if floor.intersection(taken).area > OVERLAP / 2:
            floor = largest(floor.difference(taken))
        free[room.row["number"]] = floor
        done.append(room)
    return free


def _no_room(row: Row, floor: shapely.Polygon) -> str:
    """Why a space is no room; empty if it is one."""
    if is_outside(row):
        return "by its name it is no room"
    if row["operation"] in WHOLE:
        return "it is the area of a storey"
    if floor.area < LEAST_ROOM:
        return "it has no body, or less than half a square metre of floor"
    return ""


def is_outside(row: Row) -> bool:
    """Whether a space by its name is none that is lived in."""
    words = f"{row['name']} {row['long_name']} {row['use']}".casefold().split()
    return any(word.strip(":,.") in OUTSIDE for word in words)


def _enclosed(document: Row, move: np.ndarray) -> Iterator[DrawnRoom]:
    """What the walls of each storey enclose, doors and windows where they leave gaps; where that is
    nothing, gaps as wide as a wall is thick are closed as well."""
    products = [row for row in document["products"] if row["rings"]]
    walls = [row for row in products if row["kind"] in WALLS]
    for number in sorted({row["storey"] for row in walls}):
        mine = [row for row in walls if row["storey"] == number]
        filled = [r for r in products if r["storey"] == number and r["kind"] in FILLING]
        shapes = [floor_of(row, move) for row in (*mine, *filled)]
        low = float(np.median([row["low"] for row in mine]))
        height = float(np.median([row["high"] - row["low"] for row in mine]))
        floors = next(filter(None, (_rings_within(shapes, reach) for reach in REACHES)), [])
        for floor in floors:
            yield DrawnRoom({}, floor, number, low, min(max(height, 0.5), 100.0))


def _rings_within(shapes: Sequence[shapely.Polygon], reach: float) -> list[shapely.Polygon]:
    """The floors that shapes enclose, those closer than twice ``reach`` joined."""
    solid = shapely.union_all([shape.buffer(reach, join_style="mitre") for shape in shapes])
    rings = [
        ring
        for part in shapely.get_parts(solid)
        if part.geom_type == "Polygon"
        for ring in part.interiors
    ]
    floors = [largest(shapely.Polygon(r).buffer(reach, join_style="mitre")) for r in rings]
    return [floor for floor in floors if floor.area >= LEAST_ROOM]
