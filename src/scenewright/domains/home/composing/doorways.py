"""What stands before a wide door when a home is done, moved along the walls until it does not.

While a room is composed places 0.1 m apart are looked at and of each form a few are tried, so that
something may end a hand's breadth before a sliding door which it would leave free a step aside.
What still stands before one is therefore tried once more, beside all else as it stands by then, at
places that are nearer together; a bed also along the wall, a little smaller if that frees the whole
door. A wardrobe that finds none gives way to a chest of drawers where clothes hang in the closet of
the room (:mod:`.clothes`); a plant that finds none is left out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.composing.clothes import METRE, WARDROBE, hang_instead, list_hung
from scenewright.domains.home.composing.forms import list_forms
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, RoomJudge, judge_of
from scenewright.domains.home.composing.kitchens.mend import cost_of_home
from scenewright.domains.home.composing.moving import with_margin
from scenewright.domains.home.composing.placed_faults import measure_before_doors
from scenewright.domains.home.composing.walked_places import try_places
from scenewright.domains.home.groups.classes import BED_GROUPS, COOKING
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.programme import WELCOME
from scenewright.domains.home.second_try import Opened

STEP = 0.02  # between places along a wall, metres
TRIED = 2  # rooms that are walked through with their home
BED = (0.75, 1.8)
"""No bed becomes smaller than this, or than it is, metres."""
CUT, FULL = 0.8, 1.0
"""What stands along a wall keeps so much of its width, a wardrobe of a metre its metre."""
PLANT = "plant"
"""What is left out where it stands before no less of a wide door elsewhere."""
HOLDING = frozenset((WARDROBE, "chest", "shelf", "storage", "sideboard"))
"""Groups that hold the more the wider they are."""


def clear_doorways(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with each group that stands before a wide door elsewhere, the one
    that takes most of a door first, where the home, its ways ``opened``, costs less."""
    found = answers
    for room, task in enumerate(tasks):
        may = task.preset.settings.exact and not task.accessible
        for name in _list_in_doorways(task, found[room].placed) if may else ():
            if not task.cancelled():
                found = _clear(room, task, name, found, opened)
    return found


def _list_in_doorways(task: RoomTask, placed: Placed) -> list[str]:
    """The names of the whole groups that stand before a wide door and may stand elsewhere."""
    own = task.library.own.keys() | COOKING
    whole = (p for p in placed if len(p.pieces) == sum(p.dressed.stands))
    metres = {
        p.name: measure_before_doors(p, task.ground) for p in whole if p.wish.group not in own
    }
    return sorted((name for name in metres if metres[name] > 0.0), key=lambda n: -metres[n])


def _clear(
    room: int, task: RoomTask, name: str, found: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with one group of a room moved, or as they were; no other may lose anything."""
    before, many = found[room], _count_gone(found)
    worth = cost_of_home(room, task, found) - task.preset.settings.composing.least
    at = next((i for i, p in enumerate(before.placed) if p.name == name), None)
    for placed in _list_open(task, before.placed, at) if at is not None else ():
        gone = (*before.missing, *list_hung(before.placed, placed))
        trial = [*found[:room], before._replace(placed=placed, missing=gone), *found[room + 1 :]]
        trial = opened(trial)
        if cost_of_home(room, task, trial) < worth and _count_gone(trial) == many:
            return trial
    return [_without_plant(answer, name) if answer is before else answer for answer in found]


def _without_plant(answer: RoomAnswer, name: str) -> RoomAnswer:
    """The answer without a plant of this name that nobody asked for: there was no other place."""
    gone = [p for p in answer.placed if p.name == name and _is_spare_plant(p)]
    if not gone:
        return answer
    rest = tuple(p for p in answer.placed if p not in gone)
    missing = (Missing(p.wish, "it would stand before a wide door") for p in gone)
    return answer._replace(placed=rest, missing=(*answer.missing, *missing))


def _is_spare_plant(group: FurnishedGroup) -> bool:
    wish = group.wish
    return wish.group == PLANT and wish.rank >= WELCOME and not wish.required


def _count_gone(answers: Sequence[RoomAnswer]) -> int:
    return sum(len(answer.gone) for answer in answers)


def _list_open(task: RoomTask, placed: Placed, at: int) -> Iterator[Placed]:
    """The groups of a room with one of them elsewhere where that bars no further way: before no
    wide door, then with a chest of drawers for a wardrobe, then before less of one."""
    margin, group = with_margin(task), placed[at]
    barred = frozenset(find_blocked(margin, placed))
    judge = judge_of(task, placed)
    best = judge.cost_of(placed)
    moved = _list_moved(judge, best, at)
    for wholly in (True, False):
        some = (p for p, free in moved if free == wholly)
        yield from islice((p for p in some if bars_no_more(margin, p, barred)), TRIED)
        if wholly and group.wish.group == WARDROBE:
            hung = hang_instead(task, best, barred, group)
            yield from (hung.placed,) if hung is not best else ()


def _list_moved(judge: RoomJudge, best: JudgedRoom, at: int) -> list[tuple[Placed, bool]]:
    """The cheaper rooms in which a group stands before less of a wide door, in a smaller form
    before none, and whether it stands before none."""
    task, group, found = judge.task, best.placed[at], list[tuple[Placed, bool]]()
    most, now = best.cost - task.preset.settings.composing.least, group.dressed.case
    before, forms = measure_before_doors(group, task.ground), list_lasting_forms(task, group)
    metre = METRE if group.wish.group in HOLDING else 0.0
    for judged in try_places(judge, best.placed, at, forms, most, metre, STEP):
        there = judged.placed[at]
        metres = measure_before_doors(there, task.ground)
        if metres == 0.0 or (metres < before and not _is_less(there.dressed.case, now)):
            found.append((judged.placed, metres == 0.0))
    return found


def list_lasting_forms(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    """The forms of a group that hold hardly less than it does, the least ones of it among them."""
    least = LEAST[group.wish.group]() if group.wish.group in LEAST else ()
    given, now = group.wish.most is not None, group.dressed.case
    for form in dict.fromkeys([*(() if given else least), *list_forms(task, group)]):
        if len(form.members) >= len(now.members) and holds_as_much(form, now):
            yield form


def holds_as_much(form: Group, now: Group) -> bool:
    """Whether a form holds as much as a group does ``now``, or hardly less."""
    if form.function in BED_GROUPS:
        pairs = zip(_size_of(form), _size_of(now), BED, strict=True)
        return all(new > min(old, least) - HAIR for new, old, least in pairs)
    if form.function == WARDROBE and form.width < min(now.width, FULL) - HAIR:
        return False
    return form.width > CUT * now.width - HAIR


def _is_less(form: Group, now: Group) -> bool:
    return any(new < old - HAIR for new, old in zip(_size_of(form), _size_of(now), strict=True))


def _size_of(case: Group) -> tuple[float, float]:
    """Width and length of the bed of a case, metres; the width alone of what is no bed."""
    bed = next((m for m in case.members if m.category.endswith("_bed")), None)
    return (bed.size.width, bed.size.depth) if bed else (case.width, 0.0)
