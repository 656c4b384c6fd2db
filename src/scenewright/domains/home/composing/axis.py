"""The screen or the seats moved sideways until the sofa looks straight at the screen."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, remainder, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import SOFAS
from scenewright.domains.home.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of
from scenewright.domains.home.composing.moving import dress_group
from scenewright.domains.home.composing.trials import take_first
from scenewright.domains.home.furnishing.facing import FACING, SHARES
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.furnishing.whole import list_grounded
from scenewright.domains.home.wall_places import stand_free

Floats = NDArray[np.float64]

ENOUGH, MENDED_WITHIN = 0.1, 1.6
"""What is less off the axis stays, and what is farther off is not mended so, metres."""


def slide_to_axis(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with the screen, or else the seats, aside along their wall as far as the room then
    costs less and no way is barred; as they were where the two do not face each other."""
    pair = {p.wish.group: p for p in best.placed if p.wish.group in ("media", "seating")}
    if len(pair) < 2 or any(name in task.library.own for name in pair):
        return best
    off = _measure_off(pair["seating"], pair["media"])
    if not ENOUGH < np.hypot(*off) <= MENDED_WITHIN:
        return best
    for group, way in ((pair["media"], -off), (pair["seating"], off)):
        moved = take_first(task, best, _list_moved(task, best.placed, group, way), barred)
        if moved is not best:
            return moved
    return best


def _measure_off(seating: FurnishedGroup, media: FurnishedGroup) -> Floats:
    """The way (2,) from the sofa's axis to the screen, square to the axis, metres; 0 where either
    is lacking or they do not face each other."""
    sofas = [p for p in seating.pieces if p.category in SOFAS]
    screen = next((p.pose for p in media.pieces if p.category == "tv"), None)
    if not sofas or screen is None:
        return np.zeros(2)
    sofa = max(sofas, key=lambda p: p.size.width * p.size.depth).pose
    c, s = cos(sofa.heading), sin(sofa.heading)
    dx, dy = screen.x - sofa.x, screen.y - sofa.y
    turned = abs(remainder(screen.heading - sofa.heading - pi, 2 * pi))
    if dx * c + dy * s <= 0.0 or turned > FACING:
        return np.zeros(2)
    return (dx * s - dy * c) * np.array([s, -c])


def _list_moved(
    task: RoomTask, placed: Placed, group: FurnishedGroup, way: Floats
) -> Iterator[JudgedRoom]:
    """The room with a group moved by a ``way`` (2,), or as much of it as is free, the farthest
    first."""
    case, at = group.dressed.case, placed.index(group)
    rest = (p for other in placed if other is not group for p in other.pieces)
    standing = standing_of((*task.fixed, *task.beside, *rest), flat_kinds(task.catalog))
    boxes = np.repeat(group.dressed.box[None], len(SHARES), axis=0)
    boxes[:, :2] += np.array(SHARES)[:, None] * way
    height = task.space.height
    free = stand_free(boxes, case, list_grounded(case), task.ground, standing, task.catalog, height)
    for box in boxes[free]:
        moved = dress_group(task, group, case, box, standing)
        if moved is not None:
            yield judge_of(task, placed).cost_of((*placed[:at], moved, *placed[at + 1 :]))
