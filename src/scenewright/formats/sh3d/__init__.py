"""Sweet Home 3D: a home drawn in that program, as a brief.

Reads ``.sh3d`` archives and bare ``Home.xml`` files: levels, rooms, walls, doors, windows and
furniture. Movable furniture and kitchen units (the program calls only some of these movable)
are taken out, to be placed anew; what else is built in stays.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from scenewright.core.brief import Brief, LevelBrief, WallBrief
from scenewright.core.brief.input_report import report_input
from scenewright.core.brief.variations import scale_brief
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError
from scenewright.formats.sh3d.archive import home_xml
from scenewright.formats.sh3d.floors import floors
from scenewright.formats.sh3d.level import read_level
from scenewright.formats.sh3d.report import list_fates
from scenewright.formats.sh3d.units import to_centimetres
from scenewright.formats.sh3d.xml import Home, HomeLevel, middle_line, parse
from scenewright.text import quantity


def read(path: Path, keep: bool = False, hidden_levels: bool = False, scale: float = 1.0) -> Brief:
    """The brief of a home; ``keep`` leaves movable furniture where it is, as fixed items;
    ``hidden_levels`` includes the levels that are hidden. Its plan is drawn times ``scale``; if
    that makes centimetres of the unit of the whole file, so is all else."""
    home, rest = to_centimetres(parse(home_xml(path)), scale)
    return scale_brief(brief_of(home, keep, hidden_levels), rest)


def brief_of(home: Home, keep: bool = False, hidden_levels: bool = False) -> Brief:
    """The brief of a parsed home. Hidden levels (roofs, but also floors that were not looked at
    when the home was saved) are left out unless asked for; its notes name those with rooms."""
    chosen = [level for level in home.levels if level.visible or hidden_levels]
    if home.levels and not chosen:
        raise InputError("all its levels are hidden", "show them, or add --hidden-levels")
    levels = chosen or [_only(home)]
    drawn = _with_levels(home, levels)
    home = drawn._replace(walls=tuple(wall for wall in drawn.walls if wall.thickness > 0))
    read = [read_level(home, level, keep) for level in levels]
    rooms = [room for one in read for room in one.rooms]
    if not rooms:
        raise InputError(
            "has no room: none is drawn and the walls enclose none", "draw rooms or close the walls"
        )
    walls = _walls(home) + [wall for one in read for wall in one.walls]
    used = {room["level"] for room in rooms}
    hidden = [level for level in home.levels if level not in levels]
    fates = list_fates(drawn, hidden, used, {n: f for one in read for n, f in one.fates.items()})
    try:
        return Brief.model_validate(
            {
                "name": home.name,
                "levels": [_level_brief(level) for level in levels if level.id in used],
                "rooms": rooms,
                "walls": [wall for wall in walls if wall.level in used],
                "wall_thickness": _usual_thickness(home, 0.12, np.median),
                "outer_wall_thickness": _usual_thickness(home, 0.25, np.max),
                "notes": _hidden_notes(home, hidden) + [n for one in read for n in one.notes],
                "input_report": report_input(
                    fates,
                    format="Sweet Home 3D",
                    unit="centimetres",
                    drawn_floor=round(sum(one.drawn for one in read), 2),
                    read_floor=round(sum(one.read for one in read), 2),
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
            rooms = f"{quantity(len(there), 'room')}, {area:.0f} m²"
            notes.append(
                f"the level '{name}' ({rooms}) is hidden in Sweet Home 3D and was not "
                "read; add --hidden-levels to include it"
            )
    return notes


def _only(home: Home) -> HomeLevel:
    return HomeLevel("0", "", 0.0, home.wall_height, True)


def _with_levels(home: Home, levels: list[HomeLevel]) -> Home:
    """The home with everything that names no level put on the first one."""
    first = levels[0].id if levels else ""
    return home._replace(
        walls=tuple(w._replace(level=w.level or first) for w in home.walls),
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
