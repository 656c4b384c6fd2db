"""The terms of sites the way they are usually written: one shapely object a building.

The slow reference the compiled kernels are held against. Zhang, Yang 2023, eqs. 1-5, as repaired.
"""

from __future__ import annotations

import math
from itertools import combinations

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.shapely_hall import polygon
from benchmarks.shapely_home import rectangle
from scenewright.site_problem import SiteProblem

Floats = NDArray[np.float64]


def site_terms(problem: SiteProblem, boxes: Floats) -> Floats:
    """Insert, overlap, road, facing, quality and left of boxes (n, 5); no width: left out."""
    ground, terms = problem.ground, np.zeros(6)
    site = polygon(ground.edges)
    blocks = shapely.union_all([polygon(ground.block_edges[a:b]) for a, b in ground.block_spans])
    standing = [k for k in range(len(boxes)) if boxes[k, 3] > 0.0]
    terms[5] = len(boxes) - len(standing)

    def grown(box: Floats, more: float) -> shapely.Polygon:
        return rectangle(box + np.array([0.0, 0.0, 0.0, more, more]))

    marks = [grown(box, problem.fire_access) for box in ground.landmarks]
    for k in standing:
        shape, wide = rectangle(boxes[k]), grown(boxes[k], problem.fire_access)
        terms[0] += shape.difference(blocks).area / shape.area
        blocked = wide.difference(site).area
        blocked += sum(wide.intersection(mark).area for mark in marks)
        terms[2] += blocked / wide.area
        turned = (boxes[k, 2] - problem.facing) % (2.0 * math.pi)
        terms[3] += min(turned, 2.0 * math.pi - turned) / math.pi
        terms[4] += problem.buildings.quality[k]
    for i, j in combinations(standing, 2):
        a, b = grown(boxes[i], problem.spacing), grown(boxes[j], problem.spacing)
        terms[1] += a.intersection(b).area / min(a.area, b.area)
        a, b = grown(boxes[i], problem.fire_access), grown(boxes[j], problem.fire_access)
        common = a.intersection(b).area
        terms[2] += common / a.area + common / b.area
    return terms
