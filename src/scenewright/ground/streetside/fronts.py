"""Fronts and the ways beside them: who stands by a way, and whose door looks at it.

A building stands by a way that lies within :data:`BY` metres of it; it fronts one if what of the
ways is nearest to its door lies ahead of it, at most 45° aside.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.ground.outlines import way as cover
from scenewright.ground.plan import SitePlan
from scenewright.ground.ways.walks import Doors
from scenewright.ground.works import FRONTED, Pathway, middle_lines

Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]
Shapes = NDArray[np.object_]

BY, ASIDE = 12.0, math.cos(math.pi / 4)
"""Metres from a building up to which it stands by a way, and cosine of how far aside of straight
ahead a way may lie that a door looks at."""


def list_ways(plan: SitePlan, pathways: Sequence[Pathway]) -> Shapes:
    """The ground of streets, paths, squares and lanes, one a row."""
    areas = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    beside = [cover(line, way.width)[1] for way in plan.roads for line in way.beside]
    squares = [shapely.Polygon(a.outline) for a in plan.areas if a.kind in FRONTED]
    return np.array([*areas, *beside, *squares, *cover_lanes(pathways)], object)


def cover_lanes(pathways: Sequence[Pathway]) -> Shapes:
    """The ground of the lanes among some ways."""
    lanes = [row for row in pathways if row.kind == "lane"]
    wide = np.array([0.5 * row.width for row in lanes])
    found: Shapes = shapely.buffer(middle_lines([row.line for row in lanes]), wide)
    return found


def find_fronting(ways: Shapes, shapes: Shapes, doors: Doors) -> tuple[Flags, Flags]:
    """Which of the buildings of some ``shapes`` (n,) stand by one of the ``ways`` (w,), and which
    of them front it."""
    by, looking = np.zeros(len(shapes), bool), np.zeros(len(shapes), bool)
    if len(ways) and len(shapes):
        tree = shapely.STRtree(ways)
        by[tree.query(shapes, predicate="dwithin", distance=BY)[0]] = True
        looking = find_looking(tree, doors)
    return by, by & looking


def find_looking(tree: shapely.STRtree, doors: Doors) -> Flags:
    """Which doors (n,) have the nearest of the ways in a ``tree`` ahead of them."""
    spots = shapely.points(doors.places)
    _, way = tree.query_nearest(spots, all_matches=False)
    lines = shapely.shortest_line(spots, tree.geometries[way])
    steps = np.diff(shapely.get_coordinates(lines).reshape(-1, 2, 2), axis=1)[:, 0]
    found: Flags = (steps * doors.ways).sum(1) >= ASIDE * np.hypot(*steps.T) - 1e-9
    return found
