"""Boxes put square to the nearest wall, their backs to it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import compiled
from scenewright.geometry.fit import stands

NEAR = 0.08  # a back within this many metres of a wall belongs to it
SKEW = math.radians(5)  # what is turned by less is meant to be square
QUARTER = 0.5 * math.pi
SHIFT, STEPS = 0.01, 5  # a step aside in metres, and how many are tried each way


def align_to_wall(
    boxes: Floats,
    new: NDArray[np.bool_],
    backs: NDArray[np.bool_],
    walls: Floats,
    edges: Floats,
    zones: Floats,
) -> Floats:
    """Boxes ``(n, 5)`` turned square to the nearest wall where they nearly are, and those with
    ``backs`` (n,) put flush to it where it is near; only the ``new`` ones, and only where they
    still lie inside ``edges`` and meet no other box and none of the ``zones``, there or, of those
    that were turned, up to 0.05 m along the wall.

    >>> room = np.array([[0, 0, 4, 0], [4, 0, 4, 3], [4, 3, 0, 3], [0, 3, 0, 0]], float)
    >>> bed = np.array([[1.5, 1.04, 1.55, 1.0, 2.0]])
    >>> yes = np.array([True])
    >>> align_to_wall(bed, yes, yes, room, room, np.zeros((0, 5)))[0].round(3).tolist()
    [1.479, 1.0, 1.571, 1.0, 2.0]
    """
    found = boxes.copy()
    _set_square(found, boxes, new, backs, walls, edges, zones)
    return found


@compiled
def _set_square(
    found: Floats,
    boxes: Floats,
    new: NDArray[np.bool_],
    backs: NDArray[np.bool_],
    walls: Floats,
    edges: Floats,
    zones: Floats,
) -> None:
    for i in range(found.shape[0]):
        if new[i]:
            x, y, heading = _align_box(boxes[i], backs[i], walls)
            for step in range(2 * STEPS + 1):
                aside = SHIFT * ((step + 1) // 2) * (1.0 if step % 2 else -1.0)
                found[i, 0] = x - aside * math.sin(heading)
                found[i, 1] = y + aside * math.cos(heading)
                found[i, 2] = heading
                if stands(found, i, edges, zones):
                    break
                if step == 2 * STEPS or heading == boxes[i, 2]:
                    for column in range(3):
                        found[i, column] = boxes[i, column]
                    break


@compiled
def _align_box(box: Floats, backed: bool, walls: Floats) -> tuple[float, float, float]:
    """Middle and heading of a box put square, as it is if no wall near it is nearly along it."""
    x = box[0] - 0.5 * box[4] * math.cos(box[2])
    y = box[1] - 0.5 * box[4] * math.sin(box[2])
    least, far, turn, at = math.inf, math.inf, 0.0, (0.0, 0.0, 1.0, 0.0)
    for k in range(walls.shape[0]):
        dx, dy = walls[k, 2] - walls[k, 0], walls[k, 3] - walls[k, 1]
        length = max(math.sqrt(dx * dx + dy * dy), 1e-9)
        u, v = -dy / length, dx / length
        part = (x - walls[k, 0]) * v - (y - walls[k, 1]) * u
        apart = (x - walls[k, 0]) * u + (y - walls[k, 1]) * v
        off = math.hypot(apart, max(-part, part - length, 0.0))
        skew = (box[2] - math.atan2(v, u)) / QUARTER
        skew = (skew - math.floor(skew + 0.5)) * QUARTER
        worth = off if abs(skew) <= SKEW else off + 10.0
        if worth < least:
            least, far, turn = worth, off, skew
            at = (walls[k, 0] + v * part, walls[k, 1] - u * part, u, v)
    if abs(turn) > SKEW or least == math.inf:
        return box[0], box[1], box[2]
    heading = box[2] - turn
    faces = math.cos(heading) * at[2] + math.sin(heading) * at[3] > 0.99
    if backed and faces and far < NEAR:
        return at[0] + at[2] * 0.5 * box[4], at[1] + at[3] * 0.5 * box[4], heading
    return box[0], box[1], heading
