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
ENDS = 0.7
"""Cosine of how far a side of a block may turn from the fronts of rows that end at it."""
BEYOND = (1.5, 3.5, 5.5, 8.0, 11.0)
"""Metres ahead of a front, or beyond a side of a block, at which a square is looked for."""
BESIDE = 6.0
"""Metres from the border within which a side of a block runs along it."""
NEARLY = math.radians(45.0)
"""Angle off the preferred heading within which fronts may turn to the sun."""


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
    for k in range(boxes.shape[0]):
        c, s = math.cos(boxes[k, 2]), math.sin(boxes[k, 2])
        x, y = boxes[k, 0] + 0.5 * boxes[k, 4] * c, boxes[k, 1] + 0.5 * boxes[k, 4] * s
        found[k] = looks_out(edges, roads, (x, y, c, s), far)


@inlined
def looks_out(
    edges: Floats, roads: Floats, front: tuple[float, float, float, float], far: float
) -> bool:
    """Whether a ``front`` (x, y and the way it looks) has no ground ``far`` metres ahead, and no
    road up to there."""
    x, y, c, s = front
    if lies_inside(edges, x + far * c, y + far * s):
        return False
    steps = math.ceil(far / PACE - 1e-9) + 1
    for r in range(roads.shape[0]):
        reach = 0.5 * math.hypot(roads[r, 3], roads[r, 4]) + far + PACE
        if max(abs(roads[r, 0] - x), abs(roads[r, 1] - y)) > reach:
            continue
        rc, rs = math.cos(roads[r, 2]), math.sin(roads[r, 2])
        for step in range(steps):
            dx, dy = x + PACE * step * c - roads[r, 0], y + PACE * step * s - roads[r, 1]
            along, aside = abs(dx * rc + dy * rs), abs(dx * rs - dy * rc)
            if along <= 0.5 * roads[r, 4] and aside <= 0.5 * roads[r, 3]:
                return False
    return True


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
    fronts to the sun stay, if the border is as far from them as doors need. On sites without ways
    all look to the side nearer to the preferred heading."""
    off = np.abs((boxes[:, 2] - problem.facing + math.pi) % (2.0 * math.pi) - math.pi)
    turned = boxes.copy()
    if not len(problem.ground.roads):
        turned[off > 0.5 * math.pi + 1e-6, 2] += math.pi
        return turned
    near = blind(problem, boxes, problem.door_distance)
    turned[near | blind(problem, boxes) & (off > NEARLY), 2] += math.pi
    return turned


def find_border_lines(problem: SiteProblem, lines: Floats) -> Flags:
    """Which of some ``lines`` (m, 4) of a block run along the border of the site."""
    a, b = problem.ground.edges[:, :2], problem.ground.edges[:, 2:]
    step, middle = b - a, 0.5 * (lines[:, :2] + lines[:, 2:])
    share = ((middle[:, None] - a) * step).sum(2) / np.maximum((step**2).sum(1), 1e-12)
    near = a + np.clip(share, 0.0, 1.0)[..., None] * step
    found: Flags = np.hypot(*(middle[:, None] - near).transpose(2, 0, 1)).min(1) <= BESIDE
    return found


def set_back(problem: SiteProblem, lines: Floats, deep: float) -> tuple[Floats, Floats]:
    """The ``lines`` (m, 4) of a block, the inside on their left, with those along the border moved
    ``deep`` metres inwards, and the edges (4 k, 4), clockwise, of the ground between."""
    border = find_border_lines(problem, lines)
    way = lines[:, 2:] - lines[:, :2]
    out = np.column_stack([way[:, 1], -way[:, 0]]) / np.maximum(np.hypot(*way.T), 1e-9)[:, None]
    moved = lines - np.where(border[:, None], deep, 0.0) * np.tile(out, 2)
    a, b, out = lines[border, :2], lines[border, 2:], out[border]
    ring = np.stack([a + HAIR * out, a - deep * out, b - deep * out, b + HAIR * out], 1)
    return moved, np.concatenate([ring, np.roll(ring, -1, axis=1)], -1).reshape(-1, 4)


def list_square_lines(problem: SiteProblem, lines: Floats) -> Floats:
    """Those of some ``lines`` (m, 4) of a block, the inside on their left, beyond which a square
    lies."""
    way = lines[:, 2:] - lines[:, :2]
    out = np.stack([way[:, 1], -way[:, 0]], 1) / np.maximum(np.hypot(*way.T), 1e-9)[:, None]
    return lines[_find_square(problem, 0.5 * (lines[:, :2] + lines[:, 2:]), out)]


def on_square(problem: SiteProblem, boxes: Floats) -> Flags:
    """Which boxes (k, 5) look at a square before them."""
    ahead = np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], 1)
    return _find_square(problem, boxes[:, :2] + 0.5 * boxes[:, 4:] * ahead, ahead)


def _find_square(problem: SiteProblem, places: Floats, out: Floats) -> Flags:
    squares, found = problem.ground.squares, np.zeros(len(places), np.bool_)
    for beyond in BEYOND if len(squares) else ():
        found |= inside(squares, places + beyond * out)
    return found


def list_front_margins(problem: SiteProblem, edges: Floats, heading: float) -> Floats:
    """Edges (4 m, 4), clockwise, of the ground along the border that rows with fronts to some
    ``heading`` leave free for their doors; ``edges`` (e, 4) are those of a block."""
    ground, found = problem.ground, np.empty((4 * len(edges), 4))
    way = (math.cos(heading), math.sin(heading))
    if not len(ground.roads):
        return found[:0]
    far = problem.door_distance
    return found[: write_front_margins(edges, ground.edges, ground.roads, way, far, found)]


@compiled
def write_front_margins(
    edges: Floats,
    border: Floats,
    roads: Floats,
    way: tuple[float, float],
    far: float,
    found: Floats,
) -> int:
    """Write :func:`list_front_margins` for fronts that look the ``way`` (x, y) and doors ``far``
    from the ``border`` (e, 4); how many edges they are."""
    count = 0
    for k in range(edges.shape[0]):
        along, up = edges[k, 2] - edges[k, 0], edges[k, 3] - edges[k, 1]
        long = max(math.hypot(along, up), 1e-9)
        ox, oy = up / long, -along / long
        if ox * way[0] + oy * way[1] <= FACING:
            continue
        x, y = 0.5 * (edges[k, 0] + edges[k, 2]), 0.5 * (edges[k, 1] + edges[k, 3])
        if not looks_out(border, roads, (x, y, ox, oy), far):
            continue
        deep = max(far - distance_to(border, x, y), 0.0) + 2.0 * HAIR
        ax, ay = edges[k, 0] + HAIR * ox, edges[k, 1] + HAIR * oy
        bx, by = edges[k, 2] + HAIR * ox, edges[k, 3] + HAIR * oy
        found[count] = (ax, ay, ax - deep * ox, ay - deep * oy)
        found[count + 1] = (ax - deep * ox, ay - deep * oy, bx - deep * ox, by - deep * oy)
        found[count + 2] = (bx - deep * ox, by - deep * oy, bx, by)
        found[count + 3] = (bx, by, ax, ay)
        count += 4
    return count


def list_side_margins(lines: Floats, heading: float, deep: float) -> Floats:
    """Edges (4 m, 4), clockwise, of the ground up to ``deep`` metres behind those of some ``lines``
    (k, 4), the inside on their left, that rows with fronts to a ``heading`` end at.

    >>> square = np.array([[0, 0, 9, 0], [9, 0, 9, 9], [9, 9, 0, 9], [0, 9, 0, 0]], float)
    >>> list_side_margins(square, math.pi / 2, 2.0)[1].round(6).tolist()
    [7.0, 0.0, 7.0, 9.0]
    """
    way = lines[:, 2:] - lines[:, :2]
    long = np.maximum(np.hypot(way[:, 0], way[:, 1]), 1e-9)[:, None]
    out = np.column_stack([way[:, 1], -way[:, 0]]) / long
    ends = np.abs(out @ (math.cos(heading), math.sin(heading))) < ENDS
    a, b, out = lines[ends, :2], lines[ends, 2:], out[ends]
    ring = np.stack([a + HAIR * out, a - deep * out, b - deep * out, b + HAIR * out], 1)
    return np.concatenate([ring, np.roll(ring, -1, axis=1)], -1).reshape(-1, 4)


@inlined
def distance_to(edges: Floats, x: float, y: float) -> float:
    """Metres from a point to the nearest of the edges (e, 4)."""
    nearest = math.inf
    for k in range(edges.shape[0]):
        along, up = edges[k, 2] - edges[k, 0], edges[k, 3] - edges[k, 1]
        share = (x - edges[k, 0]) * along + (y - edges[k, 1]) * up
        share = min(max(share / max(along**2 + up**2, 1e-12), 0.0), 1.0)
        off = math.hypot(edges[k, 0] + share * along - x, edges[k, 1] + share * up - y)
        nearest = min(nearest, off)
    return nearest


def inside(edges: Floats, points: Floats) -> Flags:
    """Which of points (k, 2) lie in the ground of directed edges (e, 4), by crossings."""
    (ax, ay), (bx, by) = edges[:, :2].T, edges[:, 2:].T
    x, y = points[:, :1], points[:, 1:]
    across = (ay <= y) != (by <= y)
    rise = np.where(ay == by, 1.0, by - ay)
    left = ax + (y - ay) / rise * (bx - ax) < x
    inside: Flags = (across & left).sum(1) % 2 == 1
    return inside
