"""Aims by which the default solver chooses among layouts of a block: view, sun, even spread."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem, sides_of
from scenewright.domains.site.solvers.blocks.block import BlockLayout
from scenewright.domains.site.solvers.blocks.front import inside
from scenewright.domains.site.terms.table import MUCH, read_site_aims
from scenewright.geometry.box_grid import box_grid
from scenewright.geometry.sun import SILL, light, open_hours, sun_path
from scenewright.geometry.walker import sights_of_boxes

SEEN, SUN, EVEN = range(3)


class Around(NamedTuple):
    """A block about to be filled: its middle (2,) and size in metres, eyes (e, 2) near it, its
    neighbours, boxes (m, 5) with heights (m,) and sides (m, 5), the path of the sun (s, 4), the
    hours it shines on a front to it that has nothing before it, and the weights (3,) of the aims, 0
    where there is nothing to look at."""

    middle: Floats
    size: float
    eyes: Floats
    boxes: Floats
    heights: Floats
    sides: Floats
    path: Floats
    open_hours: float
    weights: Floats


def around(problem: SiteProblem, edges: Floats, boxes: Floats, present: Flags) -> Around:
    """What is near a block of ``edges`` (e, 4), while ``boxes`` (n, 5) stand as far as
    ``present`` (n,)."""
    low, high = edges.reshape(-1, 2).min(0), edges.reshape(-1, 2).max(0)
    ground, made, rule = problem.ground, problem.buildings, problem.settings.aims
    every = np.concatenate([boxes[present], ground.landmarks])
    near = ((every[:, :2] > low - rule.far) & (every[:, :2] < high + rule.far)).all(1)
    heights = np.concatenate([made.sizes[present, 2], ground.landmark_heights])
    sides = np.concatenate(
        [
            sides_of(made.sides, made.quality)[present],
            sides_of(ground.landmark_sides, ground.landmark_quality),
        ]
    )
    eyes = ground.eyes[((ground.eyes > low - rule.near) & (ground.eyes < high + rule.near)).all(1)]
    eyes = eyes[np.unique(np.linspace(0, len(eyes) - 1, min(len(eyes), rule.eyes)).astype(int))]
    middle, area = _middle(edges)
    path = sun_path(problem.latitude, problem.day, minutes=rule.minutes)
    weights = read_site_aims(problem.weights) * (len(eyes) > 0, len(path) > 0, 1.0)
    noon = np.arctan2(path[:, 1].sum(), path[:, 0].sum())
    best = max(float(open_hours([noon], path)[0, 0]), 1e-9)
    stand = every[near], heights[near], sides[near]
    return Around(middle, area**0.5, eyes, *stand, path, best, weights)


def lacking(problem: SiteProblem, about: Around, found: BlockLayout, most: float) -> float:
    """What a layout of a block lacks in the aims, by their weights; 0 is all one can wish for. What
    is certainly ``most`` or more is not looked at to the end."""
    if not len(found.numbers):
        return float(about.weights.sum())
    weights, cost, rule = about.weights, 0.0, problem.settings.aims
    if weights[EVEN]:
        cost += weights[EVEN] * uneven(found.boxes, about.middle, about.size)
    if cost >= most or not weights[SEEN] + weights[SUN]:
        return cost
    rows = _spread_out(len(found.numbers), rule.lit)
    numbers, made = [found.numbers[k] for k in rows], problem.buildings
    every = np.concatenate([found.boxes[rows], about.boxes])
    grid = box_grid(every, np.concatenate([made.sizes[numbers, 2], about.heights]))
    if weights[SUN]:
        hours = np.zeros((min(len(rows), rule.lit), 4))
        light(grid, about.path, 1, SILL, hours)
        cost += weights[SUN] * (1.0 - float(hours[:, 0].mean()) / about.open_hours)
    if weights[SEEN] and cost < most:
        sides = np.concatenate([sides_of(made.sides, made.quality)[numbers], about.sides])
        view = sights_of_boxes(grid, sides, about.eyes, 1.0, rule.rays).values.mean()
        cost += weights[SEEN] * (1.0 - float(view) / MUCH)
    return cost


def _spread_out(count: int, most: int) -> list[int]:
    """The numbers below ``count``, at most ``most`` that are spread over all first."""
    some = np.unique(np.linspace(0, count - 1, min(count, most)).astype(int))
    return [*some.tolist(), *np.setdiff1d(np.arange(count), some).tolist()]


def uneven(boxes: Floats, middle: Floats, size: float) -> float:
    """How far the middle of some boxes' ground lies off the ``middle`` (2,) of a block, in halves
    of its ``size``, the root of its area in metres; at most 1.

    >>> uneven(np.array([[3, 0, 0, 2, 2], [6, 0, 0, 2, 4.0]]), np.zeros(2), 20.0)
    0.5
    """
    area = boxes[:, 3] * boxes[:, 4]
    off = (area[:, None] * boxes[:, :2]).sum(0) / area.sum() - middle
    return min(2.0 * float(np.hypot(*off)) / size, 1.0)


def uneven_of(problem: SiteProblem, boxes: Floats) -> float:
    """The mean of :func:`uneven` over the blocks of a site, by the ground that boxes (k, 5) take
    in each; 0 without boxes in blocks."""
    ground, sums, taken = problem.ground, 0.0, 0.0
    for first, last in ground.block_spans.tolist():
        edges = ground.block_edges[first:last]
        own = boxes[inside(edges, boxes[:, :2])]
        if len(own):
            middle, area = _middle(edges)
            share = float((own[:, 3] * own[:, 4]).sum())
            sums += share * uneven(own, middle, area**0.5)
            taken += share
    return sums / taken if taken else 0.0


def _middle(edges: Floats) -> tuple[Floats, float]:
    """The centroid (2,) and area of a polygon by its directed edges, holes included."""
    x0, y0, x1, y1 = (edges - np.tile(edges[0, :2], 2)).T
    cross = x0 * y1 - x1 * y0
    area = 0.5 * float(cross.sum())
    moments = np.array([((x0 + x1) * cross).sum(), ((y0 + y1) * cross).sum()])
    return edges[0, :2] + moments / (6.0 * max(area, 1e-9)), max(area, 1e-9)
