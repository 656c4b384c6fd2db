"""Which fronts look over the border of a site where no way runs."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.geometry.compiled import compiled, inlined

AHEAD, PACE = 10.0, 0.5
"""How far ahead of a front the border is looked for, and every how many metres a way."""
FACING, HAIR = 0.35, 1e-3
"""Cosine of how far an edge of the ground may turn from the fronts that look over it, and metres
by which margins reach over it."""
NEARLY = math.radians(45.0)
"""Fronts that look so near to the preferred heading may look out for the sun."""


def blind(problem: SiteProblem, boxes: Floats, far: float = AHEAD) -> Flags:
    """Which of boxes (k, 5) have the site's border within ``far`` metres ahead and no way before
    it. None on sites without ways, which are entered from anywhere on their border."""
    found = np.zeros(len(boxes), np.bool_)
    if len(problem.ground.roads) and len(boxes):
        mark_blind(problem.ground.edges, problem.ground.roads, boxes, far, found)
    return found


@compiled
def mark_blind(edges: Floats, roads: Floats, boxes: Floats, far: float, found: Flags) -> None:
    """Mark the boxes (k, 5) whose front has no ground of directed ``edges`` (e, 4) ``far`` metres
    ahead, and none of the ``roads`` (r, 5) up to there."""
    steps = math.ceil(far / PACE - 1e-9) + 1
    for k in range(boxes.shape[0]):
        c, s = math.cos(boxes[k, 2]), math.sin(boxes[k, 2])
        x, y = boxes[k, 0] + 0.5 * boxes[k, 4] * c, boxes[k, 1] + 0.5 * boxes[k, 4] * s
        found[k] = not lies_inside(edges, x + far * c, y + far * s)
        for r in range(roads.shape[0]):
            if not found[k]:
                break
            rc, rs = math.cos(roads[r, 2]), math.sin(roads[r, 2])
            reach = 0.5 * math.hypot(roads[r, 3], roads[r, 4]) + far + PACE
            if max(abs(roads[r, 0] - x), abs(roads[r, 1] - y)) > reach:
                continue
            for step in range(steps):
                dx, dy = x + PACE * step * c - roads[r, 0], y + PACE * step * s - roads[r, 1]
                along, aside = abs(dx * rc + dy * rs), abs(dx * rs - dy * rc)
                if along <= 0.5 * roads[r, 4] and aside <= 0.5 * roads[r, 3]:
                    found[k] = False


@inlined
def lies_inside(edges: Floats, x: float, y: float) -> bool:
    """Whether a point lies in the ground of directed edges (e, 4), by crossings."""
    odd = False
    for k in range(edges.shape[0]):
        ax, ay, bx, by = edges[k, 0], edges[k, 1], edges[k, 2], edges[k, 3]
        if (ay <= y) != (by <= y) and ax + (y - ay) / (by - ay) * (bx - ax) < x:
            odd = not odd
    return odd


def turned_in(problem: SiteProblem, boxes: Floats) -> Floats:
    """Boxes (k, 5) with those that look out where no way is turned round, to the court behind;
    fronts to the sun stay, if the border is as far from them as doors need."""
    off = np.abs((boxes[:, 2] - problem.facing + math.pi) % (2.0 * math.pi) - math.pi)
    turned = boxes.copy()
    near = blind(problem, boxes, problem.door_distance)
    turned[near | blind(problem, boxes) & (off > NEARLY), 2] += math.pi
    return turned


def list_front_margins(problem: SiteProblem, edges: Floats, heading: float) -> Floats:
    """Edges (4 m, 4), clockwise, of the ground along the border that rows with fronts to some
    ``heading`` leave free for their doors; ``edges`` (e, 4) are those of a block."""
    along = edges[:, 2:] - edges[:, :2]
    long = np.maximum(np.hypot(along[:, 0], along[:, 1]), 1e-9)
    out = np.column_stack([along[:, 1], -along[:, 0]]) / long[:, None]
    middles = 0.5 * (edges[:, :2] + edges[:, 2:])
    turn, flat = np.arctan2(out[:, 1], out[:, 0]), np.zeros(len(edges))
    boxes = np.column_stack([middles, turn, long, flat])
    facing = out @ (math.cos(heading), math.sin(heading)) > FACING
    rows = np.flatnonzero(facing & blind(problem, boxes, problem.door_distance))
    gaps = [_to_border(problem.ground.edges, middles[k]) for k in rows]
    deep = np.maximum(problem.door_distance - np.array(gaps), 0.0)[:, None]
    begin, end = edges[rows, :2] + HAIR * out[rows], edges[rows, 2:] + HAIR * out[rows]
    inward = -(deep + 2.0 * HAIR) * out[rows]
    ring = np.stack([begin, begin + inward, end + inward, end], 1)
    found: Floats = np.concatenate([ring, np.roll(ring, -1, axis=1)], axis=2).reshape(-1, 4)
    return found


def _to_border(edges: Floats, point: Floats) -> float:
    """Metres from a point to the nearest of the edges (e, 4)."""
    along = edges[:, 2:] - edges[:, :2]
    share = ((point - edges[:, :2]) * along).sum(1) / np.maximum((along**2).sum(1), 1e-12)
    nearest = edges[:, :2] + np.clip(share, 0.0, 1.0)[:, None] * along
    return float(np.hypot(*(nearest - point).T).min())


def inside(edges: Floats, points: Floats) -> Flags:
    """Which of points (k, 2) lie in the ground of directed edges (e, 4), by crossings."""
    (ax, ay), (bx, by) = edges[:, :2].T, edges[:, 2:].T
    x, y = points[:, :1], points[:, 1:]
    across = (ay <= y) != (by <= y)
    rise = np.where(ay == by, 1.0, by - ay)
    left = ax + (y - ay) / rise * (bx - ax) < x
    inside: Flags = (across & left).sum(1) % 2 == 1
    return inside
