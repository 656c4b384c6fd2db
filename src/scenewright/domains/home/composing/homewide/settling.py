"""What a finished home takes in besides: groups that its rooms have or lack together.

Rooms are furnished one by one. What a home has once (a table with a place for each, a soft seat) is
looked for again when all rooms stand, in whichever of them has a place for it beside all else. A
change stays where the exact ways of the whole home are as open as before.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import islice
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import DESKS, SOFT_SEATS
from scenewright.core.catalog import Group
from scenewright.core.same import once
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
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
from scenewright.domains.home.composing.spacing.leave_out import find_left_out
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.measures import ROUNDING
from scenewright.domains.home.needs.household import (
    BED_PLACES,
    STORING,
    Household,
    count_places,
    is_dwelling,
)
from scenewright.domains.home.programme import WELCOME, Wish
from scenewright.domains.home.rules.weigh_home import sum_rows
from scenewright.domains.home.walking.remove_blockers import Opened
from scenewright.domains.home.wished.wishes import list_barred_groups
from scenewright.engine.solve import Budget

Floats = NDArray[np.float64]

BACK: Floats = np.array([0.0, 0.0, np.pi, 0.0, 0.0])
NOWHERE: Floats = np.empty((0, 5))
SETTLED_APART = 0.3  # least distance between places of one form, metres
PLACES = 5  # of one form that are furnished
YIELDING = frozenset(("plant", "console"))
"""What waits in any case."""
KEPT = STORING | SOFT_SEATS | {"desk", "kids_desk"}
"""What holds things or is worked or sat at makes room for nothing, though it is merely welcome."""


class HomeState(NamedTuple):
    """The rooms of a home, what opens its ways, who lives in it, and whether its seconds are
    stated (``timed``): then nothing moves for a need; what its rooms were to hold, and the work
    they took (none: no room is solved again); ``whole`` is false where these are but some of its
    rooms."""

    tasks: Sequence[RoomTask]
    opened: Opened
    household: Household | None = None
    timed: bool = False
    wishes: Sequence[tuple[Wish, ...]] = ()
    budgets: Sequence[Budget] = ()
    whole: bool = True


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
    task: RoomTask,
    before: Placed,
    rest: Placed,
    found: Iterable[FurnishedGroup],
    spare: float = 0.0,
) -> Iterator[Placed]:
    """The groups of a room with one of those found beside the rest, where nothing is worse than
    ``before``: no way, no floor that others are used from, no window, no wide door, no view, no
    wish; those last whose seats have a wall or a door right behind them, or beside which
    something would be left out. How it stands may cost ``spare`` more: by a window, at the wall of
    a door."""
    wedged: list[Placed] = []
    for added in found:
        placed = (*rest, added)
        sound = is_harmless(task, before, rest, placed, spare)
        if not sound or not bars_no_more(with_narrow_ways(task), placed, find_barred(task, before)):
            continue
        close = measure_closeness((added,), (), task.ground) > 0.0
        if close or not is_roomy(task, before, placed):
            wedged.append(placed)
        else:
            yield placed
    yield from wedged


def is_harmless(task: RoomTask, before: Placed, rest: Placed, placed: Placed, spare: float) -> bool:
    """Whether the groups that are not of the rest do no more harm than those ``before`` that are
    not, but for ``spare`` in how they stand."""
    most, harm = _measure_most(task, before, rest), measure_harm(task, placed, rest)
    less = (harm[0] - spare, *harm[1:])
    return all(a <= b + ROUNDING for a, b in zip(less, most, strict=True))


def is_roomy(task: RoomTask, before: Placed, placed: Placed) -> bool:
    """Whether nothing would be left out of the groups for standing too near to others, or only
    what would be of those ``before`` and stands no nearer."""
    out = find_left_out(task, placed)
    if not out:
        return True
    near = (measure_closeness(each, task.fixed, task.ground) for each in (placed, before))
    return out <= find_left_out(task, before) and next(near) <= next(near) + ROUNDING


@once(32)
def _measure_most(task: RoomTask, before: Placed, rest: Placed) -> tuple[float, ...]:
    return measure_harm(task, before, rest)


@once(32)
def find_barred(task: RoomTask, before: Placed) -> frozenset[str]:
    """What no way reaches in a room as it stands, on a grid with narrower ways."""
    return frozenset(find_blocked(with_narrow_ways(task), before))


def measure_harm(task: RoomTask, placed: Placed, rest: Placed) -> tuple[float, ...]:
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


def wait(placed: Placed, timed: bool) -> tuple[Placed, Placed]:
    """The groups of a room without those merely welcome that hold nothing, in a ``timed`` run
    without :data:`YIELDING`, and these."""
    waiting = tuple(p for p in placed if _may_wait(p, timed))
    return tuple(p for p in placed if not _may_wait(p, timed)), waiting


def _may_wait(group: FurnishedGroup, timed: bool) -> bool:
    held = KEPT.intersection(piece.category for piece in group.pieces)
    spare = not timed and group.wish.rank >= WELCOME and not held
    return (spare or group.wish.group in YIELDING) and not group.wish.required


def put_back(
    task: RoomTask, before: Placed, placed: Placed, waiting: Placed
) -> tuple[Placed, tuple[Wish, ...]]:
    """The groups with those of the ``waiting`` that still stand well where they stood ``before``,
    and what found no place."""
    gone = []
    for group in waiting:
        standing = standing_of(pieces_of(task, placed), flat_kinds(task.catalog))
        free = len(stand_at(task, group.dressed.case, group.dressed.box[None], standing))
        whole = next(list_sound(task, before, placed, (group,)), None) if free else None
        placed = placed if whole is None else whole
        gone += [group.wish] if whole is None else []
    return placed, tuple(gone)


@cache
def measure_case(case: Group) -> tuple[float, ...]:
    """What a case holds: sleepers, nightstands, places to work, metres of storage less what is not
    missed.

    >>> from scenewright.domains.home.cases.library import cases
    >>> measure_case(cases("single").groups[0])[0]
    1.0
    """
    kinds = [member.category for member in case.members]
    return (
        float(sum(BED_PLACES.get(kind, 0) for kind in kinds)),
        float(kinds.count("nightstand")),
        float(sum(kind in DESKS for kind in kinds)),
        float(count_places(m for m in case.members if m.category in SOFT_SEATS)),
        sum(m.size.width for m in case.members if m.category in STORING),
    )
