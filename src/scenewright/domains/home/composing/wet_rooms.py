"""Bathrooms and washrooms once they stand: machines and cabinets as wide as their stretch of wall.

In a tight room the search ends with the smallest forms. Here a machine of 0.48 m becomes one of
0.6 m, and a cabinet as wide as what is left beside it, where nothing else has to move and no way is
barred; of two places that in which fewer slots too narrow for anything are left beside it.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.flush import list_flush, measure_slots
from scenewright.domains.home.composing.judging import JudgedRoom, judge_of
from scenewright.domains.home.composing.moving import dress_group, stand_at, with_margin
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of
from scenewright.domains.home.groups.bath import fitted_cabinets, washer
from scenewright.domains.home.wall_places import along_walls, read_walls

Floats = NDArray[np.float64]

ROOMS = frozenset(("bathroom", "washroom"))
FORMS = {"washer": washer, "linen": fitted_cabinets}
NEAR, STEP = 1.0, 0.1  # how far from where it stood, and between places, metres
TRIED = 4  # places of a form that are furnished
WORTH = 1.0  # what a room may cost more for it


def fill_wet_room(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer for a room with its machine and its cabinet in larger forms near to where they
    stood, where that bars no way and leaves no more slots."""
    if not ROOMS.intersection(task.space.functions):
        return answer
    for group in answer.placed:
        if group.wish.group in FORMS and group.wish.most is None and not task.cancelled():
            answer = _enlarge(task, answer, group, barred)
    return answer


@cache
def _list_forms(function: str) -> tuple[Group, ...]:
    """The forms of one piece of a group, the widest first."""
    single = (form for form in FORMS[function]() if len(form.members) == 1)
    return tuple(sorted(single, key=lambda form: -form.width))


def _enlarge(
    task: RoomTask, answer: RoomAnswer, group: FurnishedGroup, barred: frozenset[str]
) -> RoomAnswer:
    placed, at = answer.placed, answer.placed.index(group)
    rest = (p for other in placed if other is not group for p in other.pieces)
    standing = standing_of((*task.fixed, *task.beside, *rest), flat_kinds(task.catalog))
    judge, margin = judge_of(task, placed), with_margin(task)
    most = judge.cost_of(placed).cost + WORTH
    for form in _list_forms(group.wish.group):
        if form.width <= group.dressed.case.width:
            break
        for box in _list_places(task, form, group.dressed.box, standing):
            dressed = dress_group(task, group, form, box, standing)
            if dressed is None:
                continue
            judged: JudgedRoom = judge.cost_of((*placed[:at], dressed, *placed[at + 1 :]))
            if judged.cost <= most and barred.issuperset(find_blocked(margin, judged.placed)):
                return answer._replace(placed=judged.placed)
    return answer


def _list_places(
    task: RoomTask, form: Group, box: Floats, standing: StandingObstacles
) -> Iterator[Floats]:
    """Where a form stands free near to a box ``(5,)`` and looks the same way, at most
    :data:`TRIED`, those with fewer slots beside them first, then the nearer."""
    walls = read_walls(task.ground)
    found = np.concatenate(
        [
            along_walls(form, task.ground, STEP),
            list_flush(form, walls, standing, frozenset(standing.names)),
        ]
    )
    away = np.hypot(found[:, 0] - box[0], found[:, 1] - box[1])
    found = found[(away < NEAR) & (np.cos(found[:, 2] - box[2]) > 0.9)]
    found = stand_at(task, form, found, standing)
    away = np.hypot(found[:, 0] - box[0], found[:, 1] - box[1])
    slots = [measure_slots(place, walls, standing) for place in found]
    order = sorted(range(len(found)), key=lambda k: (slots[k], away[k]))
    yield from (found[k] for k in order[:TRIED])
