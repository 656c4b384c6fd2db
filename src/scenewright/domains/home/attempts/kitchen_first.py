"""A mini kitchen alone, before all else, in a kitchen that would end without sink and hob.

In a hall that is cooked in, one niche or stretch of wall holds a run, and a cabinet for shoes or a
chest fits there as well. A kitchen without a hob is none: where no run stands when all else was
tried, a mini kitchen is put down first, the widest that leaves the ways open; the rest follows. One
without a fridge is better than none; the fridge is then looked for with the rest.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, islice, pairwise
from math import cos, sin

from scenewright.catalog.classes import RUN
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.attempts.bed_first import list_placed, with_narrow_ways
from scenewright.domains.home.attempts.systematic import answer_of, place_rest
from scenewright.domains.home.composing.case_faults import ONE_LINE
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.groups.mini_kitchens import mini_kitchens
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.programme import Wish

FRIDGE = "fridge"
KITCHEN = (*RUNS, FRIDGE)
PLACES = 24
"""How many places of one form are walked past."""


def list_kitchens_first(
    task: RoomTask, wishes: tuple[Wish, ...], before: RoomAnswer
) -> Iterator[RoomAnswer]:
    """Layouts of the kitchen that is lacking, the wider forms first, each in one place that bars
    nothing further on a grid with narrower ways: beside what else is essential, else before
    it. All other ``wishes`` are missing, and the fridge where the form has none."""
    wish = _find_lacking(task, before)
    if wish is None:
        return
    others = tuple(p for p in before.placed if p.wish.group not in KITCHEN)
    for placed in _list_layouts(with_narrow_ways(task), others, wish):
        yield _answer_with(task, placed, wishes, wish)


def _list_layouts(task: RoomTask, others: Placed, wish: Wish) -> Iterator[Placed]:
    """Mini kitchens beside what is essential of the ``others``, if there is none beside what the
    room fails without, else before it."""
    essential = tuple(p for p in others if p.wish.rank == 0)
    core = tuple(p for p in essential if p.wish.core)
    for stays in (essential, core) if len(core) < len(essential) else (core,):
        found = _list_beside(task, stays, wish)
        first = next(found, None)
        if first is not None:
            yield from chain((first,), found)
            return
    yield from _list_before(task, core, wish)


def has_gap(answer: RoomAnswer) -> bool:
    """Whether a run along one wall has lost a unit between others."""
    return any(_has_gap(group) for group in answer.placed if group.wish.group in RUNS)


def _has_gap(run: FurnishedGroup) -> bool:
    units = [p for p in run.pieces if p.category in RUN and p.pose.z < RAISED]
    if len({round(p.pose.heading, 3) for p in units}) != 1:
        return False
    s, c = sin(units[0].pose.heading), cos(units[0].pose.heading)
    ends = sorted((p.pose.x * s - p.pose.y * c, p.size.width / 2) for p in units)
    return any(b - a > half + more + ONE_LINE for (a, half), (b, more) in pairwise(ends))


def _list_before(task: RoomTask, others: Placed, wish: Wish) -> Iterator[Placed]:
    """Each mini kitchen in its first place, the ``others`` in their least forms beside it."""
    rest = tuple(p.wish for p in others)
    for placed in _list_beside(task, (), wish) if others else ():
        followed = place_rest(task, placed, rest)
        if followed is not None:
            yield followed


def _list_beside(task: RoomTask, stays: Placed, wish: Wish) -> Iterator[Placed]:
    """Each mini kitchen in the first of its places beside what ``stays`` that bars nothing
    further."""
    barred = frozenset(find_blocked(task, stays))
    for case in mini_kitchens():
        form = wish._replace(group=case.function, small=True)
        found = ((*stays, run) for run in islice(list_placed(task, stays, form, case), PLACES))
        yield from islice((p for p in found if bars_no_more(task, p, barred)), 1)


def _find_lacking(task: RoomTask, before: RoomAnswer) -> Wish | None:
    """The run that a kitchen lacks; None where it lacks none, or a size of its own is wanted."""
    lacking = [m.wish for m in before.missing if m.wish.core and m.wish.group in RUNS]
    own = task.library.own.keys() & set(KITCHEN)
    if not lacking or lacking[0].most is not None or lacking[0].required or own:
        return None
    return None if task.accessible else lacking[0]


def _answer_with(
    task: RoomTask, placed: Placed, wishes: tuple[Wish, ...], wish: Wish
) -> RoomAnswer:
    """The answer that a kitchen and others make, its fridge missing where there is none."""
    answer = answer_of(task, placed, wishes)
    if any(piece.category == FRIDGE for group in placed for piece in group.pieces):
        return answer
    cold = wish._replace(group=FRIDGE, small=True, core=False)
    lost = Missing(cold, "no room is left beside the rest")
    score = answer.score + task.costs.missing[cold.rank]
    return answer._replace(missing=(*answer.missing, lost), score=score)
