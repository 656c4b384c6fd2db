"""Buildings along the sides of rectangles, many of which are tried: which closes round most floor.

All in the frame of the rectangles, whose middle is the origin: there every building is level or
upright, so what overlaps is told by comparing. Sides run counter-clockwise from the lower one.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, Ints
from scenewright.domains.site.solvers.blocks.distances import mark_shaded
from scenewright.domains.site.solvers.blocks.perimeter_block import (
    HAIR,
    ROUNDING,
    SLACK,
    STEP,
    first_waiting,
)
from scenewright.geometry.compiled import compiled, inlined

ALIKE = 5e-4
"""Square metres of floor by which rings are no better than others."""


class RingRule(NamedTuple):
    """How rings close: the ``gap`` kept and the ``widest`` one in metres, the ``fewest``
    buildings, and how many heights they stand behind one another, seen from the ``noon`` sun in
    radians."""

    gap: float
    widest: float
    fewest: int
    sun: float
    noon: float


class RingWork(NamedTuple):
    """Scratch of :func:`find_ring` for n buildings: boxes (n, 5), the side and the number of each
    (n,), which are taken and dark (n,), their heights (n,), and the shadows' (n, 5)."""

    boxes: Floats
    owner: Ints
    numbers: Ints
    taken: Flags
    dark: Flags
    heights: Floats
    shadows: Floats


def make_ring_work(count: int) -> RingWork:
    """Scratch for so many buildings."""
    return RingWork(
        np.empty((count, 5)),
        np.empty(count, np.int64),
        np.empty(count, np.int64),
        np.empty(count, np.bool_),
        np.empty(count, np.bool_),
        np.empty(count),
        np.empty((count, 5)),
    )


@compiled
def find_ring(
    sides: Floats,
    bounds: Floats,
    orders: Floats,
    rule: RingRule,
    work: RingWork,
    boxes: Floats,
    found: Ints,
) -> int:
    """Write the ``boxes`` (n, 5) of the ring that closes round most floor, then with the largest
    court, and how many they are, the rectangle of ``sides`` (r, 2) and the order they have,
    ``found`` (3,) and the places in that order behind (n,); say how many, 0 if none closes.

    ``orders`` (o, n, 3) are the sizes of the buildings in the orders they are tried in, ``bounds``
    (r,) the floor that each rectangle holds at most.
    """
    most, court, best = 0.0, 0.0, 0
    for r in range(sides.shape[0]):
        if bounds[r] < most - ALIKE:
            continue
        area = sides[r, 0] * sides[r, 1]
        for o in range(orders.shape[0]):
            count = set_round(sides[r], orders[o], rule.gap, work)
            floor = 0.0
            for k in range(count):
                floor += work.boxes[k, 3] * work.boxes[k, 4]
            better = floor > most + ALIKE or (floor > most - ALIKE and area > court)
            if count < rule.fewest or not better:
                continue
            spread_round(sides[r], count, rule.gap, work)
            if not closes(orders[o], count, rule, work):
                continue
            most, court, best = floor, area, count
            found[0], found[1] = r, o
            for k in range(count):
                found[2 + k] = work.numbers[k]
                for column in range(5):
                    boxes[k, column] = work.boxes[k, column]
    return best


@inlined
def set_round(sides: Floats, sizes: Floats, gap: float, work: RingWork) -> int:
    """Set buildings of ``sizes`` (n, 3) along the ``sides`` (2,) of a rectangle, the first of those
    waiting that is no longer than what is left of a side; how many stand."""
    count = 0
    for k in range(sizes.shape[0]):
        work.taken[k] = False
    for e in range(4):
        length, at = sides[e % 2], 0.0
        while True:
            k = first_waiting(sizes, work.taken, length - at)
            if k < 0:
                break
            width, depth = sizes[k, 0], sizes[k, 1]
            put_on_side(sides, e, at + 0.5 * width, width, depth, work.boxes[count])
            if not stands_clear(sides, gap, work.boxes, count, count):
                at += STEP
                continue
            work.owner[count], work.numbers[count], work.taken[k] = e, k, True
            count += 1
            at += width + gap
    return count


@inlined
def put_on_side(
    sides: Floats, e: int, along: float, width: float, depth: float, box: Floats
) -> None:
    """Write the ``box`` (5,) of a building whose middle is ``along`` metres on side ``e``."""
    half = 0.5 * sides[1 - e % 2] - 0.5 * depth - SLACK
    at = along - 0.5 * sides[e % 2]
    if e == 0:
        box[0], box[1], box[2] = at, -half, -0.5 * math.pi
    elif e == 1:
        box[0], box[1], box[2] = half, at, 0.0
    elif e == 2:
        box[0], box[1], box[2] = -at, half, 0.5 * math.pi
    else:
        box[0], box[1], box[2] = -half, -at, math.pi
    box[3], box[4] = width, depth


@inlined
def half_sides(box: Floats) -> tuple[float, float]:
    """Half of what a level or upright ``box`` (5,) takes in either direction."""
    if abs(abs(box[2]) - 0.5 * math.pi) < 0.1:
        return 0.5 * box[3], 0.5 * box[4]
    return 0.5 * box[4], 0.5 * box[3]


@inlined
def stands_clear(sides: Floats, gap: float, boxes: Floats, own: int, count: int) -> bool:
    """Whether building ``own`` lies in the rectangle and off the first others by the ``gap``."""
    x, y = boxes[own, 0], boxes[own, 1]
    w, d = half_sides(boxes[own])
    left, right = max(x - w, -0.5 * sides[0]), min(x + w, 0.5 * sides[0])
    low, high = max(y - d, -0.5 * sides[1]), min(y + d, 0.5 * sides[1])
    if max(right - left, 0.0) * max(high - low, 0.0) < 4.0 * w * d - ROUNDING:
        return False
    for k in range(count):
        kw, kd = half_sides(boxes[k])
        across = w + kw + gap - abs(x - boxes[k, 0])
        along = d + kd + gap - abs(y - boxes[k, 1])
        if k != own and across > 0.0 and along > 0.0 and across * along >= HAIR * HAIR:
            return False
    return True


@inlined
def spread_round(sides: Floats, count: int, gap: float, work: RingWork) -> None:
    """Move buildings on along their sides, the last of each as far as it can, those before it in
    proportion."""
    boxes, last = work.boxes, count - 1
    while last >= 0:
        e, first = work.owner[last], last
        while first > 0 and work.owner[first - 1] == e:
            first -= 1
        end, begin = find_along(sides, e, boxes[last]), find_along(sides, e, boxes[first])
        room = sides[e % 2] - 0.5 * boxes[last, 3] - end
        while room > 0.0 and not slide_on(sides, e, room, gap, boxes, last, count):
            room -= 0.5
        for k in range(last - 1, first, -1):
            by = find_along(sides, e, boxes[k]) - begin
            by *= max(room, 0.0) / max(end - begin, 1e-9)
            if by > 0.0:
                slide_on(sides, e, by, gap, boxes, k, count)
        last = first - 1


@inlined
def find_along(sides: Floats, e: int, box: Floats) -> float:
    """How many metres on side ``e`` the middle of a ``box`` (5,) is."""
    at = box[0] if e % 2 == 0 else box[1]
    return 0.5 * sides[e % 2] + (at if e < 2 else -at)


@inlined
def slide_on(
    sides: Floats, e: int, by: float, gap: float, boxes: Floats, k: int, count: int
) -> bool:
    """Move building ``k`` on by some metres if it fits there; whether it did."""
    column, step = e % 2, by if e < 2 else -by
    boxes[k, column] += step
    if stands_clear(sides, gap, boxes, k, count):
        return True
    boxes[k, column] -= step
    return False


@inlined
def closes(sizes: Floats, count: int, rule: RingRule, work: RingWork) -> bool:
    """Whether neighbours are near enough and none stands in another one's shade."""
    boxes = work.boxes
    for k in range(count):
        after = (k + 1) % count
        w, d = half_sides(boxes[k])
        aw, ad = half_sides(boxes[after])
        across = max(abs(boxes[k, 0] - boxes[after, 0]) - w - aw, 0.0)
        along = max(abs(boxes[k, 1] - boxes[after, 1]) - d - ad, 0.0)
        if math.hypot(across, along) > rule.widest:
            return False
        work.heights[k] = sizes[work.numbers[k], 2]
    if rule.sun <= 0.0:
        return True
    mark_shaded(boxes[:count], work.heights, rule.noon, rule.sun, work.shadows, work.dark)
    shaded = 0
    for k in range(count):
        shaded += work.dark[k]
    return shaded == 0
