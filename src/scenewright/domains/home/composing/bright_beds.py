"""A bedroom composed anew around its bed for two, which stood before a window.

Where neither the bed alone nor a pair of groups finds places, the bed is put first: wherever along
the walls it takes less of windows beside nothing but what stays, also as a bed of 1.4 m with narrow
nightstands or a single one if one still gets in from both sides. All others follow, the essential
and the largest first, in forms that hold hardly less than they did.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice
from math import inf

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import FurnishedGroup, RoomTask, bars_no_more, find_blocked
from scenewright.domains.home.bed_first import with_narrow_ways
from scenewright.domains.home.composing.anew import Judges, judge_in_order
from scenewright.domains.home.composing.bed_sides import count_closed_beds
from scenewright.domains.home.composing.bright_forms import list_bright_forms, list_forms_of_bed
from scenewright.domains.home.composing.clothes import METRE
from scenewright.domains.home.composing.forms import cost_of_case
from scenewright.domains.home.composing.judging import JudgedRoom, Placed
from scenewright.domains.home.composing.moving import dress_group, find_places
from scenewright.domains.home.composing.placed_faults import (
    DARK,
    cost_of_openings,
    measure_before_windows,
    measure_cases_before_windows,
)
from scenewright.domains.home.composing.walked_places import try_places
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of

Floats = NDArray[np.float64]

STEP = 0.05  # between places of the bed along a wall, metres
BRIGHT_PLACES_APART = 0.3  # nearer places of a form no larger and no worse are one, metres
STARTS = 16  # places of the bed from which the others follow
DEAR = 300.0
"""What the others may not take: another window, a wide door."""


def list_around_bed(task: RoomTask, placed: Placed, at: int, fixed: frozenset[str]) -> list[Placed]:
    """The rooms with the bed for two number ``at`` before fewer windows and all others but those
    ``fixed`` by name after it, that bar no further way on a grid with narrower ways, the cheapest
    first."""
    bed, narrow = placed[at], _make_strict(with_narrow_ways(task))
    stays = tuple(p for p in placed if p.name in fixed)
    rest = [p for k, p in enumerate(placed) if k != at and p.name not in fixed]
    order = sorted(rest, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod())))
    barred = frozenset(find_blocked(narrow, placed))
    judges, found = judge_in_order(narrow, (*stays, bed, *order)), list[JudgedRoom]()
    for start in islice(_list_starts(narrow, stays, bed, judges, barred), STARTS):
        tried = (_follow(narrow, judges, start, order, barred, m) for m in (METRE, -METRE))
        found += islice((whole for whole in tried if whole is not None), 1)
    return [judged.placed for judged in sorted(found, key=lambda j: j.cost)]


def _make_strict(task: RoomTask) -> RoomTask:
    """The task with windows and wide doors at such a price that others hardly take one."""
    rule = task.preset.settings.composing
    costs = rule.costs._replace(window=DEAR, opening=DEAR)
    settings = task.preset.settings._replace(composing=rule._replace(costs=costs))
    return task._replace(preset=task.preset._replace(settings=settings))


def _list_starts(
    task: RoomTask, stays: Placed, bed: FurnishedGroup, judges: Judges, barred: frozenset[str]
) -> Iterator[JudgedRoom]:
    """The bed beside what stays at places before fewer windows that leave both its sides open, the
    cheapest first."""
    pieces = (*task.fixed, *task.beside, *(p for group in stays for p in group.pieces))
    standing, judge = standing_of(pieces, flat_kinds(task.catalog)), judges(len(stays) + 1)
    closed = count_closed_beds((*stays, bed), task.ground)
    for case, box in _rank(task, list(_list_bright(task, bed, standing))):
        dressed = dress_group(task, bed, case, box, standing)
        if dressed is None:
            continue
        placed = (*stays, dressed)
        is_open = count_closed_beds(placed, task.ground) <= closed
        if is_open and bars_no_more(task, placed, barred):
            yield judge.cost_of(placed)


def _list_bright(
    task: RoomTask, bed: FurnishedGroup, standing: StandingObstacles
) -> Iterator[tuple[Group, Floats]]:
    """Forms of the bed with the boxes (n, 5) on which it takes the light of fewer windows."""
    dark = int((measure_before_windows(bed, task.ground) > DARK).sum())
    for case, boxes in find_places(task, list_forms_of_bed(task, bed), standing, bed, STEP):
        darker = (measure_cases_before_windows(case, boxes, task.ground) > DARK).sum(axis=1)
        if (darker < dark).any():
            yield case, boxes[darker < dark]


def _rank(task: RoomTask, bright: Sequence[tuple[Group, Floats]]) -> Iterator[tuple[Group, Floats]]:
    """Each form on each of its boxes, those with less wrong there and the smaller ones by turns,
    without those where one no larger and no worse was nearly there before."""
    rule, rated = task.preset.settings.composing, list[tuple[float, int, Group, Floats]]()
    for case, boxes in bright:
        costs = cost_of_openings(case, boxes, task.ground, rule)
        costs = costs + cost_of_case(case, task.ground.area, rule)
        rated += [(float(c), len(rated) + k, case, boxes[k]) for k, c in enumerate(costs)]
    rated.sort(key=lambda row: row[:2])
    smaller = sorted(rated, key=lambda row: row[2].width * row[2].depth)
    seen: list[tuple[float, Group, Floats]] = []
    for cost, _, case, box in chain.from_iterable(zip(rated, smaller, strict=True)):
        if not any(_is_like((cost, case, box), other) for other in seen):
            seen.append((cost, case, box))
            yield case, box


def _is_like(one: tuple[float, Group, Floats], other: tuple[float, Group, Floats]) -> bool:
    (cost, case, box), (less, form, there) = one, other
    near = np.abs(box[:2] - there[:2]).max() < BRIGHT_PLACES_APART and abs(box[2] - there[2]) < 0.1
    return bool(near and cost >= less and case.width >= form.width and case.depth >= form.depth)


def _follow(
    task: RoomTask,
    judges: Judges,
    start: JudgedRoom,
    others: Sequence[FurnishedGroup],
    barred: frozenset[str],
    metre: float,
) -> JudgedRoom | None:
    """The others beside the bed, one after the other, each where the room costs least if a
    ``metre`` of width is worth so much; None where one finds no place or closes the bed's
    sides."""
    best, closed = start, count_closed_beds(start.placed, task.ground)
    for other in others:
        whole, at = (*best.placed, other), len(best.placed)
        forms = list_bright_forms(task, other)
        found = try_places(judges(at + 1), whole, at, forms, inf, metre)
        open_ = (
            judged
            for judged in found
            if count_closed_beds(judged.placed, task.ground) <= closed
            and bars_no_more(task, judged.placed, barred)
        )
        following = next(open_, None)
        if following is None:
            return None
        best = following
    return best
