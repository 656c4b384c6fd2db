"""What a composed room takes in besides: what was missing, worktop, what makes it fuller."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomTask
from scenewright.domains.home.cases.library import cases, shipped_cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.forms import SEATS_FROM, list_further
from scenewright.domains.home.groups.classes import DESK_GROUPS, RUNS
from scenewright.domains.home.groups.kitchen import short_counters
from scenewright.domains.home.programme import FALLBACK, Wish

SLEEP_IN_BUNK = 2
"""Those who sleep in a bunk bed, each with a desk where the room holds two."""
COVERED = 0.29
"""The share of a living room's floor under furniture up to which it takes more."""
SMALLER = frozenset(("dining_wall", "lounger"))
"""What is added instead of what is lacking and finds no place."""
EVERY = 4
"""One second run of a kitchen is tried in this many, as they are shipped in steps of 0.05 m."""
FULLER = (("shelf", 9.0), ("sideboard", 9.0), ("plant", 9.0), ("shelf", 14.0))
"""What a bare living room takes, in this order, and the area in m² from which it does."""


def list_additions(
    task: RoomTask, placed: Placed, missing: tuple[Missing, ...]
) -> Iterator[tuple[Wish, tuple[Missing, ...]]]:
    """Wishes to try beside what is placed, each with what is missing no longer once it stands."""
    for lack in sorted(missing, key=lambda m: m.wish.rank):
        own = task.library.own.keys() - task.library.seated
        if lack.wish.rank < 2 and lack.wish.group not in own:
            other = FALLBACK.get(lack.wish.group)
            named = (lack.wish.group, *((other,) if other in SMALLER else ()))
            for small in (False, True) if task.library.seated else (True,):
                for group in named:
                    yield lack.wish._replace(group=group, small=small), (lack,)
    if task.asked is not None and task.asked.ask is not None:
        return
    if any(p.wish.group == "bunk" for p in placed):
        yield Wish("kids_desk", 2), ()
    if any(_is_short(p) for p in placed) and "counter" not in task.forbidden:
        yield Wish("counter", 2), ()
    shared = task.elsewhere or task.instead
    if "living" in task.space.functions and task.welcome is None and not shared:
        if task.ground.area >= SEATS_FROM and "reading" not in task.elsewhere:
            yield Wish("reading", 2), ()
        for group, least in FULLER:
            if task.ground.area >= least and group not in task.elsewhere:
                yield Wish(group, 2), ()


def is_wanted(task: RoomTask, placed: Placed, wish: Wish, lacks: tuple[Missing, ...]) -> bool:
    """Whether an addition is still wanted beside the groups placed by now."""
    there = [p.wish.group for p in placed]
    if lacks:
        return True
    if wish.group == "reading":
        return "reading" not in there and any(_has_few_seats(p) for p in placed)
    if wish.group in DESK_GROUPS:
        return sum(group in DESK_GROUPS for group in there) < SLEEP_IN_BUNK
    if wish.group == "counter":
        return "counter" not in there and any(_is_short(p) for p in placed)
    twice = wish.group == "shelf" and task.ground.area >= 14.0
    if there.count(wish.group) > int(twice):
        return False
    covered = sum(float(p.dressed.case.width * p.dressed.case.depth) for p in placed)
    return _covered_by(placed) < COVERED * task.ground.area and covered < task.ground.area


def _is_short(group: FurnishedGroup) -> bool:
    """Whether a kitchen run has too little worktop in one piece."""
    names = {name for name, _ in find_case_faults(group.dressed.case)}
    return group.wish.group in RUNS and "worktop" in names


def _has_few_seats(group: FurnishedGroup) -> bool:
    """Whether a seating group seats two."""
    return "seats" in {name for name, _ in find_case_faults(group.dressed.case)}


def _covered_by(placed: Placed) -> float:
    """Square metres under furniture on the floor, without rugs."""
    low = (p for g in placed for p in g.pieces if p.pose.z < 0.05 and p.category != "rug")
    return sum(p.size.width * p.size.depth for p in low)


def forms_to_add(task: RoomTask, wish: Wish) -> list[Group]:
    """The forms in which a group is added: the preferred first, then ever smaller ones;
    with too few places for the residents only if it may be small. A second run of a kitchen that
    gave way comes back from 1.2 m on, and for want of worktop as short as it fits."""
    if wish.group == "counter":
        back = shipped_cases("counter").groups[::EVERY]
        return list(back if wish.small else short_counters())
    seated = wish.group in task.library.seated
    own = cases(wish.group, task.library)
    found = []
    for known in (own, shipped_cases(wish.group)) if seated and wish.small else (own,):
        order = np.argsort(-known.sizes.prod(-1), kind="stable")
        fit = [int(i) for i in order if wish.most is None or (known.sizes[i] <= wish.most).all()]
        found += [known.groups[i] for i in fit]
    if wish.small and not seated and wish.most is None:
        found += sorted(list_further(wish.group), key=lambda form: -form.width * form.depth)
    return list(dict.fromkeys(found))
