"""Bathrooms, halls and stores: furniture along their walls fills its stretch of wall."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.filling.wet_rooms import can_stand_before, fill_wet_room
from scenewright.domains.home.composing.filling.widening import widen_groups
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve

NOTHING = standing_of((), frozenset())


@cache
def task_of(function, wide, deep=2.2):
    room = Room(
        id="room",
        function=function,
        outline=[[0, 0], [wide, 0], [wide, deep], [0, deep]],
        doors=[{"at": [wide / 2, 0.0], "width": 0.7}],
    )
    brief = Brief(rooms=[room])
    made = spaces(brief)
    return prepare_rooms(brief, made, catalog_of(()), PRESETS["default"], "anneal", 0)[0][0]


def stood(task, group, name, x) -> FurnishedGroup:
    """A group in one of its forms at the upper wall."""
    case = next(c for c in cases(group).groups if c.name == name)
    made = make_unplaced(task, (), Wish(group, 1), case)
    y = task.ground.bounds[3] - case.depth / 2
    box = np.array([x, y, -np.pi / 2, case.width, case.depth])
    found = dress_group(task, made, case, box, NOTHING)
    assert found is not None
    return found


def run(change, task, *groups):
    answer = RoomAnswer(0.0, groups, (), (), None, 0.0, 0)
    return change(task, answer, frozenset()).placed


def width_of(placed, name):
    return next(p for p in placed if p.wish.group == name).pieces[0].size.width


def test_a_small_machine_becomes_one_of_the_usual_size_in_a_corner():
    task = task_of("bathroom", 2.4)
    small = stood(task, "washer", "small washing machine", 1.9)
    (now,) = run(fill_wet_room, task, small)
    assert now.pieces[0].size.width == pytest.approx(0.6)
    x, _, _, width, _ = now.dressed.box
    assert min(x - width / 2, 2.4 - x - width / 2) == pytest.approx(0.0, abs=0.01)


def test_a_machine_that_fits_nowhere_larger_stays():
    task = task_of("bathroom", 1.3, 1.25)
    small = stood(task, "washer", "small washing machine", 1.05)
    assert run(fill_wet_room, task, small)[0].pieces[0].size.width == pytest.approx(0.48)


def test_a_cabinet_fills_the_niche_beside_a_bath():
    task = task_of("bathroom", 2.4)
    bath = stood(task, "bath", "1.6 m bath", 0.8)
    cabinet = stood(task, "linen", "bathroom cabinet", 2.0)
    assert width_of(run(fill_wet_room, task, bath, cabinet), "linen") == pytest.approx(0.8)


@pytest.mark.parametrize(
    ("niche", "deep", "free"), [(0.7, 0.35, True), (0.45, 0.35, False), (0.45, 0.61, True)]
)
def test_one_cannot_stand_before_a_shallow_cabinet_in_a_narrow_niche(niche, deep, free):
    task = task_of("bathroom", 1.6 + niche)
    bath = stood(task, "bath", "1.6 m bath", 0.8)
    box = np.array([1.6 + niche / 2, 2.2 - deep / 2, -np.pi / 2, niche, deep])
    assert can_stand_before(task.ground, box, standing_of(bath.pieces, frozenset())) == free


def test_rooms_that_are_more_than_a_bathroom_stay_as_they_are():
    task = task_of("kitchen", 2.4)
    small = stood(task, "washer", "small washing machine", 2.0)
    assert run(fill_wet_room, task, small) == (small,)


def test_a_shower_fills_its_niche_from_wall_to_wall():
    task = task_of("bathroom", 1.0)
    shower = stood(task, "shower", "0.7 m shower", 0.4)
    (now,) = run(widen_groups, task, shower)
    assert now.pieces[0].size.width == pytest.approx(1.0)


def test_a_basin_grows_with_its_room_and_leaves_the_toilet_its_elbow_room():
    task = task_of("bathroom", 1.5)
    toilet = stood(task, "toilet", "toilet", 1.15)
    basin = stood(task, "basin", "0.45 m hand basin", 0.3)
    now = run(widen_groups, task, basin, toilet)
    free = 1.15 - toilet.dressed.case.width / 2
    assert 0.45 < width_of(now, "basin") <= free


@pytest.mark.parametrize(("deep", "width"), [(1.4, 1.0), (1.0, 0.6)])
def test_a_shoe_cabinet_grows_where_the_way_before_it_stays_wide(deep, width):
    task = task_of("hall", 4.0, deep)
    shoes = stood(task, "shoes", "0.6 m shoe cabinet", 1.0)
    assert width_of(run(widen_groups, task, shoes), "shoes") == pytest.approx(width)


def test_shelves_of_a_store_reach_from_wall_to_wall():
    task = task_of("storage", 1.65, 1.6)
    shelf = stood(task, "storage", "1.2 m of shelving", 0.7)
    (now,) = run(widen_groups, task, shelf)
    assert sum(p.size.width for p in now.pieces) == pytest.approx(1.65)


def furnish(*rooms):
    """The categories of each of rooms side by side, (function, width, depth), by function."""
    made, x = [], 0.0
    for number, (function, wide, deep) in enumerate(rooms):
        outline = [[x, 0], [x + wide, 0], [x + wide, deep], [x, deep]]
        door = {"at": [x + 0.4, 0.0], "width": 0.6, "swing": "in"}
        made.append(
            Room(id=f"{number}-{function}", function=function, outline=outline, doors=[door])
        )
        x += wide + 0.1
    solution = solve(Brief(rooms=made), seed=0, threads=1)
    missing = {f.space for f in solution.left_out if f.required}
    held = {room.id: {p.category for p in solution.pieces if p.space == room.id} for room in made}
    return [held[room.id] for room in made], missing


def test_a_bathroom_without_room_for_a_tray_is_a_wet_room():
    (bathroom, _), missing = furnish(("bathroom", 1.1, 0.9), ("toilet", 0.9, 1.4))
    assert {"wall_shower", "pedestal_basin"} <= bathroom
    assert not missing


def test_a_bathroom_with_room_for_a_tray_has_one():
    (bathroom, _), _ = furnish(("bathroom", 2.0, 1.6), ("toilet", 0.9, 1.4))
    assert "shower" in bathroom
    assert "wall_shower" not in bathroom


@pytest.mark.parametrize("also", ["toilet", "storage"])
def test_the_bathroom_has_the_toilet_where_no_other_room_is_one(also):
    (bathroom, _), _ = furnish(("bathroom", 1.6, 1.4), (also, 0.9, 1.4))
    assert ("toilet" in bathroom) == (also == "storage")
    assert bathroom & {"shower", "wall_shower"}
    assert bathroom & {"basin", "pedestal_basin"}
