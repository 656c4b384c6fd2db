"""Nightstands at single and bunk beds of a finished home that have none.

Such a bed is furnished in forms with a nightstand and without, and where a room is tight ends
without. A nightstand is reached from its bed and needs no way of its own, so once all rooms stand
one is put beside the pillow of each bed on either side that is free. It stays if the ways of the
home are as open as they were.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece, Size
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.composing.homewide.settling import try_in_home
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.placed_faults import measure_before_doors
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.furnishing.furnish import world
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.furnishing.whole import Gone
from scenewright.domains.home.rules.weigh_home import sum_rows
from scenewright.domains.home.walking.remove_blockers import Opened
from scenewright.geometry.fit import is_backed

Floats = NDArray[np.float64]

SINGLE, BUNK, STAND = "single_bed", "bunk_bed", "nightstand"
SIZES = ((0.42, 0.4), (0.35, 0.35), (0.3, 0.3))
"""Widths and depths of a nightstand, the preferred first, metres."""
BED_TO_STAND = 0.02  # between a bed and its nightstand, metres
NOWHERE = 0.75  # a nightstand farther from the wall behind it stands in nowhere, metres
LAMP = Size(0.24, 0.24, 0.42)
AT_PILLOW = 0.8  # a nightstand whose middle is nearer to a bed's pillow serves it, metres


def add_nightstands(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with a nightstand at each single bed that has none, where that
    bars no way of the home, these ``opened``."""
    found = answers
    for room, task in enumerate(tasks):
        if not _may_have(task):
            continue
        for at, bed in enumerate(found[room].placed):
            if _lacks_stand(bed, found[room].placed) and not task.cancelled():
                found = _add(room, task, at, found, opened)
    return found


def _may_have(task: RoomTask) -> bool:
    """Whether the beds of a room may have nightstands; what is forbidden leaves groups of its
    own."""
    return task.preset.settings.exact and not task.accessible and not task.library.own


def _lacks_stand(group: FurnishedGroup, placed: Placed) -> bool:
    """Whether a group is a mere bed, of any size, at whose pillow no nightstand stands."""
    if [p.category for p in group.pieces] not in ([SINGLE], [BUNK]) or group.wish.most:
        return False
    x, y = _pillow(group.pieces[0])
    stands = (p.pose for g in placed for p in g.pieces if p.category == STAND)
    return all((p.x - x) ** 2 + (p.y - y) ** 2 > AT_PILLOW**2 for p in stands)


def _pillow(bed: Piece) -> tuple[float, float]:
    back = bed.size.depth / 2 - 0.2
    return bed.pose.x - back * cos(bed.pose.heading), bed.pose.y - back * sin(bed.pose.heading)


def _add(
    room: int, task: RoomTask, at: int, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with a nightstand at one bed at the first place that bars nothing."""
    before = found[room]
    for bed in _list_with_stand(task, before.placed, at):
        placed = (*before.placed[:at], bed, *before.placed[at + 1 :])
        if _stands_in_front(task, placed) > _stands_in_front(task, before.placed):
            continue
        answer = before._replace(placed=placed, gone=_without_stand(before.gone))
        trial = try_in_home(room, answer, found, opened)
        if trial is not None:
            return trial
    return found


def _without_stand(gone: tuple[Gone, ...]) -> tuple[Gone, ...]:
    """What gave way, without the nightstand for which another stands now."""
    first = next((g for g in gone if g.category == STAND), None)
    return tuple(g for g in gone if g is not first)


def _stands_in_front(task: RoomTask, placed: Placed) -> float:
    """What stands before doors of wardrobes, and metres of wide doors with something before
    them."""
    doors = sum(measure_before_doors(group, task.ground) for group in placed)
    return sum_rows(("doors",), placed, None, task.fixed) + doors


def _list_with_stand(task: RoomTask, placed: Placed, at: int) -> Iterator[FurnishedGroup]:
    """A bed with a nightstand wherever beside its pillow one stands free."""
    group, rest = placed[at], (p for i, p in enumerate(placed) if i != at)
    pieces = (*task.fixed, *task.beside, *(p for other in rest for p in other.pieces))
    standing = standing_of(pieces, flat_kinds(task.catalog))
    bed = next(m for m in group.dressed.case.members if m.category in (SINGLE, BUNK))
    for stand in _list_stands(bed):
        there = world((stand,), group.dressed.box, task.catalog)[0][0]
        if not is_backed(there, task.ground.walls, NOWHERE):
            continue
        case = _with_stand(group.dressed.case, bed, stand)
        dressed = dress_group(task, group, case, group.dressed.box, standing)
        if dressed is not None and all(dressed.dressed.stands):
            yield dressed


def _with_stand(case: Group, bed: Member, stand: Member) -> Group:
    """The case of a bed with a nightstand and a lamp on it."""
    lamp = Member("table_lamp", stand.x, stand.y, stand.size.height, 0, LAMP, on=1)
    return case._replace(name=f"{case.name}, nightstand", members=(bed, stand, lamp))


def _list_stands(bed: Member) -> Iterator[Member]:
    """Nightstands on either side of the pillow of a bed with their back where its head is, the
    larger first."""
    half, head = bed.size.width / 2, -bed.size.depth / 2
    for width, depth in SIZES:
        size = Size(width, depth, 0.5)
        aside = half + BED_TO_STAND + width / 2
        for side in (-1.0, 1.0):
            yield _member_at(bed, side * aside, head + BED_TO_STAND + depth / 2, size)


def _member_at(bed: Member, x: float, y: float, size: Size) -> Member:
    """A nightstand ``x`` to the right and ``y`` ahead of the middle of a bed."""
    c, s = cos(bed.heading), sin(bed.heading)
    at = (bed.x + c * x - s * y, bed.y + s * x + c * y)
    return Member(STAND, *at, 0, bed.heading, size)
