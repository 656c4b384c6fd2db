"""How much a room is to hold, where learned rooms tell how much people put into such rooms.

What makes a room and what is usual in it stays. Welcome groups are added, those most common in such
rooms first, or left out, the least common first, while that brings the floor that all groups cover
nearer to the learned share. Sizes follow the area of a room, so what is still missing is made up by
choosing them as if the room were larger or smaller.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from scenewright.core.brief import Room
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece, Pose
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomTask, floor_of, furnished_as
from scenewright.domains.home.cases.library import find_preferred_case
from scenewright.domains.home.learned import habits
from scenewright.domains.home.learned.space import measure_coverage
from scenewright.domains.home.programme import PROGRAMME, STANDS_FOR, WELCOME, Wish
from scenewright.domains.home.tasks import wishes_of

FACTORS = tuple(sorted(np.geomspace(0.5, 2.0, 17).tolist(), key=lambda f: abs(np.log(f))))
"""Areas that are tried, as parts of the room's, the nearest to it first."""
SEEN_SHARE = 0.5
"""What fewer such rooms have is not welcome, as a share of them."""
BESIDE = frozenset(row.group for rows in PROGRAMME.values() for row in rows if row.rank > 0)
"""Groups that come beside what makes a room."""


def match_learned_density(task: RoomTask, room: Room, rooms: tuple[Space, ...]) -> RoomTask:
    """The task, to be furnished as much as people furnish such rooms; as it is where nothing was
    learned of them."""
    known, functions = task.library.habits, task.space.functions
    if not known.shares or not functions or not task.preset.settings.exact:
        return task
    usual = wishes_of(room, task, rooms, task.fixed)
    wanted = habits.share(
        known, functions[0], floor_of(task.ground), estimate_coverage(task, usual)
    )
    if room.ask is None:
        task = task._replace(welcome=_welcome(task, usual, wanted))
    wishes = wishes_of(room, task, rooms, task.fixed)

    def off(factor: float) -> float:
        return round(abs(estimate_coverage(task._replace(amount=factor), wishes) - wanted), 3)

    return task._replace(amount=min(FACTORS, key=off), share=wanted)


def _welcome(task: RoomTask, usual: tuple[Wish, ...], wanted: float) -> tuple[str, ...]:
    """The welcome groups with which the room holds about as much as wanted."""
    must = [wish for wish in usual if wish.rank < WELCOME]
    chosen = [wish for wish in usual if wish.rank == WELCOME]
    area = floor_of(task.ground)
    common = habits.common(
        task.library.habits, task.space.functions[0], area, (wish.group for wish in usual)
    )
    have = {p.category for p in task.fixed}

    def off(welcome: list[Wish]) -> float:
        return abs(estimate_coverage(task, (*must, *welcome)) - wanted)

    for wish in sorted(chosen, key=lambda w: common[w.group]):
        fewer = [w for w in chosen if w is not wish]
        chosen = fewer if off(fewer) < off(chosen) else chosen
    for group in sorted(common, key=lambda g: (-common[g], g)):
        standing = have | {k for w in (*must, *chosen) for k in STANDS_FOR.get(w.group, ())}
        named = group in BESIDE and not any(w.group == group for w in usual)
        if named and common[group] >= SEEN_SHARE and not standing & set(STANDS_FOR.get(group, ())):
            more = [*chosen, Wish(group, WELCOME)]
            chosen = more if off(more) < off(chosen) else chosen
    return tuple(wish.group for wish in chosen)


def estimate_coverage(task: RoomTask, wishes: tuple[Wish, ...]) -> float:
    """The share of the floor that the groups wished for cover, with the pieces already there."""
    area = furnished_as(task)
    taken = measure_coverage(task.fixed) + sum(_taken(wish, area, task) for wish in wishes)
    return float(taken / floor_of(task.ground))


def _taken(wish: Wish, area: float, task: RoomTask) -> float:
    case = find_preferred_case(wish.group, area, task.library)
    most = wish.most
    bound = min(case.width, most[0]) * min(case.depth, most[1]) if most else np.inf
    return min(footing(case), float(bound))


@lru_cache(maxsize=4096)
def footing(case: Group) -> float:
    """The floor that the members of a case cover, square metres."""
    return measure_coverage(
        [
            Piece("", m.category, "", "", Pose(m.x, m.y, m.z, m.heading), m.size)
            for m in case.members
            if m.on < 0
        ]
    )
