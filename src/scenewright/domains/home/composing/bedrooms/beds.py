"""Beds for two instead of a single one that was given for want of room."""

from __future__ import annotations

from heapq import merge
from itertools import islice
from math import inf

from scenewright.domains.home.attempts.attempt import RoomTask, floor_of
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.anew import (
    follow,
    follow_pairs,
    judge_in_order,
    list_starts,
)
from scenewright.domains.home.composing.judging import JudgedRoom, judge_of
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import make_unplaced
from scenewright.domains.home.composing.places.trials import take_first, try_forms
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.programme import resolve_bedrooms
from scenewright.domains.home.wished.beds import list_wished_beds

DOUBLE, SINGLE = "sleeping", "single"


def restore_double_bed(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with a double bed for the single one, where the room is for two and holds it."""
    beds = [p for p in best.placed if p.wish.group in BED_GROUPS]
    if [p.wish.group for p in beds] != [SINGLE] or not wants_double_bed(task):
        return best
    rest = tuple(p for p in best.placed if p is not beds[0])
    case = cases(DOUBLE, task.library).groups[0]
    wish = beds[0].wish._replace(group=DOUBLE, small=False)
    bed = make_unplaced(task, rest, wish, case)
    whole, rule = (*rest, bed), task.preset.settings.composing
    forms = list_forms(task, bed)
    found = try_forms(judge_of(task, whole), whole, len(rest), forms, rule.forms)
    worth = best._replace(cost=best.cost + task.costs.fallback)
    paired = list(islice(follow_pairs(task, whole, barred, worth.cost, inf), rule.starts))
    others = sorted(rest, key=lambda p: (p.wish.rank, -float(p.dressed.box[3:].prod())))
    judges, starts = judge_in_order(task, (bed, *others)), list_starts(task, bed, barred)
    anew = (follow(task, judges, start, others, barred, inf) for start in starts)
    laid = sorted([*paired, *(room for room in anew if room)], key=lambda j: j.cost)
    better = take_first(task, worth, merge(found, laid, key=lambda j: j.cost), barred)
    return best if better is worth else better


def wants_double_bed(task: RoomTask) -> bool:
    """Whether two are to sleep in a room: by what is asked for in it, else by its size."""
    ask = task.asked.ask if task.asked else None
    if "double_bed" in task.forbidden:
        return False
    if ask is not None:
        asked = {one.group for one in ask if one.count}
        return DOUBLE in asked and SINGLE not in asked
    if task.asked and (wished := list_wished_beds(task.asked)):
        return DOUBLE in wished
    return "double_bedroom" in resolve_bedrooms(task.space.functions, floor_of(task.ground))
