"""All rows of a table weighed for the pieces of a room, by one kernel."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.arranging.degrees import (
    ABOVE,
    DEPTH,
    HEADING,
    IS_FLOOR,
    KIND,
    NUMBER,
    OF_GROUP,
    PART,
    RoomParts,
    measure_away,
    measure_distance,
    measure_gap,
    measure_turn,
    read_part,
    read_thing,
    touches,
)
from scenewright.arranging.row_arrays import (
    ANGLE,
    AREA,
    AWAY,
    COST,
    EACH,
    FAR,
    FIXED,
    FULL,
    GRADE,
    HUNG,
    INSET,
    JOINED,
    METRES,
    OF_BELOW,
    OF_FLOOR,
    PARTS,
    PER,
    RELATION,
    SIDE,
    START,
    TIGHT,
    TO_BELOW,
    TO_FLOOR,
    TO_PIECES,
    TURNED,
    UNSEEN,
    WALL,
    WIDE,
    WITHIN,
    ZONE,
    Arrays,
    Table,
)
from scenewright.arranging.rows import (
    ALONG,
    FLAT,
    FLOOR,
    FRONT,
    GROUP,
    ON,
    PIECE,
    ROUND,
    STRIP,
    WALLS,
    WAYS,
    WHOLE,
    Row,
)
from scenewright.arranging.rows import METRES as PER_METRES
from scenewright.geometry.boxes import (
    Frame,
    apart,
    area_in_polygon,
    beyond,
    common_area,
    make_frame,
)
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]

MOST = 256
"""Rows that do not hold in a room, as a rule fewer."""


class Broken(NamedTuple):
    """A broken row: the thing, the other that breaks it (-1: all together, or the room), the
    degree in ]0, 1], and the cost."""

    row: Row
    thing: int
    other: int
    degree: float
    cost: float


def weigh(table: Table, things: Floats, room: RoomParts) -> list[Broken]:
    """The rows that do not hold among ``things`` (n, 10) in a room, in the order of the table."""
    found = np.empty((MOST, 5))
    while (count := weigh_rows(things, table.arrays, room, found)) > len(found):
        found = np.empty((count, 5))
    rows = table.rows
    return [
        Broken(rows[int(r)], int(i), int(j), degree, cost)
        for r, i, j, degree, cost in found[:count].tolist()
    ]


@compiled
def weigh_rows(things: Floats, table: Arrays, room: RoomParts, found: Floats) -> int:
    """Write row, thing, other, degree and cost of each row that does not hold into ``found``
    (m, 5), as long as there is room; how many there are. See :func:`weigh`."""
    rows, count, r = table.numbers, 0, 0
    while r < rows.shape[0]:
        last = r + 1
        while last < rows.shape[0] and rows[last, JOINED] > 0.0:
            last += 1
        share = 1.0 if room.area >= rows[r, AREA] else rows[r, TIGHT]
        for i in range(things.shape[0] if share > 0.0 else 0):
            if not _is_of(things, i, table, r):
                continue
            if rows[r, EACH] > 0.0:
                count = _weigh_each(things, i, table, r, room, share, found, count)
                continue
            degree, broken = 0.0, False
            for k in range(r, last):
                one = _measure(things, i, table, k, room)
                degree, broken = max(degree, one), broken or one > rows[k, UNSEEN]
            if broken:
                count = _write(found, count, rows, r, i, -1, degree, share)
        r = last
    return count


@inlined
def _write(
    found: Floats, count: int, rows: Floats, r: int, i: int, j: int, degree: float, share: float
) -> int:
    """Write one that does not hold, if there is room; the number after it."""
    if count < found.shape[0]:
        part, cost = min(degree, 1.0), share * rows[r, COST]
        if rows[r, GRADE] == WHOLE:
            cost *= part
        elif rows[r, GRADE] != FLAT:
            cost = cost * (1.0 + part) / 2
        found[count, 0], found[count, 1], found[count, 2] = r, i, j
        found[count, 3], found[count, 4] = part, cost
    return count + 1


@inlined
def _is_of(things: Floats, i: int, table: Arrays, r: int) -> bool:
    """Whether a row is about a thing."""
    rows = table.numbers
    if things[i, NUMBER] < 0.0 and rows[r, FIXED] == 0.0:
        return False
    alike = things[i, IS_FLOOR] == rows[r, OF_FLOOR]
    return alike and _is_meant(things, i, table, r, 0, rows[r, OF_BELOW])


@inlined
def _is_other(things: Floats, i: int, j: int, table: Arrays, r: int) -> bool:
    """Whether a thing is one of the others of a row."""
    rows = table.numbers
    if things[j, IS_FLOOR] != rows[r, TO_FLOOR] or (rows[r, WITHIN] == PIECE and i == j):
        return False
    if rows[r, WITHIN] == GROUP and things[i, NUMBER] == things[j, NUMBER]:
        return False
    return _is_meant(things, j, table, r, 1, rows[r, TO_BELOW])


@inlined
def _is_meant(things: Floats, i: int, table: Arrays, r: int, side: int, below: float) -> bool:
    """Whether a thing is of the class on one side of a row."""
    kind = table.marks[r, int(things[i, KIND]), side]
    group = table.marks[r, int(things[i, OF_GROUP]), side]
    if kind < 0 or group < 0 or (kind == 0 and group == 0):
        return False
    return kind == HUNG or things[i, ABOVE] < below


@inlined
def _measure(things: Floats, i: int, table: Arrays, r: int, room: RoomParts) -> float:
    """The degree to which a row does not hold of a thing, of all others together."""
    rows, boxes = table.numbers, room.boxes
    relation, metres = rows[r, RELATION], rows[r, METRES]
    if relation == ANGLE:
        return max(measure_turn(things[i, HEADING], boxes) - metres, 0.0)
    if relation == WALL:
        gap = measure_gap(things, i, int(rows[r, SIDE]), room.walls)
        return gap / rows[r, FULL] if gap > metres else 0.0
    if relation == FAR:
        far = measure_distance(things, i, boxes, int(rows[r, PARTS])) - metres
        return min(max(far, 0.0) / (rows[r, FULL] - metres), 1.0)
    if relation == AWAY:
        near = measure_distance(things, i, boxes, int(rows[r, PARTS])) <= rows[r, START]
        return measure_away(things, i, boxes, int(rows[r, PARTS])) if near else 0.0
    if relation != ZONE:
        return _measure_alone(things, i, table, r)
    floor = _make_floor(read_thing(things, i), rows, r)
    taken = _measure_parts(floor, room, int(rows[r, PARTS]))
    for j in range(things.shape[0] if rows[r, TO_PIECES] > 0.0 else 0):
        if _is_other(things, i, j, table, r):
            taken += common_area(read_thing(things, j), floor)
    return taken / (4 * floor[4] * floor[5] if rows[r, PER] == FLOOR else 1.0)


@inlined
def _measure_parts(floor: Frame, room: RoomParts, parts: int) -> float:
    """Square metres of some floor that parts of a room take."""
    taken = 0.0
    if parts & WALLS:
        taken += 4 * floor[4] * floor[5] - area_in_polygon(floor, room.edges)
    if parts & WAYS:
        taken += area_in_polygon(floor, room.paths)
    for b in range(room.boxes.shape[0]):
        if int(room.boxes[b, PART]) & parts:
            taken += common_area(read_part(room.boxes, b, 0.0), floor)
    return taken


@inlined
def _measure_alone(things: Floats, i: int, table: Arrays, r: int) -> float:
    """1 where others are there and none stands side by side with a piece of a group, else 0."""
    rows, there = table.numbers, 0.0
    for j in range(things.shape[0]):
        if _is_other(things, i, j, table, r):
            there = 1.0
            for k in range(things.shape[0]):
                own = things[k, NUMBER] == things[i, NUMBER] and things[k, IS_FLOOR] == 0.0
                if own and touches(things, k, j, rows[r, METRES], rows[r, START], rows[r, TURNED]):
                    return 0.0
    return there


@inlined
def _weigh_each(
    things: Floats,
    i: int,
    table: Arrays,
    r: int,
    room: RoomParts,
    share: float,
    found: Floats,
    count: int,
) -> int:
    """Write where a row does not hold of a thing, separately for each other and each part of the
    room; the number after it."""
    rows, own, boxes = table.numbers, read_thing(things, i), room.boxes
    floor, per, metres = _make_floor(own, rows, r), rows[r, PER], rows[r, METRES]
    whole = 4 * floor[4] * floor[5] if per == FLOOR else metres if per == PER_METRES else 1.0
    for j in range(things.shape[0] if rows[r, TO_PIECES] > 0.0 else 0):
        if not _is_other(things, i, j, table, r):
            continue
        other = read_thing(things, j)
        if apart(floor, other) or math.cos(other[7] - own[7]) <= rows[r, TURNED]:
            continue
        if per == STRIP:
            whole = 2 * metres * min(min(own[4], own[5]), min(other[4], other[5]))
        degree = common_area(floor, other) / whole
        if degree > rows[r, UNSEEN]:
            count = _write(found, count, rows, r, i, j, degree, share)
    grown = metres if rows[r, SIDE] == ON else 0.0
    for b in range(boxes.shape[0]):
        if int(boxes[b, PART]) & int(rows[r, PARTS]):
            whole = boxes[b, DEPTH] if per == ALONG else whole
            degree = common_area(floor, read_part(boxes, b, grown)) / whole
            if degree > rows[r, UNSEEN]:
                count = _write(found, count, rows, r, i, -1, degree, share)
    return count


@inlined
def _make_floor(own: Frame, rows: Floats, r: int) -> Frame:
    """The floor of a row at a thing."""
    side, metres = int(rows[r, SIDE]), rows[r, METRES]
    if side == ON:
        return own
    if side == ROUND:
        return make_frame(own[0], own[1], own[7], 2 * (own[4] + metres), 2 * (own[5] + metres))
    if side != FRONT:
        return beyond(own, side, metres)
    wide = rows[r, WIDE] if rows[r, WIDE] > 0.0 else 2 * (own[4] - rows[r, INSET])
    ahead = min(2 * own[5], rows[r, START]) - own[5] + metres / 2
    return make_frame(own[0] + ahead * own[2], own[1] + ahead * own[3], own[7], wide, metres)
