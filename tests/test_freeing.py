"""What bars a way in a furnished room is put elsewhere, or in another form."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import find_blocked
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.freeing import free_ways
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve

BASIN = {"category": "basin", "heading": 0.0, "size": [0.62, 0.57, 0.97]}
BATH = {"category": "bathtub", "at": [1.82, 1.86], "heading": -np.pi / 2, "size": [1.78, 0.77, 0.7]}
ROOM = {
    "name": "bathroom",
    "function": "bathroom",
    "outline": [[0, 0], [2.72, 0], [2.72, 2.24], [0, 2.24]],
    "doors": [{"at": [2.72, 0.55], "width": 0.92}],
    "fixed": [BASIN | {"at": [0.29, 0.31]}, BASIN | {"at": [0.29, 0.93]}, BATH],
    "ask": [{"group": "wardrobe"}],
}


@pytest.fixture
def task():
    brief, preset = Brief(rooms=[Room.model_validate(ROOM)]), PRESETS["default"]
    (found,), _ = prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)
    return found


def wardrobe_at(task, x: float):
    """A wardrobe of a metre on the wall beside the lower basin, its middle at ``x``."""
    case = next(c for c in cases("wardrobe").groups if (c.width, c.depth) == (1.0, 0.56))
    group = make_unplaced(task, (), Wish("wardrobe", 0, required=True), case)
    box = np.array([x, case.depth / 2, np.pi / 2, case.width, case.depth])
    dressed = dress_group(task, group, case, box, standing_of(task.fixed, flat_kinds(task.catalog)))
    assert dressed is not None
    return dressed


def test_a_wardrobe_before_a_basin_gives_way_and_stays(task):
    placed = (wardrobe_at(task, 1.12),)
    assert any("basin" in name for name in find_blocked(task, placed))
    freed = free_ways(task, placed)
    assert [p.wish.group for p in freed] == ["wardrobe"]
    assert find_blocked(task, freed) == ()


def test_where_nothing_is_barred_all_stays_as_it_is(task):
    assert free_ways(task, ()) == ()
    free = free_ways(task, (wardrobe_at(task, 1.12),))
    assert free_ways(task, free) is free


def test_a_bathroom_gets_the_wardrobe_asked_for():
    solution = solve(Brief.model_validate({"rooms": [ROOM]}))
    assert not solution.left_out
    assert check(solution).valid
