"""Every place along the walls of a room where a case would stand free, the best first."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import lowest
from scenewright.core.catalog import Catalog, Group
from scenewright.core.same import once
from scenewright.domains.home.furnishing.furnish import SLACK, needed_of, world
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.furnishing.whole import list_grounded
from scenewright.domains.home.measures import ROUNDING
from scenewright.domains.home.problem import Ground
from scenewright.geometry.compiled import compiled
from scenewright.geometry.fit import mark_free, side_gaps

Floats = NDArray[np.float64]

STEP = 0.03  # between places along a wall, metres
APART = 0.25  # places nearer to one another than this count as one, metres
SNUG = 0.02  # a side nearer to a wall than this is in its corner, metres
FAR = 4.0  # from a door on it does not matter how far, metres
MOST = 400  # places along one wall
TINY = 1e-300


def free_places(
    case: Group, ground: Ground, standing: StandingObstacles, catalog: Catalog, height: float
) -> Floats:
    """Boxes ``(n, 5)`` of a case, its back at a wall, on which the members it cannot do without
    run into nothing: in corners first, then far from the doors; of neighbours only one."""
    boxes = free_boxes(case, ground, standing, catalog, height)
    return _apart(boxes[np.argsort(_rank(boxes, ground), kind="stable")])


class WallRows(NamedTuple):
    """The walls of a room as places along them are counted: ``rows`` (w, 5) x, y of the start, the
    unit direction and the length; ``heading`` (w,) of what has its back there, with its sine and
    cosine, ``turns`` (w, 2), and the ``length`` of all together."""

    rows: Floats
    heading: Floats
    turns: Floats
    length: float


@once(64)
def read_walls(ground: Ground) -> WallRows:
    """The walls of a ground, of the same one read once."""
    start, way = ground.walls[:, :2], ground.walls[:, 2:] - ground.walls[:, :2]
    length = np.hypot(way[:, 0], way[:, 1])
    unit = way / np.maximum(length, TINY)[:, None]
    heading = np.arctan2(unit[:, 0], -unit[:, 1])
    turns = np.column_stack([np.sin(heading), np.cos(heading)])
    rows = np.column_stack([start, unit, length])
    return WallRows(rows, heading, turns, float(length.sum()))


def free_boxes(
    case: Group,
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
    step: float = STEP,
    whole: bool = False,
    walls: WallRows | None = None,
) -> Floats:
    """The same, ``step`` metres apart and in no order; on which all that stands on the floor runs
    into nothing, if the ``whole`` case is wanted. ``walls`` are those of the ground, where they
    are known."""
    along = walls or read_walls(ground)
    boxes, turns = _list_along(case, along, step)
    needed = list_grounded(case) if whole else needed_of(case)
    return boxes[_mark(boxes, turns, case, needed, ground, standing, catalog, height)]


def along_walls(case: Group, ground: Ground, step: float = STEP) -> Floats:
    """Boxes ``(n, 5)`` of a case with its back at a wall, from one end of every wall to the other,
    at most ``step`` metres apart.

    >>> from scenewright.core.catalog import Member
    >>> from scenewright.core.scene import Size
    >>> case = Group("chest", "", 1.0, 0.4, ())
    >>> walls = np.array([[0.0, 0.0, 1.06, 0.0], [1.06, 0.0, 1.06, 0.5]])
    >>> class Room: walls = walls
    >>> along_walls(case, Room).round(3).tolist()[0]
    [0.5, 0.2, 1.571, 1.0, 0.4]
    """
    return _list_along(case, read_walls(ground), step)[0]


def _list_along(case: Group, walls: WallRows, step: float) -> tuple[Floats, Floats]:
    """Boxes ``(n, 5)`` along walls, sine and cosine of their headings ``(n, 2)``."""
    most = int(walls.length / step) + 2 * len(walls.rows)
    boxes, turns = np.empty((most, 5)), np.empty((most, 2))
    count = fill_along(*walls[:3], case.width, case.depth, step, boxes, turns)
    return boxes[:count], turns[:count]


@compiled
def fill_along(
    walls: Floats,
    heading: Floats,
    turns: Floats,
    width: float,
    depth: float,
    step: float,
    boxes: Floats,
    turned: Floats,
) -> int:
    """Write boxes (n, 5) along each of the ``walls`` (w, 5), evenly from end to end, and sine and
    cosine of their headings (n, 2); how many."""
    n = 0
    for w in range(walls.shape[0]):
        spare = walls[w, 4] - width
        if not spare >= -SLACK:
            continue
        spare = max(spare, 0.0)
        count = min(math.ceil(spare / step) + 1, MOST)
        last, ux, uy = max(count - 1, 1), walls[w, 2], walls[w, 3]
        for i in range(count):
            t = i / last * spare + width / 2
            boxes[n, 0] = walls[w, 0] + ux * t - uy * depth / 2
            boxes[n, 1] = walls[w, 1] + uy * t + ux * depth / 2
            boxes[n, 2], boxes[n, 3], boxes[n, 4] = heading[w], width, depth
            turned[n, 0], turned[n, 1] = turns[w, 0], turns[w, 1]
            n += 1
    return n


def stand_free(
    boxes: Floats,
    case: Group,
    members: tuple[int, ...],
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
) -> NDArray[np.bool_]:
    """On which boxes (n, 5) of a case some of its ``members``, by number, stand free; all of them
    where none are named, as nothing of a screen on the wall stands on the floor."""
    turns = np.column_stack([np.sin(boxes[:, 2]), np.cos(boxes[:, 2])])
    return _mark(boxes, turns, case, members, ground, standing, catalog, height)


def _mark(
    boxes: Floats,
    turns: Floats,
    case: Group,
    members: tuple[int, ...],
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
) -> NDArray[np.bool_]:
    """The same with ``turns`` (n, 2), sine and cosine of the boxes' headings."""
    free = np.zeros(len(boxes), bool)
    members = members or tuple(range(len(case.members)))
    shape, spans, flat, tall = _shape_of(case, members, catalog)
    if not len(boxes) or (tall > height + ROUNDING and not len(ground.slopes)):
        return free
    mark_free(
        boxes,
        turns,
        shape,
        spans,
        flat,
        ground.edges,
        ground.keep_free,
        ground.windows,
        standing.boxes,
        standing.spans,
        SLACK,
        free,
    )
    for i in np.flatnonzero(free) if len(ground.slopes) else ():
        placed = world(tuple(case.members[k] for k in members), boxes[i], catalog)[0]
        free[i] = bool((spans[:, 1] <= lowest(placed, ground.slopes, height) + ROUNDING).all())
    return free


@lru_cache(maxsize=4096)
def _shape_of(
    case: Group, members: tuple[int, ...], catalog: Catalog
) -> tuple[Floats, Floats, NDArray[np.bool_], float]:
    """Members of a case, its front to +y: as :func:`world` gives them, and the greatest top."""
    chosen = tuple(case.members[i] for i in members)
    shape = world(chosen, np.array([0.0, 0.0, np.pi / 2, case.width, case.depth]), catalog)
    return (*shape, float(shape[1][:, 1].max(initial=0.0)))


def _rank(boxes: Floats, ground: Ground) -> Floats:
    """Less for better places (n,): in a corner, then far from the doors."""
    snug = [min(side_gaps(box, ground.walls)) < SNUG for box in boxes]
    far = np.full(len(boxes), FAR)
    for door in ground.doors:
        far = np.minimum(far, np.hypot(boxes[:, 0] - door[0], boxes[:, 1] - door[1]))
    return np.where(snug, 0.0, 1.0) - far / FAR


def _apart(boxes: Floats) -> Floats:
    """The boxes (n, 5), of those nearly in one place only the first."""
    kept, left = list[int](), np.ones(len(boxes), bool)
    while left.any():
        kept.append(int(left.argmax()))
        off = boxes[:, :3] - boxes[kept[-1], :3]
        left &= (np.hypot(off[:, 0], off[:, 1]) >= APART) | (np.abs(off[:, 2]) >= 0.1)
    return boxes[kept]
