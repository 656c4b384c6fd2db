"""Rooms that are kitchens and nothing else: round corners, hobs of four rings, machines in line."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Ask, Brief, Room
from scenewright.core.layout import NamedBox
from scenewright.domains import check, solution_of
from scenewright.domains.home.composing.kitchens.fitted import list_round_corners
from scenewright.domains.home.composing.kitchens.free_walls import list_stretches
from scenewright.domains.home.composing.kitchens.ways import is_walked, ways_of
from scenewright.domains.home.composing.places.flush import list_flush
from scenewright.domains.home.furnishing.obstacles import StandingObstacles, standing_of
from scenewright.domains.home.grounds.wall_places import read_walls
from scenewright.domains.home.groups.kitchen import sequence
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.rules.weigh_home import sum_rows
from scenewright.domains.home.solving import prepare_rooms, solve

UNITS = ("drawer_cabinet", "base_cabinet", "corner_cabinet", "dishwasher", "sink_cabinet")
LOW = 0.3  # what begins lower stands on the floor, metres
NOTHING = standing_of((), frozenset())


def kitchen(*asked, wide=3.3, deep=3.0):
    ask = [Ask(group=name, required=True) for name in asked]
    room = Room(
        id="kitchen",
        function="kitchen",
        outline=[[0, 0], [wide, 0], [wide, deep], [0, deep]],
        doors=[{"at": [wide - 0.7, 0.0], "width": 0.8}],
        windows=[{"at": [wide / 2, deep], "width": 1.2, "sill": 1.0}],
        ask=ask or None,
    )
    return Brief(rooms=[room])


def task_of(brief):
    made = spaces(brief)
    return prepare_rooms(brief, made, catalog_of(()), PRESETS["default"], "anneal", 0)[0][0]


@pytest.fixture(scope="module")
def eat_in():
    return solve(kitchen("kitchen", "dining_wall", "wardrobe"), seed=0, threads=1)


def held(home, *names):
    return [p for p in home.pieces if p.category in names and p.pose.z < LOW]


def test_a_kitchen_turns_a_corner_and_has_four_rings(eat_in):
    assert held(eat_in, "corner_cabinet")
    assert held(eat_in, "hob_cabinet")[0].size.width == pytest.approx(0.6)
    assert len({round(p.pose.heading, 1) for p in held(eat_in, *UNITS[:2], *UNITS[3:])}) > 1
    assert check(eat_in).valid


def test_a_wardrobe_in_a_kitchen_leaves_the_run_its_wall(eat_in):
    assert held(eat_in, "wardrobe")[0].size.width <= 1.2


def test_the_table_of_a_kitchen_one_may_eat_in_seats_four():
    home = solve(kitchen("kitchen", "dining_wall"), seed=0, threads=1)
    assert len(held(home, "dining_chair", "stool")) >= 4
    assert held(home, "corner_cabinet")


def test_a_washing_machine_stands_at_the_side_of_a_unit_without_a_dryer():
    home = solve(kitchen("kitchen", "washer", wide=4.0), seed=0, threads=1)
    (machine,) = held(home, "washing_machine")
    assert machine.size.width == pytest.approx(0.6)
    assert not held(home, "dryer")
    units = held(home, *UNITS, "hob_cabinet", "fridge")
    s, c = np.sin(machine.pose.heading), np.cos(machine.pose.heading)
    gaps = [
        abs((p.pose.x - machine.pose.x) * s - (p.pose.y - machine.pose.y) * c)
        - (p.size.width + machine.size.width) / 2
        for p in units
        if np.cos(p.pose.heading - machine.pose.heading) > 0.99
    ]
    assert min(map(abs, gaps)) < 0.03


def test_both_arms_of_a_corner_are_reached_though_the_corner_has_no_floor_of_its_own():
    task = task_of(kitchen(wide=3.6, deep=3.4))
    low = list_stretches(task.ground, NOTHING, 0.6, 0.9, 0.45)
    ways = ways_of(task, (), frozenset())
    whole = [k for k in list_round_corners(low, 2.3, True) if min(len(x.units) for x in k.lines)]
    assert sum(is_walked(ways, k, {}) for k in whole if len(k.lines) == 2) > len(whole) / 4


@pytest.mark.parametrize("side", [2.2, 3.0])
def test_a_layout_that_tells_one_line_of_a_kitchen_gets_a_whole_one(side):
    """Also in a room so small that no straight run stands free of its door."""
    home = solve(kitchen("kitchen", wide=side, deep=side), seed=0, threads=1)
    (patch,) = home.patches
    for wide in (patch.box[3], 0.9):
        row = NamedBox("kitchen", (*patch.box[:3], wide, 0.6))
        again = solution_of(home.brief, {"kitchen": [row]})
        assert not again.left_out
        assert {p.category for p in held(again, "sink_cabinet", "hob_cabinet", "fridge")} == {
            "sink_cabinet",
            "hob_cabinet",
            "fridge",
        }
        assert check(again).valid


@pytest.mark.parametrize(
    ("length", "hob"), [(1.7, 0.3), (1.85, 0.45), (2.0, 0.6), (2.1, 0.6), (3.0, 0.6)]
)
def test_a_run_has_as_many_rings_as_leave_it_its_worktop(length, hob):
    units = sequence(length)
    assert dict(units)["hob_cabinet"] == pytest.approx(hob)
    assert sum(wide for _, wide in units) == pytest.approx(length)
    assert max(wide for name, wide in units if name in UNITS[:2]) >= 0.6 - 1e-9


WASHER = ("washer_alone", "washer_at_fridge")


class Stood:
    """A group of one piece at a place."""

    def __init__(self, name, category, x, wide):
        from scenewright.core.scene import Piece, Pose, Size
        from scenewright.domains.home.programme import Wish

        self.name, self.wish, size = name, Wish(name, 0), Size(wide, 0.6, 0.85)
        self.dressed = SimpleNamespace(box=np.array([x, 0.3, np.pi / 2, wide, 0.6]))
        pose = Pose(x, 0.3, 0.0, np.pi / 2)
        self.pieces = (Piece(name, category, "", "kitchen", pose, size),)


@pytest.mark.parametrize(("x", "cost"), [(0.9, 0.0), (1.2, 14.0), (0.92, 0.0)])
def test_a_washing_machine_away_from_the_run_costs(x, cost):
    groups = (
        Stood("kitchen", "sink_cabinet", 0.3, 0.6),
        Stood("washer", "washing_machine", x, 0.6),
    )
    assert 14.0 * sum_rows(WASHER, groups) == cost
    assert sum_rows(WASHER, groups[1:]) == 0.0


@pytest.mark.parametrize(
    ("x", "wide", "cost"), [(0.9, 3.6, 0.0), (1.2, 3.6, 26.0), (1.2, 2.0, 10.4)]
)
def test_a_fridge_of_its_own_away_from_the_units_costs(x, wide, cost):
    groups = Stood("kitchenette", "sink_cabinet", 0.3, 0.6), Stood("fridge", "fridge", x, 0.6)
    task = task_of(kitchen(wide=wide))
    costs = task.preset.settings.composing.costs
    away = sum_rows(("fridge_away",), groups, task.ground, (), costs)
    assert away == pytest.approx(cost)
    assert sum_rows(("fridge_away",), groups[1:], task.ground) == 0.0


def test_arms_round_a_corner_hold_sinks_as_wide_as_they_are():
    task = task_of(kitchen(wide=3.6, deep=3.4))
    low = list_stretches(task.ground, NOTHING, 0.6, 0.9, 0.45)
    lines = [x.units for k in list_round_corners(low, 2.3, False) for x in k.lines]
    washing = [units for units in lines if {name for name, _ in units} & {"sink_cabinet"}]
    bare = [units for units in washing if "hob_cabinet" not in dict(units)]
    assert {len(units) for units in bare if sum(w for _, w in units) < 0.9} == {1}
    assert all(dict(u)["sink_cabinet"] >= 0.6 for u in bare if sum(w for _, w in u) >= 0.6)


def test_beyond_the_worktop_between_hob_and_sink_a_long_arm_goes_on_behind_the_sink():
    task = task_of(kitchen(wide=5.3, deep=2.2))
    low = list_stretches(task.ground, NOTHING, 0.6, 0.9, 0.45)
    lines = [x.units for k in list_round_corners(low, 3.3, False) for x in k.lines]
    arms = [u for u in lines if {"hob_cabinet", "sink_cabinet"} <= {name for name, _ in u}]
    assert max(sum(wide for _, wide in units) for units in arms) > 3.0
    for units in arms:
        names = [name for name, _ in units]
        ends = sorted((names.index("hob_cabinet"), names.index("sink_cabinet")))
        assert sum(wide for _, wide in units[ends[0] + 1 : ends[1]]) < 0.9 + 0.6
        assert all(wide > 0.25 for _, wide in units)


@pytest.mark.parametrize(("area", "short"), [(8.0, 0.0), (10.0, 0.75), (18.0, 5 / 6)])
def test_a_table_for_one_costs_in_a_kitchen_one_may_eat_in(area, short):
    from scenewright.domains.home.cases.library import cases
    from scenewright.domains.home.composing.modest import find_few_places

    one = next(c for c in cases("dining_wall").groups if c.name == "0.8 m wall table for 1")
    assert find_few_places(one, area) == pytest.approx(short)


def test_places_beside_what_stands_touch_it_and_stay_on_their_wall():
    from scenewright.domains.home.cases.library import cases

    task = task_of(kitchen())
    box = np.array([[1.0, 2.7, -np.pi / 2, 0.8, 0.6]])
    unit = StandingObstacles(box, np.array([[0.0, 0.9]]), ("sink_cabinet",))
    case = cases("washer").groups[0]
    found = list_flush(case, read_walls(task.ground), unit, frozenset(UNITS))
    near = found[np.abs(found[:, 1] - (3.0 - case.depth / 2)) < 0.01]
    sides = np.abs(near[:, 0] - 1.0) - (0.8 + case.width) / 2
    assert len(near) == 1  # on the other side the wall ends
    assert sides == pytest.approx(0.001)
