"""Kitchens of a layout that is given: of one round corners a layout tells the line with the hob."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, inf

from scenewright.core.layout import NamedBox
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.judging import find_run
from scenewright.domains.home.composing.kitchens.reform import list_fitted, may_reform
from scenewright.domains.home.composing.places.moving import make_unplaced

KITCHEN = "kitchen"


def refit_kitchen(task: RoomTask, answer: RoomAnswer, rows: Sequence[NamedBox]) -> RoomAnswer:
    """The answer with the kitchen whose patch holds no run, or is shorter than any, made to
    measure, its hob as near to that patch as can be; as it was where none stands free."""
    row = next((row for row in rows if row.name == KITCHEN), None)
    known = cases(KITCHEN, task.library)
    lost = [m for m in answer.missing if m.wish.group == KITCHEN]
    if row is None or (row.box[3] >= min(case.width for case in known.groups) and not lost):
        return answer
    placed = find_run(answer.placed)
    rest = tuple(p for p in answer.placed if p not in placed)
    wish = next(iter([*(p.wish for p in placed), *(m.wish for m in lost)]), None)
    if wish is None:
        return answer
    run = make_unplaced(task, rest, wish, known.groups[known.smallest])
    if not may_reform(task, (*rest, run)):
        return answer
    barred = frozenset(find_blocked(task, rest))
    steps = list_fitted(task, rest, run, barred)
    found = [judged for step in steps for judged in step(inf)]
    if not found:
        return answer
    x, y = row.box[:2]
    boxes = [judged.placed[-1].dressed.box for judged in found]
    away = [round(hypot(box[0] - x, box[1] - y), 2) for box in boxes]
    best = min(range(len(found)), key=lambda k: (away[k], found[k].cost))
    missing = tuple(m for m in answer.missing if m not in lost)
    return answer._replace(placed=found[best].placed, missing=missing)
