"""What stands along the walls of bathrooms, halls and stores in the width of its stretch of wall.

In a tight room the search ends with the smallest forms. Here a shower fills the niche it stands in,
a basin, a shoe cabinet or a shelf becomes as wide as its room lets it, beside all others as they
stand: from wall to wall where that is little more, else where fewer slots are left beside it. In a
hall 0.9 m stay free before what grows.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    find_blocked,
)
from scenewright.domains.home.composing.filling.beside_others import (
    list_others,
    list_taken_beside,
    take_first_place,
)
from scenewright.domains.home.composing.filling.widths import (
    GROWING_LAST,
    Growth,
    bound_width,
    list_depths,
    list_growing,
)
from scenewright.domains.home.composing.homewide.settling import try_in_home
from scenewright.domains.home.composing.places.moving import stand_at, with_margin
from scenewright.domains.home.composing.places.wall_stretch import (
    FreeStretch,
    find_deeper,
    measure_front,
)
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.measures import HAIR
from scenewright.domains.home.rules.every import ROOMY
from scenewright.domains.home.walking.remove_blockers import Opened

Floats = NDArray[np.float64]

MORE = 0.04  # what grows by less is not seen, metres
WAY = 0.9  # left free before what grows in a hall, metres


def widen_storage(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with storage in rooms one lives in as wide as its stretch of wall, where nothing
    then stands nearer to it."""
    found = answers
    for room, task in enumerate(tasks):
        if task.preset.settings.exact and not (task.accessible or task.library.own):
            barred = frozenset(find_blocked(with_margin(task), found[room].placed))
            wider = _widen(task, found[room], barred, GROWING_LAST)
            near, before = (
                measure_closeness(answer.placed, task.fixed, task.ground)
                for answer in (wider, found[room])
            )
            better = wider is not found[room] and near <= before + HAIR
            trial = try_in_home(room, wider, found, opened) if better else None
            found = found if trial is None else trial
    return found


def widen_groups(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer for a bathroom, a hall or a store with each group that may grow there as wide as
    its stretch of wall, where it bars no way and the room costs hardly more."""
    return _widen(task, answer, barred, list_growing(task.space.functions))


def _widen(
    task: RoomTask, answer: RoomAnswer, barred: frozenset[str], growing: Mapping[str, Growth]
) -> RoomAnswer:
    for name, growth in growing.items():
        for group in answer.placed:
            if group.wish.group == name and group.wish.most is None and not task.cancelled():
                placed, standing = answer.placed, list_others(task, answer.placed, group)
                taken = list_taken_beside(task, placed, group, standing)
                taken = np.concatenate([taken, _list_doors(task, growth)])
                found = _list_larger(task, group, growth, standing, taken)
                placed = take_first_place(
                    task, placed, group, found, standing, barred, growth.worth
                )
                answer = answer if placed is answer.placed else answer._replace(placed=placed)
    return answer


def _list_doors(task: RoomTask, growth: Growth) -> Floats:
    """The floor (k, 5) where doors open, and ``off`` metres round it for what grows."""
    doors = task.ground.keep_free[: len(task.ground.keep_free) * (task.ground.area >= ROOMY)]
    return doors + 2 * growth.off * np.array([0.0, 0.0, 0.0, 1.0, 1.0])


def _list_larger(
    task: RoomTask,
    group: FurnishedGroup,
    growth: Growth,
    standing: StandingObstacles,
    taken: Floats,
) -> Iterator[tuple[Group, Floats]]:
    """Larger forms of a group, the largest first, each on a box (5,) of its stretch of wall where
    it stands free."""
    case, found = group.dressed.case, list[tuple[Group, FreeStretch]]()
    sizes = list_depths(growth)
    stretches = find_deeper(task.ground, group.dressed.box, (deep for deep, _ in sizes), taken)
    for (_, forms), stretch in zip(sizes, stretches, strict=False):
        if stretch.length < case.width:
            break
        most = bound_width(growth, task.ground.area, stretch.length)
        form = next((form for form in forms if form.width <= most), None)
        if form is not None and _is_larger(form, case):
            found.append((form, stretch))
    for form, stretch in sorted(found, key=lambda row: -row[0].width * row[0].depth):
        boxes = stand_at(task, form, _list_boxes(stretch, form), standing)
        if len(boxes) and not (growth.walked and measure_front(task.ground, boxes[0]) < WAY):
            yield form, boxes[0]


def _is_larger(form: Group, case: Group) -> bool:
    """Whether a form covers more than a case, is as wide and seen to have grown."""
    wider, deeper = form.width - case.width, form.depth - case.depth
    more = form.width * form.depth > case.width * case.depth
    return more and wider > -MORE / 4 and wider + deeper >= MORE


def _list_boxes(stretch: FreeStretch, form: Group) -> Floats:
    """The boxes (3, 5) of a form where it stands now and at both ends of its stretch, those with
    fewer slots beside them first, then the nearer."""
    spare, half = stretch.length - form.width, form.width / 2

    def rank(start: float) -> tuple[float, float]:
        slots = stretch.slots_beside(start, form.width)
        return round(slots, 2), abs(start + half - stretch.at)

    here = min(max(stretch.at - half, 0.0), spare)
    return stretch.boxes_at(np.array(sorted((here, 0.0, spare), key=rank)), form)
