"""Short second runs that stand apart from their kitchen when a home is done, moved to its side.

One or two cabinets by themselves are no place to work at: beside the run they lengthen its worktop.
They change places with the pieces there; where they cannot, they stay, but for a single cabinet,
which is left out where the run has worktop enough without it.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomAnswer, RoomTask
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import Placed, find_run, judge_of
from scenewright.domains.home.composing.kitchens.second_runs import SECOND, is_spare
from scenewright.domains.home.composing.kitchens.trades import list_at_run, list_traded
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.groups.kitchen import short_counters
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.programme import WELCOME
from scenewright.domains.home.rules.kitchen import SECOND_AWAY
from scenewright.domains.home.rules.weigh_home import compile_table, list_faults

SHORT_RUN = 1.45  # a second run no longer than this belongs to the first, metres
WORTH = 10.0  # what a room may cost more for it
SINGLE = 0.61  # what is no wider is a single cabinet, metres
REASON = "a single cabinet away from the kitchen is of little use"


def list_joined(task: RoomTask, before: RoomAnswer, _: str) -> Iterator[RoomAnswer]:
    """The room with a short second run beside the first, the cheapest first, at last without it
    where it is a single cabinet that the kitchen can spare."""
    for group in list_loose(before.placed):
        yield from _list_joined(task, before, group)
        if _measure(group) < SINGLE and not _lacks_worktop(before.placed):
            yield _without(before, group)


def list_loose(placed: Placed) -> Placed:
    """Short second runs that nobody asked for and that stand at no side of the first."""
    if not find_run(placed) or not list_faults(compile_table(SECOND_AWAY), placed):
        return ()
    return tuple(p for p in placed if is_spare(p) and _measure(p) <= SHORT_RUN)


def _measure(group: FurnishedGroup) -> float:
    """Metres of a second run that stand."""
    low = (p for p in group.pieces if p.pose.z < RAISED)
    return sum(p.size.width for p in low)


def _lacks_worktop(placed: Placed) -> bool:
    """Whether the run of a kitchen has too little worktop in one piece."""
    return any("worktop" in dict(find_case_faults(list_standing(p))) for p in find_run(placed))


def _without(answer: RoomAnswer, group: FurnishedGroup) -> RoomAnswer:
    rest = tuple(p for p in answer.placed if p is not group)
    welcome = group.wish._replace(rank=WELCOME, core=False)
    missing = (*answer.missing, Missing(welcome, REASON))
    return answer._replace(placed=rest, missing=missing)


def _list_joined(task: RoomTask, before: RoomAnswer, group: FurnishedGroup) -> Iterator[RoomAnswer]:
    """The room with a second run beside the first at little more cost, the cheapest first."""
    most = judge_of(task, before.placed).cost_of(before.placed).cost + WORTH
    moves = list_at_run(task, before.placed, group, _list_as_long(group))
    rooms = [
        (judge_of(task, placed).cost_of(placed).cost, k, placed, gone)
        for k, (placed, gone) in enumerate(list_traded(task, before.placed, moves, most))
    ]
    for _, _, placed, gone in sorted(rooms, key=lambda row: row[:2]):
        yield before._replace(placed=placed, missing=(*before.missing, *gone))


def _list_as_long(group: FurnishedGroup) -> tuple[Group, ...]:
    """The form of a second run, or the shortest that is as long as its placed pieces."""
    long = _measure(group)
    if list_standing(group) == group.dressed.case:
        return (group.dressed.case,)
    forms = (*short_counters(), *cases(SECOND).groups)
    return tuple(sorted((f for f in forms if f.width >= long - 1e-6), key=lambda f: f.width)[:1])
