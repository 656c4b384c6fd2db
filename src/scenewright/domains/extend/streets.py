"""Streets of the sources that end at the border of an area, continued into it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.plan import SitePlan

NEAR = 25.0
"""Metres from an area within which a street that ends counts as ending at its border."""
LEAST = 15.0
"""Metres of new street that are worth building, and of a street that is worth continuing."""
CLEAR = 1.0
"""Metres kept from buildings."""
JOINED = 8.0
"""Metres from a drawn street within which a street counts as continued by it."""


def continue_streets(
    roads: Sequence[BuiltRoad],
    outline: shapely.Polygon,
    buildings: Sequence[shapely.Polygon],
    drawn: Sequence[BuiltRoad],
) -> tuple[BuiltRoad, ...]:
    """Streets that run on straight from the ends of ``roads`` that lie at an area's border, to
    its other side; none through buildings, none beside another.

    >>> street = BuiltRoad(np.array([[-50.0, 5.0], [-2.0, 5.0]]), 6.0)
    >>> (found,) = continue_streets([street], shapely.box(0, 0, 40, 30), [], [])
    >>> found.line.round(3).tolist()
    [[-2.0, 5.0], [40.0, 5.0]]
    """
    found: list[BuiltRoad] = []
    taken = shapely.union_all([b.buffer(CLEAR) for b in buildings])
    others = [shapely.LineString(road.line) for road in (*roads, *drawn)]
    for road in (one for one in roads if shapely.LineString(one.line).length >= LEAST):
        for end, inner in ((road.line[-1], road.line[-2]), (road.line[0], road.line[1])):
            line = _run_on(end, inner, outline)
            if line is None or (line.distance(taken) < road.width / 2 and line.crosses(taken)):
                continue
            if any(one.distance(shapely.Point(end)) < JOINED for one in others[len(roads) :]):
                continue
            beside = [shapely.LineString(one.line) for one in found]
            if line.length < LEAST or any(one.hausdorff_distance(line) < 10 for one in beside):
                continue
            found.append(BuiltRoad(shapely.get_coordinates(line), road.width, road.kind, road.name))
    return tuple(found)


def _run_on(end: Points, inner: Points, outline: shapely.Polygon) -> shapely.LineString | None:
    """The straight line from an end to where it leaves the area; ``None`` if it does not enter."""
    if outline.distance(shapely.Point(end)) > NEAR:
        return None
    step = end - inner
    length = float(np.hypot(*step))
    if length < 1e-6:
        return None
    far = end + step / length * 3000.0
    inside = shapely.intersection(shapely.LineString([end, far]), outline)
    parts = [p for p in shapely.get_parts(inside) if p.geom_type == "LineString" and p.length > 0.0]
    if not parts:
        return None
    first = min(parts, key=lambda part: part.distance(shapely.Point(end)))
    if first.distance(shapely.Point(end)) > NEAR:
        return None
    points = shapely.get_coordinates(first)
    away = np.hypot(*(points - end).T)
    return shapely.LineString([end, points[int(np.argmax(away))]])


def list_grounds(_solution: Solution, plan: Plan) -> tuple[SitePlan, ...]:
    """The ground of an extension, old and new."""
    return (plan.detail.ground,)


def list_ways(solution: Solution, plan: Plan) -> list[BuiltRoad]:
    """The middle lines of all streets of an extension, old and new."""
    del solution
    ways = plan.detail.ground.roads
    return [BuiltRoad(way.line, way.width, way.kind, way.name) for way in ways]
