"""The plan of a drawing: its unit, its storeys, their rooms with doors and windows, as keys of a
brief, and what became of every entity. Plain values throughout, so that a process apart may do it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from shapely import Polygon

from scenewright.building.drawn.drawing import NO_LINES, Drawn, Segments
from scenewright.building.drawn.found_plan import DrawnPlan, find_plan, marked_plan
from scenewright.building.drawn.layers import kind_of_layer
from scenewright.building.drawn.leaves import find_leaves
from scenewright.building.drawn.names import name_rooms
from scenewright.building.drawn.sheet import Layer, Sheet
from scenewright.building.drawn.units import UnitFound, list_units

STOREY = 2.8
"""Metres from floor to floor where storeys lie beside each other."""
LEAST_TOLD = 0.5
"""Floor in m² that is told where no room has it."""
LEFT_ASIDE = {
    "mark": "furniture, dimensions or symbols: another pen than that of the walls",
    "aside": "a frame of the page, or a light fill",
    "other": "furniture, dimensions, notes or what lies above or below",
    "": "nothing that its layer says to be of the building",
}


def plan_sheet(sheet: Sheet, scale: float = 1.0) -> dict[str, Any]:
    """The plan of a sheet by the names of its layers: ``rooms`` and ``levels`` as keys of a brief,
    ``fates`` (rows of name, kind, outcome, reason, count), ``unit`` in words, ``drawn_floor`` and
    ``read_floor`` in m², ``place`` in m. ``scale`` multiplies the lengths of the stated unit, which
    then is taken as it is.

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
    plan = marked_plan(sheet, chosen, scale) or find_plan(sheet, chosen, units_of)
    rooms, levels = _rooms(plan, _names(sheet, plan))
    fates = [list(row) for row in _fates(sheet, kinds, plan)]
    return {"rooms": rooms, "levels": levels, "fates": fates, **_measures(plan)}


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


def _names(sheet: Sheet, plan: DrawnPlan) -> list[str]:
    if sheet.rooms:
        return [name for _, name, _ in sheet.rooms]
    return name_rooms(plan.drawn.words, plan.faces.rooms)


def _rooms(plan: DrawnPlan, names: list[str]) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Rooms and levels as keys of the brief; each storey begins at its own origin."""
    rooms: list[dict[str, Any]] = []
    levels = []
    for number, group in enumerate(plan.storeys):
        level = {"id": str(number), "elevation": number * STOREY}
        levels.append(level)
        low = np.min([plan.faces.rooms[k].bounds[:2] for k in group], axis=0)
        for k in group:
            room = _room(plan.faces.rooms[k], low)
            room |= {"id": f"room-{k + 1}", "name": names[k] or f"Room {k + 1}"}
            if len(plan.storeys) > 1:
                room["level"] = level["id"]
            mine = [o for o in plan.openings if o.room == k]
            room["doors"] = [_moved(o.keys, low) for o in mine if o.kind == "door"]
            room["windows"] = [_moved(o.keys, low) for o in mine if o.kind == "window"]
            rooms.append(room)
    return rooms, levels if len(plan.storeys) > 1 else []


def _room(polygon: Polygon, low: np.ndarray) -> dict[str, Any]:
    rings = [
        np.round(np.asarray(ring.coords)[:-1] - low, 4).tolist()
        for ring in (polygon.exterior, *polygon.interiors)
    ]
    return {"outline": rings[0], "holes": rings[1:]}


def _moved(keys: dict[str, Any], low: np.ndarray) -> dict[str, Any]:
    return keys | {"at": np.round(np.array(keys["at"]) - low, 4).tolist()}


def _measures(plan: DrawnPlan) -> dict[str, Any]:
    """The unit in words, how much of the floor that the walls span was read, and where the first
    storey lies in metres of the drawing."""
    note = "as stated" if plan.unit.stated else "by walls and doors, not as stated or not stated"
    low = np.min([plan.faces.rooms[k].bounds[:2] for k in plan.storeys[0]], axis=0)
    return {
        "place": np.round(low + plan.origin * plan.unit.metres, 4).tolist(),
        "unit": f"{plan.unit.name} ({note})",
        "drawn_floor": plan.floor + plan.missed,
        "read_floor": plan.floor,
    }


def _fates(
    sheet: Sheet, kinds: dict[str, str], plan: DrawnPlan
) -> Iterator[tuple[str, str, str, str, int]]:
    used = {k for group in plan.storeys for k in group}
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
    if plan.missed >= LEAST_TOLD:
        yield f"{plan.missed:.1f} m²", "floor", "left out", "its walls leave ways open", 1
    for face in plan.faces.around:
        yield f"{face.area:.0f} m²", "ground", "left out", "lies around the building", 1
