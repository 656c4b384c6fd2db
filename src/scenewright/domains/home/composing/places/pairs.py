"""A bed and a wardrobe that are placed together, of all pairs of places the best.

In a small room either has a place only while the other stands somewhere else, and one placed after
the other misses it. So the places of both along all walls are combined, those pairs that overlap
are left out, and of the rest the cheapest are furnished until some of them leave every way open.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import islice, product, zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask, bars_no_more
from scenewright.domains.home.composing.bed_places import cost_of_bed_places
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import JudgedRoom, RoomJudge
from scenewright.domains.home.composing.placed_faults import cost_of_openings
from scenewright.domains.home.composing.places.forms import cost_of_case, list_forms
from scenewright.domains.home.composing.places.moving import dress_group, find_places, with_margin
from scenewright.domains.home.furnishing.obstacles import flat_kinds, join_standing, standing_of
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.measures import ROUNDING
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]

Forms = Callable[[RoomTask, FurnishedGroup], Iterable[Group]]
"""The forms in which a group of a pair is tried, those without a like one before them."""
TOUCH = 0.004  # boxes that share a strip narrower than this touch, metres
NEAR = 0.2  # of places of one form nearer than this to a better one, one is taken, metres

MINOR = frozenset(("shallow", "narrow_bed"))
"""Faults with which a form is still one of the sound ones."""
UNLIKE = 0.15  # forms that differ by more than this in width or depth are unlike, metres


class FormPlaces(NamedTuple):
    """A form of a group, boxes (n, 5) on which it stands free in the empty room, and what is wrong
    with each (n,)."""

    case: Group
    boxes: Floats
    faults: Floats


class PlacedPairs(NamedTuple):
    """Pairs of forms, those of each pair (k,) by the number of two ``cases``, the boxes of both
    (k, 2, 5), and what they cost there (k,)."""

    cases: tuple[tuple[Group, Group], ...]
    forms: NDArray[np.int64]
    boxes: Floats
    costs: Floats


def find_pair(
    placed: Iterable[FurnishedGroup], other: str = "wardrobe"
) -> tuple[FurnishedGroup, ...]:
    """The bed and the wardrobe of a room, or its ``other`` group, empty unless there is one of
    each."""
    beds = [p for p in placed if p.wish.group in BED_GROUPS]
    others = [p for p in placed if p.wish.group == other]
    return (*beds, *others) if len(beds) == len(others) == 1 else ()


def list_pair_starts(
    judge: RoomJudge, pair: tuple[FurnishedGroup, ...], barred: frozenset[str], most: float
) -> Iterator[JudgedRoom]:
    """Both groups by themselves at the best pairs of places that bar no further way and cost less
    than ``most``, the cheapest first; ``judge`` is that of these two."""
    margin, most_tried = with_margin(judge.task), judge.task.preset.settings.composing.pairs
    for tried in islice(furnish_pairs(judge, pair, most, list_by_turns), most_tried):
        if bars_no_more(margin, tried.placed, barred):
            yield tried


def furnish_pairs(
    judge: RoomJudge, pair: tuple[FurnishedGroup, ...], most: float, forms: Forms
) -> Iterator[JudgedRoom]:
    """Pairs of places that cost less than ``most`` with their furniture, the cheapest first, of
    like ones only the first."""
    task, flat = judge.task, flat_kinds(judge.task.catalog)
    empty = standing_of((*task.fixed, *task.beside), flat)
    cases, numbers, boxes, _ = _list_pairs(judge, pair, most, forms)
    alike = np.zeros(len(boxes), bool)
    for k, form in enumerate(numbers.tolist()):
        if alike[k]:
            continue
        one = dress_group(task, pair[0], cases[form][0], boxes[k, 0], empty)
        if one is None:
            continue
        beside = join_standing(empty, standing_of(one.pieces, flat))
        other = dress_group(task, pair[1], cases[form][1], boxes[k, 1], beside)
        if other is not None:
            alike |= _are_alike(boxes[..., :3], boxes[k, :, :3])
            yield judge.cost_of((one, other))


def _are_alike(poses: Floats, one: Floats) -> NDArray[np.bool_]:
    """Of pairs of boxes (n, 2, 3: x, y, heading) those with both nearly where ``one`` (2, 3) has
    them."""
    alike = np.abs(poses[:, 0, 0] - one[0, 0]) < NEAR
    alike &= np.abs(poses[:, 0, 1] - one[0, 1]) < NEAR
    some = np.flatnonzero(alike)  # the rest is looked at of these only
    off = np.abs(poses[some] - one)
    near = (np.hypot(off[..., 0], off[..., 1]) < NEAR) & (off[..., 2] < 0.1)
    alike[some] = near[:, 0] & near[:, 1]
    return alike


def _list_pairs(
    judge: RoomJudge, pair: tuple[FurnishedGroup, ...], most: float, tried: Forms
) -> PlacedPairs:
    """The cheapest pairs of places of every two forms that cost less than ``most``, the cheapest of
    all first."""
    rule, energy = judge.task.preset.settings.composing, judge.task.costs.energy
    both = tuple(product(*(list_form_places(judge.task, group, tried) for group in pair)))
    found, rated, forms = [np.empty((0, 2, 5))], [np.empty(0)], [np.empty(0, np.int64)]
    for number, (one, other) in enumerate(both):
        faults = one.faults[:, None] + other.faults
        sound = faults < most + ROUNDING
        if not sound.any():
            continue
        i, j = np.nonzero(~do_overlap(one.boxes, other.boxes) & sound)
        if not len(i):
            continue
        layouts = np.stack([one.boxes[i], other.boxes[j]], axis=1)
        costs = energy * judge.energies_of(layouts) + one.faults[i] + other.faults[j]
        cheap = np.flatnonzero(costs < most)
        best = cheap[np.argsort(costs[cheap], kind="stable")[: rule.pairs]]
        found.append(layouts[best])
        rated.append(costs[best])
        forms.append(np.full(len(best), number))
    costs = np.concatenate(rated)
    order = np.argsort(costs, kind="stable")
    cases = tuple((one.case, other.case) for one, other in both)
    boxes = np.concatenate(found)[order]
    return PlacedPairs(cases, np.concatenate(forms)[order], boxes, costs[order])


def list_form_places(task: RoomTask, group: FurnishedGroup, tried: Forms) -> list[FormPlaces]:
    """The places of a group's better forms in the empty room."""
    rule, found = task.preset.settings.composing, []
    empty = standing_of((*task.fixed, *task.beside), flat_kinds(task.catalog))
    forms = _list_unlike(tried(task, group))
    for case, boxes in islice(find_places(task, forms, empty, group), rule.pair_forms):
        faults = cost_of_openings(case, boxes, task.ground, rule)
        if case.function == "single":
            faults = faults + cost_of_bed_places(case, boxes, task.ground, rule)
        faults = faults + cost_of_case(case, task.ground.area, rule)
        kept = _thin_out(boxes, faults, rule.pair_places)
        found.append(FormPlaces(case, boxes[kept], faults[kept]))
    return found


def list_by_turns(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    """The better forms of a group and, of those without a fault, the smaller ones by turns."""
    better = list(list_forms(task, group))
    sound = [form for form in better if {name for name, _ in find_case_faults(form)} <= MINOR]
    smaller = sorted(sound, key=lambda form: form.width * form.depth)
    for both in zip_longest(better, smaller):
        yield from (form for form in both if form is not None)


def _list_unlike(forms: Iterable[Group]) -> Iterator[Group]:
    """The forms without those that differ little from one before."""
    seen: list[Group] = []
    for form in forms:
        like = (
            len(form.members) == len(other.members)
            and abs(form.width - other.width) < UNLIKE
            and abs(form.depth - other.depth) < UNLIKE
            for other in seen
        )
        if not any(like):
            seen.append(form)
            yield form


def _thin_out(boxes: Floats, faults: Floats, most: int) -> NDArray[np.int64]:
    """The numbers of at most ``most`` boxes (n, 5), the better first and none near to another where
    there are more."""
    order = np.argsort(faults, kind="stable")
    if len(order) <= most:
        return order
    kept: list[int] = []
    for k in order.tolist():
        near = np.hypot(*(boxes[kept, :2] - boxes[k, :2]).T) < NEAR
        if not (near & (np.abs(boxes[kept, 2] - boxes[k, 2]) < 0.1)).any():
            kept.append(k)
            if len(kept) == most:
                break
    return np.array(kept, np.int64)


def do_overlap(one: Floats, other: Floats) -> NDArray[np.bool_]:
    """Which of boxes (n, 5) overlap which of others (m, 5), as (n, m): no axis of either has them
    apart (separating axes, Gottschalk, Lin, Manocha 1996).

    >>> boxes = np.array([[0.0, 0.0, 0.0, 1.0, 2.0], [1.4, 0.0, np.pi / 4, 1.0, 1.0]])
    >>> do_overlap(boxes[:1], boxes).tolist()
    [[True, True]]
    >>> do_overlap(boxes[:1], boxes + [0.4, 0.0, 0.0, 0.0, 0.0]).tolist()
    [[True, False]]
    """
    meet = np.empty((len(one), len(other)), bool)
    turns, their = (np.column_stack([np.cos(b[:, 2]), np.sin(b[:, 2])]) for b in (one, other))
    mark_overlap(np.ascontiguousarray(one), np.ascontiguousarray(other), turns, their, meet)
    return meet


@compiled
def mark_overlap(
    one: Floats, other: Floats, turns: Floats, their: Floats, meet: NDArray[np.bool_]
) -> None:
    """Write :func:`do_overlap` of boxes with the cosine and sine of their headings (n, 2), (m, 2)
    into ``meet`` (n, m)."""
    for i in range(one.shape[0]):
        for j in range(other.shape[0]):
            dx, dy = other[j, 0] - one[i, 0], other[j, 1] - one[i, 1]
            c = abs(turns[i, 0] * their[j, 0] + turns[i, 1] * their[j, 1])
            s = abs(turns[i, 0] * their[j, 1] - turns[i, 1] * their[j, 0])
            meet[i, j] = within(one[i], other[j], turns[i], dx, dy, c, s) and within(
                other[j], one[i], their[j], dx, dy, c, s
            )


@inlined
def within(
    box: Floats, other: Floats, turn: Floats, dx: float, dy: float, c: float, s: float
) -> bool:
    """Whether neither axis of a box (5,) has another, ``dx`` and ``dy`` from it, apart from it;
    ``turn`` (2,) is its own cosine and sine, ``c`` and ``s`` those of the angle between both."""
    ahead, aside = abs(dx * turn[0] + dy * turn[1]), abs(dx * turn[1] - dy * turn[0])
    deep = (box[4] + other[4] * c + other[3] * s) / 2 - TOUCH
    wide = (box[3] + other[3] * c + other[4] * s) / 2 - TOUCH
    return ahead < deep and aside < wide
