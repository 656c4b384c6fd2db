"""Peripheral forms: buildings along the rim of a block, fronts to the street, a court inside."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Floats
from scenewright.geometry.boxes import Frame, area_in_polygon, common_area, make_frame, read_frame
from scenewright.geometry.compiled import compiled, inlined

SLACK = 1e-3
"""How far buildings stand behind the rim, in metres."""
ROUNDING = 1e-5
"""Square metres."""
HAIR = 1e-4
"""Metres that buildings stand farther apart than asked for. Boxes that share less than its square
overlap by less than it, so what rounding makes of touching ones leaves the whole gap."""
STEP = 1.0
"""How far a building that does not fit is moved on, in metres."""


def rim(
    edges: Floats, sizes: Floats, queue: list[int], gap: float, share: float
) -> tuple[list[int], Floats]:
    """Set buildings of a queue along the edges of a block, in turn, ``gap`` metres apart, until a
    share of the queue stands: their numbers and boxes (k, 5).

    Each stands with its front on the edge, looking out. One that leaves the block or comes too
    near to another is moved on by a metre.
    """
    most = math.ceil(len(queue) * share)
    boxes, wide = np.empty((most, 5)), np.empty((most, 8))
    floors = sizes[queue, :2] if most else np.empty((0, 2))
    count = set_along(edges, floors, gap, boxes, wide)
    return queue[:count], boxes[:count]


@compiled
def set_along(edges: Floats, floors: Floats, gap: float, boxes: Floats, wide: Floats) -> int:
    """Set buildings of widths and depths ``floors`` (n, 2) in turn, as many as ``boxes`` (k, 5)
    holds, and say how many; ``wide`` (k, 8) is scratch for frames with half the gap around."""
    count, gap = 0, gap + HAIR
    for e in range(edges.shape[0]):
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
            if not fits(frame, grown, edges, wide, count):
                at += STEP
                continue
            boxes[count, 0], boxes[count, 1], boxes[count, 2] = x, y, heading
            boxes[count, 3], boxes[count, 4] = width, depth
            for k in range(8):
                wide[count, k] = grown[k]
            count += 1
            at += width + gap
    return count


@inlined
def fits(frame: Frame, grown: Frame, edges: Floats, wide: Floats, count: int) -> bool:
    """Whether a building lies in the block and, with half the gap around, off the first others."""
    for k in range(count):
        if common_area(grown, read_frame(wide, k)) >= HAIR * HAIR:
            return False
    area = 4.0 * frame[4] * frame[5]
    return area_in_polygon(frame, edges) >= area - ROUNDING
