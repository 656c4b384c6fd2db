"""The terms of sites the way they are usually written: one shapely object a building.

The slow reference the compiled kernels are held against, whole (:func:`site_terms`) and for one
building that moves (:class:`ShapelySite`). Zhang, Yang 2023, eqs. 1-5, as repaired.
"""

from __future__ import annotations

import math
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.shapely_hall import polygon
from benchmarks.shapely_home import rectangle
from scenewright.domains.site.problem import SiteProblem

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


class ShapelySite(NamedTuple):
    """A layout as shapely objects, made once: the site, its blocks, the landmarks with a way
    around, the buildings with the spacing and with a way around, and a tree of the larger."""

    problem: SiteProblem
    site: Any
    blocks: Any
    marks: list[Any]
    spaced: list[Any]
    wide: list[Any]
    tree: shapely.STRtree

    def moved(self, k: int, box: Floats) -> Floats:
        """What building ``k`` adds to the terms at ``box`` (5,), its pairs included."""
        terms, shape, around = np.zeros(6), rectangle(box), self.grown(box, self.problem.spacing)
        wide = self.grown(box, self.problem.fire_access)
        terms[0] = shape.difference(self.blocks).area / shape.area
        blocked = wide.difference(self.site).area
        blocked += sum(wide.intersection(mark).area for mark in self.marks)
        terms[2] = blocked / wide.area
        turned = (box[2] - self.problem.facing) % (2.0 * math.pi)
        terms[3] = min(turned, 2.0 * math.pi - turned) / math.pi
        terms[4] = self.problem.buildings.quality[k]
        for j in self.tree.query(around.union(wide)):
            if j != k:
                least = min(around.area, self.spaced[j].area)
                terms[1] += around.intersection(self.spaced[j]).area / least
                common = wide.intersection(self.wide[j]).area
                terms[2] += common / wide.area + common / self.wide[j].area
        return terms

    def change(self, k: int, old: Floats, new: Floats) -> Floats:
        """How the terms change when building ``k`` goes from one box to another."""
        return self.moved(k, new) - self.moved(k, old)

    def grown(self, box: Floats, more: float) -> shapely.Polygon:
        """A box with both sides longer by so much."""
        return rectangle(box + np.array([0.0, 0.0, 0.0, more, more]))


def shapely_site(problem: SiteProblem, boxes: Floats) -> ShapelySite:
    """A layout (n, 5) of buildings that all stand, ready for moves."""
    ground = problem.ground
    blocks = shapely.union_all([polygon(ground.block_edges[a:b]) for a, b in ground.block_spans])
    more = np.array([0.0, 0.0, 0.0, 1.0, 1.0])
    spaced, wide = (
        [rectangle(box + way * more) for box in boxes]
        for way in (problem.spacing, problem.fire_access)
    )
    marks = [rectangle(box + problem.fire_access * more) for box in ground.landmarks]
    larger = spaced if problem.spacing >= problem.fire_access else wide
    tree = shapely.STRtree(larger)
    return ShapelySite(problem, polygon(ground.edges), blocks, marks, spaced, wide, tree)
