"""Groups of a finished home that stand too near to others, moved along the walls until they do not.

While a room is composed what a group costs is weighed against all else, and few of its places are
tried. What still stands too near to something by the end (:mod:`.rules`) is tried once more, beside
all else as it stands by then: either of the two groups, in its form or one hardly smaller, wherever
along the walls faults of composition grow by less than is gained, no wish that was met is given up,
nothing is lost and no way of the home is barred.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import chain, islice

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.bed_first import with_narrow_ways
from scenewright.domains.home.composing.bed_sides import count_closed_beds
from scenewright.domains.home.composing.doorways import HOLDING
from scenewright.domains.home.composing.forms import list_forms
from scenewright.domains.home.composing.judging import (
    Placed,
    RoomJudge,
    count_unmet,
    judge_of,
    sum_faults,
)
from scenewright.domains.home.composing.placed_faults import measure_before_doors
from scenewright.domains.home.composing.settling import try_in_home
from scenewright.domains.home.composing.spacing.leave_out import leave_out_near, may_leave_out
from scenewright.domains.home.composing.spacing.making_room import (
    MUCH,
    list_hindered,
    list_without_one,
)
from scenewright.domains.home.composing.spacing.rules import list_close, measure_closeness
from scenewright.domains.home.composing.spacing.shifts import list_shifted
from scenewright.domains.home.composing.views import is_unseen
from scenewright.domains.home.composing.walked_places import try_places
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.programme import WELCOME
from scenewright.domains.home.second_try import Opened

ORDER = (
    *("chest", "sideboard", "reading", "shelf", "storage", "console", "plant", "shoes", "coats"),
    *("wardrobe", "media", "fridge", "dining", "dining_wall", "seating"),
    *("single", "bunk", "sleeping"),
)
"""Groups that may be moved, those first that are moved easily."""
STEP = 0.05  # between places along a wall, metres
WORTH = 3.0  # what a room may cost more by its energy for each unit that stands less near
FAULTS = 0.7  # and by how much what is wrong with it otherwise may rise for that
LEAST_GAIN = 1.0  # what is gained at least, by energy if not by distance
CUT, HALF = 0.75, 0.5  # of its width a group keeps at least so much, and one for shoes
KEPT = HOLDING - {"wardrobe"}
"""What keeps all of its width; of a wardrobe that cannot be opened that is no loss."""
WALKED = 4  # rooms that are walked through with their home, for each group
ROUNDS = 3
SEATING, STRAIGHT = "seating", {"corner_sofa": "sofa"}
"""Groups whose sofa may be a straight one instead."""
WATCHED = frozenset(("media", SEATING))
"""What is not moved to where a screen is out of sight."""
SPARE = frozenset(("plant",))
"""What stands on a group and may be lost for it."""
STUCK = 5.0
"""What it costs at least that a chair can hardly be drawn back; a table loses one for that."""
CHAIR, FEWER = "dining_chair", "a chair less stands at it: it could not be drawn back"


def keep_distances(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for all rooms with groups that stood too near to others elsewhere, the ways of
    the home ``opened``."""
    found = answers
    for room, task in enumerate(tasks):
        if task.preset.settings.exact and not task.accessible and not task.cancelled():
            for _ in range(ROUNDS):
                before = found
                found = _spread(room, task, found, opened)
                if found is before:
                    break
            less = leave_out_near(task, found[room])
            found = [less if k == room else other for k, other in enumerate(found)]
    return found


def _spread(room: int, task: RoomTask, found: list[RoomAnswer], opened: Opened) -> list[RoomAnswer]:
    """The answers with one group of a room moved, at last one for which another makes room; as they
    were where none finds a place."""
    answer = found[room]
    most = chain(_list_moves(task, answer), _list_with_room(task, answer))
    trials = chain(most, _list_with_fewer(task, answer))
    tried = (try_in_home(room, answer, found, opened) for answer in trials)
    return next((trial for trial in tried if trial is not None), found)


def _list_moves(task: RoomTask, answer: RoomAnswer) -> Iterator[RoomAnswer]:
    """The answer with a group that stands too near to others elsewhere."""
    for name in _list_movable(task, answer.placed):
        yield from (answer._replace(placed=p) for p in _list_elsewhere(task, answer.placed, name))


def _list_with_room(task: RoomTask, answer: RoomAnswer) -> Iterator[RoomAnswer]:
    """The answer with a group elsewhere for which another made room, if that is worth it."""
    if not may_leave_out(task):
        return
    placed, movable = answer.placed, _list_movable(task, answer.placed)
    most = _measure(task, placed) - MUCH
    for name in list_hindered(placed, list_close(placed, task.fixed, task.ground)):
        for rest, lost in list_without_one(task, placed, name) if name in movable else ():
            missing = (*answer.missing, lost)
            for other in _list_elsewhere(task, rest, name):
                if _measure(task, other) <= most:
                    yield answer._replace(placed=other, missing=missing)


def _list_with_fewer(task: RoomTask, answer: RoomAnswer) -> Iterator[RoomAnswer]:
    """The answer with one chair less at a table one of whose chairs can hardly be drawn back, or a
    straight sofa where one round a corner stands too near to something."""
    if not may_leave_out(task):
        return
    close = list_close(answer.placed, task.fixed, task.ground)
    stuck = {pair.group for pair in close if pair.cost >= STUCK}
    for p in answer.placed:
        if p.wish.group == SEATING and p.name in stuck:
            found = _list_elsewhere(task, answer.placed, p.name, 1)
            yield from (answer._replace(placed=other) for other in found)
        if p.wish.group in TABLES and p.name in stuck:
            lost = Missing(p.wish._replace(rank=WELCOME, core=False, required=False), FEWER)
            missing = (*answer.missing, lost)
            found = _list_elsewhere(task, answer.placed, p.name, 1)
            yield from (answer._replace(placed=other, missing=missing) for other in found)


def _list_elsewhere(task: RoomTask, placed: Placed, name: str, fewer: int = 0) -> Iterator[Placed]:
    """The groups of a room with the one of that name elsewhere, with so many chairs fewer, few of
    many places."""
    at = next(i for i, p in enumerate(placed) if p.name == name)
    yield from islice(_list_apart(task, placed, at, fewer), WALKED)


def _list_movable(task: RoomTask, placed: Placed) -> list[str]:
    """The names of whole groups that stand too near to others and may stand elsewhere."""
    close = list_close(placed, task.fixed, task.ground)
    names = {name for pair in close for name in (pair.group, pair.other)}
    whole = [p for p in placed if p.name in names and len(p.pieces) == sum(p.dressed.stands)]
    free = [p for p in whole if p.wish.group in ORDER and p.wish.group not in task.library.own]
    return [p.name for p in sorted(free, key=lambda p: ORDER.index(p.wish.group))]


def _list_apart(task: RoomTask, placed: Placed, at: int, fewer: int) -> Iterator[Placed]:
    """The groups of a room with one of them where less stands too near, the best first, where that
    bars no further way."""
    judge, now = judge_of(task, placed), _measure(task, placed)
    before, faults = judge.cost_of(placed).cost, sum_faults(task, placed)
    doors, unmet = measure_before_doors(placed[at], task.ground), count_unmet(task, placed)
    rooms, closed = list[tuple[float, Placed]](), count_closed_beds(placed, task.ground)
    for other, cost in _list_moved(judge, placed, at, fewer, before + WORTH * now):
        gain = now - _measure(task, other)
        worth = gain + max(before - cost, 0.0) / WORTH
        if gain < 0.0 or worth <= LEAST_GAIN or cost - before >= WORTH * gain:
            continue
        if measure_before_doors(other[at], task.ground) > doors + HAIR:
            continue
        if count_unmet(task, other) > unmet or _hides_screen(task, other, placed, at):
            continue
        if count_closed_beds(other, task.ground) > closed:
            continue
        if sum_faults(task, other) - faults < FAULTS * gain:
            rooms.append((cost - WORTH * gain, other))
    narrow = with_narrow_ways(task)  # the home tells exactly
    barred = frozenset(find_blocked(narrow, placed)) if rooms else frozenset()
    for other in _take_turns(sorted(rooms, key=lambda row: row[0]), at):
        if bars_no_more(narrow, other, barred):
            yield other


def _hides_screen(task: RoomTask, other: Placed, placed: Placed, at: int) -> bool:
    """Whether nobody sees a screen any more once it, or its seats, are elsewhere."""
    edges = task.ground.edges
    watched = placed[at].wish.group in WATCHED and is_unseen(other, edges)
    return watched and not is_unseen(placed, edges)


def _measure(task: RoomTask, placed: Placed) -> float:
    return measure_closeness(placed, task.fixed, task.ground)


def _take_turns(rooms: Sequence[tuple[float, Placed]], at: int) -> list[Placed]:
    """The rooms, the best first, but each with its group number ``at`` in another form before any
    in the same once more."""
    seen, turns = Counter[Group](), list[tuple[int, Placed]]()
    for _, other in rooms:
        seen[other[at].dressed.case] += 1
        turns.append((seen[other[at].dressed.case], other))
    return [other for _, other in sorted(turns, key=lambda turn: turn[0])]


def _list_moved(
    judge: RoomJudge, placed: Placed, at: int, fewer: int, most: float
) -> Iterator[tuple[Placed, float]]:
    """The rooms with a group elsewhere along the walls, or not far from where it is amid the floor,
    that cost at most so much, and what each costs."""
    forms = list(_list_like(judge.task, placed[at], fewer))
    along = try_places(judge, placed, at, forms, most, 0.0, STEP)
    for judged in chain(along, () if fewer else list_shifted(judge, placed, at, most)):
        yield judged.placed, judged.cost


def _list_like(task: RoomTask, group: FurnishedGroup, fewer: int = 0) -> Iterator[Group]:
    """The form of a group, then those that hold as much or hardly less; only those with so many
    chairs ``fewer``, or a sofa without its corner, if any are."""
    now = group.dressed.case
    if not fewer:
        yield now
    for form in list_forms(task, group):
        if form != now and _holds(form, now, fewer):
            yield form


def _holds(form: Group, now: Group, fewer: int = 0) -> bool:
    """Whether a form has all that a group has ``now``, a plant on it and so many chairs apart,
    hardly narrower, and no wider but for chairs on other sides of a table."""
    less = _straighten(now) if form.function == SEATING and fewer else _list_kinds(now)
    chairs = [CHAIR] * fewer if form.function in TABLES else []
    if sorted([*_list_kinds(form), *chairs]) != less:
        return False
    share = 1.0 if form.function in KEPT else HALF if form.function == "shoes" else CUT
    least = share * now.width
    return form.width > least - HAIR and (form.function in TABLES or form.width < now.width + HAIR)


def _straighten(form: Group) -> list[str]:
    """What a form is of, a straight sofa instead of one round a corner."""
    return sorted(STRAIGHT.get(kind, kind) for kind in _list_kinds(form))


def _list_kinds(form: Group) -> list[str]:
    return sorted(m.category for m in form.members if m.category not in SPARE)
