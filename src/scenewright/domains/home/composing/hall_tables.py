"""Halls that have no cabinet for shoes: a console table with a vase and a picture.

A home keeps its shoes in one hall; another of 4 m² and more would hold a coat rack and nothing
else. The table stands amid a free stretch of wall where 0.9 m stay free before it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer, RoomTask, find_blocked
from scenewright.domains.home.composing.bare_floor import is_left_to_us, pieces_of
from scenewright.domains.home.composing.moving import (
    dress_group,
    make_unplaced,
    stand_at,
    with_margin,
)
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.wall_stretch import (
    list_stretches,
    list_taken,
    measure_front,
)
from scenewright.domains.home.composing.widths import CONSOLE, bound_width, list_depths
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.programme import WELCOME, Wish

Floats = NDArray[np.float64]

LEAST = 4.0  # square metres of a hall from which on it has a table
HEIGHT = 0.8  # of a console table, metres
WAY = 0.9  # left free before it, metres
LOW = frozenset(("shoes", "console", "chest", "shelf", "storage"))
"""What else stands along the walls of a hall."""


def furnish_hall(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer for a hall without a cabinet with a console table, where that bars no way."""
    bare = task.space.functions == ("hall",) and task.ground.area >= LEAST
    if not bare or not is_left_to_us(task) or "console_table" in task.forbidden:
        return answer
    if LOW.intersection(p.wish.group for p in answer.placed) or task.cancelled():
        return answer
    margin, rule = with_margin(task), task.preset.settings.composing
    for table in _list_tables(task, answer):
        whole = (*answer.placed, table)
        sound = cost_of_group(table, task.ground, rule) == 0.0
        if sound and barred.issuperset(find_blocked(margin, whole)):
            return answer._replace(placed=whole)
    return answer


def _list_tables(task: RoomTask, answer: RoomAnswer) -> Iterator[FurnishedGroup]:
    """A table amid each free stretch of wall, a slim one where the way asks for it, the longest
    stretch first."""
    standing = standing_of(pieces_of(task, answer.placed), flat_kinds(task.catalog))
    taken = list_taken(task.ground, standing, np.empty((0, 5)), HEIGHT)
    for depth, forms in reversed(list_depths(CONSOLE)):
        stretches = list_stretches(task.ground, depth, taken, forms[-1].width)
        for stretch in sorted(stretches, key=lambda s: -s.length):
            most = bound_width(CONSOLE, task.ground.area, stretch.length)
            form = next(form for form in forms if form.width <= most)
            box = stretch.boxes_at(np.array([(stretch.length - form.width) / 2]), form)
            wide = measure_front(task.ground, box[0]) >= WAY
            if wide and len(stand_at(task, form, box, standing)):
                group = make_unplaced(task, answer.placed, Wish("console", WELCOME), form)
                dressed = dress_group(task, group, form, box[0], standing)
                if dressed is not None:
                    yield dressed
