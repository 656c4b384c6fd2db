"""Peripheral forms: buildings along the rim of a block, fronts to the street, a court inside."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Floats, Ints
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


def rim(
    edges: Floats,
    sizes: Floats,
    queue: list[int],
    gap: float,
    share: float,
    open_to: float | None = None,
) -> tuple[list[int], Floats]:
    """Set buildings of a queue along the edges of a block, in turn, ``gap`` metres apart, until a
    share of the queue stands: their numbers and boxes (k, 5).

    Each stands with its front on the edge, looking out. One that leaves the block or comes too
    near to another is moved on by a metre; then those of an edge spread over all of it, so that
    the court closes at its corners. None stands on edges that look to the heading ``open_to``.
    """
    most = math.ceil(len(queue) * share)
    boxes, wide = np.empty((most, 5)), np.empty((most, 8))
    floors = sizes[queue, :2] if most else np.empty((0, 2))
    sides = np.arange(len(edges))
    if open_to is not None:
        along = edges[:, 2:] - edges[:, :2]
        turn = np.arctan2(-along[:, 0], along[:, 1])
        sides = np.flatnonzero(np.cos(turn - open_to) < OPEN)
    owner = np.empty(most, np.int64)
    count = set_along(edges, sides, floors, gap, boxes, wide, owner)
    spread_along(edges, boxes, wide, owner, gap + HAIR, count)
    return queue[:count], boxes[:count]


@compiled
def set_along(
    edges: Floats, sides: Ints, floors: Floats, gap: float, boxes: Floats, wide: Floats, owner: Ints
) -> int:
    """Set buildings of widths and depths ``floors`` (n, 2) in turn along the edges ``sides``, as
    many as ``boxes`` (k, 5) holds, and say how many; ``wide`` (k, 8) are their frames with half
    the gap around, ``owner`` (k,) the edge of each."""
    count, gap = 0, gap + HAIR
    for side in range(sides.shape[0]):
        e = sides[side]
        x0, y0, x1, y1 = edges[e, 0], edges[e, 1], edges[e, 2], edges[e, 3]
        length = math.hypot(x1 - x0, y1 - y0)
        if length <= 0.0:
            continue
        ux, uy, at = (x1 - x0) / length, (y1 - y0) / length, 0.0
        heading = math.atan2(-ux, uy)
        while count < boxes.shape[0] and at + floors[count, 0] <= length:
            width, depth = floors[count, 0], floors[count, 1]
            middle, off = at + 0.5 * width, 0.5 * depth + SLACK
            x, y = x0 + ux * middle - uy * off, y0 + uy * middle + ux * off
            frame = make_frame(x, y, heading, width, depth)
            grown = make_frame(x, y, heading, width + gap, depth + gap)
            if not fits(frame, grown, edges, wide, count, -1):
                at += STEP
                continue
            boxes[count, 0], boxes[count, 1], boxes[count, 2] = x, y, heading
            boxes[count, 3], boxes[count, 4] = width, depth
            for k in range(8):
                wide[count, k] = grown[k]
            owner[count] = e
            count += 1
            at += width + gap
    return count


@compiled
def spread_along(
    edges: Floats, boxes: Floats, wide: Floats, owner: Ints, gap: float, count: int
) -> None:
    """Move the first ``count`` buildings on along their edges, the last of each edge as far as it
    can, those before it in proportion; ``gap`` metres stay between any two."""
    last = count - 1
    while last >= 0:
        e, first = owner[last], last
        while first > 0 and owner[first - 1] == e:
            first -= 1
        x0, y0 = edges[e, 0], edges[e, 1]
        length = math.hypot(edges[e, 2] - x0, edges[e, 3] - y0)
        ux, uy = (edges[e, 2] - x0) / length, (edges[e, 3] - y0) / length
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
