"""Rooms with a fault that no single change mends, composed anew: what is at fault chooses first.

The faulty group is put at its best places as if the room were empty, in the forms with least wrong;
all others follow, the essential and the largest first, each where the room so far costs least
beside those before it. A way that leaves one of them without a place, or comes to as many faults as
the room has, is given up.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot

from scenewright.domains.home.attempt import FurnishedGroup, RoomTask, find_blocked
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.forms import list_forms
from scenewright.domains.home.composing.judging import (
    RUNS,
    JudgedRoom,
    Placed,
    judge_of,
    sum_faults,
)
from scenewright.domains.home.composing.moving import make_unplaced, take_best, try_forms
from scenewright.domains.home.programme import Wish


def compose_anew(
    task: RoomTask, best: JudgedRoom, barred: frozenset[str], names: Sequence[str]
) -> JudgedRoom:
    """The groups laid out anew for the first of the faulty ones by their ``names``, the worst
    first, or as they were."""
    for name in names[: task.preset.settings.composing.anew]:
        if task.cancelled():
            break
        found = list(_lay_out_anew(task, best, barred, name))
        best = take_best(task, best, found, barred)
    return best


def _lay_out_anew(
    task: RoomTask, best: JudgedRoom, barred: frozenset[str], name: str
) -> Iterator[JudgedRoom]:
    """The whole room from each of the best places of one group."""
    least = task.preset.settings.composing.least
    most = sum_faults(task, best.placed) - least
    own = sum_faults(task, tuple(p for p in best.placed if p.name == name)) - least
    for first, *others in _list_orders(task, best.placed, name):
        for start in list_starts(task, first):
            better = sum_faults(task, start.placed) < own
            whole = follow(task, start, others, barred, most) if better else None
            if whole is not None:
                yield whole


def _list_orders(task: RoomTask, placed: Placed, name: str) -> Iterator[Placed]:
    """The groups with one of them first, then the essential and the largest; a kitchen also as a
    run and a fridge by itself, and the other way round."""
    first = next(p for p in placed if p.name == name)
    order = sorted(placed, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod())))
    run = next((p for p in placed if p.wish.group in RUNS), None)
    parts = [p for p in placed if p.wish.group in (*RUNS, "fridge")]
    given = run is None or run.wish.required or run.wish.most or task.library.own
    if first not in parts or run is None or given or len(parts) > 2:
        yield (first, *(p for p in order if p is not first))
        return
    rest = [p for p in order if p not in parts]
    bare = run._replace(wish=run.wish._replace(group="kitchenette"), name="kitchenette")
    case = cases("fridge", task.library).groups[0]
    yield bare, make_unplaced(task, tuple(rest), Wish("fridge", 0, small=True), case), *rest
    yield run._replace(wish=run.wish._replace(group="kitchen"), name="kitchen"), *rest


def list_starts(task: RoomTask, first: FurnishedGroup) -> list[JudgedRoom]:
    """One group by itself at its best places, those near to a better one left out."""
    rule = task.preset.settings.composing
    found = try_forms(judge_of(task, (first,)), (first,), 0, list_forms(task, first), rule.forms)
    kept: list[JudgedRoom] = []
    for judged in found:
        x, y, turn = judged.placed[0].dressed.box[:3]
        others = (k.placed[0].dressed.box for k in kept)
        if all(hypot(x - o[0], y - o[1]) >= rule.apart or abs(turn - o[2]) > 0.1 for o in others):
            kept.append(judged)
            if len(kept) == rule.starts:
                break
    return kept


def follow(
    task: RoomTask,
    start: JudgedRoom,
    others: Sequence[FurnishedGroup],
    barred: frozenset[str],
    most: float,
) -> JudgedRoom | None:
    """The others beside the first, one after the other; None where one finds no place, or where
    faults cost ``most`` before all stand."""
    rule, best = task.preset.settings.composing, start
    for other in others:
        if sum_faults(task, best.placed) >= most:
            return None
        whole, at = (*best.placed, other), len(best.placed)
        found = try_forms(
            judge_of(task, whole), whole, at, list_forms(task, other), rule.other_forms
        )
        open_ = (j for j in found[: rule.places] if barred >= set(find_blocked(task, j.placed)))
        following = next(open_, None)
        if following is None:
            return None
        best = following
    return best
