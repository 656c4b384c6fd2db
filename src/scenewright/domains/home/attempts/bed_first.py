"""A bed alone, before all else, in a room for sleeping that would end without one.

What is essential in a small room is looked for together and on a grid that is stricter than the
walk through the home, so a wardrobe may keep the wall on which alone a bed stands. A bedroom
without a bed is none, one without a wardrobe is a small one: where no bed stands when all else was
tried, it is put down first, in its least forms, wherever it leaves the ways open; the rest follows.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.attempts.systematic import answer_of
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.composing.places.wall_ends import list_wall_ends
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.grounds.wall_places import free_boxes, free_places
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.measures import NARROWER
from scenewright.domains.home.programme import Wish

SINGLE = "single"
LEAST_FLOOR = 1.8
"""On less floor, square metres, no bed leaves a step before it."""
BED_PLACES_APART, PLACES = 0.05, 80
"""Metres between places of one form, and how many of them are walked past."""


def list_beds_first(
    task: RoomTask, wishes: tuple[Wish, ...], before: RoomAnswer
) -> Iterator[RoomAnswer]:
    """Layouts of a bed that is lacking beside what else the room fails without, the larger forms
    first, that bar nothing further on a grid with narrower ways; all other ``wishes`` are
    missing."""
    wish = _find_lacking(task, before)
    if wish is None:
        return
    stays = tuple(p for p in before.placed if p.wish.core)
    narrow = with_narrow_ways(task)
    barred = frozenset(find_blocked(narrow, stays))
    for case in LEAST[SINGLE]():
        for bed in islice(list_placed(task, stays, wish, case), PLACES):
            if bars_no_more(narrow, (*stays, bed), barred):
                yield answer_of(task, (*stays, bed), wishes)


def with_narrow_ways(task: RoomTask) -> RoomTask:
    """The task with ways by :data:`NARROWER` narrower."""
    return task._replace(
        route_width=task.route_width - NARROWER, use_width=task.use_width - NARROWER
    )


def _find_lacking(task: RoomTask, before: RoomAnswer) -> Wish | None:
    """The bed that a room lacks, as a single one of any size; None where it lacks none or another
    thing it fails without as well, or where a size of its own is wanted."""
    lacking = [m.wish for m in before.missing if m.wish.core]
    if len(lacking) != 1 or lacking[0].group not in BED_GROUPS or lacking[0].most is not None:
        return None
    if SINGLE in task.library.own or task.ground.area < LEAST_FLOOR:
        return None
    return lacking[0]._replace(group=SINGLE, small=True)


def list_placed(
    task: RoomTask, stays: tuple[FurnishedGroup, ...], wish: Wish, case: Group
) -> Iterator[FurnishedGroup]:
    """A case of a bed wherever along the walls it stands free beside others: at the ends of free
    stretches, in corners and far from the doors, then anywhere."""
    pieces = (*task.fixed, *task.beside, *(p for group in stays for p in group.pieces))
    standing = standing_of(pieces, flat_kinds(task.catalog))
    group = make_unplaced(task, stays, wish, case)
    room = (case, task.ground, standing, task.catalog, task.space.height)
    ends = list_wall_ends(task, case, standing)
    boxes = np.concatenate([ends, free_places(*room), free_boxes(*room)])
    unlike = np.unique((boxes / BED_PLACES_APART).round(), axis=0, return_index=True)[1]
    for k in sorted(unlike.tolist()):
        bed = dress_group(task, group, case, boxes[k], standing)
        if bed is not None:
            yield bed
