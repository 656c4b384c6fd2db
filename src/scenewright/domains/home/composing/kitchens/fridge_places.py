"""Where a fridge would stand at the ends of the lines of its kitchen."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import cos, sin

from scenewright.core.catalog import Group, Member
from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.composing.bed_places import place_member
from scenewright.domains.home.composing.case_faults import find_neighbour
from scenewright.domains.home.composing.judging import Placed, find_run
from scenewright.domains.home.composing.kitchens.slits import is_unit
from scenewright.domains.home.composing.kitchens.trades import Move, list_at_run
from scenewright.domains.home.groups.fitted_kitchen import SLIM_FRIDGE

CORNER, FRIDGE = "corner_cabinet", "fridge"


def list_fridge_moves(task: RoomTask, placed: Placed) -> Iterator[Move]:
    """A fridge at one end of a line of its run after the other: one of the run in its width and
    slim, one that is a group of its own."""
    for run in (p for p in find_run(placed) if len(p.pieces) == sum(p.dressed.stands)):
        for case, fridge in list_ends(run.dressed.case):
            floor = place_member(fridge, run.dressed.box[None])[0]
            yield Move(run, case, run.dressed.box, floor)
    for group in placed:
        if group.wish.group == FRIDGE:
            yield from list_at_run(task, placed, group, (group.dressed.case,))


def list_ends(case: Group) -> Iterator[tuple[Group, Member]]:
    """A kitchen with its fridge at each end of its lines, and the fridge there."""
    units = [m for m in case.members if is_unit(m)]
    for fridge in [m for m in units if m.category == FRIDGE][:1]:
        others = [m for m in units if m is not fridge]
        for unit, side in product(others, (-1, 1)):
            if unit.category != CORNER and find_neighbour(unit, others, side) is None:
                for width in dict.fromkeys((fridge.size.width, SLIM_FRIDGE)):
                    there = _stand_beside(fridge, unit, side, width)
                    members = tuple(there if m is fridge else m for m in case.members)
                    yield case._replace(members=members), there


def _stand_beside(fridge: Member, unit: Member, side: int, width: float) -> Member:
    """A fridge of ``width`` at one side of a unit, its back in line; to its right if ``side`` is
    +1."""
    c, s = cos(unit.heading), sin(unit.heading)
    along = side * (unit.size.width + width) / 2
    ahead = (fridge.size.depth - unit.size.depth) / 2
    x, y = unit.x + c * along - s * ahead, unit.y + s * along + c * ahead
    size = fridge.size._replace(width=width)
    return fridge._replace(x=x, y=y, heading=unit.heading, size=size)
