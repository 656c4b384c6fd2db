"""Walks from the doors of buildings to the street before them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.scene import Piece
from scenewright.domains.extend.areas import ExtendPlan
from scenewright.ground.works import GroundWorks, Pathway

LONGEST, WIDE, CLEAR = 25.0, 1.4, 0.5
"""Metres: the longest walk, its width, what it keeps from other buildings."""


def lay_walks(plan: ExtendPlan, pieces: Sequence[Piece]) -> GroundWorks:
    """A straight walk from the middle of each front to the street, where one lies ahead."""
    houses = [p for p in pieces if p.category == "building"]
    houses = [p for p in houses if np.isfinite([*p.pose, *p.size]).all()]
    areas = [shapely.Polygon(a.outline, a.holes) for way in plan.ground.roads for a in way.areas]
    if not houses or not areas:
        return GroundWorks("ground")
    streets = shapely.union_all(areas)
    shapes = polygons_of(houses)
    tree = shapely.STRtree(shapes)
    found = []
    for number, piece in enumerate(houses):
        line = _walk(piece, streets)
        if line is None:
            continue
        near = tree.query(line, predicate="dwithin", distance=CLEAR)
        if not len(np.setdiff1d(near, [number])):
            (x, y), (u, v) = shapely.get_coordinates(line).tolist()
            found.append(Pathway("walk", WIDE, ((x, y), (u, v))))
    return GroundWorks("ground", tuple(found))


def _walk(piece: Piece, streets: shapely.Geometry) -> shapely.LineString | None:
    """The line from the front straight ahead to the street; ``None`` if none lies there."""
    ring = outline_of(piece)
    out = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    door = middle[int(np.argmax(np.round(middle @ out, 3)))]
    ahead = shapely.LineString([door, door + LONGEST * out])
    met = shapely.intersection(ahead, streets)
    if met.is_empty:
        return None
    length = float(shapely.distance(met, shapely.Point(door)))
    return shapely.LineString([door, door + (length + 0.1) * out]) if length > 0.3 else None
