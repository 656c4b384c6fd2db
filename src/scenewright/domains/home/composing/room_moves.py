"""The moves that repair a finished room: what each makes of it for the sake of a row."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import islice

import numpy as np

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    find_blocked,
)
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.composing.bedrooms.clothes import (
    CHEST,
    WARDROBE,
    hang_instead,
    list_hung,
)
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.kitchens.loose_cabinets import list_joined
from scenewright.domains.home.composing.kitchens.remade import list_remade
from scenewright.domains.home.composing.placed_faults import (
    DARK,
    list_adrift,
    list_standing,
    measure_before_doors,
    measure_before_windows,
)
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import make_unplaced
from scenewright.domains.home.composing.places.pairs import find_pair, furnish_pairs
from scenewright.domains.home.composing.places.swapped import swap_along_wall
from scenewright.domains.home.composing.places.walked_places import try_places
from scenewright.domains.home.composing.seats.lounge_places import list_lounges
from scenewright.domains.home.composing.spacing.leave_out import may_leave_out
from scenewright.domains.home.composing.spacing.rules import list_close
from scenewright.domains.home.composing.spacing.shifts import list_shifted
from scenewright.domains.home.composing.verdict import FEWER, STUCK
from scenewright.domains.home.groups.classes import BED_GROUPS, SITTING, TABLES
from scenewright.domains.home.groups.least import LEAST as LEAST_FORMS
from scenewright.domains.home.least_sizes import BED
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.needs.forms import LEAST, list_tables, measure_places
from scenewright.domains.home.programme import WELCOME

MOVED = (
    *("chest", "sideboard", "reading", "shelf", "storage", "console", "plant", "shoes", "coats"),
    *("wardrobe", "media", "fridge", "dining", "dining_wall", "seating"),
    *("single", "bunk", "sleeping"),
)
"""Groups that may be moved, those first that are moved easily."""
STEP = 0.05  # between places along a wall, metres
WORTH = 30.0  # what a room may cost more for what an eye finds
CHAIR = "dining_chair"
PAIRED = frozenset(("wardrobe", "one_side"))
"""Faults of a case that no pair of places is to have."""
SEATED_FROM = 11.0
"""Area in m² from which a living room has seats for three."""
PAIRS, LOUNGES = 40, 40  # pairs of places of two groups that are tried, of screen and seats
UNLIKE = 0.3
"""By how much two places of screen and seats differ, metres and radians."""
Subjects = Callable[[RoomTask, Placed], set[str]]


def list_subjects(task: RoomTask, placed: Placed, row: str) -> list[int]:
    """The numbers of the whole groups at fault by a row that may be moved, those first that are
    moved easily."""
    names = SUBJECTS[row](task, placed)
    own = task.library.own.keys()
    there = [
        k
        for k, p in enumerate(placed)
        if p.name in names
        and p.wish.group in MOVED
        and p.wish.group not in own
        and len(p.pieces) == sum(p.dressed.stands)
    ]
    return sorted(there, key=lambda k: MOVED.index(placed[k].wish.group))


def _list_near(task: RoomTask, placed: Placed) -> set[str]:
    close = list_close(placed, task.fixed, task.ground)
    return {name for pair in close if pair.cost >= STUCK for name in (pair.group, pair.other)}


def _is_of(fault: str) -> Subjects:
    """The groups with a fault of their case."""
    return lambda _, placed: {
        p.name for p in placed if fault in dict(find_case_faults(list_standing(p)))
    }


SUBJECTS: dict[str, Subjects] = {
    "near": _list_near,
    "window": lambda task, placed: {
        p.name for p in placed if (measure_before_windows(p, task.ground) > DARK).any()
    },
    "adrift": lambda task, placed: {p.name for p in placed if list_adrift((p,), task.ground)},
    "door": lambda task, placed: {
        p.name for p in placed if measure_before_doors(p, task.ground) > 0.0
    },
    "wardrobe": _is_of("wardrobe"),
    "seats": lambda task, placed: (
        _is_of("seats")(task, placed) if task.ground.area >= SEATED_FROM else set()
    ),
    "unseen": lambda _, placed: {p.name for p in placed if p.wish.group in SITTING},
    "off axis": lambda _, placed: {p.name for p in placed if p.wish.group in SITTING},
    "one_side": _is_of("one_side"),
    "closed bed": lambda _, placed: {p.name for p in placed if p.wish.group in BED_GROUPS},
}
"""The groups that are at fault by each row."""


def _list_elsewhere(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with one of the groups at fault elsewhere along the walls, the cheapest first."""
    placed = answer.placed
    judge = judge_of(task, placed)
    most = judge.cost_of(placed).cost + WORTH
    for at in list_subjects(task, placed, row):
        forms = dict.fromkeys((placed[at].dressed.case, *list_forms(task, placed[at])))
        for judged in try_places(judge, placed, at, forms, most, 0.0, STEP):
            yield answer._replace(placed=judged.placed)


def _list_swapped(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with one of the groups at fault and another at its wall in each other's place."""
    placed, judge = answer.placed, judge_of(task, answer.placed)
    most = judge.cost_of(placed).cost + WORTH
    own = task.library.own.keys()
    for at in list_subjects(task, placed, row):
        for other, group in enumerate(placed):
            if other == at or group.wish.group not in MOVED or group.wish.group in own:
                continue
            swapped = swap_along_wall(task, placed, at, other)
            if swapped is not None and judge.cost_of(swapped).cost <= most:
                yield answer._replace(placed=swapped)


def _list_amid(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with one of the free-standing groups at fault shifted, for a window also one at
    a wall."""
    placed = answer.placed
    judge = judge_of(task, placed)
    most = judge.cost_of(placed).cost + WORTH
    for at in list_subjects(task, placed, row):
        for judged in list_shifted(judge, placed, at, most, row == "window"):
            yield answer._replace(placed=judged.placed)


def _list_fewer(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with one chair less at a table at fault, which is told."""
    placed = answer.placed
    judge = judge_of(task, placed)
    most = judge.cost_of(placed).cost + WORTH
    for at in list_subjects(task, placed, row) if may_leave_out(task) else ():
        group = placed[at]
        if measure_places(group.pieces) <= LEAST:
            continue
        wish = group.wish._replace(rank=WELCOME, core=False, required=False)
        less = sorted(_list_kinds(group.dressed.case))
        forms = (
            form for form in list_forms(task, group) if sorted([*_list_kinds(form), CHAIR]) == less
        )
        missing = (*answer.missing, Missing(wish, FEWER))
        for judged in try_places(judge, placed, at, forms, most, 0.0, STEP):
            yield answer._replace(placed=judged.placed, missing=missing)


def _list_other_tables(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with as many places at a table of the other kind: at a wall, or free of it."""
    placed = answer.placed
    for at in list_subjects(task, placed, row):
        old = placed[at]
        if old.wish.group not in TABLES or old.wish.required or old.wish.most:
            continue
        rest, (other,) = (*placed[:at], *placed[at + 1 :]), TABLES - {old.wish.group}
        places = measure_places(old.pieces)
        forms = [form for form in list_tables(places) if form.function == other]
        if not forms or task.library.own or (task.asked is not None and task.asked.ask is not None):
            continue
        whole = (*rest, make_unplaced(task, rest, old.wish._replace(group=other), forms[0]))
        most = judge_of(task, placed).cost_of(placed).cost + WORTH
        for judged in try_places(judge_of(task, whole), whole, len(rest), forms, most, 0.0, STEP):
            yield answer._replace(placed=judged.placed)


def _list_kinds(form: Group) -> Iterator[str]:
    return (m.category for m in form.members)


def _list_pairs(task: RoomTask, answer: RoomAnswer, _: str) -> Iterator[RoomAnswer]:
    """The room with its bed and its wardrobe, or chest of drawers, at other pairs of places."""
    placed, own = answer.placed, task.library.own
    pair = find_pair(placed) or find_pair(placed, CHEST)
    stays = (p.wish.group in own or p.wish.most or p.wish.required for p in pair)
    if not pair or any(stays):
        return
    rest = tuple(p for p in placed if all(p is not q for q in pair))
    beside = task._replace(beside=(*task.beside, *(p for group in rest for p in group.pieces)))
    judge = judge_of(beside, pair)
    most = judge.cost_of(pair).cost + WORTH
    for judged in islice(furnish_pairs(judge, pair, most, _list_sound), PAIRS):
        yield answer._replace(placed=(*rest, *judged.placed))


def _list_sound(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    """The forms of a group without a fault that makes a pair of places one to be tried again, the
    smaller first, those of a bed that are hardly smaller than it is."""
    forms = sorted(list_forms(task, group), key=lambda form: form.width * form.depth)
    least = LEAST_FORMS[group.wish.group]() if group.wish.group in LEAST_FORMS else ()
    now = [min(size) for size in zip(_size_of(group.dressed.case), BED[:2], strict=True)]
    for form in (*least, *forms):
        sound = not PAIRED.intersection(dict(find_case_faults(form)))
        pairs = zip(_size_of(form), now, strict=True)
        if sound and all(new > old - HAIR for new, old in pairs):
            yield form


def _size_of(case: Group) -> tuple[float, float]:
    """Width and length of the bed of a case, metres; 0 without one."""
    beds = (m.size for m in case.members if m.category.endswith("_bed"))
    return next(((size.width, size.depth) for size in beds), (0.0, 0.0))


def _list_lounges(task: RoomTask, answer: RoomAnswer, _: str) -> Iterator[RoomAnswer]:
    """The room with its screen and its seats placed as one, beside all else."""
    placed, own = answer.placed, task.library.own
    pair = tuple(p for name in sorted(SITTING) for p in placed if p.wish.group == name)
    stays = (p.wish.group in own or p.wish.most or p.wish.required for p in pair)
    if len(pair) != len(SITTING) or any(stays):
        return
    rest = tuple(p for p in placed if all(p is not q for q in pair))
    beside = task._replace(beside=(*task.beside, *(p for group in rest for p in group.pieces)))
    seen = set[tuple[float, ...]]()
    for judged in list_lounges(judge_of(beside, pair), pair):
        boxes = np.array([p.dressed.box[:3] for p in judged.placed])
        like = tuple((boxes / UNLIKE).round().ravel().tolist())
        if like not in seen and len(seen) < LOUNGES:
            seen.add(like)
            yield answer._replace(placed=(*rest, *judged.placed))


def _list_exchanged(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with a chest of drawers for a wardrobe at fault, where clothes hang in its
    closet."""
    placed = answer.placed
    for at in list_subjects(task, placed, row):
        if placed[at].wish.group == WARDROBE:
            best = judge_of(task, placed).cost_of(placed)
            barred = frozenset(find_blocked(with_narrow_ways(task), placed))
            hung = hang_instead(task, best, barred, placed[at]).placed
            missing = (*answer.missing, *list_hung(placed, hung))
            yield answer._replace(placed=hung, missing=missing)


def _list_without(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room without a plant at fault that nobody asked for."""
    for at in list_subjects(task, answer.placed, row):
        wish = answer.placed[at].wish
        if wish.group == "plant" and wish.rank >= WELCOME and not wish.required:
            yield _leave_out(answer, at, "it would stand before a wide door")


def _list_spared(task: RoomTask, answer: RoomAnswer, row: str) -> Iterator[RoomAnswer]:
    """The room with its wardrobe, or that and its bed, elsewhere without a chest of drawers that
    nobody asked for."""
    for at, group in enumerate(answer.placed):
        if group.wish.group == CHEST and not group.wish.required:
            less = _leave_out(answer, at, "it makes room for a whole wardrobe")
            yield from _list_elsewhere(task, less, row)
            yield from _list_pairs(task, less, row)


def _leave_out(answer: RoomAnswer, at: int, reason: str) -> RoomAnswer:
    """The room without a group that is told as one that is merely welcome."""
    lost = Missing(answer.placed[at].wish._replace(rank=WELCOME, core=False), reason)
    rest = (*answer.placed[:at], *answer.placed[at + 1 :])
    return answer._replace(placed=rest, missing=(*answer.missing, lost))


MOVES: dict[str, Callable[[RoomTask, RoomAnswer, str], Iterator[RoomAnswer]]] = {
    "elsewhere": _list_elsewhere,
    "swap": _list_swapped,
    "amid": _list_amid,
    "remake": list_remade,
    "join": list_joined,
    "pair": _list_pairs,
    "lounge": _list_lounges,
    "other table": _list_other_tables,
    "fewer": _list_fewer,
    "exchange": _list_exchanged,
    "leave out": _list_without,
    "spare": _list_spared,
}
