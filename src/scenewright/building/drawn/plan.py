"""The plan of a drawing: its unit, its storeys, their rooms with doors and windows, as keys of a
brief, and what became of every entity. Plain values throughout, so that a process apart may do it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from shapely import Polygon, box, union_all

from scenewright.building.drawn.drawing import NO_LINES, Drawn, Segments
from scenewright.building.drawn.faces import Faces, entered_groups, find_faces, is_plan
from scenewright.building.drawn.layers import kind_of_layer
from scenewright.building.drawn.leaves import find_leaves
from scenewright.building.drawn.names import name_rooms
from scenewright.building.drawn.openings import Found, find_openings
from scenewright.building.drawn.sheet import Sheet
from scenewright.building.drawn.units import UnitFound, list_units
from scenewright.core.errors import InputError

STOREY = 2.8
"""Metres from floor to floor where storeys lie beside each other."""
SHARE = 0.3
"""Rooms that lie apart are a storey if they have this share of the floor of the largest."""
LEFT_ASIDE = {
    "other": "furniture, dimensions, notes or what lies above or below",
    "": "nothing that its layer says to be of the building",
}


class DrawnPlan(NamedTuple):
    """A drawing in metres with its unit, and the faces found in it."""

    drawn: Drawn
    unit: UnitFound
    faces: Faces


def plan_sheet(sheet: Sheet, scale: float = 1.0) -> dict[str, Any]:
    """The plan of a sheet: ``rooms`` and ``levels`` as keys of a brief, ``fates`` (rows of
    name, kind, outcome, reason, count), ``unit`` in words, ``drawn_floor`` and ``read_floor`` in
    m². ``scale`` multiplies the lengths of the stated unit, which then is taken as it is.

    Raises :class:`InputError` where the sheet holds no plan of a building.
    """
    chosen = choose_layers(sheet)
    plan = _marked_plan(sheet, chosen, scale) or _find_plan(sheet, chosen, scale)
    groups = _storeys(plan)
    if not groups:
        raise _no_plan(chosen)
    openings = find_openings(plan.drawn, plan.faces.rooms, plan.faces.gaps)
    rooms, levels = _rooms(plan, _names(sheet, plan), groups, openings)
    fates = [list(row) for row in _fates(sheet, plan, groups)]
    return {"rooms": rooms, "levels": levels, "fates": fates, **_measures(plan, groups)}


def choose_layers(sheet: Sheet) -> Drawn:
    """The drawing of a plan: lines of layers called walls, or of all that are not called anything
    else; doors and windows by their layers, arcs and words wherever they are."""
    kinds = _kinds(sheet)
    layers = sheet.layers
    named = {kind: [name for name in kinds if kinds[name] == kind] for kind in ("door", "window")}
    drawn = [name for name, kind in kinds.items() if kind not in ("other", "aside")]
    arcs = find_leaves([a for n in drawn for a in layers[n].arcs], _lines(sheet, drawn))
    return Drawn(
        _lines(sheet, [name for name, kind in kinds.items() if kind == "wall"]),
        _lines(sheet, named["door"]),
        _lines(sheet, named["window"]),
        arcs,
        tuple(word for layer in layers.values() for word in layer.words),
    )


def _kinds(sheet: Sheet) -> dict[str, str]:
    """What lies on each layer; those that say nothing hold walls where too few others do."""
    kinds = {name: kind_of_layer(name) for name in sheet.layers}
    lines = sum(len(sheet.layers[n].lines) for n, kind in kinds.items() if kind == "wall")
    silent = "wall" if lines < 8 else ""
    return {name: kind or silent for name, kind in kinds.items()}


def _lines(sheet: Sheet, names: list[str]) -> Segments:
    rows = [row for name in names for row in sheet.layers[name].lines]
    return np.array(rows).reshape(-1, 2, 2) if rows else NO_LINES


def _marked_plan(sheet: Sheet, chosen: Drawn, scale: float) -> DrawnPlan | None:
    """The plan of a file that Scenewright has written: its rooms are marked."""
    if not sheet.rooms:
        return None
    unit = UnitFound("m", (sheet.unit or 1.0) * scale, True)
    shift = np.vstack([points for _, _, points in sheet.rooms]).min(0)
    rooms = [Polygon((points - shift) * unit.metres) for _, _, points in sheet.rooms]
    if not all(room.is_valid and room.area > 0 for room in rooms):
        return None
    drawn = chosen.scaled(unit.metres, shift)
    found = find_faces(drawn)
    return DrawnPlan(drawn, unit, found._replace(rooms=rooms, around=[], small=[]))


def _find_plan(sheet: Sheet, chosen: Drawn, scale: float) -> DrawnPlan:
    """The plan in the first unit that makes one; with a scale, in the stated unit times it."""
    if not len(chosen.walls):
        raise _no_plan(chosen)
    stated = sheet.unit
    units = list_units(chosen, stated)
    if scale != 1.0:
        base = units[0].metres if units else stated or 1.0
        units = [UnitFound("as scaled", base * scale, False)]
    shift = chosen.walls.reshape(-1, 2).min(0)
    for unit in units:
        drawn = chosen.scaled(unit.metres, shift)
        found = find_faces(drawn)
        if is_plan(found, drawn):
            return DrawnPlan(drawn, unit, found)
    raise _no_plan(chosen)


def _no_plan(chosen: Drawn) -> InputError:
    size = np.ptp(chosen.walls.reshape(-1, 2), axis=0) if len(chosen.walls) else (0.0, 0.0)
    extent = f"{len(chosen.walls):,} lines, {size[0]:,.4g} x {size[1]:,.4g} units"
    return InputError(
        f"holds no floor plan: in no unit do its walls ({extent}) enclose rooms with doors",
        "give the plan of a storey, or its --scale",
    )


def _names(sheet: Sheet, plan: DrawnPlan) -> list[str]:
    if sheet.rooms:
        return [name for _, name, _ in sheet.rooms]
    return name_rooms(plan.drawn.words, plan.faces.rooms)


def _storeys(plan: DrawnPlan) -> list[list[int]]:
    """The rooms of each storey, from left to right: groups that lie apart, large enough."""
    rooms = plan.faces.rooms
    groups = entered_groups(plan.faces, plan.drawn)
    areas = [sum(rooms[k].area for k in group) for group in groups]
    kept = [g for g, area in zip(groups, areas, strict=True) if area >= SHARE * max(areas)]
    return sorted(kept, key=lambda group: min(rooms[k].bounds[0] for k in group))


def _rooms(
    plan: DrawnPlan, names: list[str], groups: list[list[int]], openings: list[Found]
) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Rooms and levels as keys of the brief; each storey begins at its own origin."""
    rooms: list[dict[str, Any]] = []
    levels = []
    for number, group in enumerate(groups):
        level = {"id": str(number), "elevation": number * STOREY}
        levels.append(level)
        low = np.min([plan.faces.rooms[k].bounds[:2] for k in group], axis=0)
        for k in group:
            room = _room(plan.faces.rooms[k], low)
            room |= {"id": f"room-{k + 1}", "name": names[k] or f"Room {k + 1}"}
            if len(groups) > 1:
                room["level"] = level["id"]
            mine = [o for o in openings if o.room == k]
            room["doors"] = [_moved(o.keys, low) for o in mine if o.kind == "door"]
            room["windows"] = [_moved(o.keys, low) for o in mine if o.kind == "window"]
            rooms.append(room)
    return rooms, levels if len(groups) > 1 else []


def _room(polygon: Polygon, low: np.ndarray) -> dict[str, Any]:
    rings = [
        np.round(np.asarray(ring.coords)[:-1] - low, 4).tolist()
        for ring in (polygon.exterior, *polygon.interiors)
    ]
    return {"outline": rings[0], "holes": rings[1:]}


def _moved(keys: dict[str, Any], low: np.ndarray) -> dict[str, Any]:
    return keys | {"at": np.round(np.array(keys["at"]) - low, 4).tolist()}


def _measures(plan: DrawnPlan, groups: list[list[int]]) -> dict[str, Any]:
    """The unit in words, and how much of the floor within the walls was read."""
    faces = plan.faces
    used = {k for group in groups for k in group}
    read_floor = sum(faces.rooms[k].area for k in used)
    reach = union_all([box(*faces.rooms[k].bounds) for k in used])
    lost = sum(face.area for face in faces.small if reach.contains(face))
    note = "as stated" if plan.unit.stated else "by walls and doors; the header is wrong or silent"
    return {
        "unit": f"{plan.unit.name} ({note})",
        "drawn_floor": read_floor + lost,
        "read_floor": read_floor,
    }


def _fates(
    sheet: Sheet, plan: DrawnPlan, groups: list[list[int]]
) -> Iterator[tuple[str, str, str, str, int]]:
    used = {k for group in groups for k in group}
    words = {"wall": "walls", "door": "doors", "window": "windows"}
    for name, kind in _kinds(sheet).items():
        for entity, count in sheet.layers[name].counts.items():
            lettered = entity in ("TEXT", "MTEXT", "ATTRIB")
            what = "words" if lettered else words.get(kind, "other lines")
            aside = not lettered and kind in LEFT_ASIDE
            yield (
                name,
                what,
                "left out" if aside else "used",
                LEFT_ASIDE.get(kind, "") * aside,
                count,
            )
    for number, face in enumerate(plan.faces.rooms):
        name = f"room {number + 1} ({face.area:.1f} m²)"
        aside = number not in used
        reason = "lies apart: another drawing" * aside
        yield name, "room", "left out" if aside else "used", reason, 1
    for face in plan.faces.around:
        yield f"{face.area:.0f} m²", "ground", "left out", "lies around the building", 1
