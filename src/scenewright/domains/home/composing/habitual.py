"""Rooms whose free floor and fullness were learned, brought nearer to that once furnished.

The search weighs what was learned among all else and stops at what its steps find. Here each group
is tried along all walls, in sizes that bring the furnished share nearer to the learned one, beside
all others as they stand; what makes such rooms is left as it was learned.
"""

from __future__ import annotations

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.build_problem import select_allowed
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.judging import Placed, judge_of, share_of
from scenewright.domains.home.composing.places.trials import take_first, try_forms
from scenewright.domains.home.learned.density import footing


def keep_habits(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with its groups moved, and taken in other sizes, where the room so costs less."""
    rule = task.preset.settings.composing
    judge = judge_of(task, answer.placed)
    best = judge.cost_of(answer.placed)
    for _ in range(rule.rounds):
        before = best.cost
        for at in range(len(best.placed)):
            if not task.cancelled():
                forms = _list_forms(task, best.placed, best.placed[at])
                found = try_forms(judge, best.placed, at, forms, len(forms))
                best = take_first(task, best, found, barred)
        if best.cost > before - rule.least:
            break
    return answer._replace(placed=best.placed)


def _list_forms(task: RoomTask, placed: Placed, group: FurnishedGroup) -> list[Group]:
    """The form a group has, and those with which the room is nearer to the learned share."""
    now, own = share_of(task, placed), group.dressed.case
    known, fits = cases(group.wish.group, task.library), select_allowed(group.wish, task.library)

    if task.share is None:
        return [own]
    wanted = task.share

    def off(case: Group) -> float:
        more = (footing(case) - footing(own)) / task.ground.area
        return abs(now + more - wanted)

    usual = [form for form, fit in zip(known.groups, fits, strict=True) if fit]
    nearer = [form for form in usual if off(form) < off(own) - 1e-6]
    return [own, *sorted(nearer, key=off)]
