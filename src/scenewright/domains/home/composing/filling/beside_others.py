"""One group of a room on another place, beside all others as they stand."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice
from math import inf

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask, bars_no_more
from scenewright.domains.home.composing.judging import Placed, RoomJudge, judge_of
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.places.moving import dress_group, with_margin
from scenewright.domains.home.composing.places.wall_stretch import list_taken
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, flat_kinds, standing_of

Floats = NDArray[np.float64]

TRIED = 6  # places that are furnished, if not stated
WORTH = 1.0  # what a room may cost more for it, if not stated
ELBOWS = frozenset(("toilet",))
"""Groups that need elbow room beside their neighbours."""


def list_others(task: RoomTask, placed: Placed, group: FurnishedGroup) -> StandingObstacles:
    """What stands in a room but for one group."""
    rest = (q for p in placed if p is not group for q in p.pieces)
    return standing_of((*task.fixed, *task.beside, *rest), flat_kinds(task.catalog))


def list_taken_beside(
    task: RoomTask, placed: Placed, group: FurnishedGroup, standing: StandingObstacles
) -> Floats:
    """The boxes (k, 5) in which nothing of a group's height stands, elbow room of others too."""
    elbows = [p.dressed.box for p in placed if p is not group and p.wish.group in ELBOWS]
    height = group.pieces[0].size.height
    return list_taken(task.ground, standing, np.array(elbows).reshape(-1, 5), height)


def take_first_place(
    task: RoomTask,
    placed: Placed,
    group: FurnishedGroup,
    found: Iterable[tuple[Group, Floats]],
    standing: StandingObstacles,
    barred: frozenset[str],
    worth: float = WORTH,
    tried: int = TRIED,
) -> Placed:
    """The groups with one of them in the first form ``found``, each with its box (5,) and at most
    ``tried`` of them, in which it has no more faults, the room costs at most what it is ``worth``
    more and no further way is barred; or as they were."""
    at, rule = placed.index(group), task.preset.settings.composing
    judge: RoomJudge | None = None
    most, faults = inf, cost_of_group(group, task.ground, rule)
    for form, box in islice(found, tried):
        dressed = dress_group(task, group, form, box, standing)
        if dressed is None or cost_of_group(dressed, task.ground, rule) > faults:
            continue
        if judge is None:
            judge = judge_of(task, placed)
            most = judge.cost_of(placed).cost + worth
        other = (*placed[:at], dressed, *placed[at + 1 :])
        if judge.cost_of(other).cost > most:
            continue
        if bars_no_more(with_margin(task), other, barred):
            return other
    return placed
