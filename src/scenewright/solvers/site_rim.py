"""Peripheral forms: buildings along the rim of a block, fronts to the street, a court inside."""

from __future__ import annotations

import math

import numpy as np

from scenewright.geometry.boxes import area_in_polygon, common_area, make_frame
from scenewright.site_problem import Floats

SLACK = 1e-3
"""How far buildings stand behind the rim, in metres."""
ROUNDING = 1e-5
"""Square metres."""


def rim(
    edges: Floats, sizes: Floats, queue: list[int], gap: float, share: float
) -> tuple[list[int], Floats]:
    """Set buildings of a queue along the edges of a block, in turn, ``gap`` metres apart, until a
    share of the queue stands: their numbers and boxes (k, 5).

    Each stands with its front on the edge, looking out. One that leaves the block or comes too
    near to another is moved on by a metre.
    """
    most = math.ceil(len(queue) * share)
    numbers: list[int] = []
    boxes: list[list[float]] = []
    waiting = list(queue)
    way = edges[:, 2:] - edges[:, :2]
    lengths = np.hypot(way[:, 0], way[:, 1])
    for (x0, y0, _, _), (dx, dy), length in zip(edges, way, lengths, strict=True):
        at = 0.0
        while waiting and len(numbers) < most and at < length:
            i = waiting[0]
            width, depth = float(sizes[i, 0]), float(sizes[i, 1])
            if at + width > length:
                break
            u = (dx / length, dy / length)
            middle, off = at + width / 2, depth / 2 + SLACK
            box = [
                float(x0 + u[0] * middle - u[1] * off), float(y0 + u[1] * middle + u[0] * off),
                math.atan2(-u[0], u[1]), width, depth,
            ]  # fmt: skip
            if _fits(box, edges, boxes, gap):
                numbers.append(waiting.pop(0))
                boxes.append(box)
                at += width + gap
            else:
                at += 1.0
    return numbers, np.array(boxes).reshape(-1, 5)


def _fits(box: list[float], edges: Floats, boxes: list[list[float]], gap: float) -> bool:
    frame = make_frame(*box)
    if area_in_polygon(frame, edges) < box[3] * box[4] - ROUNDING:
        return False
    grown = make_frame(box[0], box[1], box[2], box[3] + gap, box[4] + gap)
    return all(
        common_area(grown, make_frame(b[0], b[1], b[2], b[3] + gap, b[4] + gap)) < SLACK
        for b in boxes
    )
