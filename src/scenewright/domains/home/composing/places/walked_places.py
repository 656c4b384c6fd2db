"""One group at many places along the walls, those first that cost least, past which one walks.

Of each form only a few places are tried that are best without regard to ways (:mod:`.trials`).
Where the group would bar a way at all of these, or is itself out of reach, further ones are walked
past here, in the order of what they cost.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, RoomJudge, sum_faults
from scenewright.domains.home.composing.placed_faults import cost_of_openings
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.composing.places.moving import dress_group, find_places
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of

Floats = NDArray[np.float64]

FORMS, WALKED = 12, 30  # unlike forms, and places of all of them that are walked past
WALKED_APART = 0.15  # places of like size nearer to one another are one, metres


class WalkedPlace(NamedTuple):
    """A form of a group on a box (5,), and what the room costs at least with it there."""

    least: float
    case: Group
    box: Floats


def try_places(
    judge: RoomJudge,
    placed: Placed,
    at: int,
    forms: Iterable[Group],
    most: float,
    metre: float = 0.0,
    step: float | None = None,
) -> Iterator[JudgedRoom]:
    """The groups with one of them wherever along the walls its unlike ``forms`` stand free and the
    room costs at most ``most``, the cheapest first, a metre of width being worth ``metre``;
    places a ``step`` apart, metres."""
    found = _list_places(judge, placed, at, forms, most, step)
    found.sort(key=lambda place: place.least - metre * place.case.width)
    return furnish_places(judge, placed, at, islice(_thin_out(found), WALKED), most)


def _list_places(
    judge: RoomJudge,
    placed: Placed,
    at: int,
    cases: Iterable[Group],
    most: float,
    step: float | None,
) -> list[WalkedPlace]:
    """The free places of unlike forms of a group at which the room may cost at most ``most``."""
    task, group, found = judge.task, placed[at], list[WalkedPlace]()
    rule, rest = task.preset.settings.composing, placed[:at] + placed[at + 1 :]
    pieces = (*task.fixed, *task.beside, *(p for g in rest for p in g.pieces))
    standing, faults = standing_of(pieces, flat_kinds(task.catalog)), sum_faults(task, rest)
    forms = list_unlike(cases)
    for case, boxes in islice(find_places(task, forms, standing, group, step), FORMS):
        layouts = np.repeat(np.array([[p.dressed.box for p in placed]]), len(boxes), axis=0)
        layouts[:, at] = boxes
        costs = task.costs.energy * judge.energies_of(layouts) + faults
        costs += cost_of_case(case, task.ground.area, rule)
        costs += cost_of_openings(case, boxes, task.ground, rule)
        found += [
            WalkedPlace(float(costs[k]), case, boxes[k]) for k in np.flatnonzero(costs < most)
        ]
    return found


def list_unlike(forms: Iterable[Group]) -> Iterator[Group]:
    """The forms without those that differ by less than 0.1 m from one before."""
    seen = set[tuple[float, float, int]]()
    for form in forms:
        size = (round(form.width, 1), round(form.depth, 1), len(form.members))
        if size not in seen:
            seen.add(size)
            yield form


def _thin_out(places: Iterable[WalkedPlace]) -> Iterator[WalkedPlace]:
    """The places without those where a form no larger was nearly there before."""
    seen: list[WalkedPlace] = []
    for place in places:
        if not any(_is_like(place, other) for other in seen):
            seen.append(place)
            yield place


def _is_like(place: WalkedPlace, other: WalkedPlace) -> bool:
    off = np.abs(place.box - other.box)
    larger = place.case.width >= other.case.width and place.case.depth >= other.case.depth
    return bool(larger and off[:2].max() < WALKED_APART and off[2] < 0.1)


def furnish_places(
    judge: RoomJudge, placed: Placed, at: int, places: Iterable[WalkedPlace], most: float
) -> Iterator[JudgedRoom]:
    """The rooms with the group at each of the places that cost at most ``most``."""
    task = judge.task
    pieces = (p for i, g in enumerate(placed) for p in g.pieces if i != at)
    standing = standing_of((*task.fixed, *task.beside, *pieces), flat_kinds(task.catalog))
    for place in places:
        dressed = dress_group(task, placed[at], place.case, place.box, standing)
        if dressed is not None:
            judged = judge.cost_of((*placed[:at], dressed, *placed[at + 1 :]))
            if judged.cost <= most:
                yield judged
