"""Baskets to take on the way in, and racks for coats: at the wall next to the entrance."""

from __future__ import annotations

import numpy as np

from scenewright.core.scene import Size
from scenewright.domains.hall.accessories.setting import Setting
from scenewright.domains.hall.accessories.spots import (
    Spots,
    face,
    join_spots,
    line_walls,
    make_spots,
)
from scenewright.domains.hall.problem import Floats

ENTRANCE_FAR, BASKET_NEXT = 0.3, 0.03
"""Cost of a metre from the entrance, and metres between two stacks side by side."""
OPEN = 0.4
"""Cost of a stack that does not continue a row."""


def find_basket_spots(setting: Setting, size: Size) -> Spots:
    """Spots at walls, cheaper the nearer to the entrance, and in line with those that stand."""
    boxes = line_walls(setting.walls, size)[0]
    beside = _continue_rows(setting.others, size)
    far = [_measure_way(setting, rows) for rows in (boxes, beside)]
    return join_spots(
        [make_spots(boxes, OPEN + ENTRANCE_FAR * far[0]), make_spots(beside, ENTRANCE_FAR * far[1])]
    )


def _continue_rows(others: Floats, size: Size) -> Floats:
    """Boxes (k, 5) to the left and right of others (n, 5) of a kind, their backs in line."""
    found = [np.zeros((0, 5))]
    for x, y, heading, width, depth in others:
        front = np.array([np.cos(heading), np.sin(heading)])
        right = np.array([front[1], -front[0]])
        back = np.array([x, y]) + 0.5 * (size.depth - depth) * front
        off = 0.5 * (width + size.width) + BASKET_NEXT
        found.append(face(np.array([back - off * right, back + off * right]), heading, size))
    return np.concatenate(found)


def _measure_way(setting: Setting, boxes: Floats) -> Floats:
    """Metres from the main entrance to boxes (k, 5)."""
    if not setting.doorways:
        return np.zeros(len(boxes))
    off = boxes[:, :2] - setting.doorways[0].middle
    return np.hypot(off[:, 0], off[:, 1])
