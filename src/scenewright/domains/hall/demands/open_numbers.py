"""What a brief leaves open is filled to the usual share of its theme, walls first.

A demand of a theme's goods without a number gets one; where the brief states the theme, so does
what its programme holds and the brief does not name. ``"fill": "none"`` refuses both.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from scenewright.catalog.kinds import name_of
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.zones import AisleBrief, Demand
from scenewright.domains.hall.build_problem import HallContext, wall_lengths, zone_areas
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.demands.checked import (
    floor_needed,
    sizes_of,
    usual_clearance,
    usual_size,
)
from scenewright.domains.hall.demands.holdings import fill_defaults
from scenewright.domains.hall.demands.programme import (
    AT_WALLS,
    CASES_BETWEEN,
    CROSS_AISLE,
    LONGEST_RUN,
    PLAYED,
    PROGRAMMES,
    RUNS,
    WALL_BETWEEN,
    WALL_FREE,
    WALLS_OF_FILL,
    shop_programme,
)
from scenewright.domains.hall.demands.themes import (
    LINED,
    RETAIL,
    THEMES,
    USUAL_ROLES,
    Role,
    guess_theme,
    read_theme,
)
from scenewright.domains.hall.problem import Floats

ROWS_OF_BENCHES, BENCH_FREE = ("gate", "waiting"), (1.2, 0.0, 0.3, 0.0)
"""Themes whose benches stand in rows, and the free depths round these, in metres."""
FEWEST_LINING = 3
"""How many more stand at walls at least where such things stand free else."""


def is_open(demand: Demand) -> bool:
    """Whether a demand says neither how many nor how full.

    >>> is_open(Demand(category="gondola")), is_open(Demand(category="gondola", length=9.0))
    (True, False)
    """
    stated = (demand.count, demand.length, demand.most, demand.fill)
    return not demand.sizes and all(number is None for number in stated)


def theme_of(brief: Brief, room: Room) -> str:
    """The theme of a hall: the one it states, else that of its names or goods, else empty."""
    if room.theme:
        return read_theme(room.theme, "")
    names = (room.name, brief.name) if len(brief.rooms) == 1 else (room.name,)
    return guess_theme(names, (demand.category for demand in room.demands))


def open_numbers(brief: Brief, room: Room, hall: HallContext) -> Room:
    """A hall whose open demands say how many there may be at ``most``, at walls, or ``fill``."""
    theme, fill = theme_of(brief, room), room.fill
    if not theme or fill == "none":
        return room
    room = _break_long_rows(_call_desks(room, THEMES[theme].desk))
    demands = [*room.demands, *(_missing(room, hall, theme) if room.theme else ())]
    goods = THEMES[theme].goods
    opened = [k for k, d in enumerate(demands) if is_open(d) and d.category in goods]
    rows = theme in ROWS_OF_BENCHES
    if not opened and not rows and len(demands) == len(room.demands):
        return room
    share = THEMES[theme].fill if fill is None else fill
    at_wall = [k for k in opened if fill_defaults(demands[k], "").at_wall]
    free = [] if at_wall or theme not in LINED else opened
    lining = [d for k in free for d in _stand_at_wall(demands[k])][:1]
    demands, at_wall = [*demands, *lining], at_wall or [len(demands)] * len(lining)
    for k in at_wall:
        demands[k] = _line_walls(demands[k], demands, at_wall, hall, THEMES[theme].walls, share)
    if lining and (demands[-1].most or 0) < FEWEST_LINING:
        demands.pop()
    by_floor = {row.category: row.each for row in PROGRAMMES[theme] if row.each}
    for k in (k for k in opened if k not in at_wall):
        each = by_floor.get(demands[k].category)
        number = (
            {"fill": share, "aisle": _part_rows(demands[k], hall, share)}
            if each is None
            else {"count": _by_floor(demands[k], hall, each)}
        )
        demands[k] = demands[k].model_copy(update=number)
    if rows:
        demands = [_in_rows(demand) for demand in demands]
    return room.model_copy(update={"demands": demands})


def _in_rows(demand: Demand) -> Demand:
    """Benches to wait on side by side in rows, where the brief does not say how they stand."""
    stated = demand.patterns or demand.place or demand.facing or demand.clearance
    if demand.category != "bench" or stated:
        return demand
    rows: dict[str, Any] = {"patterns": ["chain"], "clearance": BENCH_FREE}
    return demand.model_copy(update=rows)


def with_theme(
    brief: Brief, number: int, hall: HallContext, together: bool
) -> tuple[HallContext, tuple[Role, ...]]:
    """A hall with the island of its theme where numbers are open, and the roles of that; neither
    where all are laid out ``together``."""
    room = brief.rooms[number]
    theme = THEMES.get(theme_of(brief, room))
    if theme is None or together:
        return hall, () if together else USUAL_ROLES
    opened = any(demand.most or demand.fill for demand in room.demands)
    island = theme.island if opened and room.fill != "none" else ()
    return hall._replace(island=island), theme.roles


def _call_desks(room: Room, name: str) -> Room:
    """A hall whose desks without a name have that of its theme."""
    if not name:
        return room
    desks = [d.category == "desk" and not d.name and not d.id for d in room.demands]
    called = [
        d.model_copy(update={"name": name}) if desk else d
        for d, desk in zip(room.demands, desks, strict=True)
    ]
    return room.model_copy(update={"demands": called}) if any(desks) else room


def _break_long_rows(room: Room) -> Room:
    """A hall whose goods used from both sides have an aisle across rows of a stated length."""
    demands = [
        d.model_copy(update={"aisle": _aisle_of(d)})
        if d.length and d.aisle is None and not (d.patterns or d.clearance or d.zone)
        else d
        for d in room.demands
    ]
    return room.model_copy(update={"demands": demands}) if demands != room.demands else room


def _aisle_of(demand: Demand) -> AisleBrief | None:
    """The aisle across long rows of goods used from both sides."""
    clear, width = usual_clearance(demand), usual_size(demand)[0]
    both = clear[0] > 0.0 and clear[2] > 0.0 and not any(clear[1::2])
    every = max(int(LONGEST_RUN / width), 1)
    return AisleBrief(every=every, width=CROSS_AISLE) if both else demand.aisle


def _missing(room: Room, hall: HallContext, theme: str) -> list[Demand]:
    """What the programme of a theme holds and a hall does not name, each merely welcome; what
    fills has its number left open."""
    area, around = float(zone_areas(hall).sum()), float(wall_lengths(hall).sum())
    named = {demand.category for demand in room.demands}
    filling = {row.category for row in PROGRAMMES[theme] if row.share}
    goods = theme in ROWS_OF_BENCHES and bool(named.intersection(THEMES[theme].goods))
    named |= set(SERVING) if named & set(SERVING) else set()
    own = any(demand.category == "box" for demand in room.demands)
    named |= {row.category for row in PROGRAMMES[theme] if own and row.name}
    return [
        d.model_copy(update={"required": False, "count": None if open_ else d.count})
        for d in shop_programme(theme, area, around)
        if d.category not in named and not (goods and d.category in THEMES[theme].goods)
        for open_ in [d.category in filling and d.category in THEMES[theme].goods]
    ]


def _stand_at_wall(demand: Demand) -> Iterator[Demand]:
    """More of a demand with their backs at walls, where these are good to stand there and the brief
    does not say how they stand: what is used from both sides is half as deep there."""
    deepest = AT_WALLS.get(demand.category)
    if deepest is None or demand.place or demand.patterns or demand.facing or demand.used_from:
        return
    width, depth, height = usual_size(demand)
    stands = {"place": "wall", "size": (width, min(depth, deepest), height), "clearance": WALL_FREE}
    name = demand.name or name_of(demand.category)
    yield demand.model_copy(
        update=stands | {"id": "", "name": f"{name} at walls", "required": False}
    )


def _line_walls(
    demand: Demand,
    every: list[Demand],
    alike: list[int],
    hall: HallContext,
    walls: float,
    share: float,
) -> Demand:
    """A demand at walls with its part of the share of the ``walls`` of its zones that others leave,
    and of the floor."""
    mine = zones_of(demand, hall)
    others = [
        d
        for k, d in enumerate(every)
        if k not in alike and (d.category in PLAYED or fill_defaults(d, "").at_wall)
    ]
    sharing = [every[k] for k in alike if (zones_of(every[k], hall) * mine).any()]
    taken = sum(len(sizes_of(d)) * _front(d) for d in others)
    wall = walls * float((wall_lengths(hall) * mine).sum()) - taken
    floor = WALLS_OF_FILL * share * float((zone_areas(hall) * mine).sum())
    each = floor_needed(demand) / len(sizes_of(demand))
    most = int(min(wall / _front(demand), floor / each) / len(sharing))
    return demand.model_copy(update={"count": 1, "most": max(most, 1)})


def _by_floor(demand: Demand, hall: HallContext, each: float) -> int:
    """How many of a demand there are with one for a given number of square metres of its zones."""
    return max(round(float((zone_areas(hall) * zones_of(demand, hall)).sum()) / each), 1)


def _part_rows(demand: Demand, hall: HallContext, share: float) -> AisleBrief | None:
    """The aisle across rows of goods used from both sides that are likely to be many; the one the
    brief states."""
    aisle = _aisle_of(demand)
    floor = float((zone_areas(hall) * zones_of(demand, hall)).sum())
    many = aisle and share * floor / floor_needed(demand) >= RUNS * aisle.every
    return aisle if many else demand.aisle


def _front(demand: Demand) -> float:
    """Metres of wall that one object of a demand takes."""
    filled = fill_defaults(demand, "")
    apart = any(filled.clearance[1::2]) and demand.category not in PLAYED
    between = CASES_BETWEEN if demand.category in RETAIL else WALL_BETWEEN
    return filled.sizes[0].width + between * apart


def zones_of(demand: Demand, hall: HallContext) -> Floats:
    """Which zones (z,) a demand may go to, 1 or 0."""
    named = (demand.zone,) if isinstance(demand.zone, str) else tuple(demand.zone or hall.names)
    return np.array([float(name in named) for name in hall.names])
