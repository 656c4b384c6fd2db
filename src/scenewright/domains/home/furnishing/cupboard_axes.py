"""Rugs and cupboards: along them before their middle, off the doors of wardrobes and off the floor
before a kitchen."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.scene import Piece
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.groups.classes import UNITS

Floats = NDArray[np.float64]

ONE_CUPBOARD = 0.05  # cupboards nearer to one another are one, metres
LOW = 0.05  # what begins higher stands on something, metres
TURNED = 0.1  # sine of the angle by which a cupboard may be off square to the rug
DOORS = 0.3  # floor before a wardrobe in which a rug would lie tight before its doors, metres
STANDING = 0.6
"""Groups before which one stands and works, and the floor that takes, metres."""
RUG_BEFORE = 1.0  # a rug farther before a cupboard does not lie along it, metres


def find_cupboard_axis(rug: Floats, pieces: Sequence[Piece]) -> Floats | None:
    """The box (5,) of a rug moved lengthwise before the middle of the longest row of cupboards
    that it lies along; None where it lies along none.

    >>> from scenewright.core.scene import Pose, Size
    >>> case = Piece("c", "bookcase", "", "a", Pose(0.5, 0.9, 0.0, -1.5708), Size(1.0, 0.3, 2.0))
    >>> moved = find_cupboard_axis(np.array([0.2, 0.0, np.pi / 2, 2.0, 0.8]), [case])
    >>> (moved[:2].round(2) + 0.0).tolist()
    [0.5, 0.0]
    """
    x, y, heading, width, depth = rug.tolist()
    c, s = cos(heading), sin(heading)
    spans: dict[int, list[tuple[float, float]]] = {1: [], -1: []}
    for p in pieces:
        along = (p.pose.x - x) * s - (p.pose.y - y) * c
        ahead = (p.pose.x - x) * c + (p.pose.y - y) * s
        turned = abs(sin(p.pose.heading - heading)) > TURNED
        far = abs(ahead) - (depth + p.size.depth) / 2
        if p.pose.z < LOW and not turned and p.category != "rug" and 0.0 <= far < RUG_BEFORE:
            spans[1 if ahead > 0 else -1].append(
                (along - p.size.width / 2, along + p.size.width / 2)
            )
    rows = [row for side in (1, -1) for row in _join(spans[side]) if _meets(row, width)]
    if not rows:
        return None
    low, high = max(rows, key=lambda row: (round(row[1] - row[0], 3), -abs(row[0] + row[1])))
    moved = rug.copy()
    moved[:2] += (low + high) / 2 * np.array([s, -c])
    return moved


def front_boxes(pieces: Sequence[Piece]) -> StandingObstacles:
    """The floor before wardrobes and kitchen units that a rug leaves free, as something to keep
    clear of."""
    boxes = []
    for p in pieces:
        cooking = p.function in UNITS and p.pose.z < LOW
        free = DOORS if p.category == "wardrobe" else STANDING if cooking else 0.0
        if free:
            ahead, (x, y, _, turn) = (p.size.depth + free) / 2, p.pose
            boxes.append((x + ahead * cos(turn), y + ahead * sin(turn), turn, p.size.width, free))
    spans, names = np.tile((0.0, 1.0), (len(boxes), 1)), ("cupboard",) * len(boxes)
    return StandingObstacles(np.array(boxes).reshape(-1, 5), spans, names)


def _join(spans: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Spans with those that touch made one."""
    found = list[tuple[float, float]]()
    for low, high in sorted(spans):
        if found and low - found[-1][1] < ONE_CUPBOARD:
            found[-1] = (found[-1][0], max(high, found[-1][1]))
        else:
            found.append((low, high))
    return found


def _meets(row: tuple[float, float], width: float) -> bool:
    return row[0] < width / 2 and row[1] > -width / 2
