"""Kitchens made to measure: lines of units along one, two or three walls, and what joins them.

A line is the units along one wall; where two walls meet a corner cabinet joins their lines into
one worktop (an L, with two corners a U). Without a corner the lines face one another or stand
apart, as a lone fridge does. The patch is that of the line with the hob; the others reach out
of it, so that floor in front of them stays floor.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations
from math import atan2, cos, hypot, pi, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.groups.kitchen import (
    AMPLY_BEYOND,
    BEYOND,
    FRIDGE,
    UNIT_DEPTH,
    WORKTOP_HEIGHT,
    Unit,
    fill,
    hang_above,
    sequence,
    widest_hob,
)
from scenewright.domains.home.groups.low_fridges import LOW
from scenewright.domains.home.least_sizes import SINK
from scenewright.geometry.boxes import common_area, make_frame

Floats = NDArray[np.float64]
Box = tuple[float, float, float, float, float]

CORNER = 0.9  # width and depth of the cabinet round the corner, in which one stands, metres
SLIM_FRIDGE = 0.5  # width of the narrowest fridge, metres
SHARED = 1e-3  # square metres that two lines may share
BACK = 0.005  # between a unit and the wall behind it, metres


class KitchenWall(NamedTuple):
    """A wall by where it begins and its direction, the room on its left; metres."""

    x: float
    y: float
    ux: float
    uy: float

    @property
    def heading(self) -> float:
        """The heading of units with their back at the wall."""
        return atan2(self.ux, -self.uy)


class UnitLine(NamedTuple):
    """Units one after the other along a wall, the first ``start`` metres from where it begins."""

    wall: KitchenWall
    start: float
    units: tuple[Unit, ...]


class FittedKitchen(NamedTuple):
    """A kitchen: its lines, the one with the hob first, and the walls that begin at its corners."""

    lines: tuple[UnitLine, ...]
    corners: tuple[KitchenWall, ...] = ()


def width_of(units: tuple[Unit, ...] | list[Unit]) -> float:
    """Metres of front of some units."""
    return sum(wide for _, wide in units)


def cook_and_wash(length: float) -> list[Unit]:
    """Sink and hob with the worktop that ``length`` metres leave them, the hob last."""
    return sequence(length)


def cook(length: float) -> list[Unit]:
    """A hob with 0.3 m of worktop behind it and the rest before it, in ``length`` metres."""
    wide = widest_hob(length - 3 * BEYOND)
    rest = length - wide
    beyond = 2 * BEYOND if rest >= 4 * BEYOND else min(BEYOND, rest / 2)
    if 0.6 + AMPLY_BEYOND - 1e-9 <= rest < 4 * BEYOND:
        beyond = AMPLY_BEYOND
    return [*fill(rest - beyond), ("hob_cabinet", wide), *fill(beyond)]


def wash(length: float) -> list[Unit]:
    """A sink and worktop behind it, with a dishwasher if ``length`` metres hold one."""
    short = SINK.width if length >= SINK.width + BEYOND - 1e-9 else length
    wide = next((w for w in (0.8, 0.6, SINK.width) if length >= w + 0.6 - 1e-9), short)
    rest = length - wide
    washer: list[Unit] = [("dishwasher", 0.6)] if rest >= 0.9 else []
    return [("sink_cabinet", wide), *washer, *fill(rest - width_of(washer))]


def assemble(kitchen: FittedKitchen) -> tuple[Group, Floats]:
    """A kitchen as a group and the box ``(5,)`` of its patch: x, y, heading, width, depth.

    >>> units = (("sink_cabinet", 0.6), ("hob_cabinet", 0.6))
    >>> line = UnitLine(KitchenWall(0.0, 0.0, 1.0, 0.0), 0.4, units)
    >>> group, box = assemble(FittedKitchen((line,)))
    >>> group.function, [m.category for m in group.members if m.z == 0]
    ('kitchenette', ['sink_cabinet', 'hob_cabinet'])
    >>> [round(float(v), 2) for v in box]
    [1.0, 0.3, 1.57, 1.2, 0.6]
    """
    main = kitchen.lines[0]
    box = np.array(box_of(main))
    placed: list[Member] = []
    for line in kitchen.lines:
        placed += _units_of(line)
    size = Size(CORNER, CORNER, WORKTOP_HEIGHT)
    for wall in kitchen.corners:
        x, y = point_at(wall, CORNER / 2, CORNER / 2 + BACK / 2)
        placed.append(Member("corner_cabinet", x, y, 0, wall.heading, size))
    members = tuple(_seen_from(member, box) for member in placed)
    whole = any(m.category == "fridge" for m in members)
    function = "kitchen" if whole else "kitchenette"
    return Group(function, _name(kitchen), float(box[3]), float(box[4]), members), box


def overlap(kitchen: FittedKitchen) -> bool:
    """Whether two of its lines and corner cabinets run into each other."""
    boxes = [box_of(line) for line in kitchen.lines]
    boxes += [place(wall, 0.0, CORNER, CORNER, 0.0) for wall in kitchen.corners]
    wide = [(box, hypot(box[3], box[4])) for box in boxes]
    return any(_meet(*one, *other) for one, other in combinations(wide, 2))


def _meet(one: Box, wide: float, other: Box, across: float) -> bool:
    """Whether two boxes of such diagonals run into each other; not if the circles round them do
    not."""
    if hypot(one[0] - other[0], one[1] - other[1]) > (wide + across) / 2:
        return False
    return bool(common_area(make_frame(*one), make_frame(*other)) > SHARED)


def list_solid(kitchen: FittedKitchen) -> list[Box]:
    """The floor that a kitchen takes, as boxes: a corner cabinet of two arms."""
    arms = ((CORNER, UNIT_DEPTH), (UNIT_DEPTH, CORNER))
    corners = [place(wall, 0.0, w, d, 0.0) for wall in kitchen.corners for w, d in arms]
    return [*(box_of(line) for line in kitchen.lines), *corners]


def list_fronts(kitchen: FittedKitchen, depth: float) -> list[Box]:
    """The floor before each unit from which it is used, ``depth`` metres deep; a corner cabinet is
    used from that of its neighbours."""
    found: list[Box] = []
    for line in kitchen.lines:
        at = line.start
        for category, wide in line.units:
            found.append(place(line.wall, at, wide, depth, BACK + _size(category, wide).depth))
            at += wide
    return found


def box_of(line: UnitLine) -> Box:
    """The floor that a line takes."""
    return place(line.wall, line.start, *_floor_of(line.units), 0.0)


@lru_cache(maxsize=4096)
def _floor_of(units: tuple[Unit, ...]) -> tuple[float, float]:
    """The width and depth of the floor that units of one line take."""
    return width_of(units), max(_size(*unit).depth for unit in units) + BACK


def place(wall: KitchenWall, start: float, width: float, depth: float, out: float) -> Box:
    """The box of ``width`` and ``depth`` at a wall, from ``start`` on and ``out`` from it."""
    return (*point_at(wall, start + width / 2, out + depth / 2), wall.heading, width, depth)


def middle_of(line: UnitLine, name: str) -> tuple[float, float]:
    """Where the middle of a unit of a line would stand, were it as deep as worktop."""
    return point_at(line.wall, line.start + _middle_in(line.units, name), BACK + UNIT_DEPTH / 2)


@lru_cache(maxsize=4096)
def _middle_in(units: tuple[Unit, ...], name: str) -> float:
    """How far the middle of a unit is from where its line begins."""
    number = next(k for k, unit in enumerate(units) if unit[0] == name)
    return width_of(units[:number]) + units[number][1] / 2


@lru_cache(maxsize=4096)
def width_of_line(units: tuple[Unit, ...]) -> float:
    """Metres of front of the units of one line; the same line is asked for many times."""
    return width_of(units)


def _name(kitchen: FittedKitchen) -> str:
    lines = [
        line
        for line in kitchen.lines
        if len(line.units) > 1 or line.units[0][0] not in ("fridge", LOW)
    ]
    metres = width_of([u for line in lines for u in line.units]) + CORNER * len(kitchen.corners)
    form = ("", ", round a corner", ", round two corners")[len(kitchen.corners)]
    if not form and len(lines) > 1:
        form = f" in {len(lines)} runs"
    return f"{metres:.1f} m fitted kitchen{form}"


def _units_of(line: UnitLine) -> list[Member]:
    """The units of a line in the plan, and what hangs above them."""
    members: list[Member] = []
    at, turn = line.start, line.wall.heading
    for category, wide in line.units:
        size = _size(category, wide)
        name = "fridge" if category == LOW else category
        low = Member(name, at + wide / 2, BACK + size.depth / 2, 0, 0, size)
        bare = category == "fridge" or line.units == ((LOW, wide),)
        above = [] if bare else hang_above(category, at + wide / 2, wide, BACK)
        for member in (low, *above):
            x, y = point_at(line.wall, member.x, member.y)
            members.append(member._replace(x=x, y=y, heading=turn))
        at += wide
    return members


def _size(category: str, wide: float) -> Size:
    return (
        FRIDGE._replace(width=wide)
        if category == "fridge"
        else Size(wide, UNIT_DEPTH, WORKTOP_HEIGHT)
    )


def point_at(wall: KitchenWall, along: float, out: float) -> tuple[float, float]:
    """A point ``along`` a wall and ``out`` from it, metres."""
    return (wall.x + wall.ux * along - wall.uy * out, wall.y + wall.uy * along + wall.ux * out)


def _seen_from(member: Member, box: Floats) -> Member:
    """A member in the plan in the frame of a patch."""
    x, y, turn = (float(v) for v in box[:3])
    dx, dy, c, s = member.x - x, member.y - y, cos(turn), sin(turn)
    heading = (member.heading - turn + pi) % (2 * pi) - pi
    return member._replace(x=dx * s - dy * c, y=dx * c + dy * s, heading=heading)
