"""Fronts that look to the way beside them: streets, paths and lanes decide where doors are.

A building stands by a way that lies within :data:`BY` metres of it; it fronts one that lies over
the strip as deep ahead of its front. One that does not is turned round, or by a quarter where it
keeps all distances turned so.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.ground.outlines import way as cover
from scenewright.ground.plan import SitePlan
from scenewright.ground.works import Pathway

BY = 12.0
"""Metres from a building up to which it stands by a way."""
TURNS = (math.pi, math.pi / 2, -math.pi / 2)
SLACK = 1e-3

Shapes = np.ndarray


def list_ways(plan: SitePlan, pathways: Sequence[Pathway]) -> Shapes:
    """The ground of streets, paths and lanes, one a row."""
    areas = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    beside = [cover(line, way.width)[1] for way in plan.roads for line in way.beside]
    lanes = [
        shapely.buffer(shapely.LineString(row.line), 0.5 * row.width)
        for row in pathways
        if row.kind == "lane"
    ]
    return np.array([*areas, *beside, *lanes], object)


def find_fronting(ways: Shapes, boxes: Floats) -> tuple[Flags, Flags]:
    """Which of boxes (n, 5) stand by a way, and which of them front one."""
    by, fronting = np.zeros(len(boxes), bool), np.zeros(len(boxes), bool)
    if len(ways) and len(boxes):
        tree = shapely.STRtree(ways)
        near = tree.query(shapely.polygons(corners(boxes)), predicate="dwithin", distance=BY)
        ahead = tree.query(_list_strips(boxes), predicate="intersects")
        by[near[0]], fronting[ahead[0]] = True, True
    return by, by & fronting


def _list_strips(boxes: Floats) -> Shapes:
    """The ground up to :data:`BY` metres ahead of each front."""
    strips = boxes.copy()
    off = 0.5 * (boxes[:, 4] + BY)
    strips[:, 0] += off * np.cos(boxes[:, 2])
    strips[:, 1] += off * np.sin(boxes[:, 2])
    strips[:, 4] = BY
    found: Shapes = shapely.polygons(corners(strips))
    return found


def face_ways(
    plan: SitePlan, problem: SiteProblem, boxes: Floats, free: Flags, pathways: Sequence[Pathway]
) -> Floats:
    """Boxes (n, 5) with those that are ``free`` to turn and front no way turned to one."""
    ways = list_ways(plan, pathways)
    by, fronting = find_fronting(ways, boxes)
    blocks = shapely.union_all([shapely.Polygon(b.outline, b.holes) for b in plan.free])
    lanes = list_ways(plan._replace(roads=()), pathways)
    blocks = shapely.buffer(shapely.difference(blocks, shapely.union_all(lanes)), SLACK)
    shapely.prepare(blocks)
    shapes, turned = shapely.polygons(corners(boxes)), boxes.copy()
    for k in np.flatnonzero(by & ~fronting & free).tolist():
        rows = np.repeat(turned[k : k + 1], len(TURNS), axis=0)
        rows[:, 2] += TURNS
        good = find_fronting(ways, rows)[1]
        for number in np.flatnonzero(good).tolist():
            shape = shapely.polygons(corners(rows[number : number + 1]))[0]
            if number == 0 or _keeps_distances(problem, blocks, shapes, k, shape):
                turned[k], shapes[k] = rows[number], shape
                break
    return turned


def _keeps_distances(
    problem: SiteProblem, blocks: shapely.Geometry, shapes: Shapes, k: int, shape: shapely.Polygon
) -> bool:
    """Whether building ``k`` as a ``shape`` stays on the ground and off all others."""
    if problem.sun_spacing > 0.0 or not shapely.covers(blocks, shape):
        return False
    gaps = shapely.distance(shapes, shape)
    gaps[k] = math.inf
    return bool(gaps.min() >= problem.spacing)
