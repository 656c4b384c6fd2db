"""Rooms of a building model while it is read, and the floor a product covers in plan."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely

Row = dict[str, Any]
"""A product as :mod:`scenewright.formats.ifc.extract` gives it, or keys of a brief."""


class DrawnRoom(NamedTuple):
    """A room with its floor in metres, the level it is on and the height of that floor."""

    row: Row
    floor: shapely.Polygon
    level: int
    low: float
    height: float


def floor_of(row: Row, move: np.ndarray) -> shapely.Polygon:
    """What a product covers in plan."""
    if not row["rings"]:
        return shapely.Polygon()
    outline, *holes = (np.asarray(ring) - move for ring in row["rings"])
    found = shapely.Polygon(outline, holes).buffer(0)
    parts = [part for part in shapely.get_parts(found) if part.geom_type == "Polygon"]
    return max(parts, key=lambda part: part.area, default=shapely.Polygon())
