"""Which fronts look over the border of a site where no way runs."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem

AHEAD, PACE = 10.0, 0.5
"""How far ahead of a front the border is looked for, and every how many metres a way."""
NEARLY = math.radians(45.0)
"""Fronts that look so near to the preferred heading may look out for the sun."""


def blind(problem: SiteProblem, boxes: Floats) -> Flags:
    """Which of boxes (k, 5) have the site's border ahead and no way before it. None on sites
    without ways, which are entered from anywhere on their border."""
    found = np.zeros(len(boxes), np.bool_)
    if not len(problem.ground.roads) or not len(boxes):
        return found
    front = np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], 1)
    door = boxes[:, :2] + 0.5 * boxes[:, 4:] * front
    out = np.flatnonzero(~inside(problem.ground.edges, door + AHEAD * front))
    steps = np.arange(0.0, AHEAD + PACE, PACE)
    points = door[out, None] + steps[:, None] * front[out, None]
    found[out] = ~_on_ways(problem.ground.roads, points).any(1)
    return found


def turned_in(problem: SiteProblem, boxes: Floats) -> Floats:
    """Boxes (k, 5) with those that look out where no way is turned round, to the court behind;
    fronts to the sun stay."""
    off = np.abs((boxes[:, 2] - problem.facing + math.pi) % (2.0 * math.pi) - math.pi)
    turned = boxes.copy()
    turned[blind(problem, boxes) & (off > NEARLY), 2] += math.pi
    return turned


def inside(edges: Floats, points: Floats) -> Flags:
    """Which of points (k, 2) lie in the ground of directed edges (e, 4), by crossings."""
    (ax, ay), (bx, by) = edges[:, :2].T, edges[:, 2:].T
    x, y = points[:, :1], points[:, 1:]
    across = (ay <= y) != (by <= y)
    rise = np.where(ay == by, 1.0, by - ay)
    left = ax + (y - ay) / rise * (bx - ax) < x
    inside: Flags = (across & left).sum(1) % 2 == 1
    return inside


def _on_ways(roads: Floats, points: Floats) -> Flags:
    """Which of points (k, s, 2) lie on straight pieces of ways (r, 5)."""
    found = np.zeros(points.shape[:2], np.bool_)
    if not points.size:
        return found
    reach = 0.5 * np.hypot(roads[:, 3], roads[:, 4])[:, None]
    flat = points.reshape(-1, 2)
    near = ((roads[:, :2] + reach > flat.min(0)) & (roads[:, :2] - reach < flat.max(0))).all(1)
    for x, y, heading, width, length in roads[near].tolist():
        c, s = math.cos(heading), math.sin(heading)
        dx, dy = points[..., 0] - x, points[..., 1] - y
        along, aside = np.abs(dx * c + dy * s), np.abs(dx * s - dy * c)
        found |= (along <= 0.5 * length) & (aside <= 0.5 * width)
    return found
