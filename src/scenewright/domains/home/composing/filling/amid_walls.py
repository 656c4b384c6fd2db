"""Places of one more group at the middle of free stretches of wall."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.filling.bare_floor import pieces_of
from scenewright.domains.home.composing.filling.widths import Growth, bound_width, list_depths
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced, stand_at
from scenewright.domains.home.composing.places.wall_stretch import (
    list_free_stretches,
    list_taken,
    measure_front,
)
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.programme import Wish


def list_amid_walls(
    task: RoomTask, placed: Placed, wish: Wish, growth: Growth, way: float
) -> Iterator[FurnishedGroup]:
    """A group at the middle of each free stretch of wall, ``way`` metres free before it: of its
    depths the greatest first, then the longest stretch."""
    standing = standing_of(pieces_of(task, placed), flat_kinds(task.catalog))
    for depth, forms in reversed(list_depths(growth)):
        height = forms[0].members[0].size.height
        taken = list_taken(task.ground, standing, np.empty((0, 5)), height)
        stretches = list_free_stretches(task.ground, depth, taken, forms[-1].width)
        for stretch in sorted(stretches, key=lambda s: -s.length):
            most = bound_width(growth, task.ground.area, stretch.length)
            form = next(form for form in forms if form.width <= most)
            box = stretch.boxes_at(np.array([(stretch.length - form.width) / 2]), form)
            wide = measure_front(task.ground, box[0]) >= way
            if wide and len(stand_at(task, form, box, standing)):
                group = make_unplaced(task, placed, wish, form)
                dressed = dress_group(task, group, form, box[0], standing)
                if dressed is not None:
                    yield dressed
