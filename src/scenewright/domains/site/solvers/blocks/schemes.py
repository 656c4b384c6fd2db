"""Schemes of a site: what its blocks have in common, drawn by the seed.

A scheme says how buildings stand (rows behind a border, a perimeter, a court open to the front,
points behind a border), which side of its block the rows of each follow, and where the open ground
of each lies. Seeds that follow one another are other schemes.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from itertools import chain, zip_longest
from typing import NamedTuple

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem, sides_of
from scenewright.domains.site.solvers.blocks.front import inside
from scenewright.geometry.compiled import compiled

QUEUES = ("as ranked", "handsome first", "backwards", "alternating")
"""Orders in which the buildings of a block are placed."""
FORMS = ("mixed", "peripheral", "mixed", "half-closed")
AXES = 2
"""Longest sides of a block that rows may follow."""
GOLDEN = math.pi * (3.0 - math.sqrt(5.0))
"""The angle in radians whose multiples lie apart, however many there are."""
FAR, POINTS, LEAST = 25.0, 16, 4.0
"""Metres from a building beyond which ground is void; points looked at in either direction, and the
least metres between them."""
SHARE, WIDEST, OFF = 0.06, 60.0, 0.55
"""Share of a block that is left open, the most metres of a side of it, and how far off the middle
it lies, in shares of the way to the border."""


class Scheme(NamedTuple):
    """The planar ``form`` of blocks, which of their longest sides rows follow, the direction
    from the middle of a block in which its open ground lies (None: in the middle), and the number
    of the order in which buildings are placed first and of the side they begin with."""

    form: str = "mixed"
    axis: int = 1
    open_to: float | None = None
    order: int = 0


def choose_scheme(seed: int) -> Scheme:
    """The scheme of a seed.

    >>> [choose_scheme(seed).form for seed in range(3)]
    ['mixed', 'peripheral', 'mixed']
    """
    form, axis = FORMS[seed % len(FORMS)], 1 + (seed + 1) // 2 % AXES
    open_to = seed * GOLDEN % (2.0 * math.pi) if seed % 3 else None
    return Scheme(form, axis, open_to, seed)


def list_open_edges(edges: Floats, area: float, heading: float, scheme: Scheme) -> Floats:
    """Edges (4, 4), clockwise, of the ground of a block of ``edges`` (e, 4) that stays open, a
    square along ``heading``; none where it would leave the block."""
    middle, side = edges[:, :2].mean(0), min(math.sqrt(SHARE * area), WIDEST)
    if scheme.open_to is not None:
        way = np.array([math.cos(scheme.open_to), math.sin(scheme.open_to)])
        middle = middle + OFF * float(((edges[:, :2] - middle) @ way).max()) * way
    c, s = 0.5 * side * math.cos(heading), 0.5 * side * math.sin(heading)
    ring = middle + np.array([[c - s, s + c], [c + s, s - c], [s - c, -s - c], [-c - s, c - s]])
    if not inside(edges, ring).all():
        return np.zeros((0, 4))
    return np.hstack([ring, np.roll(ring, -1, axis=0)])


def spread_points(edges: Floats) -> Floats:
    """Points (k, 2), up to :data:`POINTS` in each direction, spread over a block of ``edges``."""
    low, high = edges.reshape(-1, 2).min(0), edges.reshape(-1, 2).max(0)
    step = max(float((high - low).max()) / POINTS, LEAST)
    x, y = (np.arange(a + 0.5 * step, b, step) for a, b in zip(low, high, strict=True))
    grid = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    return grid[inside(edges, grid)]


def find_void(points: Floats, boxes: Floats) -> float:
    """The share of points (k, 2) that lie more than :data:`FAR` metres from every box (n, 5).

    >>> find_void(np.array([[0.0, 0.0], [60.0, 0.0]]), np.array([[10.0, 0.0, 0.0, 9.0, 9.0]]))
    0.5
    """
    if not len(points) or not len(boxes):
        return float(len(points) > 0)
    far = np.ones(len(points), np.bool_)
    mark_far(points, boxes, far)
    return float(far.mean())


@compiled
def mark_far(points: Floats, boxes: Floats, far: Flags) -> None:
    """Unmark the points (k, 2) within :data:`FAR` metres of a box (n, 5)."""
    for b in range(boxes.shape[0]):
        c, s = math.cos(boxes[b, 2]), math.sin(boxes[b, 2])
        for k in range(points.shape[0]):
            dx, dy = points[k, 0] - boxes[b, 0], points[k, 1] - boxes[b, 1]
            ahead = max(abs(dx * c + dy * s) - 0.5 * boxes[b, 4], 0.0)
            aside = max(abs(dx * s - dy * c) - 0.5 * boxes[b, 3], 0.0)
            if ahead * ahead + aside * aside <= FAR * FAR:
                far[k] = False


def order_queue(problem: SiteProblem, share: Sequence[int], queue: str) -> list[int]:
    """The buildings of a block in the order they are placed.

    ``alternating`` takes one of each model in turn.
    """
    if queue == "backwards":
        return list(reversed(share))
    if queue == "handsome first":
        looks = sides_of(problem.buildings.sides, problem.buildings.quality)[:, :4].mean(1)
        return sorted(share, key=lambda i: (-float(looks[i]), i))
    if queue == "alternating":
        same: dict[int, list[int]] = defaultdict(list)
        for i in share:
            same[int(problem.buildings.models[i])].append(i)
        return [i for i in chain(*zip_longest(*same.values())) if i is not None]
    return list(share)
