"""Sweet Home 3D: a home drawn in that program, as a brief.

Reads ``.sh3d`` archives and bare ``Home.xml`` files: levels, rooms, walls, doors, windows and
furniture. Movable furniture and kitchen units (of which that program calls only some movable)
are taken out, to be placed anew; what else is built in stays.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from pydantic import ValidationError

from scenewright.building import outlines
from scenewright.building.room_names import functions_from_name
from scenewright.core.brief import Brief, LevelBrief, WallBrief
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError
from scenewright.formats.sh3d_archive import home_xml
from scenewright.formats.sh3d_floors import DrawnFloor, floors
from scenewright.formats.sh3d_openings import is_door, open_sides, place_openings
from scenewright.formats.sh3d_pieces import (
    assign_to_floors,
    fixed_item,
    flatten_groups,
    function_from_pieces,
    stays,
)
from scenewright.formats.sh3d_xml import Home, HomeLevel, HomePiece, middle_line, parse

BEDROOM = 7.0
MOST_HELD = 2000
"""Pieces of furniture in one room."""


def read(path: Path, keep: bool = False, hidden_levels: bool = False) -> Brief:
    """The brief of a home; ``keep`` leaves movable furniture where it is, as fixed items;
    ``hidden_levels`` includes the levels that are hidden."""
    return brief_of(parse(home_xml(path)), keep, hidden_levels)


def brief_of(home: Home, keep: bool = False, hidden_levels: bool = False) -> Brief:
    """The brief of a parsed home. Hidden levels (roofs, but also floors that were not looked at
    when the home was saved) are left out unless asked for; its notes name those with rooms."""
    chosen = [level for level in home.levels if level.visible or hidden_levels]
    if home.levels and not chosen:
        raise InputError("all its levels are hidden", "show them, or add --hidden-levels")
    levels = chosen or [_only(home)]
    home = _with_levels(home, levels)
    rooms = [room for level in levels for room in _rooms(home, level, keep)]
    if not rooms:
        raise InputError(
            "has no room: none is drawn and the walls enclose none", "draw rooms or close the walls"
        )
    used = {room["level"] for room in rooms}
    try:
        return Brief.model_validate(
            {
                "name": home.name,
                "levels": [_level_brief(level) for level in levels if level.id in used],
                "rooms": rooms,
                "walls": [wall for wall in _walls(home) if wall.level in used],
                "wall_thickness": _usual_thickness(home, 0.12, np.median),
                "outer_wall_thickness": _usual_thickness(home, 0.25, np.max),
                "notes": _hidden_notes(
                    home, [level for level in home.levels if level not in levels]
                ),
            }
        )
    except ValidationError as error:
        raise to_input_error(error) from None


def _hidden_notes(home: Home, hidden: list[HomeLevel]) -> list[str]:
    """A line for each hidden level on which there is floor."""
    notes = []
    for level in hidden:
        there = floors(home, level.id)
        if there:
            name, area = level.name[:80] or level.id[:80], sum(f.polygon.area for f in there)
            rooms = f"{len(there)} room{'s' * (len(there) != 1)}, {area:.0f} m²"
            notes.append(
                f"the level '{name}' ({rooms}) is hidden in Sweet Home 3D and was not "
                "read; add --hidden-levels to include it"
            )
    return notes


def _rooms(home: Home, level: HomeLevel, keep: bool) -> list[dict[str, Any]]:
    """The rooms of a level as keys of the brief."""
    found = floors(home, level.id)
    pieces = [piece for piece in flatten_groups(home.pieces) if piece.level == level.id]
    rings = [outlines.rings(floor.polygon) for floor in found]
    openings = [piece for piece in pieces if piece.kind == "doorOrWindow"]
    placed = place_openings(openings, [outline for outline, _ in rings])
    placed += open_sides([floor.polygon for floor in found], placed, level.height)
    furniture = [piece for piece in pieces if piece.kind != "doorOrWindow"]
    inside = assign_to_floors(furniture, [floor.polygon for floor in found])
    _check_held(inside, found)
    functions = _functions(found, inside, [piece for piece in openings if is_door(piece)])
    rooms = []
    for number, (outline, holes) in enumerate(rings):
        mine = [entry.opening for entry in placed if entry.room == number]
        rooms.append(
            {
                "name": found[number].name or f"Room {number + 1}",
                "function": list(functions[number]),
                "level": level.id,
                "outline": outline.tolist(),
                "holes": [hole.tolist() for hole in holes],
                "doors": [opening for opening in mine if not hasattr(opening, "sill")],
                "windows": [w for w in mine if hasattr(w, "sill") and w.sill < level.height - 0.05],
                "fixed": [
                    fixed_item(p)
                    for p in inside[number]
                    if (keep or stays(p)) and p.z < level.height - 0.05
                ],
            }
        )
    return rooms


def _check_held(inside: list[list[HomePiece]], found: list[DrawnFloor]) -> None:
    """No room holds more pieces than a brief may list."""
    for pieces, floor in zip(inside, found, strict=True):
        if len(pieces) > MOST_HELD:
            raise InputError(
                f"holds {len(pieces):,} pieces of furniture",
                f"at most {MOST_HELD:,} are read",
                place=floor.name,
            )


def _functions(
    found: list[DrawnFloor], inside: list[list[HomePiece]], doors: list[HomePiece]
) -> list[tuple[str, ...]]:
    """By the room's name, else what stands there, else a hall if it has three doors, else (where
    no room is named) by size."""
    known = [
        functions_from_name(floor.name)
        if floor.name
        else function_from_pieces(pieces) or _hall(floor, doors)
        for floor, pieces in zip(found, inside, strict=True)
    ]
    if any(floor.name for floor in found):
        return [functions or ("other",) for functions in known]
    areas = [floor.polygon.area if not f else 0.0 for floor, f in zip(found, known, strict=True)]
    lived = any("living" in functions for functions in known)
    largest = int(np.argmax(areas)) if areas and not lived else -1
    return [
        functions
        or (("living",) if i == largest else ("bedroom",) if areas[i] >= BEDROOM else ("other",))
        for i, functions in enumerate(known)
    ]


def _hall(floor: DrawnFloor, doors: list[HomePiece]) -> tuple[str, ...]:
    if not doors:
        return ()
    points = shapely.points([(door.x, door.y) for door in doors])
    near = np.flatnonzero(shapely.distance(floor.polygon, points) < 0.3)
    return ("hall",) if len(near) >= 3 else ()


def _only(home: Home) -> HomeLevel:
    return HomeLevel("0", "", 0.0, home.wall_height, True)


def _with_levels(home: Home, levels: list[HomeLevel]) -> Home:
    """The home with everything that names no level put on the first one."""
    first = levels[0].id if levels else ""
    return home._replace(
        walls=tuple(w._replace(level=w.level or first) for w in home.walls if w.thickness > 0),
        rooms=tuple(r._replace(level=r.level or first) for r in home.rooms),
        pieces=tuple(p._replace(level=p.level or first) for p in home.pieces),
    )


def _level_brief(level: HomeLevel) -> LevelBrief:
    return LevelBrief(id=level.id, name=level.name, elevation=level.elevation, height=level.height)


def _walls(home: Home) -> list[WallBrief]:
    """Straight pieces of all walls."""
    found = []
    for wall in home.walls:
        line = middle_line(wall).round(6).tolist()
        for number, (start, end) in enumerate(pairwise(line)):
            found.append(
                WallBrief(
                    start=start,
                    end=end,
                    thickness=wall.thickness,
                    height=wall.height or None,
                    level=wall.level,
                    id=wall.id if len(line) == 2 else f"{wall.id}.{number}",
                )
            )
    return found


def _usual_thickness(home: Home, default: float, choose: Any) -> float:
    thick = [wall.thickness for wall in home.walls]
    return float(np.clip(choose(thick), 0.02, 2.0)) if thick else default
