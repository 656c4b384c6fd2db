"""The walls that are built in a hall, as pieces."""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.zoning.borders import floor_of

UNDER_CEILING, TALLEST = 0.3, 4.0
"""Metres a partition stays below the ceiling, and its greatest height."""
BUILT_AT_WALL = 0.15
"""Most metres from a wall to the back of an object at it."""
SHORTEST_PIECE = 0.3
"""Shorter walls are not built, in metres."""


def partitions(
    hall: HallContext, problem: HallProblem, kept: Kept, boxes: Floats, catalog: Catalog
) -> list[Piece]:
    """The generated walls as pieces, within the hall: at a slanting wall they end before it; one at
    which none of the objects (n, 5) has its back is not built."""
    ahead = np.column_stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])])
    backs = boxes[:, :2] - 0.5 * boxes[:, 4:] * ahead
    floor, thick = floor_of(hall.space), problem.ground.thickness
    found: list[Piece] = []
    rows = zip(problem.ground.hosts, kept.walls, kept.offsets, strict=True)
    for host, span, off in rows:
        start, end = np.array(host[:2]), np.array(host[2:4])
        way = (end - start) / np.hypot(*(end - start))
        start = start + off * np.array([-way[1], way[0]])
        low, high = clip_span(floor, start, way, (float(span[0]), float(span[1])), thick)
        middle = start + way * (low + high) / 2
        if high - low < SHORTEST_PIECE or not _holds(backs, middle, way, 0.5 * (high - low), thick):
            continue
        found.append(_make_wall(hall, len(found) + 1, middle, way, high - low, thick, catalog))
    return found


def _make_wall(
    hall: HallContext,
    number: int,
    middle: Floats,
    way: Floats,
    length: float,
    thick: float,
    catalog: Catalog,
) -> Piece:
    """One wall along a ``way`` about its middle."""
    height = min(max(hall.space.height - UNDER_CEILING, 2.0), TALLEST, hall.space.height)
    size = Size(length, thick, height)
    asset = catalog.choose("partition", size)
    heading = math.remainder(math.atan2(way[0], -way[1]), 2.0 * math.pi)
    return Piece(
        id=f"{hall.space.id}/partitions/partition_{number}",
        category="partition",
        asset=asset.id if asset else "",
        space=hall.space.id,
        pose=Pose(float(middle[0]), float(middle[1]), 0.0, heading),
        size=size,
        group=f"{hall.space.id}/partitions",
        function="partition",
    )


def clip_span(
    floor: shapely.Polygon, start: Floats, way: Floats, span: tuple[float, float], thick: float
) -> tuple[float, float]:
    """From where to where along a ``way`` both faces of a wall with a ``span`` are on a floor.

    >>> floor = shapely.Polygon([(0, 0), (4, 0), (4, 3), (0, 5)])
    >>> start, way = np.array([2.0, 0.0]), np.array([0.0, 1.0])
    >>> clip_span(floor, start, way, (1.0, 4.0), 0.2)
    (1.0, 3.95)
    """
    side, (low, high) = 0.5 * thick * np.array([-way[1], way[0]]), span
    for at in (start + side, start - side):
        face = shapely.LineString([at + low * way, at + high * way])
        inside = shapely.get_parts(shapely.intersection(face, floor))
        lines = [part for part in inside.tolist() if part.length > 0.0]
        if not lines:
            return low, low
        ends = (shapely.get_coordinates(max(lines, key=lambda part: part.length)) - at) @ way
        low, high = max(low, float(ends.min())), min(high, float(ends.max()))
    return low, high


def _holds(backs: Floats, middle: Floats, way: Floats, half: float, thickness: float) -> bool:
    """Whether one of the backs (k, 2) lies at a wall about its ``middle``."""
    off = backs - middle
    across = np.abs(off @ (-way[1], way[0]))
    return bool(((np.abs(off @ way) <= half) & (across <= 0.5 * thickness + BUILT_AT_WALL)).any())
