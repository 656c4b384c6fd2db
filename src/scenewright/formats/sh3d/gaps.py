"""Gaps that the walls of a Sweet Home 3D level leave: where one goes through without a door.

Many leave the wall out where a door is to be, at the foot of a wall or between two in line.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.formats.sh3d.xml import HomePiece, HomeWall, middle_line

PASSAGE = 1.5
"""Widest gap that is read as an open passage, metres."""
MISSING = 4.0
"""Widest gap across which walls are still meant to enclose a room, metres."""
TOUCHING = 0.15
"""Walls that miss each other by less are taken as joined, metres."""
ACROSS = 0.5
"""Cosine of the least angle between a gap and a wall that only ends in it."""
PARTITION = 1.6
"""Lower walls part no rooms, metres."""


class Gap(NamedTuple):
    """What is missing of a wall: its ``start`` (the end of a wall) and ``end``, at the wall it
    meets, and the ``thickness`` of the wall it lengthens."""

    start: tuple[float, float]
    end: tuple[float, float]
    thickness: float

    @property
    def width(self) -> float:
        """How wide it is, metres."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))

    @property
    def middle(self) -> tuple[float, float]:
        """The point halfway."""
        return (self.start[0] + self.end[0]) / 2, (self.start[1] + self.end[1]) / 2

    def band(self) -> shapely.Polygon:
        """The floor that the missing wall would take."""
        line = shapely.LineString([self.start, self.end])
        return line.buffer(self.thickness / 2, cap_style="flat")


def find_gaps(walls: Sequence[HomeWall], widest: float = PASSAGE) -> list[Gap]:
    """The gaps of at most ``widest`` metres between an end of a wall that meets no other and what
    it would meet if it went straight on; each once, from west to east."""
    walls = [wall for wall in walls if (wall.height or PARTITION) >= PARTITION]
    bands = [_band(wall) for wall in walls]
    tree = shapely.STRtree(bands)
    ids = {wall.id for wall in walls} - {""}
    found: list[Gap] = []
    for number, tip, way in _free_ends(walls, tree, ids):
        gap = _ahead(walls, number, tip, way, bands, tree, widest)
        if gap is not None and not any(_is_same(gap, other) for other in found):
            found.append(gap)
    return sorted(found, key=lambda gap: (gap.middle, gap.width))


def _band(wall: HomeWall) -> shapely.Polygon:
    band: shapely.Polygon = shapely.LineString(middle_line(wall)).buffer(
        max(wall.thickness, 1e-3) / 2, cap_style="flat"
    )
    return band


def _free_ends(
    walls: Sequence[HomeWall], tree: shapely.STRtree, ids: set[str]
) -> Iterator[tuple[int, Points, Points]]:
    """Number of the wall, point and direction outwards of the ends that meet no wall."""
    for number, wall in enumerate(walls):
        line = middle_line(wall)
        for end, inner in ((0, 1), (-1, -2)):
            if wall.joined[end] in ids:
                continue
            tip, along = line[end], line[end] - line[inner]
            length = float(np.hypot(*along))
            near = tree.query(shapely.Point(tip), predicate="dwithin", distance=TOUCHING)
            if length > 0 and not len(near[near != number]):
                yield number, tip, along / length


def _ahead(
    walls: Sequence[HomeWall],
    number: int,
    tip: Points,
    way: Points,
    bands: Sequence[shapely.Polygon],
    tree: shapely.STRtree,
    widest: float,
) -> Gap | None:
    """The gap before a free end up to the nearest wall within reach; None if there is none. A wall
    across that ends in the gap does not fill it, if another lies beyond."""
    ray = shapely.LineString([tip, tip + way * widest])
    near = tree.query(ray, predicate="intersects")
    hits = [
        (_ends_across(walls[k], ray, way), float(np.min((_points(bands[k], ray) - tip) @ way)))
        for k in near.tolist()
        if k != number
    ]
    if not hits:
        return None
    x, y = (tip + way * min(hits)[1]).tolist()
    return Gap((float(tip[0]), float(tip[1])), (x, y), walls[number].thickness)


def _points(band: shapely.Polygon, ray: shapely.LineString) -> Points:
    found: Points = shapely.get_coordinates(band.intersection(ray))
    return found


def _ends_across(wall: HomeWall, ray: shapely.LineString, way: Points) -> bool:
    """Whether a wall across a ray ends at it."""
    line = middle_line(wall)
    for end, inner in ((0, 1), (-1, -2)):
        along = line[end] - line[inner]
        across = abs(along @ way) < ACROSS * float(np.hypot(*along))
        if across and ray.distance(shapely.Point(line[end])) < TOUCHING:
            return True
    return False


def _is_same(one: Gap, other: Gap) -> bool:
    """Whether two gaps are one seen from both sides."""
    return one.band().intersection(other.band()).area > 0.5 * min(
        one.band().area, other.band().area
    )


def passages(gaps: Sequence[Gap], level: str, height: float) -> list[HomePiece]:
    """The gaps as open doorways of a level, to be put on the walls of rooms like doors."""
    return [_passage(gap, level, height) for gap in gaps]


def _passage(gap: Gap, level: str, height: float) -> HomePiece:
    along = np.subtract(gap.end, gap.start)
    x, y = gap.middle
    return HomePiece(
        kind="doorOrWindow",
        catalog="",
        name="opening",
        level=level,
        x=x,
        y=y,
        z=0.0,
        turn=float(np.arctan2(along[1], along[0])),
        width=gap.width,
        depth=gap.thickness,
        height=height,
        movable=False,
        visible=True,
        sashes=(),
        members=(),
        place="",
        upright=(gap.width, gap.thickness, height),
    )
