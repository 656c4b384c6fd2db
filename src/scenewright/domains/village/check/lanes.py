"""Houses that stand on lanes, drives and footways of the brief."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Shapes
from scenewright.check.buildings import measure_shared, state_fault
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.domains.village.brief import Lane


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
