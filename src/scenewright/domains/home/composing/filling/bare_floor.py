"""A second zone where much of a large room is bare: somewhere to sit and talk, to read, a shelf.

What a living room needs stands in one half of it where the room is long; the other half is then
bare, however much of the whole is covered. So the largest empty circle of the composed room is
furnished, while it is large, with free-standing furniture that bars no way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.filling.talking import is_left_alone
from scenewright.domains.home.composing.filling.voids import (
    Void,
    find_circle,
    find_void,
    free_beside,
    free_floor,
    may_stand_free,
)
from scenewright.domains.home.composing.judging import Placed, judge_of, sum_faults
from scenewright.domains.home.composing.places.moving import (
    dress_group,
    find_places,
    list_amid,
    make_unplaced,
    stand_at,
    with_margin,
)
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of
from scenewright.domains.home.grounds.wall_places import along_walls
from scenewright.domains.home.groups.living import talking
from scenewright.domains.home.programme import WELCOME, Wish
from scenewright.geometry.fit import is_backed

Floats = NDArray[np.float64]

SECOND_ZONE_FROM = 12.0  # area from which a room has a second zone, m²
BARE = 1.0  # radius from which an empty circle is bare, metres
LESS = 0.1  # a group shrinks its radius by at least this, metres
TWO = 24.0  # area from which two armchairs replace a lone one, m²
ZONES = 3  # groups that are added to a room at most
TWICE = 2  # most groups of one kind in a room
TRIED = 16  # places of one form that are furnished
OFF_WALL, NEAR_AT_WALL = (
    0.4,
    0.05,
)  # how far before its wall something stands, and how near at it, metres
AMID = 0.3  # radius, metres, by which a free-standing group has to do better than one at a wall
PAIRS_APART = 4.5  # nearer middles of two pairs of armchairs are rows of seats, metres
NOWHERE: Floats = np.empty((0, 5))
FREE = frozenset(form.name for form in talking())
"""Forms that also stand a step before their wall, as before a window, or in the middle of the
room."""


def _seats() -> Iterator[Group]:
    yield from (*talking(), *cases("reading").groups)


def _largest_first(group: str) -> Callable[[], Iterator[Group]]:
    return lambda: iter(sorted(cases(group).groups, key=lambda form: -form.width * form.depth))


Zones = tuple[tuple[str, Callable[[], Iterator[Group]]], ...]

PLANT = ("plant", _largest_first("plant"))
ZONED: dict[str, Zones] = {
    "living": (("reading", _seats), ("shelf", _largest_first("shelf")), PLANT),
    "bedroom": (("reading", _seats), ("chest", _largest_first("chest")), PLANT),
    "study": (("reading", _seats), ("shelf", _largest_first("shelf")), PLANT),
    "dining": (("reading", _seats), PLANT),
    "kitchen": (("reading", _seats), ("sideboard", _largest_first("sideboard")), PLANT),
}
"""What fills a bare part of a room by its function: groups with their forms, in this order."""


def furnish_bare_floor(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with further groups in the bare part of a large room that is left to us."""
    if task.ground.area < SECOND_ZONE_FROM or not is_left_to_us(task):
        return answer
    answer, added = _seat_two(task, answer, barred), 0
    for group, forms in next((ZONED[f] for f in task.space.functions if f in ZONED), ()):
        there = sum(p.wish.group == group for p in answer.placed)
        if there >= TWICE or group in task.elsewhere or task.cancelled():
            continue
        void = find_void(task, pieces_of(task, answer.placed))
        if void.radius < BARE or added == ZONES:
            break
        more = _add(task, answer.placed, group, list_other(answer.placed, forms()), void, barred)
        if more is not None:
            answer, added = answer._replace(placed=(*answer.placed, more)), added + 1
    return answer


def list_other(placed: Placed, forms: Iterable[Group]) -> Iterator[Group]:
    """Of some forms those in which no pair of armchairs stands yet."""
    there = {p.dressed.case.name for p in placed} & FREE
    return (form for form in forms if form.name not in there)


def _seat_two(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with two armchairs where one stands alone in floor that is bare without it."""
    lone = next((p for p in answer.placed if p.wish.group == "reading" and _is_lone(p)), None)
    small = task.ground.area < TWO or "living" not in task.space.functions
    if lone is None or small or lone.wish.required:
        return answer
    rest = tuple(p for p in answer.placed if p is not lone)
    void = find_void(task, pieces_of(task, rest))
    if void.radius < BARE:
        return answer
    two = _add(task, rest, "reading", talking(), void, barred)
    return answer._replace(placed=(*rest, two._replace(wish=lone.wish))) if two else answer


def _is_lone(group: FurnishedGroup) -> bool:
    return sum(piece.category == "armchair" for piece in group.pieces) == 1


def is_left_to_us(task: RoomTask) -> bool:
    """Whether nobody listed what a room is to hold, nor learned what is welcome there."""
    listed = task.asked is not None and task.asked.ask is not None
    return not listed and task.welcome is None


def pieces_of(task: RoomTask, placed: Placed) -> tuple[Piece, ...]:
    """All that stands in a room or reaches into it."""
    return (*task.fixed, *task.beside, *(piece for group in placed for piece in group.pieces))


def _add(
    task: RoomTask,
    placed: Placed,
    name: str,
    forms: Iterable[Group],
    void: Void,
    barred: frozenset[str],
) -> FurnishedGroup | None:
    """One more group in an empty circle, in the first of the forms that stands free in it and bars
    no way; of its best places the one that leaves the smallest circle."""
    for case in forms:
        if task.forbidden.intersection(m.category for m in case.members):
            continue
        group = make_unplaced(task, placed, Wish(name, WELCOME), case)
        found = list(_list_smaller(task, placed, group, void))
        for _, _, added in sorted(found, key=lambda each: each[:2]):
            if bars_no_more(with_margin(task), (*placed, added), barred):
                return added
    return None


def _list_smaller(
    task: RoomTask, placed: Placed, group: FurnishedGroup, void: Void
) -> Iterator[tuple[float, int, FurnishedGroup]]:
    """A group at the places that make an empty circle smaller, each after the radius that is left,
    more if free-standing, and its number in order of cost."""
    pieces = pieces_of(task, placed)
    floor = free_floor(task, pieces)
    for number, added in enumerate(_list_added(task, placed, group, void)):
        box = added.dressed.box
        if may_stand_free(task, pieces, box):
            radius = find_circle(free_beside(task, floor, pieces, added.pieces)).radius
            if radius <= void.radius - LESS:
                stands_free = not is_backed(box, task.ground.walls, OFF_WALL + NEAR_AT_WALL)
                yield radius + AMID * stands_free, number, added


def _list_added(
    task: RoomTask, placed: Placed, group: FurnishedGroup, void: Void
) -> Iterator[FurnishedGroup]:
    """A group in its form at the places in an empty circle at which the room costs least and has no
    further fault."""
    case, standing = group.dressed.case, standing_of(pieces_of(task, placed), _flat(task))
    faults, found = sum_faults(task, placed), 0
    for box in order_boxes(
        task, (*placed, group), _list_boxes(task, placed, group, standing, void)
    ):
        added = dress_group(task, group, case, box, standing)
        if added is None or (case.name not in FREE and is_left_alone(added, placed)):
            continue
        if sum_faults(task, (*placed, added)) <= faults:
            yield added
            found += 1
            if found == TRIED:
                return


def _flat(task: RoomTask) -> frozenset[str]:
    return flat_kinds(task.catalog)


def _list_boxes(
    task: RoomTask, placed: Placed, group: FurnishedGroup, standing: StandingObstacles, void: Void
) -> Floats:
    """The boxes (n, 5) with their middle in an empty circle on which a group stands free."""
    case = group.dressed.case
    rows = [boxes for _, boxes in find_places(task, (case,), standing, group)]
    if case.name in FREE:
        rows += [_step_before(task, case, standing), list_amid(task, case, standing)]
    boxes = np.concatenate([NOWHERE, *rows])
    near = np.hypot(boxes[:, 0] - void.x, boxes[:, 1] - void.y) < void.radius
    return boxes[near & ~_are_near_pairs(boxes, placed)] if case.name in FREE else boxes[near]


def _are_near_pairs(boxes: Floats, placed: Placed) -> NDArray[np.bool_]:
    """Which of boxes (n, 5) for two armchairs are near two others that would look at their
    backs."""
    pairs = (p.dressed.box[:2] for p in placed if p.dressed.case.name in FREE)
    near = [np.hypot(*(boxes[:, :2] - pair).T) < PAIRS_APART for pair in pairs]
    return np.any(np.reshape(near, (len(near), len(boxes))), axis=0)


def _step_before(task: RoomTask, case: Group, standing: StandingObstacles) -> Floats:
    """The boxes (n, 5) a step before each wall on which a case stands free."""
    boxes = along_walls(case, task.ground, task.preset.settings.composing.step)
    boxes[:, :2] += OFF_WALL * np.column_stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])])
    return stand_at(task, case, boxes, standing)


def order_boxes(task: RoomTask, whole: Placed, boxes: Floats) -> Floats:
    """The boxes (n, 5) for the last group, where the room costs least first."""
    if not len(boxes):
        return boxes
    layouts = np.repeat(np.array([[p.dressed.box for p in whole]]), len(boxes), axis=0)
    layouts[:, -1] = boxes
    return boxes[np.argsort(judge_of(task, whole).energies_of(layouts), kind="stable")]
