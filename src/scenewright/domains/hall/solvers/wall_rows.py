"""Wall rows for the hierarchical method: objects set along the walls of a zone, longest first."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.solvers.cells import CellObjects
from scenewright.domains.hall.terms.state import Floats

WALL_ROW_OFF, CORNER, WALL_ROW_STEP, FARTHEST_STEP = 0.003, 0.1, 0.1, 1.0
"""How far backs stand off the wall, what stays free in corners, steps past what is in the way,
and the greatest gap between neighbours, in metres."""


def polygons_of(boxes: Floats) -> Any:
    """Boxes (n, 5) as polygons (n,)."""
    return shapely.polygons(corners(np.asarray(boxes, np.float64).reshape(-1, 5)))


def grow_boxes(boxes: Floats, clear: Floats, share: float) -> Floats:
    """Boxes (n, 5) with a share of their clear depths (n, 4) at front, left, back, right."""
    front, left, back, right = (share * clear).T
    cos, sin = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    ahead, aside = 0.5 * (front - back), 0.5 * (left - right)
    return np.column_stack(
        [
            boxes[:, 0] + cos * ahead - sin * aside,
            boxes[:, 1] + sin * ahead + cos * aside,
            boxes[:, 2],
            boxes[:, 3] + left + right,
            boxes[:, 4] + front + back,
        ]
    )


def wall_row(members: CellObjects, walls: Floats, free: Any) -> Floats | None:
    """Boxes (n, 5) of a row along ``walls`` (k, 7; see :class:`.hall_state.Prepared`) of a zone,
    on its ``free`` floor, with the widest even gap of at most 1 m that finds room; None if the
    walls are too short."""
    order = np.argsort(-walls[:, 4], kind="stable")
    for gap in FARTHEST_STEP * np.array([1.0, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05, 0.0]):
        found = _walk_walls(members, walls[order], free, float(gap))
        if found is not None:
            return found
    return None


def _walk_walls(members: CellObjects, walls: Floats, free: Any, gap: float) -> Floats | None:
    deepest, boxes = float(members.sizes[:, 1].max()), []
    shapely.prepare(free)
    i = 0
    for wall in walls:
        t = float(wall[6]) * (deepest + CORNER)
        while i < len(members.sizes):
            width, depth = members.sizes[i]
            if t + width > wall[4]:
                break
            box = _at(wall, t + 0.5 * width, width, depth)
            if free.covers(polygons_of(box)[0].buffer(-0.001)):
                boxes.append(box)
                i, t = i + 1, t + width + gap
            else:
                t += WALL_ROW_STEP
    return np.array(boxes) if i == len(members.sizes) else None


def _at(wall: Floats, along: float, width: float, depth: float) -> Floats:
    dx, dy, off = wall[2], wall[3], 0.5 * depth + WALL_ROW_OFF
    return np.array(
        [
            wall[0] + dx * along - dy * off,
            wall[1] + dy * along + dx * off,
            math.atan2(dx, -dy),
            width,
            depth,
        ]
    )
