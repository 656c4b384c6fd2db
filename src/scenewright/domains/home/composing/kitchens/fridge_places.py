"""A fridge at the ends of the lines of its kitchen, where need be in the place of what is there."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup, Missing, RoomTask
from scenewright.domains.home.composing.bed_places import place_member
from scenewright.domains.home.composing.case_faults import RUN, find_neighbour
from scenewright.domains.home.composing.flush import list_flush
from scenewright.domains.home.composing.forms import list_forms
from scenewright.domains.home.composing.judging import Placed, find_run, judge_of
from scenewright.domains.home.composing.kitchens.mend import may_go
from scenewright.domains.home.composing.kitchens.slits import is_unit
from scenewright.domains.home.composing.moving import dress_group, stand_at
from scenewright.domains.home.composing.walked_places import try_places
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.fitted_kitchen import SLIM_FRIDGE
from scenewright.domains.home.wall_places import read_walls
from scenewright.geometry.boxes import Frame, common_area, make_frame

Floats = NDArray[np.float64]

CORNER, FRIDGE, RUG = "corner_cabinet", "fridge", "rug"
STEP = 0.05  # between places along a wall, metres
SHARED = 1e-3  # square metres that what stands side by side may share
REASON = "the fridge takes its place beside the kitchen"


class JoinedFridge(NamedTuple):
    """The groups of a room with the fridge beside other units, without those that stood there."""

    placed: Placed
    away: Placed


def list_traded(
    task: RoomTask, placed: Placed, most: float
) -> Iterator[tuple[Placed, tuple[Missing, ...]]]:
    """The groups of a room that cost at most so much with its fridge at an end of its run, what
    stood there elsewhere along the walls; what is merely welcome and finds no place is missing."""
    for joined, away in list_joined(task, placed):
        if not away:
            yield joined, ()
            continue
        whole, (other,) = (*joined, *away), away
        forms, judge = list_forms(task, other), judge_of(task, whole)
        for judged in try_places(judge, whole, len(joined), forms, most, 0.0, STEP):
            yield judged.placed, ()
        if may_go(other):
            yield joined, (Missing(other.wish, REASON),)


def list_joined(task: RoomTask, placed: Placed) -> Iterator[JoinedFridge]:
    """The groups of a room with its fridge at one end of a line after the other, where at most one
    other group stands."""
    for group, case, box, floor in (*_list_of_run(placed), *_list_of_its_own(task, placed)):
        others = tuple(p for p in placed if p is not group)
        away = tuple(p for p in others if _is_on(p, make_frame(*floor.tolist())))
        rest = tuple(p for p in others if all(p is not q for q in away))
        standing = standing_of(_pieces(task, rest), flat_kinds(task.catalog))
        dressed = dress_group(task, group, case, box, standing) if len(away) < 2 else None
        if dressed is not None and len(dressed.pieces) == len(group.pieces):
            yield JoinedFridge((*rest, dressed), away)


def _list_of_run(placed: Placed) -> Iterator[tuple[FurnishedGroup, Group, Floats, Floats]]:
    """A run with its fridge at an end, its box, and that of the fridge."""
    for run in find_run(placed):
        for case, fridge in list_ends(run.dressed.case):
            yield run, case, run.dressed.box, place_member(fridge, run.dressed.box[None])[0]


def _list_of_its_own(
    task: RoomTask, placed: Placed
) -> Iterator[tuple[FurnishedGroup, Group, Floats, Floats]]:
    """A fridge that is a group of its own at an end of a run, and its box twice."""
    runs = find_run(placed)
    standing = standing_of(_pieces(task, runs), flat_kinds(task.catalog))
    for fridge in (p for p in placed if p.wish.group == FRIDGE and runs):
        case = fridge.dressed.case
        boxes = list_flush(case, read_walls(task.ground), standing, RUN - {FRIDGE})
        for box in stand_at(task, case, boxes, standing):
            yield fridge, case, box, box


def _pieces(task: RoomTask, groups: Placed) -> tuple[Piece, ...]:
    return (*task.fixed, *task.beside, *(p for group in groups for p in group.pieces))


def _is_on(group: FurnishedGroup, floor: Frame) -> bool:
    """Whether a group stands on some floor."""
    return any(
        common_area(floor, make_frame(p.pose.x, p.pose.y, p.pose.heading, *p.size[:2])) > SHARED
        for p in group.pieces
        if p.category != RUG
    )


def list_ends(case: Group) -> Iterator[tuple[Group, Member]]:
    """A kitchen with its fridge at each end of its lines, and the fridge there."""
    units = [m for m in case.members if is_unit(m)]
    fridge = next((m for m in units if m.category == FRIDGE), None)
    others = [m for m in units if m is not fridge]
    for unit in others if fridge else ():
        for side in (-1, 1):
            if unit.category != CORNER and find_neighbour(unit, others, side) is None:
                for width in dict.fromkeys((fridge.size.width, SLIM_FRIDGE)):
                    there = _stand_beside(fridge, unit, side, width)
                    members = tuple(there if m is fridge else m for m in case.members)
                    yield case._replace(members=members), there


def _stand_beside(fridge: Member, unit: Member, side: int, width: float) -> Member:
    """A fridge so wide at one side of a unit, its back in line; to its right if ``side`` is +1."""
    c, s = cos(unit.heading), sin(unit.heading)
    along = side * (unit.size.width + width) / 2
    ahead = (fridge.size.depth - unit.size.depth) / 2
    x, y = unit.x + c * along - s * ahead, unit.y + s * along + c * ahead
    size = fridge.size._replace(width=width)
    return fridge._replace(x=x, y=y, heading=unit.heading, size=size)
