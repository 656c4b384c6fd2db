"""Coats beside the units of a kitchen, in a room that is kitchen and hall, moved away from them."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.composing.beside_others import (
    list_others,
    list_taken_beside,
    take_first_place,
)
from scenewright.domains.home.composing.case_faults import RUN
from scenewright.domains.home.composing.moving import stand_at
from scenewright.domains.home.composing.wall_stretch import list_free_stretches
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.geometry.boxes import common_area, make_frame

Floats = NDArray[np.float64]

SPLASHED = 0.6  # coats keep so far off the units of a kitchen, metres


def move_coats(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with coats that stand beside the units of a kitchen at the nearest end of a free
    stretch of wall that is farther off, where that bars no way."""
    coats = next((p for p in answer.placed if p.wish.group == "coats" and p.pieces), None)
    pieces = (*task.fixed, *(q for p in answer.placed for q in p.pieces))
    units = [p for p in pieces if p.category in RUN and p.pose.z < ON_FLOOR]
    if coats is None or task.cancelled() or not is_splashed(coats.dressed.box, units):
        return answer
    standing = list_others(task, answer.placed, coats)
    taken = list_taken_beside(task, answer.placed, coats, standing)
    found = _list_places(task, coats, units, standing, taken)
    placed = take_first_place(task, answer.placed, coats, found, standing, barred)
    return answer._replace(placed=placed)


def _list_places(
    task: RoomTask,
    coats: FurnishedGroup,
    units: list[Piece],
    standing: StandingObstacles,
    taken: Floats,
) -> Iterator[tuple[Group, Floats]]:
    """Where coats stand free and away from units, the nearest first."""
    form, (x, y) = coats.dressed.case, coats.dressed.box[:2]
    stretches = list_free_stretches(task.ground, form.depth, taken, form.width)
    ends = [s.boxes_at(np.array([0.0, s.length - form.width]), form) for s in stretches]
    boxes = np.concatenate([np.empty((0, 5)), *ends])
    boxes = boxes[np.argsort(np.hypot(boxes[:, 0] - x, boxes[:, 1] - y), kind="stable")]
    for box in stand_at(task, form, boxes, standing):
        if not is_splashed(box, units):
            yield form, box


def is_splashed(box: Floats, units: list[Piece]) -> bool:
    """Whether the floor :data:`SPLASHED` metres round one of some units reaches a box (5,).

    >>> from scenewright.core.scene import Pose, Size
    >>> hob = Piece("h", "hob_cabinet", "", "a", Pose(0, 0, 0, 0), Size(0.6, 0.6, 0.9))
    >>> rack = np.array([1.0, 0.0, 0.0, 0.4, 0.4])
    >>> is_splashed(rack, [hob]), is_splashed(rack + [0.2, 0.0, 0.0, 0.0, 0.0], [hob])
    (True, False)
    """
    frame, x, y = make_frame(*box.tolist()), float(box[0]), float(box[1])
    for unit in units:
        (a, b, _, heading), (width, depth, _) = unit.pose, unit.size
        if hypot(a - x, b - y) < width + depth + 2 * SPLASHED:
            near = make_frame(a, b, heading, width + 2 * SPLASHED, depth + 2 * SPLASHED)
            if float(common_area(near, frame)) > 0.0:
                return True
    return False
