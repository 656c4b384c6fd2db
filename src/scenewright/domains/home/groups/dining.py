"""Dining groups: tables with chairs on their free sides."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.least_sizes import TABLE

CHAIR = Size(0.46, 0.5, 0.85)
SMALL = Size(0.4, 0.46, 0.82)  # where two sit at a metre
SEAT = 0.5  # free depth a chair and its sitter take beyond the table's edge
CLOSE = 0.475  # between the middles of chairs side by side, at least
LEG = 0.06  # of a table, in from its short side
STOOL = Size(0.32, 0.32, 0.45)
PUSHED = 0.08  # of a stool pushed under its table that still shows, metres
TUCK = 0.2  # how far a chair stands under the table


def dining() -> Iterator[Group]:
    """Tables for two to eight, chairs on all used sides."""
    yield _table(TABLE.width, 0.75, sides=1, ends=0)
    yield _table(0.9, 0.9, sides=1, ends=1)
    for length, deep in ((1.2, 0.75), (1.3, 0.8), (1.4, 0.85), (1.6, 0.9)):
        yield _table(length, deep, sides=2, ends=0)
    for length, deep in ((1.6, 0.9), (1.8, 0.95), (2.0, 1.0)):
        yield _table(length, deep, sides=2, ends=1)
    yield _table(2.2, 1.0, sides=3, ends=1)
    for diameter in (0.9, 1.1):
        yield _round(diameter)


def dining_wall() -> Iterator[Group]:
    """A table with its long side at the wall: two chairs at the front or at the ends, small ones
    also with one at the front, or with one there and one at an end, the other in a corner."""
    for length, deep in (TABLE[:2], (0.9, 0.6), (1.0, 0.65), (1.2, 0.75)):
        yield _wall_table(length, deep, front=1 if length < 1 else 2, ends=0)
        yield _wall_table(length, deep, front=0, ends=1)
        if length < 1.0:
            yield _corner_table(length, deep, 1)
            yield _corner_table(length, deep, -1)
        if length >= 0.9:
            yield _wall_table(length, deep, front=1, ends=1)


def tables_for_many() -> Iterator[Group]:
    """Tables at a wall for four to six, for households that say how many they are: a short side
    at the wall and chairs along both long ones, or a long side at the wall."""
    for length, deep, sides, end in (
        (0.8, 0.7, 1, 0),
        (1.2, 0.75, 2, 0),
        (1.3, 0.8, 2, 0),
        (1.2, 0.75, 2, 1),
        (1.7, 0.8, 3, 0),
    ):
        yield _head_table(length, deep, sides, end)
    for length, front in ((1.5, 2), (2.0, 3)):
        yield _wall_table(length, 0.75, front, ends=1)


def tables_with_stools() -> Iterator[Group]:
    """Small tables with two stools pushed under, where two chairs have no place: the stools before
    a long side, or at both where a short one is at the wall."""
    length, deep, _ = TABLE
    members = (
        Member("dining_table", 0, 0, 0, pi / 2, Size(length, deep, 0.74)),
        Member("vase", 0, -length / 4, 0.74, 0, Size(0.14, 0.14, 0.26), on=0),
        *(
            Member("stool", x, _aside(length), 0, turn, STOOL)
            for x, turn in (
                (deep / 2 + PUSHED - STOOL.depth / 2, pi / 2),
                (STOOL.depth / 2 - deep / 2 - PUSHED, -pi / 2),
            )
        ),
    )
    name = f"{length:.1f} m table from the wall, two stools"
    yield Group("dining_wall", name, deep + 2 * PUSHED, length, members)
    for length, deep in (TABLE[:2], (1.0, TABLE.depth)):
        depth = deep + PUSHED
        y = PUSHED / -2
        members = (
            Member("dining_table", 0, y, 0, 0, Size(length, deep, 0.74)),
            Member("vase", 0, y - deep / 5, 0.74, 0, Size(0.14, 0.14, 0.26), on=0),
            *(
                Member("stool", side * _aside(length), depth / 2 - STOOL.depth / 2, 0, pi, STOOL)
                for side in (1, -1)
            ),
        )
        yield Group("dining_wall", f"{length:.1f} m table, two stools", length, depth, members)


def _aside(length: float) -> float:
    """How far from the middle of a table a stool stands, between the legs."""
    return min(length / 4, length / 2 - LEG - STOOL.width / 2)


def further_tables() -> Iterator[Group]:
    """Tables tried where a room is composed: :func:`tables_for_many`, those with stools."""
    yield from tables_for_many()
    yield from tables_with_stools()


def kitchen_tables() -> Iterator[Group]:
    """Tables tried besides in a room that is a kitchen and nothing else: for two round a free
    corner, for four with a long side at the wall, for five from it."""
    for length, deep in ((1.0, 0.65), (1.2, 0.75)):
        yield _corner_table(length, deep, 1)
        yield _corner_table(length, deep, -1)
    yield _wall_table(1.4, 0.65, front=2, ends=1)
    yield _head_table(1.6, 0.8, 2, 1)


def _head_table(length: float, deep: float, sides: int, end: int) -> Group:
    """A table with a short side at the wall."""
    width, depth = deep + 2 * SEAT, length + SEAT * end
    y = -depth / 2 + length / 2
    x = deep / 2 + CHAIR.depth / 2 - TUCK
    step = CLOSE if end else length / sides  # a chair at the end has the corners to itself
    first = LEG + CHAIR.width / 2 if end else step / 2
    rows = [-depth / 2 + first + i * step for i in range(sides)]
    members = [
        Member("dining_table", 0, y, 0, pi / 2, Size(length, deep, 0.74)),
        Member("vase", 0, y, 0.74, 0, Size(0.14, 0.14, 0.26), on=0),
        *(
            Member("dining_chair", side * x, at, 0, side * pi / 2, CHAIR)
            for side in (1, -1)
            for at in rows
        ),
        *_chairs_along(deep, end, y + length / 2 + CHAIR.depth / 2 - TUCK, pi),
    ]
    name = f"{length:.1f} m table from the wall for {2 * sides + end}"
    return Group("dining_wall", name, width, depth, tuple(members))


def _corner_table(length: float, deep: float, side: int) -> Group:
    """A table for two with one end free, to the right if ``side`` is 1."""
    width, depth = length + SEAT, deep + SEAT
    x, y = -side * SEAT / 2, -SEAT / 2
    aside = x - side * ((length - CHAIR.width) / 2 - LEG)
    members = (
        Member("dining_table", x, y, 0, 0, Size(length, deep, 0.74)),
        Member("vase", x, y - deep / 5, 0.74, 0, Size(0.14, 0.14, 0.26), on=0),
        Member("dining_chair", aside, y + deep / 2 + CHAIR.depth / 2 - TUCK, 0, pi, CHAIR),
        Member(
            "dining_chair",
            x + side * (length / 2 + CHAIR.depth / 2 - TUCK),
            y,
            0,
            side * pi / 2,
            CHAIR,
        ),
    )
    return Group("dining_wall", f"{length:.1f} m corner table for 2", width, depth, members)


def _chairs_along(length: float, count: int, y: float, heading: float) -> list[Member]:
    step = length / max(count, 1)
    chair = CHAIR if step > 2 * LEG + SMALL.width else SMALL
    step = min(step, (length - 2 * LEG - chair.width) / max(count - 1, 1))  # between the legs
    y += (chair.depth - CHAIR.depth) / 2 * (1 if y > 0 else -1)
    return [
        Member("dining_chair", (i - (count - 1) / 2) * step, y, 0, heading, chair)
        for i in range(count)
    ]


def _chairs_at_ends(length: float, y: float) -> list[Member]:
    x = length / 2 + CHAIR.depth / 2 - TUCK
    return [
        Member("dining_chair", x, y, 0, pi / 2, CHAIR),
        Member("dining_chair", -x, y, 0, -pi / 2, CHAIR),
    ]


def _table(length: float, deep: float, sides: int, ends: int) -> Group:
    width, depth = length + 2 * SEAT * ends, deep + 2 * SEAT
    y = deep / 2 + CHAIR.depth / 2 - TUCK
    members = [
        Member("dining_table", 0, 0, 0, 0, Size(length, deep, 0.74)),
        Member("bowl", 0, 0, 0.74, 0, Size(0.28, 0.28, 0.1), on=0),
        *_chairs_along(length, sides, y, pi),
        *_chairs_along(length, sides, -y, 0),
        *(_chairs_at_ends(length, 0) if ends else ()),
    ]
    seats = 2 * (sides + ends)
    return Group("dining", f"{length:.1f} m table for {seats}", width, depth, tuple(members))


def _round(diameter: float) -> Group:
    size = diameter + 2 * SEAT
    reach = diameter / 2 + CHAIR.depth / 2 - TUCK + 0.04
    members = [
        Member("round_table", 0, 0, 0, 0, Size(diameter, diameter, 0.74)),
        Member("vase", 0, 0, 0.74, 0, Size(0.16, 0.16, 0.28), on=0),
        Member("dining_chair", 0, reach, 0, pi, CHAIR),
        Member("dining_chair", 0, -reach, 0, 0, CHAIR),
        Member("dining_chair", reach, 0, 0, pi / 2, CHAIR),
        Member("dining_chair", -reach, 0, 0, -pi / 2, CHAIR),
    ]
    return Group("dining", f"{diameter:.1f} m round table for 4", size, size, tuple(members))


def _wall_table(length: float, deep: float, front: int, ends: int) -> Group:
    width, depth = length + 2 * SEAT * ends, deep + (SEAT if front else 0.0)
    y = -depth / 2 + deep / 2
    members = [
        Member("dining_table", 0, y, 0, 0, Size(length, deep, 0.74)),
        Member("vase", 0, y - deep / 5, 0.74, 0, Size(0.14, 0.14, 0.26), on=0),
    ]
    if front:
        row = length - 0.3 if ends else length
        members += _chairs_along(row, front, y + deep / 2 + CHAIR.depth / 2 - TUCK, pi)
    if ends:
        members += _chairs_at_ends(length, y)
    seats = front + 2 * ends
    name = f"{length:.1f} m wall table for {seats}"
    return Group("dining_wall", name, width, depth, tuple(members))
