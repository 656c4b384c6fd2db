"""Doors, windows and bare openings of a building model, put on the walls of its rooms."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.building.outlines import project, run_lengths, wall_runs
from scenewright.building.outlines import rings as clean_rings
from scenewright.core.brief.input_report import Fate
from scenewright.formats.ifc.rooms import DrawnRoom, Row, floor_of
from scenewright.formats.sh3d.openings import open_sides

REACH = 0.35
"""How far from a room's outline an opening may be beyond half its wall, in metres."""
DOORS = ("IfcDoor", "IfcDoorStandardCase")
WINDOWS = ("IfcWindow", "IfcWindowStandardCase")
OPENINGS = {
    **dict.fromkeys(DOORS, "door"),
    **dict.fromkeys(WINDOWS, "window"),
    "IfcOpeningElement": "opening",
    "IfcOpeningStandardCase": "opening",
}
"""Plain names of entities that pierce walls; openings are those that nothing fills."""
STEP = 0.3
"""Height of an opening's lower edge up to which one walks through it, in metres."""


def place_openings(
    products: Sequence[Row], rooms: Sequence[DrawnRoom], made: list[Row], move: np.ndarray
) -> list[Fate]:
    """Doors and windows put into the nearest room of their height."""
    fates = []
    for row in products:
        kind, name = OPENINGS.get(row["kind"], ""), row["name"] or row["id"]
        if not kind:
            continue
        door = kind == "door"
        box = floor_of(row, move)
        number = _room_at(box, row, rooms) if box.area > 0 else None
        if number is None:
            fates.append(Fate(name, kind, "left out", "it is at no wall of a room", stands=door))
            continue
        opening = _opening(row, box, rooms[number])
        if opening is None:
            fates.append(Fate(name, kind, "left out", "it is narrower or lower than an opening"))
            continue
        if kind == "opening" and opening["low"] > STEP:
            fates.append(Fate(name, kind, "left out", "it is a niche or hole above the floor"))
            continue
        opening.pop("low", None)
        made[number]["windows" if kind == "window" else "doors"].append(opening)
        fates.append(Fate(name, kind, "used"))
    return fates


def add_open_sides(rooms: Sequence[DrawnRoom], made: list[Row]) -> None:
    """Open passages where two rooms of a level touch without a wall between them."""
    for level in sorted({room.level for room in rooms}):
        numbers = [k for k, room in enumerate(rooms) if room.level == level]
        floors = [rooms[k].floor for k in numbers]
        height = max(rooms[k].height for k in numbers)
        for entry in open_sides(floors, [], height):
            made[numbers[entry.room]]["doors"].append(entry.opening.model_dump())


def _room_at(box: shapely.Polygon, row: Row, rooms: Sequence[DrawnRoom]) -> int | None:
    """The nearest room whose height holds the middle of an opening."""
    middle = (row["low"] + row["high"]) / 2
    near = [
        (room.floor.exterior.distance(box), -room.floor.area, k)
        for k, room in enumerate(rooms)
        if room.low - 0.3 <= middle <= room.low + max(room.height, 2.2) + 0.3
    ]
    distance, _, number = min(near, default=(np.inf, 0.0, 0))
    return number if distance <= REACH else None


def _opening(row: Row, box: shapely.Polygon, room: DrawnRoom) -> Row | None:
    """An opening as a door or window of the brief; ``None`` where it is too small for one."""
    spot = _on_wall(box, room.floor)
    sill, head = max(row["low"] - room.low, 0.0), row["high"] - room.low
    if spot is None or head - sill < 0.3:
        return None
    at, width = spot
    common: Row = {"at": [round(float(v), 5) for v in at], "width": round(min(width, 20.0), 4)}
    if row["kind"] in WINDOWS:
        return common | {"sill": round(sill, 4), "height": round(head - sill, 4)}
    common["height"] = round(min(head, max(room.height, 0.5)), 4)
    if row["kind"] not in DOORS:
        return common | {"low": sill, "swing": "none"}
    sliding = "SLIDING" in row["operation"] or "FOLDING" in row["operation"]
    return common | {
        "swing": "slide" if sliding else "in",
        "hinge": "right" if "RIGHT" in row["operation"] else "left",
    }


def _on_wall(box: shapely.Polygon, floor: shapely.Polygon) -> tuple[np.ndarray, float] | None:
    """The middle and width of an opening on the stretch of outline it takes most of; ``None``
    where it takes less than 0.3 m of any."""
    corners, middle = shapely.get_coordinates(box), shapely.get_coordinates(box.centroid)[0]
    best: tuple[float, np.ndarray] | None = None
    for run in wall_runs(clean_rings(floor)[0]):
        place, away = project(run, middle)
        lengths = run_lengths(run)
        ahead = np.array(
            [[np.interp(place + t, lengths, run[:, k]) for k in (0, 1)] for t in (-0.1, 0.1)]
        )
        along = ahead[1] - ahead[0]
        if away > REACH + np.sqrt(box.area) or not along.any():
            continue
        spread = (corners - middle) @ (along / np.hypot(*along))
        low, high = np.clip((place + spread.min(), place + spread.max()), 0.0, lengths[-1])
        across = float(
            np.ptp((corners - middle) @ (np.array([-along[1], along[0]]) / np.hypot(*along)))
        )
        if away <= across / 2 + REACH and (best is None or high - low > best[0]):
            at = [np.interp((low + high) / 2, lengths, run[:, k]) for k in (0, 1)]
            best = (float(high - low), np.array(at))
    return (best[1], best[0]) if best is not None and best[0] >= 0.3 else None
