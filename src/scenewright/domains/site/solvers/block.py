"""Layouts of one block: buildings of a queue in some form, gaps as wide as all still fit.

Rows stand in strips of the ground that no edge crosses, so they are inside by construction.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.core.layout import corners
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.front import list_front_margins, turned_in
from scenewright.domains.site.solvers.perimeter_block import rim
from scenewright.domains.site.solvers.strips import StripRule, back, rotate_block, rows

FORMS = ("parallel", "staggered", "peripheral", "mixed")
HALVINGS = 5


class BlockLayout(NamedTuple):
    """Buildings of a block: their numbers and boxes (k, 5), and the form."""

    numbers: tuple[int, ...]
    boxes: Floats
    form: str


def forms(problem: SiteProblem, share: list[int]) -> list[str]:
    """The forms that all buildings of a block may take; all, if there is none."""
    asked = [problem.buildings.forms[i] for i in share] if problem.buildings.forms else []
    allowed = [form for form in FORMS if all(form in one for one in asked if one)]
    return allowed or list(FORMS)


def headings(problem: SiteProblem, edges: Floats) -> list[float]:
    """The preferred heading, and those along the two longest edges nearest to it.

    ``edges`` (e, 4) x0, y0, x1, y1 in metres; radians.
    """
    way = edges[:, 2:] - edges[:, :2]
    longest = np.argsort(-np.hypot(way[:, 0], way[:, 1]), kind="stable")[:2]
    found = [problem.facing]
    for k in longest.tolist():
        along = math.atan2(way[k, 1], way[k, 0])
        turns = [along + q * math.pi / 2 for q in range(4)]
        found.append(min(turns, key=lambda a: abs(wrap_angle(a - problem.facing))))
    return found


def loosen_layout(
    problem: SiteProblem, edges: Floats, queue: list[int], heading: float, form: str, loosest: float
) -> BlockLayout:
    """A layout of a block with gaps as wide as still hold all that the least gaps hold.

    ``edges`` (e, 4) of the block in metres, ``heading`` in radians.
    """
    tight = lay_out_block(problem, edges, queue, heading, form, 1.0)
    low, high, best = 1.0, loosest, tight
    for _ in range(HALVINGS if loosest > 1.0 else 0):
        loose = 0.5 * (low + high)
        found = lay_out_block(problem, edges, queue, heading, form, loose)
        if len(found.numbers) >= len(tight.numbers):
            low, best = loose, found
        else:
            high = loose
    return best


def lay_out_block(
    problem: SiteProblem, edges: Floats, queue: list[int], heading: float, form: str, loose: float
) -> BlockLayout:
    """One layout of a block.

    ``edges`` (e, 4) of the block in metres, ``heading`` in radians.
    """
    sizes, way = problem.buildings.sizes, problem.fire_access
    rule = StripRule(problem.spacing, way, problem.sun_spacing, loose, form == "staggered", True)
    numbers: list[int] = []
    boxes = np.zeros((0, 5))
    waiting = queue
    if form in ("peripheral", "mixed"):
        share = 0.5 if form == "mixed" else 1.0
        numbers, boxes = rim(edges, sizes, queue, max(rule.beside(), way), share)
        boxes = turned_in(problem, boxes)
        waiting = [i for i in queue if i not in set(numbers)]
    if len(boxes):
        ahead = float(sizes[waiting, 2].max()) if waiting else 0.0
        edges = np.concatenate(
            [edges, list_reserved_edges(problem, boxes, sizes[numbers, 2], ahead)]
        )
    margins = list_front_margins(problem, edges, heading)
    block = rotate_block(np.concatenate([edges, margins]), heading)
    placed = rows(block, sizes, waiting, rule)
    found = np.zeros((len(placed), 5))
    if placed:
        at = np.array([(x, y) for _, x, y in placed])
        found[:, 0], found[:, 1] = back(at[:, 0], at[:, 1], heading)
        found[:, 2] = heading
        found[:, 3:] = sizes[[i for i, _, _ in placed], :2]
    numbers += [i for i, _, _ in placed]
    return _in_sun(problem, BlockLayout(tuple(numbers), np.concatenate([boxes, found]), form))


def _in_sun(problem: SiteProblem, found: BlockLayout) -> BlockLayout:
    """A layout without the buildings that stand too near behind another one of it."""
    if problem.sun_spacing <= 0.0 or len(found.numbers) < 2:
        return found
    heading = noon(problem)
    c, s = math.cos(heading), math.sin(heading)
    rings = corners(found.boxes)
    x = rings[..., 0] * s - rings[..., 1] * c
    y = rings[..., 0] * c + rings[..., 1] * s
    reach = problem.sun_spacing * problem.buildings.sizes[list(found.numbers), 2]
    beside = (x.min(1)[:, None] < x.max(1)[None, :]) & (x.max(1)[:, None] > x.min(1)[None, :])
    gap = y.min(1)[:, None] - y.max(1)[None, :]
    behind = y.mean(1)[:, None] > y.mean(1)[None, :]
    dark = (beside & behind & (gap < reach[:, None] - 1e-6)).any(0)
    kept = np.flatnonzero(~dark)
    return BlockLayout(tuple(found.numbers[k] for k in kept), found.boxes[kept], found.form)


def list_reserved_edges(
    problem: SiteProblem, boxes: Floats, heights: Floats, ahead: float
) -> Floats:
    """Edges (clockwise) of the ground that buildings keep from others: the spacing all around;
    behind, away from the sun, as many of their heights as asked for, and ahead as many of the
    heights of those to come.

    ``boxes`` (n, 5), ``heights`` (n,) in metres; edges (4 n, 4).
    """
    heading = noon(problem)
    c, s = math.cos(heading), math.sin(heading)
    rings = corners(boxes)
    x = rings[..., 0] * s - rings[..., 1] * c
    y = rings[..., 0] * c + rings[..., 1] * s
    gap, sun = problem.spacing, problem.sun_spacing
    x0, x1 = x.min(1) - gap, x.max(1) + gap
    y0, y1 = y.min(1) - np.maximum(gap, sun * heights), y.max(1) + max(gap, sun * ahead)
    px, py = np.stack([x0, x0, x1, x1], 1), np.stack([y0, y1, y1, y0], 1)
    ring = np.stack(back(px, py, heading), -1)
    edges: Floats = np.concatenate([ring, np.roll(ring, -1, axis=1)], axis=2).reshape(-1, 4)
    return edges


def noon(problem: SiteProblem) -> float:
    """The heading towards the sun at noon: south in the northern half of the world."""
    return -math.pi / 2 if problem.latitude >= 0.0 else math.pi / 2


def wrap_angle(angle: float) -> float:
    """An angle in [-π, π)."""
    return (angle + math.pi) % (2 * math.pi) - math.pi
