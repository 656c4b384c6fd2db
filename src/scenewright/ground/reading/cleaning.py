"""Buildings as files give them, made sound: simple footprints that do not overlap."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.building.outlines import ring, signed_area
from scenewright.core.space import Points
from scenewright.ground.buildings.built import BuiltBuilding

LEAST, LARGEST = 4.0, 300.0
"""Square metres of the least building, and metres of the longest."""
SHARED = 0.05
"""The share of a footprint that may lie in another; the smaller of two that share more goes."""
MOST_BUILDINGS = 5000


def clean_outline(points: Points) -> Points | None:
    """A ring as a simple counter-clockwise outline; ``None`` if it encloses nothing usable.

    >>> clean_outline(np.array([[0, 0], [0, 3], [4, 3], [4, 0], [0, 0.0]])).tolist()
    [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]
    """
    corners = np.asarray(points, float).reshape(-1, 2)
    if len(corners) < 3 or not np.isfinite(corners).all():
        return None
    shape = shapely.Polygon(corners)
    if not shape.is_valid:
        parts = [p for p in shapely.get_parts(shape.buffer(0)) if p.geom_type == "Polygon"]
        if not parts:
            return None
        shape = max(parts, key=lambda part: part.area)
    sides = np.ptp(corners, axis=0)
    if shape.area < LEAST or sides.max() > LARGEST:
        return None
    found = ring(shapely.get_coordinates(shape.simplify(0.02).exterior))
    if len(found) < 3:
        return None
    return found if signed_area(found) > 0 else found[::-1]


def drop_overlaps(
    buildings: Sequence[BuiltBuilding],
) -> tuple[tuple[BuiltBuilding, ...], tuple[str, ...]]:
    """The buildings without those that lie in larger ones, and a line for each left out."""
    shapes = np.empty(len(buildings), object)
    shapes[:] = [shapely.Polygon(one.outline) for one in buildings]
    i, j = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    shared = shapely.area(shapely.intersection(shapes[i], shapes[j]))
    area = shapely.area(shapes)
    gone: set[int] = set()
    for a, b, common in sorted(zip(i.tolist(), j.tolist(), shared.tolist(), strict=True)):
        small, large = (a, b) if (area[a], a) < (area[b], b) else (b, a)
        if a < b and common > SHARED * area[small] and not {small, large} & gone:
            gone.add(small)
    left_out = tuple(f"{buildings[k].id}: overlaps another building" for k in sorted(gone))
    return tuple(one for k, one in enumerate(buildings) if k not in gone), left_out
