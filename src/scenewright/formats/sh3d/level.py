"""One level of a Sweet Home 3D home: its rooms as keys of a brief, and what became of the rest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import shapely

from scenewright.building import outlines
from scenewright.building.room_names import functions_from_name
from scenewright.core.brief import WallBrief
from scenewright.core.errors import InputError
from scenewright.formats.sh3d.doors import opening_among
from scenewright.formats.sh3d.fates import (
    ROOF,
    fates_of_furniture,
    fates_of_openings,
    fates_of_rooms,
    fates_of_walls,
    is_kept,
)
from scenewright.formats.sh3d.floors import DrawnFloor, drawn_area, floors
from scenewright.formats.sh3d.functions import room_functions
from scenewright.formats.sh3d.gaps import MISSING, PASSAGE, Gap, find_gaps, passages
from scenewright.formats.sh3d.openings import is_door, open_sides, place_openings
from scenewright.formats.sh3d.pieces import assign_to_floors, fixed_item, flatten_groups
from scenewright.formats.sh3d.report import Fates
from scenewright.formats.sh3d.slopes import find_slopes
from scenewright.formats.sh3d.xml import Home, HomeLevel, HomePiece, HomeWall

ACROSS = 0.1
"""Length of a gap in a room from which on the room is drawn across it, metres."""
MOST_HELD = 2000
"""Pieces of furniture in one room."""
LEAST_LOST = 1.0
"""Floor that walls nearly enclose and that is not read, from which on it is noted, m²."""


class LevelRead(NamedTuple):
    """The rooms of a level, the fate of what is drawn on it, its floor in m² as drawn and as read,
    walls across the gaps in which its passages are, and notes of gaps too wide for one."""

    rooms: list[dict[str, Any]]
    fates: Fates
    drawn: float
    read: float
    walls: list[WallBrief]
    notes: list[str]


def read_level(home: Home, level: HomeLevel, keep: bool) -> LevelRead:
    """The rooms of a level; ``keep`` leaves movable furniture where it is, as fixed items."""
    found = floors(home, level.id)
    walls = [wall for wall in home.walls if wall.level == level.id]
    standing = (p for p in flatten_groups(home.pieces) if p.level == level.id)
    pieces = [opening_among(piece, walls) for piece in standing]
    rings = [outlines.rings(floor.polygon) for floor in found]
    openings = [piece for piece in pieces if piece.kind == "doorOrWindow"]
    gaps = find_gaps(walls)
    through = passages(gaps, level.id, level.height)
    placed = place_openings(openings + through, [outline for outline, _ in rings])
    sides = open_sides([floor.polygon for floor in found], placed.placed, level.height)
    furniture = [piece for piece in pieces if piece.kind != "doorOrWindow"]
    inside = assign_to_floors(furniture, [floor.polygon for floor in found])
    _check_held(inside, found)
    doors = [piece for piece in openings + through if is_door(piece)]
    functions = room_functions(found, inside, doors, keep)
    rooms = []
    for number, (outline, holes) in enumerate(rings):
        mine = [e.opening for e in placed.placed + sides if e.room == number]
        rooms.append(
            {
                "name": found[number].name or f"Room {number + 1}",
                "function": _stated(found[number].name, functions[number]),
                "level": level.id,
                "outline": outline.tolist(),
                "holes": [hole.tolist() for hole in holes],
                "doors": [opening for opening in mine if not hasattr(opening, "sill")],
                "windows": [w for w in mine if hasattr(w, "sill") and w.sill < level.height - ROOF],
                "slopes": find_slopes(outline, walls, level.height),
                "fixed": [fixed_item(p) for p in inside[number] if is_kept(p, keep, level.height)],
            }
        )
    fates = fates_of_furniture(home, level, inside, functions, keep)
    fates |= fates_of_rooms(home, level.id, found) | fates_of_openings(openings, placed, level)
    fates |= fates_of_walls(home, level.id)
    read = sum(floor.polygon.area for floor in found)
    drawn = drawn_area(home, level.id)
    return LevelRead(
        rooms,
        fates if found else {},
        drawn,
        read,
        [wall for wall in _fill(gaps, level.id) if _is_clear(wall, found)],
        _notes(walls, level, drawn - read),
    )


def _fill(gaps: Sequence[Gap], level: str) -> list[WallBrief]:
    """Walls in place of the gaps."""
    return [
        WallBrief(
            start=gap.start,
            end=gap.end,
            thickness=gap.thickness,
            level=level,
            id=f"gap-{level}-{number + 1}",
        )
        for number, gap in enumerate(gaps)
    ]


def _is_clear(wall: WallBrief, found: Sequence[DrawnFloor]) -> bool:
    """Whether a wall lies in no room that is drawn across it."""
    line = shapely.LineString([wall.start, wall.end])
    return all(line.intersection(floor.polygon).length < ACROSS for floor in found)


def _stated(name: str, functions: Sequence[str]) -> list[str] | None:
    """The functions of a room unless they are just what its name says."""
    return None if name and tuple(functions) == functions_from_name(name) else list(functions)


def _notes(walls: Sequence[HomeWall], level: HomeLevel, lost: float) -> list[str]:
    """A line for gaps in the walls of a level through which floor is lost."""
    wide = [gap for gap in find_gaps(walls, MISSING) if gap.width > PASSAGE]
    if lost < LEAST_LOST or not wide:
        return []
    places = ", ".join(f"{g.width:.2f} m near ({g.middle[0]:.2f}, {g.middle[1]:.2f})" for g in wide)
    where = f" on the level '{level.name[:40]}'" if level.name else ""
    return [
        f"{lost:.0f} m² of floor{where} were not read: the walls leave gaps of more than "
        f"{PASSAGE} m ({places[:200]}); close them, or draw the rooms"
    ]


def _check_held(inside: list[list[HomePiece]], found: list[DrawnFloor]) -> None:
    """No room holds more pieces than a brief may list."""
    for pieces, floor in zip(inside, found, strict=True):
        if len(pieces) > MOST_HELD:
            raise InputError(
                f"holds {len(pieces):,} pieces of furniture",
                f"at most {MOST_HELD:,} are read",
                place=floor.name,
            )
