"""Parted rows: a row that runs through a partition moves to one side of it.

An exhibit panel alone behind a wall belongs to nothing: the visitor sees it before or after the
others, and the wall cuts the row.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.hall.patterns import ALONG, CHAIN, GRID
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.terms.state import Kept

WEIGHT = 3.0
"""What a place counts where a partition cuts a row, in metres."""
BUILT, IN_ROW = 0.3, 0.2
"""Least length of a partition that is built, and how far neighbours of a row lie off its line at
most; metres."""
BEYOND = 0.5
"""How far beyond the ends of a partition a row counts as cut by it, in metres."""
SHIFTS = (0.0, -0.5, 0.5, -1.0, 1.0, -1.5, 1.5, -2.2, 2.2, -3.0, 3.0)
"""By how much a row is moved along its line, in metres."""
NARROWER = (1.0, 0.9, 0.8, 0.65, 0.5)
"""Parts of their width that gaps between neighbours keep."""


def measure_parted(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """What the rows of boxes (n, 5) count that partitions cut, in metres."""
    return WEIGHT * float(_find_cuts(problem, kept, boxes).sum())


def _find_cuts(problem: HallProblem, kept: Kept, boxes: Floats) -> NDArray[np.int64]:
    """How often partitions cut the rows of each unit (g,): a line between the middles of two
    neighbours crosses one."""
    cuts = np.zeros(len(problem.units.spans), np.int64)
    walls = _list_walls(problem, kept)
    if not len(walls) or len(boxes) < 2:
        return cuts
    owner = np.repeat(np.arange(len(cuts)), np.diff(problem.units.spans, axis=1)[:, 0])
    rows = np.isin(kept.rows[owner, 0], (CHAIN, GRID))
    start, way = boxes[:-1, :2], np.diff(boxes[:, :2], axis=0)
    ahead = np.column_stack([np.cos(boxes[:-1, 2]), np.sin(boxes[:-1, 2])])
    pairs = rows[:-1] & (owner[:-1] == owner[1:]) & (np.abs((way * ahead).sum(1)) < IN_ROW)
    for wall in walls:
        crossed = pairs & _cross(start, way, wall[:2], wall[2:] - wall[:2])
        np.add.at(cuts, owner[:-1][crossed], 1)
    return cuts


def _list_walls(problem: HallProblem, kept: Kept) -> Floats:
    """The ends x, y, x, y (k, 4) of the partitions of a layout, a little beyond where they lie."""
    hosts = problem.ground.hosts[:, :4]
    way = hosts[:, 2:] - hosts[:, :2]
    way = way / np.maximum(np.hypot(way[:, 0], way[:, 1]), 1e-9)[:, None]
    first = hosts[:, :2] + kept.offsets[:, None] * np.column_stack([-way[:, 1], way[:, 0]])
    ends = [first + (kept.walls[:, k, None] + (2 * k - 1) * BEYOND) * way for k in range(2)]
    walls: Floats = np.hstack(ends)[np.diff(kept.walls, axis=1)[:, 0] >= BUILT]
    return walls


def _cross(start: Floats, way: Floats, at: Floats, along: Floats) -> NDArray[np.bool_]:
    """Whether lines from ``start`` by ``way`` (k, 2) cross that from ``at`` by ``along`` (2,)."""
    off, over = start - at, start + way - at
    side = (along[0] * off[:, 1] - along[1] * off[:, 0]) * (
        along[0] * over[:, 1] - along[1] * over[:, 0]
    )
    end = at + along - start
    other = (way[:, 1] * off[:, 0] - way[:, 0] * off[:, 1]) * (
        way[:, 0] * end[:, 1] - way[:, 1] * end[:, 0]
    )
    found: NDArray[np.bool_] = (side < 0.0) & (other < 0.0)
    return found


def propose_sides(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one of the rows of ``boxes`` (n, 5) that partitions cut moved along its line,
    its gaps as wide or narrower."""
    for unit in np.flatnonzero(_find_cuts(problem, kept, boxes)):
        first = find_layers(problem, int(unit))[0]
        mine = slice(first, first + int(kept.rows[unit, 1]))
        right = np.array([np.sin(kept.pose[unit, 2]), -np.cos(kept.pose[unit, 2])])
        for part, shift in product(NARROWER, SHIFTS):
            pose, layers = kept.pose.copy(), kept.layers.copy()
            pose[unit, :2] += shift * right
            layers[mine, ALONG] *= part
            yield kept._replace(pose=pose, layers=layers)
