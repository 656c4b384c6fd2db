"""Plans drawn in CAD: rooms, doors and windows of a DXF file as a brief (extra ``dxf``).

Walls may be double or single lines, polylines, hatches or blocks, on layers called anything in any
language; the unit is that of the header where it makes a building, else the one that does. Rooms
are what lines enclose once gaps are closed; several storeys may lie beside each other. What was
read and what was left aside is in the input report. Plans written by Scenewright are read as they
were.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from pydantic import ValidationError
from shapely import Polygon, box, union_all

from scenewright.building.drawn.drawing import NO_LINES, Drawn, Segments
from scenewright.building.drawn.faces import Faces, find_faces, group_rooms, is_plan
from scenewright.building.drawn.layers import kind_of_layer
from scenewright.building.drawn.leaves import find_leaves
from scenewright.building.drawn.names import name_rooms
from scenewright.building.drawn.openings import Found, find_openings
from scenewright.building.drawn.units import UnitFound, list_units
from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import Fate, report_input
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError
from scenewright.formats.dxf.entities import Entities, read_entities

STOREY = 2.8
"""Metres from floor to floor where storeys lie beside each other."""
SHARE = 0.3
"""Rooms that lie apart are a storey if they have this share of the floor of the largest."""
OPENING, MOST_MISFITS = re.compile(r"rooms\[(\d+)\].*?(doors|windows)\[(\d+)\]"), 60
"""How a fault names an opening, and how many are taken out."""
LEFT_ASIDE = {
    "other": "furniture, dimensions, notes or what lies above or below",
    "": "nothing that its layer says to be of the building",
}


class DrawnPlan(NamedTuple):
    """A drawing in metres with its unit, and the faces found in it."""

    drawn: Drawn
    unit: UnitFound
    faces: Faces


def read(path: str | os.PathLike[str], keep: bool = False, scale: float = 1.0) -> Brief:
    """The brief of a plan; ``keep`` changes nothing: furniture in drawings is left aside.
    ``scale`` multiplies the lengths of the stated unit, which then is taken as it is.

    Raises :class:`InputError` where the file holds no plan of a building, or none can be read.
    """
    del keep
    entities = read_entities(path)
    chosen = choose_layers(entities)
    plan = _marked_plan(entities, chosen, scale) or _find_plan(entities, chosen, scale)
    names = _names(entities, plan)
    groups = _storeys(plan)
    if not groups:
        raise _no_plan(chosen)
    openings = find_openings(plan.drawn, plan.faces.rooms, plan.faces.gaps)
    rooms, levels = _rooms(plan, names, groups, openings)
    name = os.path.splitext(os.path.basename(path))[0][:80]
    document = {"name": name, "levels": levels, "rooms": rooms}
    fates = [*_fates(entities, plan, groups), *_drop_misfits(document)]
    try:
        return Brief.model_validate(document | {"input_report": _report(fates, plan, groups)})
    except ValidationError as error:
        raise to_input_error(error) from None


def _drop_misfits(document: dict[str, Any]) -> list[Fate]:
    """Take out the openings that no wall has room for, as the plan of the brief finds them; the
    fates of all openings."""
    from scenewright.domains import plan_of

    fates = []
    for _ in range(MOST_MISFITS):
        try:
            plan_of(Brief.model_validate(document))
            break
        except InputError as error:
            place = OPENING.search(error.place)
            if place is None:
                raise
            room, kind, number = int(place[1]), place[2], int(place[3])
            del document["rooms"][room][kind][number]
            fates.append(Fate(f"in room {room + 1}", kind[:-1], "left out", error.fault))
        except ValidationError as error:
            raise to_input_error(error) from None
    kept = [
        (r, kind, k) for r in document["rooms"] for kind in ("doors", "windows") for k in r[kind]
    ]
    return fates + [Fate(room["name"], kind[:-1], "used") for room, kind, _ in kept]


def choose_layers(entities: Entities) -> Drawn:
    """The drawing of a plan: lines of layers called walls, or of all that are not called anything
    else; doors and windows by their layers, arcs and words wherever they are."""
    kinds = _kinds(entities)
    layers = entities.layers
    named = {kind: [name for name in kinds if kinds[name] == kind] for kind in ("door", "window")}
    drawn = [name for name, kind in kinds.items() if kind not in ("other", "aside")]
    arcs = find_leaves([a for n in drawn for a in layers[n].arcs], _lines(entities, drawn))
    return Drawn(
        _lines(entities, [name for name, kind in kinds.items() if kind == "wall"]),
        _lines(entities, named["door"]),
        _lines(entities, named["window"]),
        arcs,
        tuple(word for layer in layers.values() for word in layer.words),
    )


def _kinds(entities: Entities) -> dict[str, str]:
    """What lies on each layer; those that say nothing hold walls where too few others do."""
    kinds = {name: kind_of_layer(name) for name in entities.layers}
    lines = sum(len(entities.layers[n].lines) for n, kind in kinds.items() if kind == "wall")
    silent = "wall" if lines < 8 else ""
    return {name: kind or silent for name, kind in kinds.items()}


def _lines(entities: Entities, names: list[str]) -> Segments:
    rows = [row for name in names for row in entities.layers[name].lines]
    return np.array(rows).reshape(-1, 2, 2) if rows else NO_LINES


def _marked_plan(entities: Entities, chosen: Drawn, scale: float) -> DrawnPlan | None:
    """The plan of a file that Scenewright has written: its rooms are marked."""
    if not entities.rooms:
        return None
    unit = UnitFound("m", (entities.unit or 1.0) * scale, True)
    shift = np.vstack([points for _, _, points in entities.rooms]).min(0)
    rooms = [Polygon((points - shift) * unit.metres) for _, _, points in entities.rooms]
    if not all(room.is_valid and room.area > 0 for room in rooms):
        return None
    drawn = chosen.scaled(unit.metres, shift)
    found = find_faces(drawn)
    return DrawnPlan(drawn, unit, found._replace(rooms=rooms, around=[], small=[]))


def _find_plan(entities: Entities, chosen: Drawn, scale: float) -> DrawnPlan:
    """The plan in the first unit that makes one; with a scale, in the stated unit times it."""
    if not len(chosen.walls):
        raise _no_plan(chosen)
    stated = entities.unit
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


def _names(entities: Entities, plan: DrawnPlan) -> list[str]:
    if entities.rooms:
        return [name for _, name, _ in entities.rooms]
    return name_rooms(plan.drawn.words, plan.faces.rooms)


def _storeys(plan: DrawnPlan) -> list[list[int]]:
    """The rooms of each storey, from left to right: groups that lie apart and are large enough."""
    rooms = plan.faces.rooms
    groups = group_rooms(rooms)
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


def _report(fates: list[Fate], plan: DrawnPlan, groups: list[list[int]]) -> dict[str, Any]:
    """What became of every entity, and how much of the floor within the walls was read."""
    faces = plan.faces
    used = {k for group in groups for k in group}
    read_floor = sum(faces.rooms[k].area for k in used)
    reach = union_all([box(*faces.rooms[k].bounds) for k in used])
    lost = [face for face in faces.small if reach.contains(face)]
    note = "as stated" if plan.unit.stated else "by walls and doors; the header is wrong or silent"
    report = report_input(
        fates,
        format="DXF",
        unit=f"{plan.unit.name} ({note})",
        drawn_floor=read_floor + sum(face.area for face in lost),
        read_floor=read_floor,
    )
    return report.model_dump()


def _fates(entities: Entities, plan: DrawnPlan, groups: list[list[int]]) -> Iterator[Fate]:
    used = {k for group in groups for k in group}
    words = {"wall": "walls", "door": "doors", "window": "windows"}
    for name, kind in _kinds(entities).items():
        layer = entities.layers[name]
        for entity, count in layer.counts.items():
            lettered = entity in ("TEXT", "MTEXT", "ATTRIB")
            what = "words" if lettered else words.get(kind, "other lines")
            row = Fate(name, what, "used")
            if not lettered and kind in LEFT_ASIDE:
                row = Fate(name, what, "left out", LEFT_ASIDE[kind])
            yield from [row] * count
    for number, face in enumerate(plan.faces.rooms):
        name = f"room {number + 1} ({face.area:.1f} m²)"
        reason = "" if number in used else "lies apart and is small: another drawing"
        yield Fate(name, "room", "used" if number in used else "left out", reason)
    for face in plan.faces.around:
        yield Fate(f"{face.area:.0f} m²", "ground", "left out", "lies around the building")
