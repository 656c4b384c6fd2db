"""Machines and cabinets of bathrooms as wide as their stretch of wall, and no slots there."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.flush import measure_slots
from scenewright.domains.home.composing.moving import dress_group, make_unplaced
from scenewright.domains.home.composing.wet_rooms import fill_wet_room
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms
from scenewright.domains.home.wall_places import read_walls

NOTHING = standing_of((), frozenset())


def task_of(function, wide):
    room = Room(
        id="room",
        function=function,
        outline=[[0, 0], [wide, 0], [wide, 2.2], [0, 2.2]],
        doors=[{"at": [wide / 2, 0.0], "width": 0.7}],
    )
    brief = Brief(rooms=[room])
    made = spaces(brief)
    return prepare_rooms(brief, made, catalog_of(()), PRESETS["default"], "anneal", 0)[0][0]


def stood(task, group, name, x) -> FurnishedGroup:
    """A group in one of its forms at the upper wall."""
    case = next(c for c in cases(group).groups if c.name == name)
    made = make_unplaced(task, (), Wish(group, 1), case)
    box = np.array([x, 2.2 - case.depth / 2, -np.pi / 2, case.width, case.depth])
    found = dress_group(task, made, case, box, NOTHING)
    assert found is not None
    return found


def filled(task, *groups):
    answer = RoomAnswer(0.0, groups, (), (), None, 0.0, 0)
    return fill_wet_room(task, answer, frozenset()).placed


def test_a_small_machine_becomes_one_of_the_usual_size_and_leaves_no_slot():
    task = task_of("bathroom", 2.4)
    small = stood(task, "washer", "small washing machine", 2.0)
    (now,) = filled(task, small)
    assert now.pieces[0].size.width == pytest.approx(0.6)
    assert measure_slots(now.dressed.box, read_walls(task.ground), NOTHING) == 0.0
    assert measure_slots(small.dressed.box, read_walls(task.ground), NOTHING) == pytest.approx(0.15)


def test_a_machine_that_fits_nowhere_larger_stays():
    task = task_of("bathroom", 2.4)
    bath = stood(task, "bath", "1.8 m bath", 0.9)
    small = stood(task, "washer", "small washing machine", 2.1)
    now = next(p for p in filled(task, bath, small) if p.wish.group == "washer")
    assert now.pieces[0].size.width == pytest.approx(small.pieces[0].size.width)


def test_a_cabinet_fills_its_stretch():
    task = task_of("bathroom", 2.4)
    bath = stood(task, "bath", "1.6 m bath", 0.8)
    cabinet = stood(task, "linen", "bathroom cabinet", 2.0)
    now = next(p for p in filled(task, bath, cabinet) if p.wish.group == "linen")
    assert now.pieces[0].size.width == pytest.approx(0.8)


def test_other_rooms_stay_as_they_are():
    task = task_of("kitchen", 2.4)
    small = stood(task, "washer", "small washing machine", 2.0)
    assert filled(task, small) == (small,)
