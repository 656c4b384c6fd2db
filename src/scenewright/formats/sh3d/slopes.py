"""Ceilings under a roof, by the walls of a Sweet Home 3D level that are higher at one end."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from scenewright.building.outlines import edges
from scenewright.core.brief.slope import SlopeBrief
from scenewright.core.space import Points
from scenewright.formats.sh3d.xml import HomeWall

LEAST_RISE = 0.05
"""Difference of height of the ends of a wall from which on the ceiling slopes, metres."""
ACROSS = 0.95
"""Cosine of the greatest angle between a sloping wall and the rise of the ceiling."""
BESIDE = 0.15
"""Farthest that the corner of a room may be from the face of a wall that it lies at, metres."""
GENTLEST, STEEPEST = 0.02, 1.55
MOST_SLOPES = 20


def is_sloping(wall: HomeWall) -> bool:
    """Whether the top of a wall slopes."""
    low, high = wall.height, wall.height_at_end
    return low is not None and high is not None and abs(high - low) >= LEAST_RISE


def find_slopes(outline: Points, walls: Sequence[HomeWall], height: float) -> list[SlopeBrief]:
    """The slopes of the ceiling of a room ``height`` metres high by the sloping walls of its level.

    Along a wall of length l whose top rises from a to b the ceiling rises by (b - a) / l a metre;
    it begins at the edge of the room across the wall, on the side of its lower end and nearest to
    that. Of one edge the lowest counts.
    """
    found: dict[int, SlopeBrief] = {}
    for slope in (s for wall in walls if is_sloping(wall) for s in _along(outline, wall, height)):
        known = found.get(slope.edge)
        if known is None or slope.knee < known.knee:
            found[slope.edge] = slope
    return [found[edge] for edge in sorted(found)][:MOST_SLOPES]


def _along(outline: Points, wall: HomeWall, height: float) -> Iterator[SlopeBrief]:
    """The slope of a room that rises along a wall, if the room lies at it."""
    low, high = wall.height or 0.0, wall.height_at_end or 0.0
    foot, top = np.array(wall.start), np.array(wall.end)
    if high < low:
        foot, top, low, high = top, foot, high, low
    length = float(np.hypot(*(top - foot)))
    if length < LEAST_RISE:
        return
    way, rise = (top - foot) / length, (high - low) / length
    rows = edges(outline)
    along = rows[:, 2:] - rows[:, :2]
    along = along / np.hypot(along[:, 0], along[:, 1])[:, None]
    inwards = np.column_stack([-along[:, 1], along[:, 0]])
    across = inwards @ way > ACROSS
    ends = rows.reshape(-1, 2, 2) - foot
    ahead, aside = ends @ way, np.abs(ends @ np.array([-way[1], way[0]]))
    reach = wall.thickness / 2 + BESIDE
    at = (aside < reach) & (ahead > -wall.thickness - BESIDE) & (ahead < length - BESIDE)
    beside = np.flatnonzero(across & at.any(1))
    if len(beside):
        edge = int(beside[np.argmin(ahead[beside].mean(1))])
        knee = max(low + rise * float(ahead[edge].mean()), 0.0)
        pitch = min(math.atan(rise), STEEPEST)
        if knee < height - LEAST_RISE and pitch >= GENTLEST:
            yield SlopeBrief(edge=edge, knee=round(knee, 4), pitch=round(pitch, 6))
