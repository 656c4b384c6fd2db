"""One group of a room in other forms and places, beside all others as they stand."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import count

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import RUN
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.flush import list_flush
from scenewright.domains.home.composing.places.forms import is_mere_kitchen
from scenewright.domains.home.composing.places.stretches import Reach, longest_stretch, reach_of
from scenewright.domains.home.furnishing.furnish import FurnishedPatch, dress_case, pieces_of
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.furnishing.whole import list_grounded
from scenewright.domains.home.grounds.wall_places import (
    WallRows,
    free_boxes,
    read_walls,
    stand_free,
)
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.programme import Wish
from scenewright.geometry.fit import is_backed, side_gaps

Floats = NDArray[np.float64]

NOWHERE: Floats = np.empty((0, 5))
AMID = 0.3  # what is farther from the wall behind it stands free in the room, metres
FREE = frozenset(("dining",))
"""Groups that may stand free in a room."""
AMID_FROM, GRID = 14.0, 0.3
"""Area in m² from which free-standing places are tried, and metres between them."""
UNIT_AT_WALL = 0.04  # a unit nearer than this is at its wall, metres


def with_margin(task: RoomTask) -> RoomTask:
    """The task with ways wider, so that an exact walk finds every way the grid finds."""
    more = task.preset.settings.composing.wider
    return task._replace(route_width=task.route_width + more, use_width=task.use_width + more)


def find_places(
    task: RoomTask,
    cases: Iterable[Group],
    standing: StandingObstacles,
    group: FurnishedGroup,
    step: float | None = None,
) -> Iterator[tuple[Group, Floats]]:
    """The cases that stand free somewhere along a wall, or where the group stands now if that is
    away from walls, each with its boxes ``(n, 5)``; places along walls are a ``step`` apart,
    metres, if not stated that of the preset."""
    longest, walls = dict[Reach, float](), read_walls(task.ground)
    step = step or task.preset.settings.composing.step
    stands_free = bool(group.pieces) and not is_backed(group.dressed.box, task.ground.walls, AMID)
    for case in cases:
        reach = reach_of(case)
        if reach not in longest:
            longest[reach] = longest_stretch(task.ground, standing, reach)
        free = _free(task, case, standing, walls, step) if case.width <= longest[reach] else NOWHERE
        if case.function == "fridge" or (case.function == "washer" and is_mere_kitchen(task)):
            flush = stand_at(task, case, list_flush(case, walls, standing, RUN), standing)
            free = flush if len(flush) else free
        if case.function in FREE and _may_stand_amid(task):
            free = np.concatenate([free, list_amid(task, case, standing)])
        if stands_free:
            there = _in_place(task, case, standing, group.dressed.box)
            free = np.concatenate([free, there])
        if len(free):
            yield case, free


def _in_place(task: RoomTask, case: Group, standing: StandingObstacles, box: Floats) -> Floats:
    """Of the boxes of a case with the middle, the back or the front where ``box`` has it those on
    which it stands free, ``(n, 5)``."""
    ahead = (box[4] - case.depth) / 2 * np.array([0.0, -1.0, 1.0])
    boxes = np.repeat(box[None], 3, axis=0)
    boxes[:, 0] += ahead * np.cos(box[2])
    boxes[:, 1] += ahead * np.sin(box[2])
    boxes[:, 3:] = case.width, case.depth
    return stand_at(task, case, boxes, standing)


def stand_at(task: RoomTask, case: Group, boxes: Floats, standing: StandingObstacles) -> Floats:
    """Those of the boxes (n, 5) on which a case stands free."""
    height = task.space.height
    return boxes[
        stand_free(boxes, case, list_grounded(case), task.ground, standing, task.catalog, height)
    ]


def _may_stand_amid(task: RoomTask) -> bool:
    """Whether a room is large, and no wish for a place needs the middle of its floor."""
    return task.ground.area >= AMID_FROM and not (task.asked and task.asked.wishes)


def list_amid(task: RoomTask, case: Group, standing: StandingObstacles) -> Floats:
    """The boxes (n, 5) of a grid over the room, along its longest wall and across, on which a case
    stands free."""
    x0, y0, x1, y1 = task.ground.bounds.tolist()
    walls = task.ground.walls
    u, v = (walls[:, 2:] - walls[:, :2])[np.hypot(*(walls[:, 2:] - walls[:, :2]).T).argmax()]
    turns = np.arctan2(v, u) + np.array([0.0, np.pi / 2])
    axes = np.arange(x0, x1, GRID), np.arange(y0, y1, GRID), turns
    x, y, turn = (a.ravel() for a in np.meshgrid(*axes))
    size = np.tile((case.width, case.depth), (len(x), 1))
    boxes = np.column_stack([x, y, turn, size])
    return stand_at(task, case, boxes, standing)


def _free(
    task: RoomTask, case: Group, standing: StandingObstacles, walls: WallRows, step: float
) -> Floats:
    height = task.space.height
    free = free_boxes(case, task.ground, standing, task.catalog, height, step, True, walls)
    side = _side_of_corner(case) if len(free) else 0.0
    if not side:
        return free
    gaps = np.array([side_gaps(box, task.ground.walls) for box in free])
    return free[gaps[:, int(side > 0.0)] < UNIT_AT_WALL]


@lru_cache(maxsize=4096)
def _side_of_corner(case: Group) -> float:
    """How far to the right the corner cabinet of a case stands, metres; 0 without one."""
    return next((m.x for m in case.members if m.category == "corner_cabinet"), 0.0)


def dress_group(
    task: RoomTask, group: FurnishedGroup, case: Group, box: Floats, standing: StandingObstacles
) -> FurnishedGroup | None:
    """The group as a case on a box ``(5,)``; None where it loses more than it has lost, or a unit
    of a kitchen has no wall behind it."""
    dressed = dress_case(
        case.function, case, box, task.ground, standing, task.catalog, task.space.height
    )
    if not isinstance(dressed, FurnishedPatch) or dressed.lost > group.dressed.lost:
        return None
    name = f"{task.space.id}/{group.name}"
    pieces = pieces_of(dressed, task.space.id, name, group.wish.group, task.catalog)
    if group.wish.group in RUNS and not all(_is_at_wall(p, task) for p in pieces):
        return None
    return group._replace(dressed=dressed, pieces=pieces)


def _is_at_wall(unit: Piece, task: RoomTask) -> bool:
    """Whether a unit of a kitchen that stands on the floor has its back at a wall."""
    (x, y, z, heading), size = unit.pose, unit.size
    box = np.array([x, y, heading, size.width, size.depth])
    return z > UNIT_AT_WALL or bool(is_backed(box, task.ground.walls, UNIT_AT_WALL))


def make_unplaced(task: RoomTask, placed: Placed, wish: Wish, case: Group) -> FurnishedGroup:
    """A group under a name of its own that has no place yet."""
    taken = {p.name for p in placed} | {p.group.rpartition("/")[2] for p in task.fixed}
    names = (f"{wish.group}_{k}" if k > 1 else wish.group for k in count(1))
    nowhere = FurnishedPatch(case, np.array([0.0, 0.0, 0.0, case.width, case.depth]), (), 0)
    return FurnishedGroup(wish, next(n for n in names if n not in taken), nowhere, ())
