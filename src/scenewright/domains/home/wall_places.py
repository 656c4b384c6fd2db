"""Every place along the walls of a room where a case would stand free, the best first."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog, Group, Member
from scenewright.domains.home.furnishing.furnish import SLACK, needed_of, too_tall, world
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.furnishing.whole import RAISED
from scenewright.domains.home.problem import Ground
from scenewright.geometry.fit import faults, side_gaps

Floats = NDArray[np.float64]

STEP = 0.03  # between places along a wall, metres
APART = 0.25  # places nearer to one another than this count as one, metres
SNUG = 0.02  # a side nearer to a wall than this is in its corner, metres
FAR = 4.0  # from a door on it does not matter how far, metres
MOST = 400  # places along one wall


def free_places(
    case: Group, ground: Ground, standing: StandingObstacles, catalog: Catalog, height: float
) -> Floats:
    """Boxes ``(n, 5)`` of a case, its back at a wall, on which the members it cannot do without
    run into nothing: in corners first, then far from the doors; of neighbours only one."""
    boxes = free_boxes(case, ground, standing, catalog, height)
    return _apart(boxes[np.argsort(_rank(boxes, ground), kind="stable")])


def free_boxes(
    case: Group,
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
    step: float = STEP,
    whole: bool = False,
) -> Floats:
    """The same, ``step`` metres apart and in no order; on which all that stands on the floor runs
    into nothing, if the ``whole`` case is wanted."""
    boxes = along_walls(case, ground, step)
    needed = tuple(case.members[i] for i in needed_of(case))
    if whole:
        needed = tuple(m for m in case.members if m.on < 0 and m.z < RAISED)
    return boxes[stand_free(boxes, case, needed, ground, standing, catalog, height)]


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
    start, way = ground.walls[:, :2], ground.walls[:, 2:] - ground.walls[:, :2]
    length = np.hypot(way[:, 0], way[:, 1])
    fit = np.flatnonzero(length - case.width >= -SLACK)
    if not len(fit):
        return np.empty((0, 5))
    spare = np.maximum(length[fit] - case.width, 0.0)
    count = np.minimum(np.ceil(spare / step).astype(int) + 1, MOST)
    wall, first = np.repeat(np.arange(len(fit)), count), np.repeat(np.cumsum(count) - count, count)
    share = (np.arange(len(wall)) - first) / np.maximum(count - 1, 1)[wall]
    t = share * spare[wall] + case.width / 2
    ux, uy = (way[fit] / length[fit, None])[wall].T
    boxes = np.empty((len(wall), 5))
    boxes[:, 0] = start[fit[wall], 0] + ux * t - uy * case.depth / 2
    boxes[:, 1] = start[fit[wall], 1] + uy * t + ux * case.depth / 2
    boxes[:, 2] = np.arctan2(ux, -uy)
    boxes[:, 3:] = case.width, case.depth
    return boxes


def stand_free(
    boxes: Floats,
    case: Group,
    members: tuple[Member, ...],
    ground: Ground,
    standing: StandingObstacles,
    catalog: Catalog,
    height: float,
) -> NDArray[np.bool_]:
    """On which boxes (n, 5) of a case some of its ``members`` stand free."""
    if not len(boxes):
        return np.zeros(0, bool)
    local = world(members, np.array([0.0, 0.0, np.pi / 2, case.width, case.depth]), catalog)
    (shape, spans, flat), n = local, len(boxes)
    sin, cos = np.sin(boxes[:, 2:3]), np.cos(boxes[:, 2:3])
    placed = np.empty((n, len(members), 5))
    placed[:, :, 0] = boxes[:, :1] + shape[:, 0] * sin + shape[:, 1] * cos
    placed[:, :, 1] = boxes[:, 1:2] - shape[:, 0] * cos + shape[:, 1] * sin
    placed[:, :, 2] = boxes[:, 2:3] + shape[:, 2] - np.pi / 2
    placed[:, :, 3:] = shape[:, 3:]
    rows, tall = placed.reshape(-1, 5), np.tile(spans, (n, 1))
    codes, _ = faults(
        rows,
        tall,
        np.tile(flat, n),
        ground.edges,
        ground.keep_free,
        ground.windows,
        standing.boxes,
        standing.spans,
        SLACK,
    )
    codes = too_tall(rows, tall, ground, height, codes)
    return np.asarray((codes.reshape(n, -1) == 0).all(1))


def _rank(boxes: Floats, ground: Ground) -> Floats:
    """Less for better places (n,): in a corner, then far from the doors."""
    snug = [min(side_gaps(box, ground.walls)) < SNUG for box in boxes]
    far = np.full(len(boxes), FAR)
    for door in ground.doors:
        far = np.minimum(far, np.hypot(boxes[:, 0] - door[0], boxes[:, 1] - door[1]))
    return np.where(snug, 0.0, 1.0) - far / FAR


def _apart(boxes: Floats) -> Floats:
    """The boxes (n, 5), of those nearly in one place only the first."""
    kept: list[int] = []
    for i, box in enumerate(boxes):
        near = np.hypot(*(boxes[kept, :2] - box[:2]).T) < APART
        if not (near & (np.abs(boxes[kept, 2] - box[2]) < 0.1)).any():
            kept.append(i)
    return boxes[kept]
