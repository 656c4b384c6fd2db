"""Distances between buildings of a block: spacing all around, sun behind the tall ones."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.geometry.compiled import compiled

ROUNDING = 1e-6


def noon(problem: SiteProblem) -> float:
    """The heading towards the sun at noon: south in the northern half of the world."""
    return -math.pi / 2 if problem.latitude >= 0.0 else math.pi / 2


def list_reserved_edges(
    problem: SiteProblem, boxes: Floats, heights: Floats, ahead: float
) -> Floats:
    """Edges (clockwise) of the ground that buildings keep from others: the spacing all around;
    behind, away from the sun, as many of their heights as asked for, and ahead as many of the
    heights of those to come.

    ``boxes`` (n, 5), ``heights`` (n,) in metres; edges (4 n, 4).
    """
    edges: Floats = np.empty((4 * len(boxes), 4))
    write_reserved(
        np.ascontiguousarray(boxes, np.float64),
        np.ascontiguousarray(heights, np.float64),
        noon(problem),
        problem.spacing,
        problem.sun_spacing,
        float(ahead),
        edges,
    )
    return edges


@compiled
def write_reserved(
    boxes: Floats,
    heights: Floats,
    heading: float,
    gap: float,
    sun: float,
    ahead: float,
    edges: Floats,
) -> None:
    """Write :func:`list_reserved_edges` for a sun at noon in some ``heading``."""
    c, s = math.cos(heading), math.sin(heading)
    before = max(gap, sun * ahead)
    for k in range(boxes.shape[0]):
        bc, bs = math.cos(boxes[k, 2]), math.sin(boxes[k, 2])
        ahead_part, side_part = 0.5 * boxes[k, 4], 0.5 * boxes[k, 3]
        along, across = abs(bc * c + bs * s), abs(bc * s - bs * c)
        x, y = boxes[k, 0] * s - boxes[k, 1] * c, boxes[k, 0] * c + boxes[k, 1] * s
        wide = across * ahead_part + along * side_part + gap
        long = along * ahead_part + across * side_part
        y0, y1 = y - long - max(gap, sun * heights[k]), y + long + before
        for side in range(4):
            for end in range(2):
                corner = (side + end) % 4
                px = x - wide if corner < 2 else x + wide
                py = y0 if corner == 0 or corner == 3 else y1
                edges[4 * k + side, 2 * end] = px * s + py * c
                edges[4 * k + side, 2 * end + 1] = -px * c + py * s


@compiled
def mark_shaded(
    boxes: Floats, heights: Floats, heading: float, sun: float, work: Floats, dark: Flags
) -> None:
    """Mark the boxes (k, 5) that stand nearer behind another one, seen from a sun in ``heading``,
    than ``sun`` times its height; ``work`` (k, 5) is scratch."""
    c, s = math.cos(heading), math.sin(heading)
    for k in range(boxes.shape[0]):
        bc, bs = math.cos(boxes[k, 2]), math.sin(boxes[k, 2])
        along, across = abs(bc * c + bs * s), abs(bc * s - bs * c)
        x, y = boxes[k, 0] * s - boxes[k, 1] * c, boxes[k, 0] * c + boxes[k, 1] * s
        wide = 0.5 * (across * boxes[k, 4] + along * boxes[k, 3])
        long = 0.5 * (along * boxes[k, 4] + across * boxes[k, 3])
        work[k, 0], work[k, 1], work[k, 2] = x - wide, x + wide, y - long
        work[k, 3], work[k, 4] = y + long, y
        dark[k] = False
    for i in range(boxes.shape[0]):
        reach = sun * heights[i] - ROUNDING
        for j in range(boxes.shape[0]):
            if (
                work[i, 4] > work[j, 4]
                and work[i, 0] < work[j, 1]
                and work[i, 1] > work[j, 0]
                and work[i, 2] - work[j, 3] < reach
            ):
                dark[j] = True
