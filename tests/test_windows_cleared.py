"""Windows: pieces before one when its home is done, and where they go instead."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import shapely

from scenewright.building.door_approach import gates
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.piece_outlines import outline_of
from scenewright.domains.home.attempts.attempt import Missing, RoomAnswer, find_blocked
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.bed_sides import count_closed_beds
from scenewright.domains.home.composing.mend_rooms import mend_rooms
from scenewright.domains.home.composing.placed_faults import (
    list_adrift,
    measure_before_windows,
    measure_cases_before_windows,
)
from scenewright.domains.home.composing.places.forms import list_further
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.composing.places.swapped import swap_along_wall
from scenewright.domains.home.composing.verdict import judge_room
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms

NORTH = np.pi / 2
DOOR = {"at": [0.5, 0.0], "width": 0.8, "swing": "out"}
ROOM = {
    "id": "bed",
    "function": "bedroom",
    "outline": [[0, 0], [3.2, 0], [3.2, 2.6], [0, 2.6]],
    "doors": [DOOR],
    "windows": [{"at": [1.6, 2.6], "width": 1.4, "sill": 0.9}],
}


def task_of(room=ROOM):
    brief = Brief(rooms=[Room.model_validate(room)])
    preset, rooms = PRESETS["default"], spaces(brief)
    return prepare_rooms(brief, rooms, catalog_of(()), preset, preset.solver, 0)[0][0]


def stand(task, name, x, y, heading, fits, beside=()):
    """A group in the first of its forms that ``fits``, its back at x, y."""
    case = next(c for c in (*cases(name).groups, *list_further(name)) if fits(c))
    group = make_unplaced(task, (), Wish(name, 0), case)
    middle = np.array([x, y]) + case.depth / 2 * np.array([np.cos(heading), np.sin(heading)])
    box = np.array([*middle, heading, case.width, case.depth])
    others = standing_of([p for g in beside for p in g.pieces], flat_kinds(task.catalog))
    dressed = dress_group(task, group, case, box, others)
    assert dressed is not None
    return dressed


def answer_of(*placed):
    return RoomAnswer(0.0, placed, (), (), None, 0.0, 0)


def clear(task, *placed, opened=list):
    (answer,) = mend_rooms([task], [answer_of(*placed)], opened)
    return answer.placed


def dark(task, placed):
    return judge_room(task, answer_of(*placed)).findings["window"]


def test_metres_before_windows_are_those_of_the_polygons():
    task = task_of()
    (gate,) = (g for g in gates(task.space) if g.opening.kind == "window")
    x, y = gate.face
    strip = shapely.box(x - 0.7, y - 0.3, x + 0.7, y)
    for left in (0.6, 1.0, 1.6, 2.7):
        chest = stand(task, "chest", left, 2.6, -NORTH, lambda c: c.width == 0.8)
        shapes = [shapely.Polygon(outline_of(p)) for p in chest.pieces if p.pose.z < 0.1]
        metres = shapely.union_all(shapes).intersection(strip).area / 0.3
        assert measure_before_windows(chest, task.ground) == pytest.approx([metres], abs=1e-6)
        many = measure_cases_before_windows(
            chest.dressed.case, chest.dressed.box[None], task.ground
        )
        assert many == pytest.approx(np.array([[metres]]), abs=1e-6)


def test_a_chest_before_a_window_goes_to_another_wall_and_keeps_its_width():
    task = task_of()
    chest = stand(task, "chest", 1.6, 2.6, -NORTH, lambda c: c.width == 0.8)
    assert dark(task, (chest,)) == 1
    (moved,) = clear(task, chest)
    assert dark(task, (moved,)) == 0
    assert moved.dressed.case.width >= 0.8 * chest.dressed.case.width - 1e-9
    assert not find_blocked(task, (moved,))


def test_nothing_moves_that_takes_no_light_or_has_no_way():
    task = task_of()
    free = stand(task, "chest", 3.2, 1.3, np.pi, lambda c: c.width == 0.8)
    assert clear(task, free) == (free,)
    chest = stand(task, "chest", 1.6, 2.6, -NORTH, lambda c: c.width == 0.8)
    lost = answer_of()._replace(missing=(Missing(chest.wish, ""),))
    assert clear(task, chest, opened=lambda _: [lost]) == (chest,)


def test_a_bed_and_the_wardrobe_in_its_way_are_placed_together():
    """The only long wall without an opening is the wardrobe's."""
    room = ROOM | {"outline": [[0, 0], [2.6, 0], [2.6, 3], [0, 3]]}
    room |= {"windows": [{"at": [1.3, 3.0], "width": 2.0, "sill": 0.9}]}
    room |= {"doors": [{"at": [0.0, 0.6], "width": 0.8, "swing": "out"}]}
    task = task_of(room)
    bed = stand(task, "single", 0.4, 3.0, -NORTH, lambda c: c.width == 0.8)
    wardrobe = stand(task, "wardrobe", 2.6, 1.0, np.pi, lambda c: c.width == 1.4, (bed,))
    assert dark(task, (bed, wardrobe)) == 1
    moved = clear(task, bed, wardrobe)
    assert dark(task, moved) == 0
    assert sorted(p.wish.group for p in moved) == ["single", "wardrobe"]
    assert not list_adrift(moved, task.ground)
    (case,) = (p.dressed.case for p in moved if p.wish.group == "wardrobe")
    assert case.width >= 1.0 - 1e-9
    assert not find_blocked(with_narrow_ways(task), moved)


def test_a_bed_adrift_goes_to_a_wall_but_not_before_a_window():
    task = task_of()
    bed = stand(task, "single", 1.6, 0.0, NORTH, lambda c: c.width == 0.8)
    assert list_adrift((bed,), task.ground)
    moved = clear(task, bed)
    found = judge_room(task, answer_of(*moved)).findings
    assert (found["window"], found["adrift"]) == (0, 0)


def test_seats_before_a_window_leave_its_curtain_free():
    room = ROOM | {"function": "living", "outline": [[0, 0], [4, 0], [4, 3.4], [0, 3.4]]}
    across = {"at": [2.5, 0.0], "width": 2.8, "sill": 0.9}
    room |= {"windows": [{"at": [2.0, 3.4], "width": 3.6, "sill": 0.9}, across]}
    room |= {"doors": [DOOR, *({"at": [x, 1.7], "width": 2.8, "swing": "slide"} for x in (0, 4))]}
    task = task_of(room)
    sofa = stand(task, "seating", 2.0, 3.4, -NORTH, lambda c: len(c.members) == 1 or c.width < 2.0)
    assert dark(task, (sofa,)) == 1
    (moved,) = clear(task, sofa)
    assert dark(task, (moved,)) == 0
    assert len(moved.pieces) >= len(sofa.pieces)


CORNER = ROOM | {
    "outline": [[0, 0], [3.4, 0], [3.4, 3], [0, 3]],
    "windows": [{"at": [1.2, 3.0], "width": 1.8, "sill": 0.9}],
    "doors": [
        {"at": [0.0, 0.9], "width": 1.0, "swing": "slide"},
        {"at": [1.6, 0.0], "width": 1.0, "swing": "slide"},
        {"at": [3.4, 0.6], "width": 1.0, "swing": "slide"},
    ],
}
"""A bedroom with 1.9 m of wall that is neither below its window nor beside it."""


def test_a_side_of_a_bed_is_closed_by_a_wall_and_by_a_chest():
    task = task_of(CORNER)
    bed = stand(task, "sleeping", 1.7, 3.0, -NORTH, lambda c: round(c.width, 2) == 2.3)
    assert count_closed_beds((bed,), task.ground) == 0
    beside = stand(task, "chest", 3.4, 1.8, np.pi, lambda c: c.width == 0.6, (bed,))
    chest = beside.pieces[0]
    near = replace(chest, pose=chest.pose._replace(x=bed.pieces[0].pose.x + 1.0))
    assert count_closed_beds((bed, beside), task.ground) == 0
    assert count_closed_beds((bed, beside._replace(pieces=(near,))), task.ground) == 1
    first = bed.pieces[0]
    aside = replace(first, pose=first.pose._replace(x=2.4))
    assert count_closed_beds((bed._replace(pieces=(aside,)),), task.ground) == 1


def test_two_groups_at_one_wall_change_places():
    task = task_of()
    chest = stand(task, "chest", 1.4, 0.0, NORTH, lambda c: c.width <= 0.8)
    wide = stand(task, "chest", 2.5, 0.0, NORTH, lambda c: 0.9 < c.width < 1.3)
    swapped = swap_along_wall(task, (chest, wide), 0, 1)
    assert swapped is not None
    before, after = (np.array([p.dressed.box for p in pair]) for pair in ((chest, wide), swapped))
    assert after[0, 0] > after[1, 0]
    ends = [((b[:, 0] - b[:, 3] / 2).min(), (b[:, 0] + b[:, 3] / 2).max()) for b in (before, after)]
    assert ends[0] == pytest.approx(ends[1])
    beside = stand(task, "chest", 0.0, 1.7, 0.0, lambda c: c.width <= 0.8)
    assert swap_along_wall(task, (chest, beside), 0, 1) is None
