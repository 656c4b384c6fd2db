"""What a room is for, put wherever along its walls it fits: a search that misses nothing small.

The solver moves boxes by chance and finds the narrow fit of a small room only by luck. So before a
room gives up something essential, the essential groups are tried in their smallest forms at every
place along the walls, one after the other, the largest first (depth first with backtracking); what
else is wished for is tried in the room that is left.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import count
from typing import NamedTuple

import numpy as np

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomAnswer,
    RoomTask,
    build_task_problem,
    find_blocked,
    score_answer,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.furnishing.furnish import FurnishedPatch, dress_case, pieces_of
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.grounds.wall_places import free_places
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.programme import FALLBACK, LAST, Wish, instead_of, is_essential
from scenewright.domains.home.wished.wishes import list_barred_groups

Forms = Callable[[RoomTask, Wish], tuple[Group, ...]]


class Attempt(NamedTuple):
    """One way to have all that is essential: what stays where it is, what is to be placed, the
    largest first, in which forms, and whether the ways to it are looked at."""

    stays: tuple[FurnishedGroup, ...]
    rest: tuple[Wish, ...]
    forms: Forms
    walked: bool


def essential_layouts(
    task: RoomTask, wishes: tuple[Wish, ...], before: RoomAnswer, rank: int = 0
) -> Iterator[RoomAnswer]:
    """Layouts of all that is essential in a room, up to a ``rank``, and of nothing else: first
    beside the pieces ``before``, then afresh, then with fallbacks, then in the least forms of all.
    The last may be out of reach on the grid, which is stricter than an exact walk. All other
    ``wishes`` are missing."""
    for way in _ways(task, wishes, before, rank):
        looked = [0]
        for number, placed in enumerate(_extend(task, way, way.stays, way.rest, looked), 1):
            yield answer_of(task, placed, wishes)
            if number == task.preset.settings.walls.answers:
                break


def place_rest(
    task: RoomTask, stays: tuple[FurnishedGroup, ...], rest: tuple[Wish, ...]
) -> tuple[FurnishedGroup, ...] | None:
    """The ``rest`` in the least forms beside what ``stays``, the largest first, with all ways open;
    None where no such layout is found."""
    small = tuple(wish._replace(small=True) for wish in rest)
    way = Attempt(stays, _largest_first(task, small), least_forms, True)
    return next(_extend(task, way, stays, way.rest, [0]), None)


def _ways(
    task: RoomTask, wishes: tuple[Wish, ...], before: RoomAnswer, rank: int
) -> Iterator[Attempt]:
    kept = tuple(p for p in before.placed if is_essential(p.wish) and p.wish.rank <= rank)
    missing = [m.wish for m in before.missing]
    lacking, essential = (
        tuple(w._replace(small=True) for w in some if is_essential(w) and w.rank <= rank)
        for some in (missing, wishes)
    )
    sets = ((kept, lacking), ((), essential), (kept, _others(lacking)), ((), _others(essential)))
    out = list_barred_groups(task.asked, task.library) if task.asked else frozenset()
    known = set()
    for forms, walked in ((small_forms, True), (least_forms, True), (least_forms, False)):
        for stays, rest in sets if walked else sets[:1]:
            key = (forms, walked, len(stays), tuple(w.group for w in rest))
            possible = not any(wish.group in out for wish in rest)
            if (
                rest
                and possible
                and len(rest) <= task.preset.settings.walls.groups
                and key not in known
            ):
                known.add(key)
                yield Attempt(stays, _largest_first(task, rest), forms, walked)


def _others(wishes: tuple[Wish, ...]) -> tuple[Wish, ...]:
    return tuple(other for wish in wishes for other in instead_of(wish, FALLBACK | LAST))


def _largest_first(task: RoomTask, wishes: tuple[Wish, ...]) -> tuple[Wish, ...]:
    def area(wish: Wish) -> float:
        return min(case.width * case.depth for case in small_forms(task, wish))

    return tuple(sorted(wishes, key=lambda wish: -area(wish)))


def small_forms(task: RoomTask, wish: Wish) -> tuple[Group, ...]:
    """The smallest cases of a group."""
    known = cases(wish.group, task.library)
    order = np.argsort(known.sizes.prod(-1), kind="stable")
    fit = [i for i in order if wish.most is None or (known.sizes[i] <= wish.most).all()]
    return tuple(known.groups[i] for i in (fit or order)[: task.preset.settings.walls.forms])


def least_forms(task: RoomTask, wish: Wish) -> tuple[Group, ...]:
    """The least forms of a group, the larger first; its smallest cases where it has none, or where
    the cases are the user's own."""
    if wish.group not in LEAST or wish.group in task.library.own:
        return small_forms(task, wish)
    return tuple(LEAST[wish.group]())


def _extend(
    task: RoomTask,
    way: Attempt,
    placed: tuple[FurnishedGroup, ...],
    rest: tuple[Wish, ...],
    looked: list[int],
) -> Iterator[tuple[FurnishedGroup, ...]]:
    """Each of the ways to place the rest beside what is ``placed``; ``looked`` counts walks."""
    if not rest:
        yield placed
        return
    for item in _candidates(task, way.forms, placed, rest[0]):
        if looked[0] >= task.preset.settings.walls.walked:
            return
        looked[0] += 1
        more = (*placed, item)
        if not way.walked or not find_blocked(task, more):
            yield from _extend(task, way, more, rest[1:], looked)


def _candidates(
    task: RoomTask, forms: Forms, placed: tuple[FurnishedGroup, ...], wish: Wish
) -> Iterator[FurnishedGroup]:
    """One more group wherever it fits."""
    flat = flat_kinds(task.catalog)
    standing = standing_of((*task.fixed, *(q for p in placed for q in p.pieces)), flat)
    name = _free_name(task, placed, wish.group)
    for case in forms(task, wish):
        height = task.space.height
        free = free_places(case, task.ground, standing, task.catalog, height)
        for box in free[: task.preset.settings.walls.places]:
            furnished = dress_case(
                wish.group, case, box, task.ground, standing, task.catalog, height
            )
            if isinstance(furnished, FurnishedPatch):
                group = f"{task.space.id}/{name}"
                pieces = pieces_of(furnished, task.space.id, group, wish.group, task.catalog)
                yield FurnishedGroup(wish, name, furnished, pieces)


def _free_name(task: RoomTask, placed: tuple[FurnishedGroup, ...], group: str) -> str:
    taken = {p.name for p in placed} | {p.group.rpartition("/")[2] for p in task.fixed}
    return next(n for k in count(1) if (n := f"{group}_{k}" if k > 1 else group) not in taken)


def answer_of(
    task: RoomTask, placed: tuple[FurnishedGroup, ...], wishes: tuple[Wish, ...]
) -> RoomAnswer:
    """The answer that groups so placed make, with the other wishes as missing."""
    groups = [p.wish.group for p in placed]
    missing = []
    for wish in wishes:
        serving = (wish.group, *(other.group for other in _others((wish,))))
        stands = next((group for group in serving if group in groups), None)
        if stands:
            groups.remove(stands)
        else:
            missing.append(Missing(wish, "no room is left beside the rest"))
    problem = build_task_problem(task, tuple(p.wish for p in placed), task.ground)
    return score_answer(task, placed, tuple(missing), problem, 0.0)
