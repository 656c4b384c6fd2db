"""Fronts that look to the streets and squares beside them: one that does not is turned round, or by
a quarter where it keeps all distances turned so."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.fronts import Shapes, find_fronting, list_ways
from scenewright.ground.ways.walks import Doors

TURNS = (math.pi, math.pi / 2, -math.pi / 2)
SLACK = 1e-3


def find_box_doors(boxes: Floats) -> Doors:
    """The doors of boxes (n, 5), in the middle of their fronts."""
    ahead = np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], 1)
    return Doors(boxes[:, :2] + 0.5 * boxes[:, 4:] * ahead, ahead)


def face_ways(plan: SitePlan, problem: SiteProblem, boxes: Floats, free: Flags) -> Floats:
    """Boxes (n, 5) with those that are ``free`` to turn and front no street or square turned to
    one."""
    ways, shapes, turned = list_ways(plan, ()), shapely.polygons(corners(boxes)), boxes.copy()
    by, fronting = find_fronting(ways, shapes, find_box_doors(boxes))
    wrong = np.flatnonzero(by & ~fronting & free)
    if not len(wrong):
        return turned
    blocks = shapely.union_all([shapely.Polygon(b.outline, b.holes) for b in plan.free])
    blocks = shapely.buffer(blocks, SLACK)
    shapely.prepare(blocks)
    for turn in TURNS:
        rows = boxes[wrong]
        rows[:, 2] += turn
        places = shapely.polygons(corners(rows))
        good = find_fronting(ways, places, find_box_doors(rows))[1]
        for number in np.flatnonzero(good).tolist():
            k, shape = int(wrong[number]), places[number]
            if turn == math.pi or _keeps_distances(problem, blocks, shapes, k, shape):
                turned[k], shapes[k] = rows[number], shape
                good[number] = True
            else:
                good[number] = False
        wrong = wrong[~good]
    return turned


def _keeps_distances(
    problem: SiteProblem, blocks: shapely.Geometry, shapes: Shapes, k: int, shape: shapely.Polygon
) -> bool:
    """Whether building ``k`` as a ``shape`` stays on the ground and off all others."""
    if problem.sun_spacing > 0.0 or not shapely.covers(blocks, shape):
        return False
    near = shapely.dwithin(shapes, shape, problem.spacing - 1e-9)
    near[k] = False
    return not near.any()
