"""Stairs in the rooms of a brief: what they take of each floor, and where one steps on and off."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.stair_walls import check_walls
from scenewright.core.brief import Brief
from scenewright.core.brief.stairs import StairsBrief
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.space import Level, Space, StairEnd, StairPart
from scenewright.core.stairs import FLOOR, HEADROOM, Box, End, Stairs, build_stairs

Floats = NDArray[np.float64]

LOWEST, HIGHEST = 0.3, 8.0
"""Between what differences of height stairs are made, metres."""
BEYOND = 0.35
"""Floor that one needs where one steps off, metres."""
RAILING = 0.9
SLIVER = 0.05
"""What stairs take of a room is left out where it is narrower than this, metres."""
FLIGHT = 0.2
"""Depth of a flight of stairs below its steps, metres."""
TOUCH = 0.01
"""Treads that overlap by less lie beside each other, metres."""
WHOLE = 0.999
"""Share of a part inside a room from which the part is not cut to it."""
BASEMENT = -0.5
"""Levels lower than this are not entered from outside if others are, metres."""


def stairs_of(brief: Brief, storeys: Sequence[Level]) -> tuple[Stairs, ...]:
    """The stairs of a brief, in the order listed."""
    known = {level.id: level for level in storeys}
    found: list[Stairs] = []
    for number, asked in enumerate(brief.stairs):
        place = f"stairs[{number}]" + f" '{asked.name or asked.id}'" * bool(asked.name or asked.id)
        lower, upper = _levels(asked, storeys, known, place)
        height = upper.elevation - lower.elevation
        if not LOWEST <= height <= HIGHEST:
            raise InputError(
                f"the level '{upper.id}' is {height:.2f} m above '{lower.id}'",
                f"give stairs between {LOWEST} and {HIGHEST} m",
                place=place,
            )
        name = asked.id or ("stairs" if number == 0 else f"stairs-{number + 1}")
        if any(name == other.id for other in found):
            raise InputError(
                f"the id '{name}' is used twice", "give all stairs their own id", place=place
            )
        found.append(build_stairs(asked, name, lower.id, upper.id, height))
    return tuple(found)


def _levels(
    asked: StairsBrief, storeys: Sequence[Level], known: dict[str, Level], place: str
) -> tuple[Level, Level]:
    """The lower and upper level of stairs."""
    for name in (asked.level, asked.to):
        if name and name not in known:
            raise InputError(
                f"the level '{name}' does not exist", f"use one of: {', '.join(known)}", place=place
            )
    lower = known[asked.level] if asked.level else min(storeys, key=lambda lv: lv.elevation)
    above = [lv for lv in storeys if lv.elevation > lower.elevation + LOWEST]
    if not asked.to and not above:
        raise InputError(
            f"there is no level above '{lower.id}'",
            "list it under levels, with its elevation",
            place=place,
        )
    return lower, known[asked.to] if asked.to else min(above, key=lambda lv: lv.elevation)


def with_stairs(
    brief: Brief, spaces: Sequence[Space], storeys: Sequence[Level]
) -> tuple[Space, ...]:
    """Spaces with the ends and parts of the stairs in them."""
    found = stairs_of(brief, storeys)
    if not found:
        return tuple(spaces)
    floors = [shapely.Polygon(space.outline, space.holes) for space in spaces]
    tree = shapely.STRtree(floors)
    entered = _find_entrance_elevation(spaces, storeys)
    height = {level.id: level.elevation for level in storeys}
    rise = {s.id: height[s.upper] - height[s.level] for s in found}
    ends: list[list[StairEnd]] = [[] for _ in spaces]
    parts: list[list[StairPart]] = [[] for _ in spaces]
    taken = {item.id for room in brief.rooms for item in room.fixed}
    for number, stairs in enumerate(found):
        place = f"stairs[{number}] '{stairs.name or stairs.id}'"
        _check_between(stairs, spaces, floors, height, place)
        entries: dict[str, int] = {}
        for kind, end, level in (
            ("foot", stairs.foot, stairs.level),
            ("head", stairs.head, stairs.upper),
        ):
            room = _room_of(end, level, spaces, floors)
            if room is None:
                raise InputError(
                    f"the {kind} at ({end.x:.2f}, {end.y:.2f}) leads into no room of the level "
                    f"'{level}'",
                    "move the stairs or turn them, or draw the room they lead into",
                    place=place,
                )
            arrival = height[level] > entered if kind == "head" else height[level] < entered
            ends[room].append(StairEnd(stairs.id, kind, *end, arrival))
            entries[kind] = room
        check_walls(stairs, entries["foot"], spaces, floors, place)
        for kind, level in (("foot", stairs.level), ("head", stairs.upper)):
            own = np.array([space.level == level for space in spaces])
            most = rise[stairs.id] if kind == "foot" else RAILING
            tall = [min(most, space.height) for space in spaces]
            above = [other for other in found if kind == "head" and is_stacked(stairs, other)]
            for room, part in _parts(stairs, kind, entries[kind], tree, own, tall, above):
                if part.id in taken:
                    raise InputError(
                        f"the id '{part.id}' is used twice",
                        "give the stairs another id",
                        place=place,
                    )
                taken.add(part.id)
                parts[room].append(part)
    return tuple(
        replace(space, stairs=tuple(e), stair_parts=tuple(p))
        for space, e, p in zip(spaces, ends, parts, strict=True)
    )


def _parts(
    stairs: Stairs,
    kind: str,
    entry: int,
    floors: shapely.STRtree,
    own: NDArray[np.bool_],
    tall: Sequence[float],
    above: Sequence[Stairs] = (),
) -> Iterator[tuple[int, StairPart]]:
    """What stairs take of the ``floors`` of their ``own`` level, cut where rooms part, and nothing
    where rooms have been drawn round it, or stairs stacked ``above`` take it. The first box holds
    the foot, the last the head: in the room of the ``entry`` (else the one with most of it) that
    part is the staircase one steps onto.
    """
    boxes = stairs.taken if kind == "foot" else stairs.open
    main = 0 if kind == "foot" else len(boxes) - 1
    name = stairs.id if kind == "foot" else f"{stairs.id}/well"
    over = shapely.union_all([shapely.Polygon(_outline(b)) for s in above for b in s.taken]).buffer(
        TOUCH, join_style="mitre"
    )
    for k, box in enumerate(boxes):
        shape = shapely.Polygon(_outline(box)).difference(over)
        near = np.sort(floors.query(shape))
        near = near[own[near]]
        inside = shapely.intersection(floors.geometries[near], shape)
        order = np.argsort(-shapely.area(inside), kind="stable")
        cut = {int(near[i]): _cut_to(inside[i], box) for i in order if inside[i].area > 0.0}
        here = {room: part for room, part in cut.items() if min(part[3:]) > SLIVER}
        first = entry if entry in here else next(iter(here), -1)
        for room, part in here.items():
            label = name if k == main else f"{name}/{k + 1}"
            category = "staircase" if k == main and room == first else "obstacle"
            label += "" if room == first else f"/room-{room + 1}"
            yield room, StairPart(label, category, tuple(part), tall[room])


def is_stacked(stairs: Stairs, other: Stairs) -> bool:
    """Whether other stairs rise from where stairs arrive, above them, and one walks upright below.

    Where treads lie one above the other, at h of stairs that rise by H and at h' of the others, it
    is H + h' - h less a rise and the depth of the flight, 0.2 m, at least 2 m.

    >>> from scenewright.core.brief.stairs import StairsBrief
    >>> def up(y, turns, level, to):
    ...     asked = StairsBrief(at=(0, y), heading=turns * np.pi / 2)
    ...     return build_stairs(asked, level, level, to, 2.8)
    >>> first = up(0, 1, "a", "b")
    >>> is_stacked(first, up(0, 1, "b", "c")), is_stacked(first, up(4, -1, "b", "c"))
    (True, False)
    """
    if other.level != stairs.upper or other.id == stairs.id:
        return False
    below, rise = stairs.treads, stairs.rise * stairs.rises
    tree = shapely.STRtree([shapely.Polygon(tread.outline).buffer(-TOUCH) for tread in below])
    upper = [shapely.Polygon(tread.outline) for tread in other.treads]
    pairs = tree.query(upper, predicate="intersects").T.tolist()
    clear = [rise + other.treads[j].height - below[i].height for j, i in pairs]
    return bool(clear) and min(clear) - other.rise - FLIGHT >= HEADROOM


def _outline(box: Box) -> Floats:
    return corners(np.array([box]))[0]


def _cut_to(shape: shapely.Geometry, box: Box) -> Box:
    """The least box with the heading of another round what of it lies in a room."""
    if shape.area > WHOLE * box.width * box.depth:
        return box
    ahead = np.array([np.cos(box.heading), np.sin(box.heading)])
    axes = np.array([[ahead[1], -ahead[0]], ahead])
    points = shapely.get_coordinates(shape) @ axes.T
    low, high = points.min(0), points.max(0)
    x, y = ((low + high) / 2 @ axes).tolist()
    return Box(x, y, box.heading, *(high - low).tolist())


def _check_between(
    stairs: Stairs,
    spaces: Sequence[Space],
    floors: Sequence[shapely.Polygon],
    height: dict[str, float],
    place: str,
) -> None:
    """No room of a level between may lie where the stairs go through it."""
    low, high = height[stairs.level], height[stairs.upper]
    for space, floor in zip(spaces, floors, strict=True):
        if not low < height[space.level] < high:
            continue
        met = height[space.level] - low - FLOOR - HEADROOM
        through = [shapely.Polygon(t.outline) for t in stairs.treads if t.height > met]
        if floor.intersection(shapely.union_all(through)).area > SLIVER:
            raise InputError(
                f"goes through '{space.id}' of the level '{space.level}'",
                "let the stairs end on that level, or draw the room round them",
                place=place,
            )


def _room_of(
    end: End, level: str, spaces: Sequence[Space], floors: Sequence[shapely.Polygon]
) -> int | None:
    """The room one steps into."""
    way = np.array([np.cos(end.heading), np.sin(end.heading)])
    at = shapely.Point(np.array([end.x, end.y]) + BEYOND * way)
    inside = (k for k, floor in enumerate(floors) if spaces[k].level == level and floor.covers(at))
    return next(inside, None)


def _find_entrance_elevation(spaces: Sequence[Space], storeys: Sequence[Level]) -> float:
    """The elevation of the level that is entered from outside: the lowest with a door to the
    outside, but a basement only if no other has one; else the lowest."""
    doors = {
        s.level for s in spaces for o in s.openings if o.kind != "window" and len(o.spaces) == 1
    }
    heights = sorted(level.elevation for level in storeys if level.id in doors)
    above = [height for height in heights if height >= BASEMENT]
    return next(iter(above or heights), min(level.elevation for level in storeys))
