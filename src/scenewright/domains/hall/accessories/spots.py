"""Spots where a small object may stand, as arrays of boxes and what each costs."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from scenewright.core.scene import Size
from scenewright.domains.hall.problem import Floats, Ints

OFF_THE_WALL, FROM_END, SPOT_STEP, SPOTS_APART = 0.02, 0.12, 0.5, 0.8
"""Metres off the wall, from the end of it, and between two spots along it and on open floor."""
NO_PAIR = -1


class Spots(NamedTuple):
    """``boxes`` (k, 5) and what each of them ``costs`` (k,); two spots of a pair have the same
    number (k,) of ``pairs`` and no other."""

    boxes: Floats
    costs: Floats
    pairs: Ints


def make_spots(boxes: Floats, cost: Floats | float, pairs: Ints | int = NO_PAIR) -> Spots:
    """Spots of boxes (k, 5) that cost as much, by themselves unless in ``pairs``."""
    count = len(boxes)
    costs = np.broadcast_to(np.asarray(cost, np.float64), count).copy()
    return Spots(boxes.reshape(-1, 5), costs, np.broadcast_to(np.asarray(pairs), count).copy())


def join_spots(parts: Iterable[Spots]) -> Spots:
    """All spots of some parts."""
    boxes, costs, pairs = zip(*parts, strict=True)
    return Spots(np.concatenate(boxes), np.concatenate(costs), np.concatenate(pairs))


def line_walls(walls: Floats, size: Size) -> tuple[Floats, Floats]:
    """Boxes (k, 5) with their backs at walls (w, 4), the inside on the left, and how far each is
    from the nearer end of its wall (k,).

    >>> boxes, far = line_walls(np.array([[0.0, 0, 3, 0]]), Size(1.0, 0.4, 1.0))
    >>> boxes[:, 0].round(2).tolist(), float(boxes[0, 1]), far.round(2).tolist()
    ([0.62, 1.12, 1.62, 2.12, 2.38], 0.22, [0.12, 0.62, 0.88, 0.38, 0.12])
    """
    rows, far = [np.zeros((0, 5))], [np.zeros(0)]
    half = 0.5 * size.width + FROM_END
    for x0, y0, x1, y1 in walls:
        length = float(np.hypot(x1 - x0, y1 - y0))
        if length < 2.0 * half:
            continue
        along = np.unique([*np.arange(half, length - half, SPOT_STEP), length - half])
        way = np.array([x1 - x0, y1 - y0]) / length
        inward = np.array([-way[1], way[0]])
        points = [x0, y0] + along[:, None] * way + (OFF_THE_WALL + 0.5 * size.depth) * inward
        rows.append(face(points, np.arctan2(inward[1], inward[0]), size))
        far.append(np.minimum(along, length - along) - 0.5 * size.width)
    return np.concatenate(rows), np.concatenate(far)


def flank(
    middle: Floats, inward: Floats, width: float, gaps: Iterable[float], size: Size
) -> Floats:
    """Boxes (2 g, 5) to both sides of something ``width`` metres wide in the line of a wall, at
    ``gaps`` from it; ``middle`` (2,) lies in the face of the wall, ``inward`` (2,) leads off it."""
    right = np.array([inward[1], -inward[0]])
    front = middle + (OFF_THE_WALL + 0.5 * size.depth) * inward
    off = np.array([[side * (0.5 * (width + size.width) + g)] for g in gaps for side in (-1, 1)])
    return face(front + off * right, np.arctan2(inward[1], inward[0]), size)


def face(points: Floats, heading: Floats | float, size: Size) -> Floats:
    """Boxes (k, 5) of one size about points (k, 2)."""
    boxes = np.empty((len(points), 5))
    boxes[:, :2], boxes[:, 2], boxes[:, 3:] = points, heading, size[:2]
    return boxes


def measure_crowd(boxes: Floats, others: Floats, reach: float) -> Floats:
    """By how many metres each of boxes (k, 5) is nearer than ``reach`` to others (n, 5), summed."""
    off = boxes[:, None, :2] - others[None, :, :2]
    total: Floats = np.maximum(reach - np.hypot(off[..., 0], off[..., 1]), 0.0).sum(1)
    return total


def spread_spots(
    bounds: tuple[float, float, float, float],
    setting: object,  # noqa: ARG001
    size: Size,
) -> Spots:
    """Spots all over the floor within some bounds, lengthwise and across."""
    x0, y0, x1, y1 = bounds
    grid = np.meshgrid(np.arange(x0 + 0.3, x1, SPOTS_APART), np.arange(y0 + 0.3, y1, SPOTS_APART))
    points = np.stack([part.ravel() for part in grid], axis=1)
    turned = [face(points, heading, size) for heading in (-0.5 * np.pi, 0.0)]
    return make_spots(np.concatenate(turned), 0.0)
