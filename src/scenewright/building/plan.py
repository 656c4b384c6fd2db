"""The plan: from a brief to valid spaces and levels.

Everything the later stages rely on is checked here, once: outlines that are simple and do not
overlap, openings that lie on walls, fixed items that stand in their rooms.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import shapely

from scenewright.building import outlines
from scenewright.building.extent import check_extent
from scenewright.building.labels import correct_labels
from scenewright.building.openings import find_openings
from scenewright.building.room_names import functions_from_name, sort_functions
from scenewright.building.services import add_services
from scenewright.building.stairwells import with_stairs
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.domain_keys import check_domain
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.plan import Plan
from scenewright.core.space import Level, Points, Slope, Space

DEFAULT_LEVEL = Level("0", "", 0.0, 2.6)
OVERLAP = 0.02
LOWEST_ROOM = 1.0
"""The least height of a room, metres: below nobody can even crawl through it."""


def levels(brief: Brief) -> tuple[Level, ...]:
    """The storeys of a brief in the order listed; one at height 0 if none is listed."""
    seen: set[str] = set()
    for number, level in enumerate(brief.levels):
        if level.id in seen:
            raise InputError(
                f"the id '{level.id}' is used twice",
                "give every level its own id",
                place=f"levels[{number}]",
            )
        seen.add(level.id)
    found = tuple(Level(lv.id, lv.name or lv.id, lv.elevation, lv.height) for lv in brief.levels)
    return found or (DEFAULT_LEVEL,)


def spaces(brief: Brief) -> tuple[Space, ...]:
    """The spaces of a brief, one a room in the order listed, with their openings shared.

    Raises InputError, with the place in the brief, for anything that cannot be built.

    >>> brief = Brief.model_validate(
    ...     {"rooms": [{"name": "Bedroom 1", "outline": [[0, 0], [0, 3], [4, 3], [4, 0]]}]}
    ... )
    >>> space = spaces(brief)[0]
    >>> space.id, space.functions, space.outline.tolist()[:2]
    ('bedroom-1', ('bedroom',), [[0.0, 0.0], [4.0, 0.0]])
    """
    check_domain(brief)
    storeys = {level.id: level for level in levels(brief)}
    ids = room_ids(brief)
    _check_ids(brief)
    floors = [_floor(room, number, brief) for number, room in enumerate(brief.rooms)]
    found = [
        _space(room, number, ids[number], floors[number], storeys)
        for number, room in enumerate(brief.rooms)
    ]
    check_extent(brief, floors)
    _check_overlaps(brief, found, floors)
    for number, room in enumerate(brief.rooms):
        _check_fixed(room, number, floors, brief)
    openings = find_openings(brief, tuple(found))
    opened = [replace(s, openings=tuple(o for o in openings if s.id in o.spaces)) for s in found]
    joined = correct_labels(brief, with_stairs(brief, opened, levels(brief)))
    return tuple(
        add_services(brief, room, space, place(brief, number))
        for number, (room, space) in enumerate(zip(brief.rooms, joined, strict=True))
    )


def room_ids(brief: Brief) -> tuple[str, ...]:
    """The id of every room: the one given, else its name in plain letters, else ``room-3``.

    >>> room = {"name": "Kitchen", "outline": [[0, 0], [1, 0], [1, 1]]}
    >>> room_ids(Brief.model_validate({"rooms": [room, room]}))
    ('kitchen', 'kitchen-2')
    """
    ids: list[str] = []
    taken = {room.id for room in brief.rooms if room.id}
    for number, room in enumerate(brief.rooms):
        if room.id and room.id in ids:
            raise InputError(
                f"the id '{room.id}' is used twice",
                "give every room its own id",
                place=place(brief, number),
            )
        ids.append(room.id or _fresh(_slug(room.name) or f"room-{number + 1}", taken))
        taken.add(ids[-1])
    return tuple(ids)


def space_names(brief: Brief) -> dict[str, str]:
    """The name of every room by its id."""
    return {i: room.name or i for i, room in zip(room_ids(brief), brief.rooms, strict=True)}


def plan_rooms(brief: Brief) -> Plan:
    """The plan of a brief of rooms.

    >>> room = {"name": "Study", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}
    >>> dict(plan_rooms(Brief.model_validate({"rooms": [room]})).names)
    {'study': 'Study'}
    """
    return Plan(levels(brief), spaces(brief), space_names(brief))


def place(brief: Brief, number: int, rest: str = "") -> str:
    """How a room is named in messages: ``rooms[2] 'Kitchen'``."""
    name = brief.rooms[number].name or brief.rooms[number].id
    return " ".join(part for part in (f"rooms[{number}]", f"'{name}'" * bool(name), rest) if part)


def _slug(name: str) -> str:
    return re.sub(r"[\W_]+", "-", name.casefold()).strip("-")


def _fresh(wish: str, taken: set[str]) -> str:
    names = (wish if count == 1 else f"{wish}-{count}" for count in range(1, len(taken) + 2))
    return next(name for name in names if name not in taken)


def _floor(room: Room, number: int, brief: Brief) -> shapely.Polygon:
    try:
        floor = outlines.polygon(room.outline, room.holes)
        if brief.outlines == "centre":
            floor = outlines.shrink(floor, brief.wall_thickness / 2)
    except InputError as error:
        raise error.located(place=place(brief, number)) from None
    return floor


def _space(
    room: Room, number: int, space_id: str, floor: shapely.Polygon, storeys: dict[str, Level]
) -> Space:
    where = f"rooms[{number}] '{room.name or space_id}'"
    level = storeys.get(room.level) if room.level else next(iter(storeys.values()))
    if level is None:
        raise InputError(
            f"the level '{room.level}' does not exist",
            f"use one of: {', '.join(storeys)}",
            place=where,
        )
    outline, holes = outlines.rings(floor)
    height = room.height or level.height
    if height < LOWEST_ROOM:
        raise InputError(
            f"a room {height:g} m high is not possible",
            f"give a height of at least {LOWEST_ROOM:g} (metres)",
            place=where if room.height else f"{where}, level '{level.id}'",
        )
    return Space(
        id=space_id,
        name=room.name or space_id,
        functions=_functions(room),
        level=level.id,
        outline=outline,
        holes=holes,
        height=height,
        main_wall=_main_wall(room, outline, where),
        slopes=_slopes(room, outline, height, where),
    )


def _functions(room: Room) -> tuple[str, ...]:
    if room.function is None or room.function == []:
        return functions_from_name(room.name)
    listed = [room.function] if isinstance(room.function, str) else room.function
    return sort_functions(listed)


def _main_wall(room: Room, outline: Points, place: str) -> int | None:
    if room.main_wall is None:
        return None
    try:
        return outlines.edge_meant(room.outline, room.main_wall, outline, "main_wall")
    except InputError as error:
        raise error.located(place=place) from None


def _slopes(room: Room, outline: Points, height: float, place: str) -> tuple[Slope, ...]:
    """The slopes of a room by the edges of its cleaned outline."""
    found = []
    for number, wish in enumerate(room.slopes):
        try:
            if wish.knee > height:
                raise InputError(
                    f"its knee is {wish.knee:g} m high, above the ceiling at {height:g} m",
                    "lower the knee or raise the room's height",
                )
            edge = outlines.edge_meant(room.outline, wish.edge, outline, "edge")
        except InputError as error:
            raise error.located(place=f"{place} slopes[{number}]") from None
        found.append(Slope(edge, wish.knee, wish.pitch))
    return tuple(found)


def _check_overlaps(brief: Brief, found: list[Space], floors: list[shapely.Polygon]) -> None:
    tree = shapely.STRtree(floors)
    firsts, seconds = tree.query(floors, predicate="intersects")
    for first, second in zip(firsts.tolist(), seconds.tolist(), strict=True):
        if first >= second or found[first].level != found[second].level:
            continue
        shared = floors[first].intersection(floors[second])
        if shared.area > OVERLAP:
            middle = shared.representative_point()
            raise InputError(
                f"overlaps {place(brief, first)} by {shared.area:.2f} m² "
                f"near ({middle.x:.2f}, {middle.y:.2f})",
                "move one of them or cut it out of the other",
                place=place(brief, second),
            )


def _check_ids(brief: Brief) -> None:
    """What stands in rooms has an id of its own, where it has one: files name pieces by them."""
    seen: set[str] = set()
    for number, room in enumerate(brief.rooms):
        lines = [(f"fixed[{index}]", item.id) for index, item in enumerate(room.fixed)]
        lines += [(f"radiators[{k}]", radiator.id) for k, radiator in enumerate(room.radiators)]
        for which, name in lines:
            if name in seen:
                raise InputError(
                    f"the id '{name[:80]}' is used twice",
                    "give everything that stands in a room its own id",
                    place=place(brief, number, which),
                )
            seen |= {name} - {""}


def _check_fixed(room: Room, number: int, floors: list[shapely.Polygon], brief: Brief) -> None:
    for index, item in enumerate(room.fixed):
        box = np.array([[*item.at, item.heading, *item.size[:2]]])
        away = floors[number].distance(shapely.Polygon(corners(box)[0]))
        if away > 0.05:
            raise InputError(
                f"the {item.category} stands {away:.2f} m outside the room",
                "move it in or list it in the room it stands in",
                place=place(brief, number, f"fixed[{index}]"),
            )
