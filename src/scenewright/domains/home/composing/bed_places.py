"""A double bed with a fault at further places along the walls, the first past which all ways are
open.

Of each form only a few places are tried that are best without regard to ways (:mod:`.trials`).
Where the bed would bar a way at all of these, the room keeps a bed in a corner, entered from one
side. So for such a bed the places of unlike forms are walked past in the order of what they cost.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import RoomTask
from scenewright.domains.home.composing.forms import cost_of_case, list_forms
from scenewright.domains.home.composing.judging import (
    JudgedRoom,
    Placed,
    RoomJudge,
    judge_of,
    sum_faults,
)
from scenewright.domains.home.composing.moving import dress_group, find_places
from scenewright.domains.home.composing.placed_faults import cost_of_group, cost_of_openings
from scenewright.domains.home.composing.trials import take_first
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of

Floats = NDArray[np.float64]

DOUBLE = "sleeping"
FORMS, WALKED = 12, 30  # unlike forms, and places of all of them that are walked past
APART = 0.15  # places of like size nearer to one another are one, metres


class BedPlace(NamedTuple):
    """A form of a bed on a box (5,), and what the room costs at least with it there."""

    least: float
    case: Group
    box: Floats


def move_double_bed(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with a double bed that has more wrong than its length at the cheapest place that
    bars no further way, or as they were."""
    rule = task.preset.settings.composing
    at = next((i for i, p in enumerate(best.placed) if p.wish.group == DOUBLE), None)
    if at is None or task.cancelled() or DOUBLE in task.library.own:
        return best
    if cost_of_group(best.placed[at], task.ground, rule) <= rule.costs.short_bed:
        return best
    judge = judge_of(task, best.placed)
    places = _thin_out(_list_places(judge, best.placed, at, best.cost - rule.least))
    return take_first(task, best, _furnish(judge, best, at, islice(places, WALKED)), barred)


def _list_places(judge: RoomJudge, placed: Placed, at: int, most: float) -> list[BedPlace]:
    """The free places of the bed's unlike forms at which the room may cost less than ``most``, the
    cheapest first."""
    task, group, found = judge.task, placed[at], list[BedPlace]()
    rule, rest = task.preset.settings.composing, placed[:at] + placed[at + 1 :]
    pieces = (*task.fixed, *task.beside, *(p for g in rest for p in g.pieces))
    standing, faults = standing_of(pieces, flat_kinds(task.catalog)), sum_faults(task, rest)
    forms = _list_unlike(list_forms(task, group))
    for case, boxes in islice(find_places(task, forms, standing, group), FORMS):
        layouts = np.repeat(np.array([[p.dressed.box for p in placed]]), len(boxes), axis=0)
        layouts[:, at] = boxes
        costs = task.costs.energy * judge.energies_of(layouts) + faults
        costs += cost_of_case(case, task.ground.area, rule)
        costs += cost_of_openings(case, boxes, task.ground, rule)
        found += [BedPlace(float(costs[k]), case, boxes[k]) for k in np.flatnonzero(costs < most)]
    return sorted(found, key=lambda place: place.least)


def _list_unlike(forms: Iterable[Group]) -> Iterator[Group]:
    """The forms without those that differ by less than 0.1 m from one before."""
    seen = set[tuple[float, float, int]]()
    for form in forms:
        size = (round(form.width, 1), round(form.depth, 1), len(form.members))
        if size not in seen:
            seen.add(size)
            yield form


def _thin_out(places: Iterable[BedPlace]) -> Iterator[BedPlace]:
    """The places without those where a bed no larger was nearly as before."""
    seen: list[BedPlace] = []
    for place in places:
        if not any(_is_like(place, other) for other in seen):
            seen.append(place)
            yield place


def _is_like(place: BedPlace, other: BedPlace) -> bool:
    off = np.abs(place.box - other.box)
    larger = place.case.width >= other.case.width and place.case.depth >= other.case.depth
    return bool(larger and off[:2].max() < APART and off[2] < 0.1)


def _furnish(
    judge: RoomJudge, best: JudgedRoom, at: int, places: Iterable[BedPlace]
) -> Iterator[JudgedRoom]:
    """The rooms with the bed at each of the places, as far as they cost less than the best."""
    task, placed = judge.task, best.placed
    pieces = (p for i, g in enumerate(placed) for p in g.pieces if i != at)
    standing = standing_of((*task.fixed, *task.beside, *pieces), flat_kinds(task.catalog))
    for place in places:
        dressed = dress_group(task, placed[at], place.case, place.box, standing)
        if dressed is not None:
            judged = judge.cost_of((*placed[:at], dressed, *placed[at + 1 :]))
            if judged.cost < best.cost - task.preset.settings.composing.least:
                yield judged
