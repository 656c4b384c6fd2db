"""Houses that stand on lanes, drives and footways of the brief."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Shape, Shapes
from scenewright.check.buildings import measure_shared, state_fault
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.domains.village.brief import Lane


class LaidLane(Protocol):
    """A lane of a solution: its block, middle line (n, 2), width, radius of its turning head."""

    block: str
    line: Any
    width: float
    head: float


def cover_laid_lanes(lanes: Sequence[LaidLane]) -> Shape:
    """The ground of lanes of a solution, with their turning heads."""
    parts = [
        shapely.LineString(lane.line).buffer(lane.width / 2, cap_style="flat") for lane in lanes
    ]
    heads = [shapely.Point(lane.line[-1]).buffer(lane.head - 0.1) for lane in lanes if lane.head]
    return shapely.union_all(np.array([*parts, *heads], object))


def find_on_laid_lanes(houses: Sequence[Piece], shapes: Shapes, ground: Shape) -> list[Finding]:
    """Houses more than 1 cm on a lane that was laid."""
    found = []
    for piece, shape in zip(houses, shapes, strict=True):
        depth, area = measure_shared(shapely.intersection(shape, ground))
        if depth > TOLERANCE:
            message = f"{piece.id} stands on a lane by {depth:.2f} m ({area:.2f} m²)"
            found.append(state_fault("blocked_path", piece, message, depth, area, "lane"))
    return found


def find_on_lanes(houses: Sequence[Piece], shapes: Shapes, lanes: Sequence[Lane]) -> list[Finding]:
    """Houses more than 1 cm on a lane, by its line and width in the brief."""
    if not len(shapes) or not lanes:
        return []
    lines = np.array([shapely.LineString(lane.line) for lane in lanes], object)
    half = np.array([lane.width / 2 for lane in lanes])
    ground = shapely.buffer(lines, half, cap_style="flat", join_style="mitre")
    found = []
    rows, ways = shapely.STRtree(ground).query(shapes, predicate="intersects")
    for k, way in sorted(zip(rows.tolist(), ways.tolist(), strict=True)):
        depth, area = measure_shared(shapely.intersection(shapes[k], ground[way]))
        if depth > TOLERANCE:
            name = lanes[way].name or lanes[way].id or f"lane {way + 1}"
            message = f"{houses[k].id} stands on {name} by {depth:.2f} m ({area:.2f} m²)"
            found.append(state_fault("blocked_path", houses[k], message, depth, area, name))
    return found
