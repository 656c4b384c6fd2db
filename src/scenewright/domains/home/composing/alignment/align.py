"""Groups slid along the wall at their back: onto an axis, into a corner, against a neighbour, off a
door.

Nothing is lost by it: all pieces stay, no fault of composition is added, no piece has less floor
before it. Ways are walked once, on the outcome (:mod:`.homes`). Bathrooms have rules of their own
(:mod:`..filling.wet_rooms`), kitchens are made to measure.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import hypot, remainder, tau
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.alignment.axes import Axis, find_aside, list_axes
from scenewright.domains.home.composing.alignment.clearance import is_crowded
from scenewright.domains.home.composing.alignment.spans import Span, find_span
from scenewright.domains.home.composing.filling.beside_others import list_others
from scenewright.domains.home.composing.judging import Placed, count_unmet, sum_faults
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.groups.classes import WET_ROOMS
from scenewright.domains.home.groups.living import media
from scenewright.domains.home.measures import HAIR

Floats = NDArray[np.float64]
Allowed = Callable[[Placed], bool]

ORDER = (
    *("media", "seating", "desk", "kids_desk", "chest", "vanity", "sideboard", "wardrobe"),
    *("single", "bunk", "storage", "shelf", "play", "shoes", "console"),
)
"""Groups that slide along their wall, in this order."""
BY_BOX = frozenset(("single", "bunk"))
"""Groups that are as deep at their wall as they are."""
LOOSE = frozenset(("seating",))
"""Groups that need not touch their neighbours."""
ROUNDS = 2
BETTER = 0.06  # what is gained at least, metres off an axis
SKEW, SKEWED = 0.002, 0.2  # radians from which a piece is skew, and what that costs
SHARES = (0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9)  # of the way to an axis that may be left
LESS, CUT, STAND_SHORT = 0.3, 0.3, 0.15
"""By how many metres a stand of a screen may be narrower for its axis, what a metre of that costs,
and how far off it the whole stand has to be for it."""
ENOUGH = 0.02  # what is less off its axis is on it, metres
OFF_COUNTED = 1.5  # metres off an axis that count


class Slide(NamedTuple):
    """A form of a group on a box (5,), what it costs there, metres off an axis, and which share of
    the way to its axis it leaves: less only where its axis is to be had at no lower cost."""

    case: Group
    box: Floats
    cost: float
    left: float


def align_groups(task: RoomTask, placed: Placed, allowed: Allowed | None = None) -> Placed:
    """The groups of a room, each where along its wall it costs least, where that is ``allowed``."""
    if WET_ROOMS.intersection(task.space.functions):
        return placed
    own = task.library.own
    names = [p.name for kind in ORDER for p in placed if p.wish.group == kind and kind not in own]
    for _ in range(ROUNDS):
        before = placed
        for name in names:
            at = next(i for i, p in enumerate(placed) if p.name == name)
            if len(placed[at].pieces) == sum(placed[at].dressed.stands) and not task.cancelled():
                placed = _align(task, placed, at, allowed)
        if placed is before:
            break
    return placed


def _align(task: RoomTask, placed: Placed, at: int, allowed: Allowed | None) -> Placed:
    """The groups with one of them slid, or as they were."""
    group = placed[at]
    standing = list_others(task, placed, group)
    depth, height = _measure(group)
    span = find_span(task.ground, group.dressed.box, depth, height, standing)
    if span is not None and group.wish.group in LOOSE:
        span = span.without_cases()
    if span is None:
        return placed
    axes = list_axes(group, placed, task.ground)
    skew = abs(remainder(group.dressed.box[2] - span.heading, tau)) > SKEW
    now = _cost_at(span, axes, group.dressed.case, span.at) + SKEWED * skew
    if now < BETTER:
        return placed
    x, y = group.dressed.box[:2].tolist()
    slides = list(_list_slides(span, axes, group))
    slides.sort(key=lambda s: (round(s.cost, 6), s.left, hypot(s.box[0] - x, s.box[1] - y)))
    for slide in slides:
        if slide.cost > now - BETTER:
            break
        whole = _slide(task, placed, at, slide, standing)
        if whole is not None and (allowed is None or allowed(whole)):
            return whole
    return placed


def _measure(group: FurnishedGroup) -> tuple[float, float]:
    """How deep a group is at the wall behind it, and how high, metres."""
    case, main = group.dressed.case, group.dressed.case.members[0]
    deep = main.y + (main.size.depth + case.depth) / 2
    if group.wish.group in BY_BOX or main.heading != 0.0:
        deep = case.depth
    return deep, main.z + main.size.height


def _cost_at(span: Span, axes: list[Axis], case: Group, middle: float) -> float:
    """What a case costs with its middle at ``middle`` metres along a wall: gaps beside it, and how
    far it is off its axes."""
    cost, main = span.cost_at(middle, case.width), middle + find_aside(case)
    for axis in axes:
        off = abs(span.along(axis.x, axis.y) - main)
        cost += axis.weight * min(off, OFF_COUNTED) if off > ENOUGH else 0.0
    return cost


def _list_slides(span: Span, axes: list[Axis], group: FurnishedGroup) -> Iterator[Slide]:
    """The group where it is, at the ends of its stretch, and on its axes or as near to them as it
    comes."""
    for case in _list_forms(group, span, axes):
        first, last = span.start + case.width / 2, span.end - case.width / 2
        if last < first - ENOUGH / 10:
            continue
        less = CUT * (group.dressed.case.width - case.width)
        here = min(max(span.at, first), last)
        for middle in (here, *span.list_flush(case.width)):
            cost = _cost_at(span, axes, case, middle) + less
            yield Slide(case, span.box_at(middle, case), cost, 0.0)
        for axis in axes:
            on = min(max(span.along(axis.x, axis.y) - find_aside(case), first), last)
            least = 0.0
            for left in SHARES:
                middle = on + left * (here - on)
                least = max(least, _cost_at(span, axes, case, middle) + less)
                yield Slide(case, span.box_at(middle, case), least, left)


def _list_forms(group: FurnishedGroup, span: Span, axes: list[Axis]) -> Iterator[Group]:
    """The case of a group; if it belongs on an axis, its mirror image where its main piece stands
    aside of its middle, and narrower stands of a screen that does not come near its axis."""
    case = group.dressed.case
    yield case
    aside = axes and case.function == "seating" and find_aside(case) != 0.0
    if aside and not any(m.asset for m in case.members):
        members = tuple(m._replace(x=-m.x, heading=-m.heading) for m in case.members)
        yield case._replace(name=f"{case.name}, mirrored", members=members)
    room = case.width / 2 - STAND_SHORT
    on = [span.along(axis.x, axis.y) for axis in axes]
    off = any(m < span.start + room or m > span.end - room for m in on)
    if off and case.members[0].category == "tv_stand" and group.wish.most is None:
        least = case.width - LESS - HAIR
        yield from (form for form in media() if least < form.width < case.width - HAIR)


def _slide(
    task: RoomTask, placed: Placed, at: int, slide: Slide, standing: StandingObstacles
) -> Placed | None:
    """The groups with one of them slid; None where anything is lost by it."""
    group, rest = placed[at], [*placed[:at], *placed[at + 1 :]]
    moved = dress_group(task, group, slide.case, slide.box, standing)
    if moved is None or len(moved.pieces) < len(group.pieces):
        return None
    if is_crowded(task, group, moved, rest):
        return None
    whole = (*placed[:at], moved, *placed[at + 1 :])
    if sum_faults(task, whole) > sum_faults(task, placed) + HAIR:
        return None
    if count_unmet(task, whole) > count_unmet(task, placed):
        return None
    return whole
