"""Bedrooms of a finished home with a narrow wardrobe or a bed for two with one side, tried again.

Rooms are furnished one by one on a grid that is stricter than the walk through the whole home; what
finds no way on it comes back in the least forms, wherever it fits. So once all rooms stand, a bed
and a wardrobe with a fault are placed together once more, beside all else, in the smaller of their
sound forms, the bed no smaller than it is. A change stays if the whole home, its ways opened, costs
less.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, islice

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.clothes import CHEST
from scenewright.domains.home.composing.forms import list_forms
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.kitchens.mend import cost_of_home
from scenewright.domains.home.composing.pairs import find_pair, furnish_pairs
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.measures import HAIR, NARROWER
from scenewright.domains.home.second_try import Opened

WALKED, TRIED = 40, 3
"""Pairs of places walked past in their room, and of these those through the whole home."""
FAULTS = frozenset(("wardrobe", "one_side"))
"""What makes a pair one to be tried again."""
LEAST_BED = (0.8, 1.9)
"""No bed becomes smaller than this, or than it is, metres."""


def mend_bedrooms(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with bed and wardrobe placed anew where either has one of
    :data:`FAULTS`, their ways ``opened``."""
    found = answers
    for room, task in enumerate(tasks):
        pair = _find_faulty(task, found[room].placed)
        if pair and not task.cancelled():
            found = _mend(room, task, pair, found, opened)
    return found


def _find_faulty(task: RoomTask, placed: Placed) -> Placed:
    """The bed and the wardrobe of a room, or the chest of drawers that stands for it, if either has
    such a fault and both may be changed."""
    pair = find_pair(placed) or find_pair(placed, CHEST)
    own = task.library.own.keys() or task.accessible or not task.preset.settings.exact
    if not pair or own or any(p.wish.required or p.wish.most for p in pair):
        return ()
    return pair if any(FAULTS & _faults_of(list_standing(group)) for group in pair) else ()


def _faults_of(case: Group) -> set[str]:
    return {name for name, _ in find_case_faults(case)}


def _mend(
    room: int, task: RoomTask, pair: Placed, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with the pair of one room at the first places that leave the home cheaper."""
    worth = cost_of_home(room, task, found) - task.preset.settings.composing.least
    rest = tuple(p for p in found[room].placed if all(p is not q for q in pair))
    for placed in islice(_list_open(task, pair, rest), TRIED):
        answer = found[room]._replace(placed=placed)
        trial = [answer if k == room else other for k, other in enumerate(found)]
        if cost_of_home(room, task, trial) < worth:
            trial = opened(trial)
            if cost_of_home(room, task, trial) < worth:
                return trial
    return found


def _list_open(task: RoomTask, pair: Placed, rest: Placed) -> Iterator[Placed]:
    """Those of the pairs that bar nothing more than now on a grid with narrower ways."""
    width, use = task.route_width - NARROWER, task.use_width - NARROWER
    narrow = task._replace(route_width=width, use_width=use)
    barred = frozenset(find_blocked(narrow, (*rest, *pair)))
    for placed in islice(_list_pairs(task, pair, rest), WALKED):
        if bars_no_more(narrow, placed, barred):
            yield placed


def _list_pairs(task: RoomTask, pair: Placed, rest: Placed) -> Iterator[Placed]:
    """The groups of a room with the pair at other places beside the rest, the cheapest first."""
    beside = task._replace(beside=(*task.beside, *(p for group in rest for p in group.pieces)))
    judge = judge_of(beside, pair)
    most = judge.cost_of(pair).cost - task.preset.settings.composing.least
    for judged in furnish_pairs(judge, pair, most, _list_forms):
        yield (*rest, *judged.placed)


def _list_forms(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    """The sound forms of a wardrobe or a chest, the smaller first, those of a bed that are no
    smaller than it is."""
    forms = sorted(list_forms(task, group), key=lambda form: form.width * form.depth)
    least = LEAST[group.wish.group]() if group.wish.group in LEAST else ()
    if group.wish.group not in BED_GROUPS:
        yield from (form for form in (*least, *forms) if not FAULTS & _faults_of(form))
        return
    wide, deep = (min(pair) for pair in zip(_size_of(group.dressed.case), LEAST_BED, strict=True))
    for form in chain(least, forms):
        width, depth = _size_of(form)
        sound = not FAULTS & _faults_of(form)
        if sound and width > wide - HAIR and depth > deep - HAIR:
            yield form


def _size_of(case: Group) -> tuple[float, float]:
    """Width and length of the bed of a case, metres."""
    bed = next(m for m in case.members if m.category.endswith("_bed"))
    return bed.size.width, bed.size.depth
