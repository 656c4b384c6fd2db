"""Walls beside what is bare of a living room, also before its doors: a sideboard, a shelf, where
no second zone has a place (:mod:`.bare_floor`); in a bedroom a chest of drawers, an armchair with
its lamp, a bookcase."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.filling.bare_floor import (
    NOWHERE,
    SECOND_ZONE_FROM,
    is_left_to_us,
    order_boxes,
    pieces_of,
)
from scenewright.domains.home.composing.filling.talking import is_left_alone
from scenewright.domains.home.composing.filling.voids import Void, find_circle, open_floor
from scenewright.domains.home.composing.judging import Placed, sum_faults
from scenewright.domains.home.composing.places.moving import (
    dress_group,
    find_places,
    make_unplaced,
    with_margin,
)
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of
from scenewright.domains.home.programme import WELCOME, Wish

Floats = NDArray[np.float64]


class BareWalls(NamedTuple):
    """What is added at the walls of rooms for a function from ``least`` square metres on, while an
    empty circle is ``wide`` metres in radius, doors or not, no more than ``beside`` metres beyond
    its edge: groups, in this order, and how many of each a room has at most (``added``)."""

    least: float
    wide: float
    beside: float
    added: tuple[tuple[str, int], ...]


BARE_WALLS = {
    "living": BareWalls(SECOND_ZONE_FROM, 1.2, 0.6, (("sideboard", 1), ("shelf", 2))),
    "bedroom": BareWalls(9.0, 0.65, 1.2, (("chest", 1), ("reading", 1), ("shelf", 1))),
    "child_bedroom": BareWalls(9.0, 0.65, 1.2, (("shelf", 1), ("chest", 1))),
}
"""By function of a room."""
FORMS, PLACES, EACH = 3, 4, 5
"""Forms tried of each group, places tried of a form, and of places in a row every how many."""


def furnish_bare_walls(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with low and high pieces at the walls round the widest empty floor."""
    row = next((BARE_WALLS[f] for f in task.space.functions if f in BARE_WALLS), None)
    if row is None or task.ground.area < row.least or not is_left_to_us(task):
        return answer
    for group, most in row.added:
        there = sum(p.wish.group == group for p in answer.placed)
        if there >= most or group in task.elsewhere or task.cancelled():
            continue
        void = find_circle(open_floor(task, pieces_of(task, answer.placed)))
        if void.radius < row.wide:
            break
        wide = void._replace(radius=void.radius + row.beside)
        more = next(_list_beside(task, answer.placed, group, wide, barred), None)
        if more is not None:
            answer = answer._replace(placed=(*answer.placed, more))
    return answer


def _list_beside(
    task: RoomTask, placed: Placed, name: str, void: Void, barred: frozenset[str]
) -> Iterator[FurnishedGroup]:
    """A group in some of its forms at the walls round an empty circle, where it bars no way and the
    room has no further fault: the widest first, each where the room costs least."""
    forms = sorted(cases(name, task.library).groups, key=lambda form: -form.width)
    standing = standing_of(pieces_of(task, placed), flat_kinds(task.catalog))
    faults, margin = sum_faults(task, placed), with_margin(task)
    for case in forms[:: max(len(forms) // FORMS, 1)]:
        group = make_unplaced(task, placed, Wish(name, WELCOME), case)
        for box in _list_boxes(task, (*placed, group), standing, void):
            added = dress_group(task, group, case, box, standing)
            whole = (*placed, *((added,) if added else ()))
            if added is None or is_left_alone(added, placed) or sum_faults(task, whole) > faults:
                continue
            if bars_no_more(margin, whole, barred):
                yield added


def _list_boxes(task: RoomTask, whole: Placed, standing: StandingObstacles, void: Void) -> Floats:
    """Some boxes (n, 5) at the walls round an empty circle for the last group."""
    group = whole[-1]
    rows = [boxes for _, boxes in find_places(task, (group.dressed.case,), standing, group)]
    boxes = np.concatenate([NOWHERE, *rows])
    near = np.hypot(boxes[:, 0] - void.x, boxes[:, 1] - void.y) < void.radius
    return order_boxes(task, whole, boxes[near])[: PLACES * EACH : EACH]
