"""Changes nobody needs are taken back; what remains changed has its reason.

After the rest of a room was placed anew around what was moved by hand, every group that now
stands elsewhere is tried where it stood before. If it can stand there and the room costs no more
it is put back, until no single change can be taken back so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf
from typing import NamedTuple

import numpy as np

from scenewright.domains.home.attempts.attempt import (
    DOOR,
    FurnishedGroup,
    Missing,
    RoomTask,
    build_task_problem,
    out_of_reach,
    penalty,
)
from scenewright.domains.home.changes.least_change import Rest
from scenewright.domains.home.changes.regroup import as_standing, newly_misplaced
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.programme import FALLBACK
from scenewright.domains.home.wished.unmet import count_unmet_wishes

SAME = 1e-9  # costs that differ by less are equal
BARS = "where it stood it would bar a walking route, or none would reach it"
WORSE = "where it stood the room as a whole would be arranged worse"


class Pair(NamedTuple):
    """A group as it was and as it is; ``now`` is ``was`` itself where nothing changed, and None
    where the group is gone."""

    was: FurnishedGroup
    now: FurnishedGroup | None


def take_back(
    task: RoomTask, held: Sequence[FurnishedGroup], before: Sequence[FurnishedGroup], rest: Rest
) -> tuple[Rest, dict[str, str]]:
    """The rest of a room with what need not change as it was ``before``, and for every group that
    still changes the reason, by the group's id.

    ``task`` is the room without the groups ``held``, which stay.
    """
    pairs, others = _pair_groups(before, (*rest.stay, *rest.answer.placed))
    missing = list(rest.answer.missing)
    reasons: dict[str, str] = {}
    again, least = any(pair.now is not pair.was for pair in pairs), inf
    while again:
        again, reasons = False, {}
        for k, pair in enumerate(pairs):
            if pair.now is pair.was:
                continue
            if least == inf:
                least = cost(task, [*held, *others, *_present(pairs)], missing)
            why = _why_not(task, (*held, *others), pairs, k, missing, least)
            if not why:
                pairs[k], again, least = Pair(pair.was, pair.was), True, inf
                missing = _without(missing, pair)
            reasons[pair.was.pieces[0].group] = why
    stay = tuple(pair.was for pair in pairs if pair.now is pair.was)
    moved = tuple(p.now for p in pairs if p.now is not None and p.now is not p.was)
    answer = rest.answer._replace(placed=(*moved, *others), missing=tuple(missing))
    return Rest(stay, answer), reasons


def cost(task: RoomTask, groups: Sequence[FurnishedGroup], missing: Sequence[Missing]) -> float:
    """What a furnished room costs: what is missing or out of reach, wishes that are not met, and
    the energy; as :func:`scenewright.domains.home.attempts.attempt.score_answer` has it."""
    pieces = tuple(p for g in groups for p in g.pieces)
    far = out_of_reach(task, pieces) - task.tight
    doors = sum(name.startswith(DOOR) for name in far)
    cut = sum(any(p.id in far for p in g.pieces) for g in groups)
    fixed = len(far - {p.id for p in pieces}) - doors
    standing = (*task.fixed, *pieces)
    costs = task.costs
    total = (
        sum(penalty(m.wish, costs) for m in missing)
        + costs.barred * doors
        + costs.unreached * (cut + fixed)
        + costs.piece * sum(g.dressed.lost for g in groups)
        + costs.unmet * count_unmet_wishes(task.asked, task.space, standing, task.catalog)
    )
    if not groups:
        return total
    problem = build_task_problem(task, tuple(g.wish for g in groups), task.ground)
    boxes = np.array([[g.dressed.box for g in groups]])
    return total + costs.energy * float(evaluate(problem, boxes)[0])


def _why_not(
    task: RoomTask,
    others: Sequence[FurnishedGroup],
    pairs: Sequence[Pair],
    k: int,
    missing: list[Missing],
    now: float,
) -> str:
    """Why a group cannot be put back where it was; empty if the room then costs no more than
    ``now``."""
    pair = pairs[k]
    beside = [*others, *_present([p for i, p in enumerate(pairs) if i != k])]
    standing = (*task.fixed, *(p for g in beside for p in g.pieces))
    wrong = newly_misplaced(task, pair.was.pieces, as_standing(standing, task.catalog))
    if wrong:
        text = next(iter(wrong.values())).removeprefix("no place found: ")
        return f"where it stood {text}"
    back = cost(task, [*beside, pair.was], _without(missing, pair))
    if back <= now + SAME:
        return ""
    return BARS if back > now + task.costs.unmet else WORSE


def _present(pairs: Sequence[Pair]) -> list[FurnishedGroup]:
    return [pair.now for pair in pairs if pair.now is not None]


def _without(missing: Sequence[Missing], pair: Pair) -> list[Missing]:
    """What is missing once a group that was gone is back."""
    left = list(missing)
    if pair.now is None:
        group = pair.was.wish.group
        known = [m for m in left if m.wish is pair.was.wish or m.wish.group == group]
        if known:
            left.remove(known[0])
    return left


def _pair_groups(
    before: Sequence[FurnishedGroup], placed: Sequence[FurnishedGroup]
) -> tuple[list[Pair], tuple[FurnishedGroup, ...]]:
    """Each group as it was with the nearest of its function now, which takes its name; and groups
    that are new."""
    left = list(placed)
    now: dict[int, FurnishedGroup] = {}
    for k, was in enumerate(before):
        same = [p for p in left if p.pieces == was.pieces]
        if same:
            now[k] = was
            left = [p for p in left if p is not same[0]]
    for k, was in enumerate(before):
        alike = [p for p in left if k not in now and _alike(was, p)]
        if alike:
            nearest = min(alike, key=lambda p: _apart(was, p))
            left = [p for p in left if p is not nearest]
            now[k] = _keep_name(nearest, was)
    return [Pair(was, now.get(k)) for k, was in enumerate(before)], tuple(left)


def _alike(was: FurnishedGroup, now: FurnishedGroup) -> bool:
    return now.wish.group in (was.wish.group, FALLBACK.get(was.wish.group))


def _apart(one: FurnishedGroup, other: FurnishedGroup) -> float:
    return float(np.hypot(*(one.dressed.box[:2] - other.dressed.box[:2])))


def _keep_name(now: FurnishedGroup, was: FurnishedGroup) -> FurnishedGroup:
    """A group under the name it had, where it is the same function."""
    old, new = now.pieces[0].group, was.pieces[0].group
    if old == new or now.wish.group != was.wish.group:
        return now

    def name(wanted: str) -> str:
        return new + wanted[len(old) :] if wanted.startswith(f"{old}/") else wanted

    pieces = tuple(
        replace(p, id=name(p.id), group=new, on=None if p.on is None else name(p.on))
        for p in now.pieces
    )
    return now._replace(name=was.name, pieces=pieces)
