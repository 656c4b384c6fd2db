"""Peripheral forms: buildings along the rim of a block, fronts to the street, a court inside."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.site.problem import Flags, Floats, Ints
from scenewright.geometry.boxes import Frame, area_in_polygon, common_area, make_frame, read_frame
from scenewright.geometry.compiled import compiled, inlined

SLACK = 1e-3
"""How far buildings stand behind the rim, in metres."""
ROUNDING = 1e-5
"""Square metres."""
HAIR = 1e-4
"""Metres that buildings stand farther apart than asked for. Boxes that share less than its square
overlap by less than it, so what rounding makes of touching ones leaves the whole gap."""
OPEN = 0.7
"""Cosine of how far an edge may turn from a heading and still look that way."""
STEP = 1.0
"""How far a building that does not fit is moved on, in metres."""
SMOOTH, INWARD, BACK, STEPS = 3.0, 6.0, 2.0, 6
"""Metres by which lines are simpler than edges; how far off a line buildings may stand, and the
steps in which that is tried; gaps tried from the widest on."""


def rim(
    edges: Floats,
    sizes: Floats,
    queue: list[int],
    gap: float,
    share: float,
    open_to: float | None = None,
    lines: Floats | None = None,
    widest: float = 0.0,
) -> tuple[list[int], Floats]:
    """Set buildings of a queue along the edges of a block, in turn, ``gap`` metres apart, until a
    share of the queue stands: their numbers and boxes (k, 5).

    Each stands with its front on the edge, looking out. One that leaves the block or comes too
    near to another is moved on by a metre; then those of an edge spread over all of it, so that
    the court closes at its corners. None stands on edges that look to the heading ``open_to``.
    ``lines`` (m, 4) are followed instead of the edges, up to :data:`INWARD` metres off them; along
    them buildings stand up to ``widest`` metres farther apart, as far as as many still stand.
    """
    lines, inward = (edges, 0.0) if lines is None else (lines, INWARD)
    if open_to is not None:
        along = lines[:, 2:] - lines[:, :2]
        turn = np.arctan2(-along[:, 0], along[:, 1])
        lines = lines[np.cos(turn - open_to) < OPEN]
    floors, most = sizes[queue, :2].reshape(-1, 2), math.ceil(len(queue) * share)
    best = _fill_lines(lines, edges, floors, (gap, gap, inward), most)
    for more in spread_out(widest, gap, STEPS) if widest else ():
        found = _fill_lines(lines, edges, floors, (gap, gap + more, inward), most)
        if len(found.boxes) >= len(best.boxes):
            best = found
            break
    spread_along(lines, edges, best.boxes, best.wide, best.owner, gap + HAIR)
    return [queue[k] for k in best.numbers.tolist()], best.boxes


@lru_cache(512)
def spread_out(first: float, last: float, count: int) -> tuple[float, ...]:
    """Numbers from the first to the last in equal proportions."""
    return tuple(np.geomspace(first, last, count).tolist())


class AlongLines(NamedTuple):
    """Buildings along lines: ``numbers`` (k,) in the queue, ``boxes`` (k, 5), their frames ``wide``
    (k, 8) with half the gap around, and the line each stands on, ``owner`` (k,)."""

    numbers: Ints
    boxes: Floats
    wide: Floats
    owner: Ints


def _fill_lines(
    lines: Floats, edges: Floats, floors: Floats, rule: tuple[float, float, float], most: int
) -> AlongLines:
    found = AlongLines(
        np.full(most, -1, np.int64),
        np.empty((most, 5)),
        np.empty((most, 8)),
        np.empty(most, np.int64),
    )
    count = set_along(lines, edges, floors, rule, np.zeros(len(floors), np.bool_), *found)
    numbers, boxes, wide, owner = found
    return AlongLines(numbers[:count], boxes[:count], wide[:count], owner[:count])


def list_front_lines(edges: Floats) -> Floats:
    """The lines (m, 4) that buildings of a block follow: its edges (e, 4), rings one after
    another, drawn more simply by :data:`SMOOTH` metres.

    >>> bent = np.array([[0, 0], [20, 0.5], [40, 0], [40, 30], [0, 30]], float)
    >>> list_front_lines(np.hstack([bent, np.roll(bent, -1, axis=0)])).tolist()[0]
    [0.0, 0.0, 40.0, 0.0]
    """
    joined = (edges[1:, :2] == edges[:-1, 2:]).all(1)
    rings = np.split(edges[:, :2], np.flatnonzero(~joined) + 1)
    plain = [
        shapely.get_coordinates(shapely.simplify(shapely.LinearRing(ring), SMOOTH))
        for ring in rings
        if len(ring) > 2
    ]
    return np.concatenate([np.zeros((0, 4)), *(np.hstack([r[:-1], r[1:]]) for r in plain)])


@compiled
def set_along(
    lines: Floats,
    edges: Floats,
    floors: Floats,
    rule: tuple[float, float, float],
    taken: Flags,
    numbers: Ints,
    boxes: Floats,
    wide: Floats,
    owner: Ints,
) -> int:
    """Set buildings of widths and depths ``floors`` (n, 2) along ``lines``, the first of those
    waiting that is no longer than what is left of a line, as many as ``boxes`` (k, 5) holds, and
    say how many; the rest is that of :class:`AlongLines`. ``rule``: the gap kept, the one along a
    line, and how far behind it buildings may stand."""
    count, gap, pace, inward = 0, rule[0] + HAIR, rule[1] + HAIR, rule[2]
    for e in range(lines.shape[0]):
        x0, y0, x1, y1 = lines[e, 0], lines[e, 1], lines[e, 2], lines[e, 3]
        length = math.hypot(x1 - x0, y1 - y0)
        if length <= 0.0:
            continue
        ux, uy, at = (x1 - x0) / length, (y1 - y0) / length, 0.0
        heading = math.atan2(-ux, uy)
        while count < boxes.shape[0]:
            k = first_waiting(floors, taken, length - at)
            if k < 0:
                break
            width, depth = floors[k, 0], floors[k, 1]
            middle, off, stands = at + 0.5 * width, 0.5 * depth + SLACK, False
            while off <= 0.5 * depth + SLACK + inward:
                x, y = x0 + ux * middle - uy * off, y0 + uy * middle + ux * off
                frame = make_frame(x, y, heading, width, depth)
                grown = make_frame(x, y, heading, width + gap, depth + gap)
                if fits(frame, grown, edges, wide, count, -1):
                    stands = True
                    break
                off += BACK
            if not stands:
                at += STEP
                continue
            boxes[count, 0], boxes[count, 1], boxes[count, 2] = x, y, heading
            boxes[count, 3], boxes[count, 4] = width, depth
            for column in range(8):
                wide[count, column] = grown[column]
            owner[count], numbers[count], taken[k] = e, k, True
            count += 1
            at += width + pace
    return count


@inlined
def first_waiting(floors: Floats, taken: Flags, room: float) -> int:
    """The first building not taken that is no longer than the ``room``; -1 if there is none."""
    for k in range(floors.shape[0]):
        if not taken[k] and floors[k, 0] <= room:
            return k
    return -1


@compiled
def spread_along(
    lines: Floats, edges: Floats, boxes: Floats, wide: Floats, owner: Ints, gap: float
) -> None:
    """Move buildings on along their lines, the last of each line as far as it can, those before it
    in proportion; ``gap`` metres stay between any two."""
    count = boxes.shape[0]
    last = count - 1
    while last >= 0:
        e, first = owner[last], last
        while first > 0 and owner[first - 1] == e:
            first -= 1
        x0, y0 = lines[e, 0], lines[e, 1]
        length = math.hypot(lines[e, 2] - x0, lines[e, 3] - y0)
        ux, uy = (lines[e, 2] - x0) / length, (lines[e, 3] - y0) / length
        at = (boxes[last, 0] - x0) * ux + (boxes[last, 1] - y0) * uy
        begin = (boxes[first, 0] - x0) * ux + (boxes[first, 1] - y0) * uy
        room = length - 0.5 * boxes[last, 3] - at
        while room > 0.0:
            if slide(edges, boxes, wide, last, ux * room, uy * room, gap, count):
                break
            room -= 0.5
        for k in range(last - 1, first, -1):
            here = (boxes[k, 0] - x0) * ux + (boxes[k, 1] - y0) * uy
            by = room * (here - begin) / max(at - begin, 1e-9) if room > 0.0 else 0.0
            if by > 0.0:
                slide(edges, boxes, wide, k, ux * by, uy * by, gap, count)
        last = first - 1


@inlined
def slide(
    edges: Floats, boxes: Floats, wide: Floats, k: int, dx: float, dy: float, gap: float, count: int
) -> bool:
    """Move building ``k`` by (dx, dy) metres if it fits there; whether it did."""
    x, y, heading = boxes[k, 0] + dx, boxes[k, 1] + dy, boxes[k, 2]
    frame = make_frame(x, y, heading, boxes[k, 3], boxes[k, 4])
    grown = make_frame(x, y, heading, boxes[k, 3] + gap, boxes[k, 4] + gap)
    if not fits(frame, grown, edges, wide, count, k):
        return False
    boxes[k, 0], boxes[k, 1] = x, y
    for column in range(8):
        wide[k, column] = grown[column]
    return True


@inlined
def fits(frame: Frame, grown: Frame, edges: Floats, wide: Floats, count: int, own: int) -> bool:
    """Whether building ``own`` lies in the block and, with half the gap around, off the first
    others."""
    for k in range(count):
        if k != own and common_area(grown, read_frame(wide, k)) >= HAIR * HAIR:
            return False
    area = 4.0 * frame[4] * frame[5]
    return area_in_polygon(frame, edges) >= area - ROUNDING
