"""Guidelines of interior design for single objects (Merrell et al. 2011), for halls.

Clearance, circulation, pairwise distance and angle, balance, alignment, emphasis; the sign is
turned, low is good. Conversation is left out: it is about seats of a dwelling, and no object of a
hall is known to be one. The weights are not printed; these make a square metre of clearance
outweigh any wish about angles, and overlap outweigh clearance. What the paper hard-wires by kind of
furniture here goes by group: neighbours in a group are related, rows at walls belong to a wall.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.hall.terms.measure import clear_of, gap_between, write_row
from scenewright.domains.hall.terms.state import Floats, PreparedHall, State
from scenewright.engine.guidelines import (
    ALIGNMENT,
    ANGLE,
    BACK,
    BALANCE,
    CIRCULATION,
    CLEARANCE,
    DISTANCE,
    EMPHASIS,
    OVERLAP,
    within_range,
)
from scenewright.geometry.boxes import (
    Frame,
    apart,
    area_in_polygon,
    common_area,
    nearest_segment,
    read_frame,
)
from scenewright.geometry.buckets import Buckets, column_of, insert, remove, row_of
from scenewright.geometry.compiled import compiled, inlined


class Ways(NamedTuple):
    """Where a person can stand: ``cover`` (rows * columns,) counts what forbids each cell of
    ``cell`` metres from ``x0``, ``y0`` on; people are discs of ``radius``. ``labels`` and
    ``stack`` are scratch."""

    x0: float
    y0: float
    cell: float
    radius: float
    rows: int
    columns: int
    cover: NDArray[np.int64]
    labels: NDArray[np.int64]
    stack: NDArray[np.int64]


@inlined
def stamp(ways: Ways, frame: Frame, change: int) -> None:
    """Add ``change`` to the cells a person cannot stand in because of a box."""
    x, y, c, s = frame[0], frame[1], frame[2], frame[3]
    w, d = frame[4] + ways.radius, frame[5] + ways.radius
    rx, ry = abs(s) * w + abs(c) * d, abs(c) * w + abs(s) * d
    rows, columns = ways.rows, ways.columns
    for i in range(
        max(int((y - ry - ways.y0) / ways.cell), 0),
        min(int((y + ry - ways.y0) / ways.cell) + 1, rows),
    ):
        py = ways.y0 + (i + 0.5) * ways.cell - y
        for j in range(
            max(int((x - rx - ways.x0) / ways.cell), 0),
            min(int((x + rx - ways.x0) / ways.cell) + 1, columns),
        ):
            px = ways.x0 + (j + 0.5) * ways.cell - x
            if abs(px * s - py * c) <= w and abs(px * c + py * s) <= d:
                ways.cover[i * columns + j] += change


@compiled
def regions(ways: Ways) -> int:
    """How many separate regions people can stand in: flood fill over sides of cells."""
    rows, columns = ways.rows, ways.columns
    cover, labels, stack = ways.cover, ways.labels, ways.stack
    for k in range(rows * columns):
        labels[k] = 0
    count = 0
    for start in range(rows * columns):
        if cover[start] > 0 or labels[start] > 0:
            continue
        count, top, stack[0], labels[start] = count + 1, 1, start, 1
        while top > 0:
            top -= 1
            k = stack[top]
            column = k % columns
            for side in range(4):
                other = k + (1, -1, columns, -columns)[side]
                if (side == 0 and column + 1 == columns) or (side == 1 and column == 0):
                    continue
                if 0 <= other < rows * columns and cover[other] == 0 and labels[other] == 0:
                    labels[other], stack[top] = 1, other
                    top += 1
    return count


@compiled
def put(p: PreparedHall, s: State, ways: Ways, i: int, frame: Frame) -> None:
    """Move an object, filed and stamped anew."""
    if s.buckets.place[i] >= 0:
        stamp(ways, read_frame(s.frames, i), -1)
        remove(s.buckets, i)
    clear = clear_of(frame, p.clear, i)
    write_row(s.frames, i, frame)
    write_row(s.clears, i, clear)
    insert(s.buckets, i, clear[0], clear[1], clear[6])
    stamp(ways, frame, 1)


@inlined
def stands(p: PreparedHall, frame: Frame, clear: Frame, zone: int) -> float:
    """Overlap with fixed objects and with floor outside the zone, clearance beyond the hall."""
    edges = p.zone_edges[p.zone_spans[zone, 0] : p.zone_spans[zone, 1]]
    overlap = 4.0 * frame[4] * frame[5] - area_in_polygon(frame, edges)
    covered = 4.0 * clear[4] * clear[5] - area_in_polygon(clear, p.edges)
    for solids in (p.obstacles, p.keep_free):
        for k in range(solids.shape[0]):
            overlap += common_area(frame, read_frame(solids, k))
            covered += common_area(clear, read_frame(solids, k))
    return OVERLAP * overlap + CLEARANCE * covered


@inlined
def beside(s: State, i: int, frame: Frame, clear: Frame) -> float:
    """Overlap with other objects, and their bodies in its clearance and the other way round."""
    b: Buckets = s.buckets
    overlap, covered, large = 0.0, 0.0, b.columns * b.rows
    far = clear[6] + b.reach
    x0, x1 = column_of(b, clear[0] - far), column_of(b, clear[0] + far)
    y0, y1 = row_of(b, clear[1] - far), row_of(b, clear[1] + far)
    wide = x1 - x0 + 1
    for turn in range(wide * (y1 - y0 + 1) + 1):
        place = large
        if turn > 0:
            place = (y0 + (turn - 1) // wide) * b.columns + x0 + (turn - 1) % wide
        j = b.heads[place]
        while j >= 0:
            other, around = read_frame(s.frames, j), read_frame(s.clears, j)
            if j != i and not apart(clear, around):
                overlap += common_area(frame, other)
                covered += common_area(clear, other) + common_area(frame, around)
            j = b.after[j]
    return OVERLAP * overlap + CLEARANCE * covered


@inlined
def measure_relations(p: PreparedHall, s: State, i: int, frame: Frame) -> float:
    """Distance, angle and alignment with the objects before and after it in its group."""
    unit, total = p.unit_of[i], 0.0
    for j in (i - 1, i + 1):
        if p.spans[unit, 0] <= j < p.spans[unit, 1]:
            other = read_frame(s.frames, j)
            most = p.iota[i] + p.iota[j] + 1.0
            total -= DISTANCE * within_range(
                gap_between(frame, other), 0.05 + p.gaps[unit, 0], most
            )
            between = frame[7] - other[7]
            total -= ANGLE * math.cos(between) + ALIGNMENT * math.cos(4.0 * between)
    return total


@inlined
def faces(p: PreparedHall, i: int, frame: Frame, doors: Floats) -> float:
    """Alignment with the nearest wall, the back of wall objects at theirs, and the way the fronts
    of others are seen from the nearest entrance (emphasis).

    ``doors`` (d, 2) x, y of the entrances in metres.
    """
    unit = p.unit_of[i]
    if p.wall_bound[unit] == 1:
        x, y = frame[0] - frame[2] * frame[5], frame[1] - frame[3] * frame[5]
        least, normal, zone = math.inf, 0.0, p.zones[unit]
        for k in range(p.loop_spans[zone, 0], p.loop_spans[zone, 1]):
            row = p.loops[k]
            if p.stretches[row, 4] <= 0.0:
                continue
            dx, dy = x - p.stretches[row, 0], y - p.stretches[row, 1]
            ux, uy = p.stretches[row, 2], p.stretches[row, 3]
            t = min(max(dx * ux + dy * uy, 0.0), p.stretches[row, 4])
            far = math.hypot(dx - t * ux, dy - t * uy)
            if far < least:
                least, normal = far, math.atan2(ux, -uy)
        return BACK * least - ANGLE * math.cos(frame[7] - normal) if least < math.inf else 0.0
    k, _ = nearest_segment(frame[0], frame[1], p.edges)
    angle = math.atan2(p.edges[k, 3] - p.edges[k, 1], p.edges[k, 2] - p.edges[k, 0])
    total, least, seen = -ALIGNMENT * math.cos(4.0 * (frame[7] - angle)), math.inf, 0.0
    for k in range(doors.shape[0]):
        dx, dy = doors[k, 0] - frame[0], doors[k, 1] - frame[1]
        far = math.hypot(dx, dy)
        if 0.0 < far < least:
            least, seen = far, (dx * frame[2] + dy * frame[3]) / far
    return total - EMPHASIS * seen


@compiled
def own_cost(p: PreparedHall, s: State, i: int, doors: Floats) -> float:
    """Everything that changes with one object's pose, but balance and circulation.

    ``doors`` (d, 2) x, y of the entrances in metres.
    """
    frame, clear = read_frame(s.frames, i), read_frame(s.clears, i)
    total = stands(p, frame, clear, p.zones[p.unit_of[i]]) + beside(s, i, frame, clear)
    return total + measure_relations(p, s, i, frame) + faces(p, i, frame, doors)


@compiled
def whole_cost(p: PreparedHall, s: State, ways: Ways, middle: Floats, doors: Floats) -> float:
    """The cost of a layout: pairs count once, balance and circulation are added.

    ``middle`` (2,) of the hall and ``doors`` (d, 2) x, y of the entrances, metres.
    """
    total = 0.0
    for i in range(s.frames.shape[0]):
        frame, clear = read_frame(s.frames, i), read_frame(s.clears, i)
        total += stands(p, frame, clear, p.zones[p.unit_of[i]]) + faces(p, i, frame, doors)
        total += 0.5 * (beside(s, i, frame, clear) + measure_relations(p, s, i, frame))
    return total + BALANCE * off_balance(s, middle) + CIRCULATION * max(regions(ways) - 1, 0)


@compiled
def off_balance(s: State, middle: Floats) -> float:
    """Distance of the objects' common centre of mass from the middle of the hall, in metres.

    ``middle`` (2,) x, y.
    """
    x, y, mass = 0.0, 0.0, 1e-9
    for i in range(s.frames.shape[0]):
        area = s.frames[i, 4] * s.frames[i, 5]
        x, y, mass = x + area * s.frames[i, 0], y + area * s.frames[i, 1], mass + area
    return math.hypot(x / mass - middle[0], y / mass - middle[1])
