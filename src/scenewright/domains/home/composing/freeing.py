"""Rooms furnished so that something cannot be reached: what bars the way in another form or place.

What still bars a way when all rooms are done is taken out of its room. A group that does is
therefore tried before in all its forms, down to the least, wherever along the walls it stands free.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomTask,
    bars_no_more,
    find_blocked,
)
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.moving import with_margin
from scenewright.domains.home.composing.places.pairs import find_pair
from scenewright.domains.home.composing.places.trials import try_forms
from scenewright.domains.home.groups.least import LEAST


def free_ways(task: RoomTask, placed: Placed) -> Placed:
    """The groups with one of them where it bars nothing that would be reached without it; as they
    were where nothing is barred or none has such a place. The smallest is tried first. A bed and a
    wardrobe find their places together (:mod:`.places.pairs`)."""
    barred = frozenset() if find_pair(placed) else frozenset(find_blocked(task, placed))
    if not barred:
        return placed
    margin = with_margin(task)
    for group in sorted(placed, key=lambda p: float(p.dressed.box[3:].prod())):
        rest = tuple(p for p in placed if p is not group)
        left = frozenset(find_blocked(task, rest))
        if left < barred:
            for whole in _list_elsewhere(task, rest, group):
                if bars_no_more(margin, whole, left):
                    return whole
    return placed


def _list_elsewhere(task: RoomTask, rest: Placed, group: FurnishedGroup) -> Iterator[Placed]:
    """The groups with one in each of its forms at its best places, the cheapest room first."""
    forms = dict.fromkeys([*list_forms(task, group), *_list_least(task, group)])
    whole = (*rest, group)
    judge = judge_of(task, whole)
    for judged in try_forms(judge, whole, len(rest), forms, len(forms)):
        yield judged.placed


def _list_least(task: RoomTask, group: FurnishedGroup) -> list[Group]:
    """The least forms of a group, none where a household or a size asked for says otherwise."""
    own = group.wish.group in task.library.own or group.wish.most is not None
    return [] if own or group.wish.group not in LEAST else list(LEAST[group.wish.group]())
