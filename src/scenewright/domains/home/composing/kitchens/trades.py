"""Groups that belong to a kitchen at the ends of its lines, in place of the pieces there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import RUN
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomTask
from scenewright.domains.home.composing.case_faults import IN_LINE
from scenewright.domains.home.composing.judging import Placed, find_run, judge_of
from scenewright.domains.home.composing.kitchens.mend import may_go
from scenewright.domains.home.composing.places.flush import AT, list_flush
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import dress_group, stand_at
from scenewright.domains.home.composing.places.walked_places import try_places
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.grounds.wall_places import read_walls
from scenewright.domains.home.measures import ALIKE
from scenewright.geometry.boxes import Frame, common_area, make_frame

Floats = NDArray[np.float64]
RoomTrade = tuple[Placed, tuple[Missing, ...]]
"""The groups of a room, and what is missing in it now."""

FRIDGE, RUG = "fridge", "rug"
STEP = 0.05  # between places along a wall, metres
SHARED = 1e-3  # overlap allowed between neighbours, square metres
REASON = "what belongs to the kitchen takes its place beside it"


class Move(NamedTuple):
    """A group as a case on a box (5,), and the box (5,) of the floor it takes anew."""

    group: FurnishedGroup
    case: Group
    box: Floats
    floor: Floats


def list_traded(
    task: RoomTask, placed: Placed, moves: Iterable[Move], most: float
) -> Iterator[RoomTrade]:
    """The groups of a room, at a cost of at most ``most``, with one of them moved and the one there
    elsewhere along the walls; optional groups that find no place are missing."""
    for joined, away in list_moved(task, placed, moves):
        if not away:
            yield joined, ()
            continue
        whole, (other,) = (*joined, *away), away
        forms, judge = list_forms(task, other), judge_of(task, whole)
        for judged in try_places(judge, whole, len(joined), forms, most, 0.0, STEP):
            yield judged.placed, ()
        if may_go(other):
            yield joined, (Missing(other.wish, REASON),)


def list_moved(
    task: RoomTask, placed: Placed, moves: Iterable[Move]
) -> Iterator[tuple[Placed, Placed]]:
    """The groups of a room with one of them moved to where at most one other stands, without that,
    and that."""
    for group, case, box, floor in moves:
        others = tuple(p for p in placed if p is not group)
        away = tuple(p for p in others if _is_on(p, make_frame(*floor.tolist())))
        rest = tuple(p for p in others if all(p is not q for q in away))
        standing = standing_of(_pieces(task, rest), flat_kinds(task.catalog))
        dressed = dress_group(task, group, case, box, standing) if len(away) < 2 else None
        if dressed is not None and len(dressed.pieces) >= len(group.pieces):
            yield (*rest, dressed), away


def list_at_run(
    task: RoomTask, placed: Placed, group: FurnishedGroup, cases: Iterable[Group]
) -> Iterator[Move]:
    """A group in each of some cases at the side of a unit of the run, where walls leave it room."""
    runs = find_run(placed)
    standing = standing_of(_pieces(task, runs), flat_kinds(task.catalog))
    for case in cases if runs else ():
        boxes = list_flush(case, read_walls(task.ground), standing, RUN - {FRIDGE})
        for box in stand_at(task, case, boxes, standing):
            if any(_is_in_line(box, p) for run in runs for p in run.pieces):
                yield Move(group, case, box, box)


def _is_in_line(box: Floats, unit: Piece) -> bool:
    """Whether a box (5,) is at a side of a unit and looks the same way."""
    x, y, heading, width, _ = box.tolist()
    dx, dy, s, c = unit.pose.x - x, unit.pose.y - y, sin(heading), cos(heading)
    gap = abs(dx * s - dy * c) - (width + unit.size.width) / 2
    alike = cos(unit.pose.heading - heading) > ALIKE
    return alike and unit.category in RUN and abs(gap) < AT and abs(dx * c + dy * s) < IN_LINE


def _pieces(task: RoomTask, groups: Placed) -> tuple[Piece, ...]:
    return (*task.fixed, *task.beside, *(p for group in groups for p in group.pieces))


def _is_on(group: FurnishedGroup, floor: Frame) -> bool:
    """Whether a group stands on some floor."""
    return any(
        common_area(floor, make_frame(p.pose.x, p.pose.y, p.pose.heading, *p.size[:2])) > SHARED
        for p in group.pieces
        if p.category != RUG
    )
