"""Whether a group slid along its wall loses free floor before it, or takes it from others."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.places.wall_stretch import measure_front
from scenewright.domains.home.furnishing.obstacles import flat_kinds
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.rules.classes import MOVED
from scenewright.geometry.boxes import Frame, common_area, make_frame

LOW = 0.12  # what begins higher leaves the floor free, metres
FREE = 0.6  # floor before what is used, metres
SEATS = {"desk": 0.7, "kids_desk": 0.7, "vanity": 0.6}
"""By group how wide the floor is that a chair before it needs, metres."""
UNMISSED = 0.02  # metres, and square metres, that nobody misses


def is_crowded(
    task: RoomTask, now: FurnishedGroup, then: FurnishedGroup, rest: Sequence[FurnishedGroup]
) -> bool:
    """Whether a group has less free floor before it ``then`` than ``now``, or takes more of what
    the ``rest`` have before them."""
    before, after = (measure_front(task.ground, g.dressed.box) for g in (now, then))
    if after < min(before, FREE) - UNMISSED:
        return True
    low = _frame_low(task, (*task.fixed, *(p for g in rest for p in g.pieces)))
    fronts = [_front_of(g) for g in rest]
    return (
        _measure_taken(task, then, low, fronts) > _measure_taken(task, now, low, fronts) + UNMISSED
    )


def _measure_taken(
    task: RoomTask, group: FurnishedGroup, low: Sequence[Frame], fronts: Sequence[Frame]
) -> float:
    """Square metres of the floor before a group that ``low`` pieces take, and of the ``fronts`` of
    others that the group takes."""
    front, own = _front_of(group), _frame_low(task, group.pieces)
    taken = sum(float(common_area(front, frame)) for frame in low)
    return taken + sum(float(common_area(a, b)) for a in own for b in fronts)


def _frame_low(task: RoomTask, pieces: Sequence[Piece]) -> list[Frame]:
    """What stands on the floor, but for rugs and what is pushed aside, as frames."""
    flat = flat_kinds(task.catalog) | MOVED
    return [
        make_frame(p.pose.x, p.pose.y, p.pose.heading, p.size.width, p.size.depth)
        for p in pieces
        if p.pose.z < LOW and p.category not in flat
    ]


def _front_of(group: FurnishedGroup) -> Frame:
    """The floor before a group, as deep as it asks for and as wide as its main piece, or as the
    chair before that."""
    x, y, heading, width, depth = group.dressed.box.tolist()
    clear, main = max(GROUPS[group.wish.group].clear[0], UNMISSED), group.dressed.case.members[0]
    if main.heading == 0.0:
        x, y, width = x + main.x * sin(heading), y - main.x * cos(heading), main.size.width
    wide, ahead = min(width, SEATS.get(group.wish.group, width)), (depth + clear) / 2
    return make_frame(x + ahead * cos(heading), y + ahead * sin(heading), heading, wide, clear)
