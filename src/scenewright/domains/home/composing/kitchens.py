"""Kitchens that are put together otherwise: the fridge by itself, or all of it round a corner."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from scenewright.domains.home.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.forms import cost_of_case, list_forms
from scenewright.domains.home.composing.judging import RUNS, JudgedRoom, Placed, judge_of
from scenewright.domains.home.composing.moving import make_unplaced, take_best, try_forms
from scenewright.domains.home.programme import Wish

TRIED, KEPT = 4, 2
"""Forms tried of a run, and of these those beside which a fridge is looked a place for."""


def reform_kitchen(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with a faulty kitchen put together otherwise, or as they were: a run with its
    fridge becomes a longer worktop and a fridge by itself, and the other way round."""
    run = next((p for p in best.placed if p.wish.group in RUNS), None)
    rule = task.preset.settings.composing
    if run is None or task.library.own or not cost_of_case(run.dressed.case, 0.0, rule):
        return best
    if run.wish.required or run.wish.most or task.cancelled():
        return best
    rest = tuple(p for p in best.placed if p.wish.group not in (*RUNS, "fridge"))
    if len(best.placed) - len(rest) > 2:
        return best
    return take_best(task, best, _reform(task, rest, run), barred)


def _reform(task: RoomTask, rest: Placed, run: FurnishedGroup) -> list[JudgedRoom]:
    """The kitchen put together either way beside the ``rest``."""
    return [*_whole(task, rest, run), *_apart(task, rest, run)]


def _whole(task: RoomTask, rest: Placed, run: FurnishedGroup) -> Iterator[JudgedRoom]:
    """Runs with their fridge."""
    whole = run._replace(wish=run.wish._replace(group="kitchen"), name="kitchen")
    placed = (*rest, whole)
    yield from try_forms(judge_of(task, placed), placed, len(rest), list_forms(task, whole), TRIED)


def _apart(task: RoomTask, rest: Placed, run: FurnishedGroup) -> Iterator[JudgedRoom]:
    """Runs without, and a fridge by itself."""
    bare = run._replace(wish=run.wish._replace(group="kitchenette"), name="kitchenette")
    placed = (*rest, bare)
    judge = judge_of(task, placed)
    fridges = cases("fridge", task.library).groups
    fridge = make_unplaced(task, rest, Wish("fridge", 0, small=True), fridges[0])
    both = judge_of(task, (*placed, fridge))
    for judged in islice(try_forms(judge, placed, len(rest), list_forms(task, bare), TRIED), KEPT):
        whole = (*judged.placed, fridge)
        yield from try_forms(both, whole, len(placed), fridges, len(fridges))[:1]
