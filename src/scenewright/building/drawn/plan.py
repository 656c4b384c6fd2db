"""The plan of a drawing: its unit, its storeys, their rooms with doors and windows, as keys of a
brief, and what became of every entity. Plain values throughout, so that a process apart may do it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from shapely import Geometry, Polygon, box, union_all
from shapely.affinity import affine_transform

from scenewright.building.drawn.drawing import NO_LINES, Drawn, Segments
from scenewright.building.drawn.faces import (
    Faces,
    entered_groups,
    find_faces,
    is_plan,
    without_solid,
)
from scenewright.building.drawn.layers import kind_of_layer
from scenewright.building.drawn.leaves import find_leaves
from scenewright.building.drawn.names import name_rooms
from scenewright.building.drawn.openings import Found, find_openings
from scenewright.building.drawn.sheet import Layer, Sheet
from scenewright.building.drawn.units import UnitFound, list_units
from scenewright.core.errors import InputError

STOREY = 2.8
"""Metres from floor to floor where storeys lie beside each other."""
SHARE = 0.3
"""Rooms that lie apart are a storey if they have this share of the floor of the largest."""
LEFT_ASIDE = {
    "mark": "furniture, dimensions or symbols: another pen than that of the walls",
    "aside": "a frame of the page, or a light fill",
    "other": "furniture, dimensions, notes or what lies above or below",
    "": "nothing that its layer says to be of the building",
}


class DrawnPlan(NamedTuple):
    """A drawing in metres with its unit, and the faces found in it."""

    drawn: Drawn
    unit: UnitFound
    faces: Faces


def plan_sheet(sheet: Sheet, scale: float = 1.0) -> dict[str, Any]:
    """The plan of a sheet by the names of its layers: ``rooms`` and ``levels`` as keys of a brief,
    ``fates`` (rows of name, kind, outcome, reason, count), ``unit`` in words, ``drawn_floor`` and
    ``read_floor`` in m². ``scale`` multiplies the lengths of the stated unit, which then is taken
    as it is.

    Raises :class:`InputError` where the sheet holds no plan of a building.
    """
    return plan_layers(
        sheet, kinds_by_name(sheet), lambda drawn: _scaled_units(drawn, sheet.unit, scale), scale
    )


def plan_layers(
    sheet: Sheet,
    kinds: dict[str, str],
    units_of: Callable[[Drawn], list[UnitFound]],
    scale: float = 1.0,
) -> dict[str, Any]:
    """The plan of a sheet whose layers hold the ``kinds`` (wall, door, window, mark, other, aside
    or nothing known), in the first unit that makes one."""
    chosen = choose_layers(sheet, kinds)
    plan = _marked_plan(sheet, chosen, scale) or _find_plan(chosen, sheet.solid, units_of)
    groups = _storeys(plan)
    openings = find_openings(plan.drawn, plan.faces.rooms, plan.faces.gaps)
    rooms, levels = _rooms(plan, _names(sheet, plan), groups, openings)
    fates = [list(row) for row in _fates(sheet, kinds, plan, groups)]
    return {"rooms": rooms, "levels": levels, "fates": fates, **_measures(plan, groups)}


def _scaled_units(drawn: Drawn, stated: float | None, scale: float) -> list[UnitFound]:
    units = list_units(drawn, stated)
    if scale == 1.0:
        return units
    base = units[0].metres if units else stated or 1.0
    return [UnitFound("as scaled", base * scale, False)]


def choose_layers(sheet: Sheet, kinds: dict[str, str]) -> Drawn:
    """The drawing of a plan by what its layers hold; words are taken wherever they are."""
    layers = sheet.layers
    drawn = [name for name in layers if kinds[name] not in ("other", "aside")]
    arcs = find_leaves([a for n in drawn for a in layers[n].arcs], _lines(layers, drawn))
    walls, doors, windows, marks = (
        _lines(layers, [name for name in layers if kinds[name] == kind])
        for kind in ("wall", "door", "window", "mark")
    )
    words = tuple(word for layer in layers.values() for word in layer.words)
    return Drawn(walls, doors, windows, arcs, words, marks)


def kinds_by_name(sheet: Sheet) -> dict[str, str]:
    """What lies on each layer; those that say nothing hold walls where too few others do."""
    kinds = {name: kind_of_layer(name) for name in sheet.layers}
    lines = sum(len(sheet.layers[n].lines) for n, kind in kinds.items() if kind == "wall")
    silent = "wall" if lines < 8 else ""
    return {name: kind or silent for name, kind in kinds.items()}


def _lines(layers: dict[str, Layer], names: list[str]) -> Segments:
    rows = [row for name in names for row in layers[name].lines]
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


def _find_plan(
    chosen: Drawn, solid: Geometry | None, units_of: Callable[[Drawn], list[UnitFound]]
) -> DrawnPlan:
    """The plan in the first unit that makes one; no room lies within what is solid."""
    shift = chosen.walls.reshape(-1, 2).min(0) if len(chosen.walls) else np.zeros(2)
    for unit in units_of(chosen) if len(chosen.walls) else ():
        drawn = chosen.scaled(unit.metres, shift)
        found = find_faces(drawn)
        if solid is not None:
            moved = affine_transform(solid, [k := unit.metres, 0, 0, k, *(-k * shift)])
            found = without_solid(found, moved)
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
    note = "as stated" if plan.unit.stated else "by walls and doors, not as stated or not stated"
    return {
        "unit": f"{plan.unit.name} ({note})",
        "drawn_floor": read_floor + lost,
        "read_floor": read_floor,
    }


def _fates(
    sheet: Sheet, kinds: dict[str, str], plan: DrawnPlan, groups: list[list[int]]
) -> Iterator[tuple[str, str, str, str, int]]:
    used = {k for group in groups for k in group}
    words = {"wall": "walls", "door": "doors", "window": "windows"}
    for name, kind in kinds.items():
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
