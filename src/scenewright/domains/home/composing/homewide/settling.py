"""What a finished home takes in besides: groups that its rooms have or lack together.

Rooms are furnished one by one. What a home has once (a table with a place for each, a soft seat) is
looked for again when all rooms stand, in whichever of them has a place for it beside all else. A
change stays where the exact ways of the whole home are as open as before.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.same import once
from scenewright.domains.home.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.bed_first import with_narrow_ways
from scenewright.domains.home.composing.filling.bare_floor import (
    is_left_to_us,
    order_boxes,
    pieces_of,
)
from scenewright.domains.home.composing.homewide.used_floor import measure_taken
from scenewright.domains.home.composing.judging import Placed, count_unmet
from scenewright.domains.home.composing.placed_faults import (
    cost_of_group,
    list_standing,
    measure_before_doors,
)
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.composing.places.moving import (
    dress_group,
    find_places,
    list_amid,
    make_unplaced,
    stand_at,
)
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.household import STORING, is_dwelling
from scenewright.domains.home.measures import ROUNDING
from scenewright.domains.home.programme import WELCOME, Wish
from scenewright.domains.home.remove_blockers import Opened
from scenewright.domains.home.rules.weigh_home import sum_rows
from scenewright.domains.home.wished.wishes import list_barred_groups

Floats = NDArray[np.float64]

BACK: Floats = np.array([0.0, 0.0, np.pi, 0.0, 0.0])
NOWHERE: Floats = np.empty((0, 5))
SETTLED_APART = 0.3  # least distance between places of one form, metres
PLACES = 5  # of one form that are furnished
YIELDING = frozenset(("plant", "console"))
"""What makes room for a first table in any case."""
KEPT = STORING | {"desk", "kids_desk"}
"""What holds things or is worked at makes room for nothing, though it is merely welcome."""


def is_home(tasks: Sequence[RoomTask]) -> bool:
    """Whether rooms make a dwelling."""
    return is_dwelling(task.space for task in tasks)


def may_take_in(task: RoomTask, group: str) -> bool:
    """Whether a room may have a group that nobody asked for."""
    known = task.library.own.keys() - task.library.seated
    free = task.preset.settings.exact and not task.accessible and is_left_to_us(task)
    barred = list_barred_groups(task.asked, task.library) if task.asked else frozenset()
    return free and not known and group not in barred


def list_placed(
    task: RoomTask, rest: Placed, wish: Wish, case: Group, free: bool
) -> Iterator[FurnishedGroup]:
    """A group as a case beside the rest, along walls or also ``free``-standing, where the room
    costs least first."""
    if task.forbidden.intersection(m.category for m in case.members):
        return
    group = make_unplaced(task, rest, wish, case)
    standing = standing_of(pieces_of(task, rest), flat_kinds(task.catalog))
    rows = [boxes for _, boxes in find_places(task, (case,), standing, group)]
    if free:
        there = list_amid(task, case, standing)
        rows += [there, stand_at(task, case, there + BACK, standing)]
    boxes = order_boxes(task, (*rest, group), np.concatenate([NOWHERE, *rows]))
    dressed = (dress_group(task, group, case, box, standing) for box in _pick(boxes))
    yield from islice((each for each in dressed if each is not None), PLACES)


def _pick(boxes: Floats) -> Iterator[Floats]:
    """Of boxes (n, 5) those :data:`SETTLED_APART` from all before them, or turned otherwise."""
    left = np.ones(len(boxes), bool)
    while left.any():
        box = boxes[left.argmax()]
        off = np.abs(boxes[:, :3] - box[:3])
        left &= (np.hypot(off[:, 0], off[:, 1]) >= SETTLED_APART) | (off[:, 2] > 0.1)
        yield box


def list_sound(
    task: RoomTask, before: Placed, rest: Placed, found: Iterable[FurnishedGroup]
) -> Iterator[Placed]:
    """The groups of a room with one of those found beside the rest, where nothing is worse than
    ``before``: no way, no floor that others are used from, no window, no wide door, no view, no
    wish; those last whose seats have a wall or a door right behind them."""
    barred: frozenset[str] | None = None
    most: tuple[float, ...] | None = None
    wedged: list[Placed] = []
    for added in found:
        placed = (*rest, added)
        most = _measure_harm(task, before, rest) if most is None else most
        harm = _measure_harm(task, placed, rest)
        if any(a > b + ROUNDING for a, b in zip(harm, most, strict=True)):
            continue
        barred = _find_barred(task, before) if barred is None else barred
        if bars_no_more(with_narrow_ways(task), placed, barred):
            if measure_closeness((added,), (), task.ground) > 0.0:
                wedged.append(placed)
            else:
                yield placed
    yield from wedged


@once(32)
def _find_barred(task: RoomTask, before: Placed) -> frozenset[str]:
    """What no way reaches in a room as it stands, on a grid with narrower ways."""
    return frozenset(find_blocked(with_narrow_ways(task), before))


def _measure_harm(task: RoomTask, placed: Placed, rest: Placed) -> tuple[float, ...]:
    """What the groups that are not of the rest do to it, and to the room."""
    rule = task.preset.settings.composing
    new = [group for group in placed if all(group is not other for other in rest)]
    pieces = [piece for group in new for piece in group.pieces]
    others = (*task.fixed, *(piece for group in rest for piece in group.pieces))
    stands = sum(
        cost_of_group(group, task.ground, rule)
        - cost_of_case(list_standing(group), task.ground.area, rule)
        for group in new
    )
    return (
        stands,
        measure_taken(pieces, others),
        sum(measure_before_doors(group, task.ground) for group in new),
        sum_rows(("crowded",), placed),
        cost_of_view(placed, rule.costs, task.ground.edges),
        float(count_unmet(task, placed)),
    )


def try_in_home(
    room: int, answer: RoomAnswer, found: Sequence[RoomAnswer], opened: Opened
) -> list[RoomAnswer] | None:
    """The answers with another for one room; None where the ways of the home take something of
    it, or of another room, away."""
    trial = [answer if k == room else other for k, other in enumerate(found)]
    return trial if _count_lost(opened(trial)) == _count_lost(trial) else None


def _count_lost(answers: Sequence[RoomAnswer]) -> int:
    return sum(len(answer.gone) + len(answer.missing) for answer in answers)


def list_yielding(
    placed: Placed, use: str, timed: bool
) -> Iterator[tuple[Placed, tuple[Missing, ...]]]:
    """The groups of a room without one of those merely welcome that hold nothing, in a ``timed``
    run without one of :data:`YIELDING`, and what is missing for the sake of a ``use``."""
    for other in placed:
        held = KEPT.intersection(piece.category for piece in other.pieces)
        spare = not timed and other.wish.rank >= WELCOME and not held
        if (spare or other.wish.group in YIELDING) and not other.wish.required:
            lost = Missing(other.wish, f"it makes room for the {use} of the home")
            yield tuple(p for p in placed if p is not other), (lost,)
