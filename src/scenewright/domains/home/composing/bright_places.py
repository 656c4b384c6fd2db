"""Where what stands before a window, or adrift in the room, could stand instead.

Places along the walls are looked for in the room as if only its kitchen stood there; those before
fewer windows are kept, a bed's only where it has a wall along its side. Most small bedrooms have
none, and are done with. Where some are free, the group moves there by itself; where another group
is in the way, both are placed together (:mod:`.pairs`), and a third one follows them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.anew import follow
from scenewright.domains.home.composing.bed_places import are_adrift, cost_of_bed_places
from scenewright.domains.home.composing.bright_forms import list_bright_forms
from scenewright.domains.home.composing.forms import cost_of_case
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of
from scenewright.domains.home.composing.moving import dress_group, find_places, stand_at
from scenewright.domains.home.composing.pairs import do_overlap, furnish_pairs
from scenewright.domains.home.composing.placed_faults import (
    DARK,
    cost_of_openings,
    list_adrift,
    measure_before_windows,
    measure_cases_before_windows,
)
from scenewright.domains.home.composing.walked_places import list_unlike
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of
from scenewright.domains.home.wall_places import along_walls

Floats = NDArray[np.float64]

STEP = 0.05  # between places along a wall, metres
SAME_PLACE = 0.15  # nearer places of a form no larger are one, metres
PLACED, PAIRS = 15, 100  # places that are furnished, and pairs beside what is not in their way
FOLLOWED = 3  # pairs which a third group follows
WAYS = 2  # sets of groups in the way that are tried
SEAT_TO_WINDOW, AT_GLASS_FROM = 0.31, 9.0
"""Seats stand so far before a window at their back, metres, in rooms of so many square metres."""
DEAR = 1000.0
"""What a pair may not have: a window behind it, a bed adrift."""
FEW = {"pair_forms": 4, "pair_places": 40}
"""Of pairs the forms of either, and places of each form."""
STAYS = frozenset(("plant",))
"""What is never placed together with something."""


class BrightPlaces(NamedTuple):
    """A form of a group, and boxes (n, 5) on which it is before fewer windows or no more adrift."""

    case: Group
    boxes: Floats


def list_brighter(
    task: RoomTask, placed: Placed, at: int, fixed: frozenset[str], worth: float
) -> Iterator[JudgedRoom]:
    """The rooms that cost less than so much more (``worth``) in which one of the groups takes less
    of windows or is not adrift; groups that are ``fixed`` by name stay."""
    group, rest = placed[at], placed[:at] + placed[at + 1 :]
    stays = tuple(p for p in rest if p.name in fixed)
    bright = list(_list_bright(task, group, _stand(task, stays)))
    if not bright:
        return
    judge = judge_of(task, placed)
    most = judge.cost_of(placed).cost + worth
    for judged in _list_alone(task, placed, at, bright):
        if judged.cost < most:
            yield judged
    others = tuple(p for p in rest if p.name not in fixed and p.wish.group not in STAYS)
    for away in islice(_list_in_the_way(bright, others), WAYS):
        for judged in _list_together(task, placed, group, away, worth):
            if judged.cost < most:
                yield judged


def _stand(task: RoomTask, placed: Sequence[FurnishedGroup]) -> StandingObstacles:
    pieces = (p for group in placed for p in group.pieces)
    return standing_of((*task.fixed, *task.beside, *pieces), flat_kinds(task.catalog))


def _list_bright(
    task: RoomTask, group: FurnishedGroup, standing: StandingObstacles
) -> Iterator[BrightPlaces]:
    forms = list(list_unlike(list_bright_forms(task, group)))
    for case, boxes in find_places(task, forms, standing, group, STEP):
        yield from _keep_bright(task, group, case, boxes)
    if group.wish.group == "seating" and task.ground.area >= AT_GLASS_FROM:
        for case in forms:
            boxes = stand_at(task, case, _list_ahead(task, case), standing)
            yield from _keep_bright(task, group, case, boxes)


def _list_ahead(task: RoomTask, case: Group) -> Floats:
    """Boxes (n, 5) along the walls, :data:`SEAT_TO_WINDOW` from the wall at their back."""
    boxes = along_walls(case, task.ground, 2 * STEP)
    boxes[:, :2] += SEAT_TO_WINDOW * np.column_stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])])
    return boxes


def _keep_bright(
    task: RoomTask, group: FurnishedGroup, case: Group, boxes: Floats
) -> Iterator[BrightPlaces]:
    """Of a form's boxes (n, 5) those before fewer windows than the group and no more adrift, or the
    other way round."""
    dark, adrift = _count_dark(group, task), len(list_adrift((group,), task.ground))
    darker = (measure_cases_before_windows(case, boxes, task.ground) > DARK).sum(axis=1)
    loose = np.zeros(len(boxes), int)
    if case.function == "single":
        loose = are_adrift(case, boxes, task.ground.walls).astype(int)
    kept = (darker <= dark) & (loose <= adrift) & (darker + loose < dark + adrift)
    if kept.any():
        yield BrightPlaces(case, boxes[kept])


def _count_dark(group: FurnishedGroup, task: RoomTask) -> int:
    return int((measure_before_windows(group, task.ground) > DARK).sum())


def _list_alone(
    task: RoomTask, placed: Placed, at: int, bright: Sequence[BrightPlaces]
) -> Iterator[JudgedRoom]:
    """The room with one of its groups at such a place where nothing else stands, those first that
    cost least."""
    judge, standing = judge_of(task, placed), _stand(task, placed[:at] + placed[at + 1 :])
    found: list[tuple[float, int, Group, Floats]] = []
    for case, boxes in bright:
        free = stand_at(task, case, boxes, standing)
        layouts = np.repeat(np.array([[p.dressed.box for p in placed]]), len(free), axis=0)
        if len(free):
            layouts[:, at] = free
            costs = task.costs.energy * judge.energies_of(layouts) + _rate(task, case, free)
            found += [(float(c), len(found) + k, case, free[k]) for k, c in enumerate(costs)]
    for case, box in islice(_thin_out(sorted(found, key=lambda f: f[:2])), PLACED):
        dressed = dress_group(task, placed[at], case, box, standing)
        if dressed is not None:
            yield judge.cost_of((*placed[:at], dressed, *placed[at + 1 :]))


def _rate(task: RoomTask, case: Group, boxes: Floats) -> Floats:
    """What is wrong with a case on each of boxes (n, 5)."""
    rule = task.preset.settings.composing
    cost = cost_of_openings(case, boxes, task.ground, rule)
    cost += cost_of_case(case, task.ground.area, rule)
    if case.function == "single":
        cost += cost_of_bed_places(case, boxes, task.ground, rule)
    return cost


def _thin_out(found: Sequence[tuple[float, int, Group, Floats]]) -> Iterator[tuple[Group, Floats]]:
    """The forms and boxes without those where a form no larger was nearly there before."""
    seen: list[tuple[Group, Floats]] = []
    for _, _, case, box in found:
        like = (
            np.abs(box[:2] - other[:2]).max() < SAME_PLACE
            and abs(box[2] - other[2]) < 0.1
            and case.width >= form.width
            and case.depth >= form.depth
            for form, other in seen
        )
        if not any(like):
            seen.append((case, box))
            yield case, box


def _list_in_the_way(bright: Sequence[BrightPlaces], others: Placed) -> Iterator[Placed]:
    """The groups in the way of such places, one or two at once, first those that leave most places;
    where no others are in the way of a place that bars a way, each essential one of them."""
    if not others:
        return
    boxes = np.concatenate([b.boxes for b in bright])
    meet = do_overlap(boxes, np.array([p.dressed.box for p in others]))
    ways, counts = np.unique(meet, axis=0, return_counts=True)
    order = sorted(range(len(ways)), key=lambda k: (int(ways[k].sum()), -int(counts[k])))
    sets = [np.flatnonzero(ways[k]).tolist() for k in order]
    free = [[k] for k, p in enumerate(others) if p.wish.rank == 0] if [] in sets else []
    seen: list[list[int]] = []
    for each in (*free, *sets):
        if 0 < len(each) < 3 and each not in seen:
            seen.append(each)
            yield tuple(others[k] for k in each)


def _list_together(
    task: RoomTask, placed: Placed, group: FurnishedGroup, away: Placed, worth: float
) -> Iterator[JudgedRoom]:
    """The room with a group and the larger of those in its way at other places, a smaller one after
    them."""
    second, *third = sorted(away, key=lambda p: -float(p.dressed.box[3:].prod()))
    rest = tuple(p for p in placed if all(p is not q for q in (group, *away)))
    judge = judge_of(task, (*rest, group, second, *third))
    pairs = _list_pairs(task, (group, second), rest, worth)
    if not third:
        yield from (judge.cost_of(whole) for whole in islice(pairs, PAIRS))
        return
    for whole in islice(pairs, FOLLOWED):
        start = JudgedRoom(whole, 0.0)
        done = follow(task, lambda _: judge, start, third, frozenset(), inf)
        if done is not None:
            yield done


def _list_pairs(task: RoomTask, pair: Placed, rest: Placed, worth: float) -> Iterator[Placed]:
    """The groups of a room with two at places beside the rest that are before no window, a bed
    along a wall, the cheapest first."""
    pieces = (p for group in rest for p in group.pieces)
    beside = task._replace(beside=(*task.beside, *pieces))
    most = judge_of(beside, pair).cost_of(pair).cost + worth
    strict = _make_dear(beside)
    for judged in furnish_pairs(judge_of(strict, pair), pair, most, list_bright_forms):
        yield (*rest, *judged.placed)


def _make_dear(task: RoomTask) -> RoomTask:
    """The task with windows and beds adrift at such a price that no pair is worth one."""
    rule = task.preset.settings.composing
    costs = rule.costs._replace(window=DEAR, adrift=DEAR)
    settings = task.preset.settings._replace(composing=rule._replace(costs=costs, **FEW))
    return task._replace(preset=task.preset._replace(settings=settings))
