"""Whether a building fits on the ground: exact for the headings tried.

A rectangle turned by some angle fits in a polygon where its centre can stand: the polygon less
the sum (Minkowski) of the rectangle with each edge, which is the hull of the rectangle at both
ends of the edge. What is left is exactly the centres at which no edge is touched.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
import shapely

from scenewright.core.space import Points

STEP = np.deg2rad(7.5)
SLACK = 1e-3
MOST_EDGES = 12


class BuildableGround(Protocol):
    """A piece of ground: outline and holes, area, main direction, radius of its largest circle."""

    @property
    def outline(self) -> Points:
        """Corners (n, 2), counter-clockwise."""

    @property
    def holes(self) -> tuple[Points, ...]:
        """Rings, clockwise."""

    @property
    def area(self) -> float:
        """Square metres."""

    @property
    def direction(self) -> float:
        """Radians."""

    @property
    def radius(self) -> float:
        """Metres."""


class BuildableSite(Protocol):
    """What has blocks, as the plan of a site."""

    @property
    def blocks(self) -> Sequence[BuildableGround]:
        """Pieces of ground that can be built on."""


def fits(plan: BuildableSite, width: float, depth: float) -> bool:
    """Whether a box fits in some block of a plan, at the directions of its longest edges or a
    multiple of 7.5 degrees to its principal direction (exact for each of these).

    >>> from scenewright.domains.site.brief import Site
    >>> from scenewright.domains.site.plan import site_plan
    >>> plan = site_plan(Site(outline=[(0, 0), (40, 0), (40, 20), (0, 20)], setback=3))
    >>> fits(plan, 14, 34), fits(plan, 14, 35)
    (True, False)
    """
    short = min(width, depth)
    hopeful = [b for b in plan.blocks if 2 * b.radius >= 0.98 * short and b.area >= width * depth]
    return any(_fits(block, width, depth) for block in hopeful)


def main_direction(rings: Sequence[Points]) -> float:
    """The direction, in [0, pi/2), that most of the length of some rings runs along.

    >>> round(float(main_direction([np.array([(0, 0), (5, 0), (5, 3), (0, 3)])])), 6)
    0.0
    """
    along = np.vstack([np.roll(ring, -1, axis=0) - ring for ring in rings])
    lengths, quarter = np.hypot(*along.T), np.pi / 2
    angles = np.arctan2(along[:, 1], along[:, 0]) % quarter
    rows = np.minimum((angles / quarter * 180).astype(int), 179)
    counts = np.bincount(rows, lengths, 180)
    around = counts + np.roll(counts, 1) + np.roll(counts, -1)
    middle = (int(np.argmax(np.round(around, 6))) + 0.5) / 180 * quarter
    off = (angles - middle + quarter / 2) % quarter - quarter / 2
    near = np.abs(off) <= 1.5 * quarter / 180 + 1e-9
    turned = (middle + np.average(off[near], weights=lengths[near])) % quarter
    return float(turned) if quarter - turned > 1e-9 else 0.0


def corners_of(box: Sequence[float]) -> Points:
    """The four corners of a box (x, y, heading, width, depth), counter-clockwise."""
    x, y, heading, width, depth = box
    front = np.array([np.cos(heading), np.sin(heading)]) * depth / 2
    right = np.array([np.sin(heading), -np.cos(heading)]) * width / 2
    return np.array([x, y]) + np.stack(
        [right - front, right + front, front - right, -front - right]
    )


def _fits(block: BuildableGround, width: float, depth: float) -> bool:
    floor = shapely.Polygon(block.outline, block.holes)
    edges = [
        np.stack([ring, np.roll(ring, -1, axis=0)], 1) for ring in (block.outline, *block.holes)
    ]
    ends = np.vstack(edges)
    pairs = [(width, depth)] if width == depth else [(width, depth), (depth, width)]
    return any(
        _fits_turned(floor, ends, corners_of((0.0, 0.0, heading, *pair)))
        for heading in _headings(ends, block.direction)
        for pair in pairs
    )


def _headings(ends: Points, direction: float) -> list[float]:
    along = ends[:, 1] - ends[:, 0]
    longest = np.argsort(-np.hypot(*along.T), kind="stable")[:MOST_EDGES]
    own = np.arctan2(along[longest, 1], along[longest, 0]) % (np.pi / 2)
    turned = (direction + STEP * np.arange(12)) % (np.pi / 2)
    return np.unique(np.round([direction, *own, *turned], 6)).tolist()


def _fits_turned(floor: shapely.Polygon, ends: Points, box: Points) -> bool:
    smaller = box * (1 - SLACK / np.abs(box).max())
    swept = (ends[:, :, None, :] + smaller[None, None]).reshape(len(ends), -1, 2)
    hulls = shapely.convex_hull(shapely.multipoints(swept))
    return not shapely.difference(floor, shapely.union_all(hulls)).is_empty
