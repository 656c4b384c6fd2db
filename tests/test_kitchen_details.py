"""Tables, fridges, machines and ends of runs in kitchens; shelves of stores, cupboards of baths."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scenewright.core.scene import Pose
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.filling.wet_rooms import _list_forms, _pick_forms
from scenewright.domains.home.composing.filling.widening import widen_groups
from scenewright.domains.home.composing.kitchen_faults import cost_of_places
from scenewright.domains.home.composing.kitchens.corners import list_round_corners
from scenewright.domains.home.composing.kitchens.fitted import FreeWalls, list_steps
from scenewright.domains.home.composing.kitchens.free_walls import list_stretches
from scenewright.domains.home.composing.kitchens.slits import SLIT, Slit, close_slits, widen_end
from scenewright.domains.home.composing.modest import find_few_places
from scenewright.domains.home.composing.places.forms import cost_of_case, list_forms, list_further
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.groups.fitted_kitchen import width_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.every import NEAR_DOOR
from scenewright.domains.home.rules.weigh_home import sum_rows
from scenewright.domains.home.settings import MERE_KITCHEN, fit_settings
from scenewright.domains.home.solving import solve
from test_kitchen_rooms import NOTHING, WASHER, Stood, held, kitchen, task_of
from test_wet_rooms import run, stood
from test_wet_rooms import task_of as task_of_room

RUN = ("drawer_cabinet", "base_cabinet", "sink_cabinet", "hob_cabinet", "dishwasher", "fridge")


@pytest.fixture(scope="module")
def large():
    """A kitchen of 18 m², furnished."""
    return solve(kitchen("kitchen", "dining_wall", wide=4.0, deep=4.5), seed=0, threads=1)


def test_the_table_of_a_large_kitchen_seats_six_in_daylight(large):
    assert len(held(large, "dining_chair", "stool")) >= 6
    (table,) = held(large, "dining_table", "round_table")
    ground = task_of(kitchen(wide=4.0, deep=4.5)).ground
    group = FurnishedGroup(Wish("dining", 0), "dining", None, (table,))
    assert sum_rows(("dim_table",), (group,), ground) < 0.5
    assert check(large).valid


def test_a_large_kitchen_has_a_dishwasher_beside_its_sink(large):
    (washer,) = held(large, "dishwasher")
    (sink,) = held(large, "sink_cabinet")
    apart = np.hypot(washer.pose.x - sink.pose.x, washer.pose.y - sink.pose.y)
    assert apart == pytest.approx((washer.size.width + sink.size.width) / 2, abs=0.1)


def wall_table(words):
    known = [*cases("dining_wall").groups, *list_further("dining_wall")]
    return next(case for case in known if case.name == words and case.depth > 0)


def test_chairs_side_by_side_before_a_wall_cost_and_those_at_the_ends_do_not():
    front = next(c for c in cases("dining_wall").groups if _turns(c) == 1 and len(_chairs(c)) == 2)
    ends = next(c for c in cases("dining_wall").groups if _turns(c) == 2 and len(_chairs(c)) == 2)
    assert "abreast_wall" in dict(find_case_faults(front))
    assert "abreast_wall" not in dict(find_case_faults(ends))


def _chairs(case):
    return [m for m in case.members if m.category == "dining_chair"]


def _turns(case):
    return len({round(m.heading, 1) for m in _chairs(case)})


def test_two_at_the_table_of_a_small_kitchen_do_not_both_face_the_wall():
    home = solve(kitchen("kitchen", "dining_wall", wide=3.4, deep=2.4), seed=0, threads=1)
    chairs = held(home, "dining_chair")
    assert len({round(p.pose.heading, 1) for p in chairs}) == len(chairs) == 2


def test_tables_with_places_enough_are_tried_first_in_a_kitchen():
    task = task_of(kitchen(wide=3.1))
    case = cases("dining_wall").groups[0]
    group = make_unplaced(task, (), Wish("dining_wall", 1), case)
    first = next(iter(list_forms(task, group)))
    assert find_few_places(first, task.ground.area) == 0.0
    assert find_few_places(case, task.ground.area) > 0.0


def with_table(x, y, *others):
    case = wall_table("1.2 m wall table for 2")
    box = np.array([x, y, -np.pi / 2, case.width, case.depth])
    dressed = FurnishedPatch(case, box, tuple(True for _ in case.members), 0)
    piece = Stood("dining_wall", "dining_table", x, 1.2).pieces[0]
    piece = replace(piece, pose=Pose(x, y, 0, 0))
    return (FurnishedGroup(Wish("dining_wall", 1), "dining_wall", dressed, (piece,)), *others)


def cost_of_table(groups, ground, costs):
    rows = ("beside_clothes", "dim_table")
    places = cost_of_places(groups, ground, costs.few_places)
    return places + sum_rows(rows, groups, ground, (), costs)


def test_tables_off_the_window_and_beside_a_wardrobe_cost():
    task = task_of(kitchen(wide=2.8, deep=3.0))
    costs = task.preset.settings.composing.costs
    clothes = Stood("wardrobe", "wardrobe", 1.0, 1.0)
    near, far = with_table(1.4, 2.5), with_table(1.4, 0.9)
    assert cost_of_table(near, task.ground, costs) == 0.0
    assert cost_of_table(far, task.ground, costs) == pytest.approx(6.0 * 1.05 / 1.05, abs=1.5)
    beside = cost_of_table((*far, clothes), task.ground, costs)
    assert beside - cost_of_table(far, task.ground, costs) == pytest.approx(costs.beside_clothes)


def test_a_fridge_hard_at_the_sink_costs_and_runs_with_worktop_between_are_listed():
    task = task_of(kitchen(wide=4.0))
    rule = task.preset.settings.composing
    hard = next(c for c in cases("kitchen").groups if c.name.startswith("2.6"))
    assert "fridge_at_sink" in dict(find_case_faults(hard))
    free = rule._replace(costs=rule.costs._replace(fridge_at_sink=0.0))
    assert cost_of_case(hard, 12.0, rule) - cost_of_case(hard, 12.0, free) == pytest.approx(8.0)
    assert cost_of_case(hard, 6.0, rule) - cost_of_case(hard, 6.0, free) == pytest.approx(2.0)
    low = list_stretches(task.ground, NOTHING, 0.6, 0.9, 0.45)
    runs = [k.lines[0].units for k in list_steps(FreeWalls(low, low, 12.0))[0]() if not k.corners]
    between = [[name for name, _ in units if units[0][0] == "fridge"][:3] for units in runs]
    assert ["fridge", "drawer_cabinet", "sink_cabinet"] in between


def test_a_washing_machine_beside_the_fridge_costs_half():
    run = Stood("kitchen", "sink_cabinet", 0.3, 0.6)
    fridge = Stood("kitchen", "fridge", 0.9, 0.6)
    run.pieces += fridge.pieces
    assert sum_rows(WASHER, (run, Stood("washer", "washing_machine", 1.5, 0.6))) == 0.5
    assert sum_rows(WASHER, (run, Stood("washer", "washing_machine", -0.3, 0.6))) == 0.0


@pytest.mark.parametrize(("x", "cost"), [(1.05, 8.0), (1.2, 6.0), (1.36, 0.0)])
def test_a_stand_beside_a_run_costs(x, cost):
    groups = (Stood("kitchen", "sink_cabinet", 0.3, 0.6), Stood("media", "tv_stand", x, 0.9))
    assert sum_rows(("watch_at_cook",), groups) == pytest.approx(cost)


def test_arms_leave_a_machine_its_place():
    task = task_of(kitchen(wide=3.6, deep=3.4))
    low = list_stretches(task.ground, NOTHING, 0.6, 0.9, 0.45)
    usual, left = (
        {
            round(width_of(x.units), 2)
            for k in list_round_corners(low, 9.0, True, spare)
            for x in k.lines
        }
        for spare in (0.0, 0.64)
    )
    assert {round(max(usual) - 0.64, 2), 2.06} & (left - usual)


def two_units(gap):
    from scenewright.core.catalog import Group, Member
    from scenewright.core.scene import Size

    low = [
        Member("drawer_cabinet", -0.55, 0, 0, 0, Size(0.5, 0.6, 0.9)),
        Member("fridge", 0.0, 0, 0, 0, Size(0.6, 0.64, 1.9)),
        Member("wall_cabinet", -0.55, -0.1, 1.45, 0, Size(0.5, 0.36, 0.7)),
    ]
    case = Group("kitchen", "two", 1.1, 0.65, tuple(low))
    return widen_end(case, Slit(low[1], 1, gap))


def test_a_slit_behind_a_fridge_is_closed_by_the_cabinet_before_it():
    closed = two_units(0.12)
    drawer, fridge, above = closed.members
    assert drawer.size.width == pytest.approx(0.62)
    assert drawer.x == above.x == pytest.approx(-0.49)
    assert above.size.width == pytest.approx(0.62)
    assert fridge.x == pytest.approx(0.12)
    assert two_units(0.6) is None


@pytest.mark.parametrize("wide", [2.62, 2.87, 3.13])
def test_no_run_ends_with_a_slit(wide):
    home = solve(kitchen("kitchen", wide=wide, deep=2.4), seed=0, threads=1)
    ends = [
        p.pose.x + side * p.size.width / 2
        for p in held(home, *RUN)
        for side in (-1, 1)
        if abs(np.sin(p.pose.heading)) > 0.9
    ]
    gaps = [min(ends, default=0.0), wide - max(ends, default=wide)]
    assert not [gap for gap in gaps if SLIT[0] < gap < 0.2]
    assert check(home).valid


def test_a_kitchen_that_something_was_taken_off_keeps_its_slit():
    task = task_of_room("kitchen", 3.4, 2.4)
    whole = stood(task, "kitchen", "2.2 m kitchen run with fridge", 1.2)
    less = whole._replace(pieces=whole.pieces[:-1])
    assert run(close_slits, task, whole) != (whole,)
    assert run(close_slits, task, less) == (less,)


def test_shelves_of_a_large_store_are_deep_and_clear_of_its_door():
    task = task_of_room("other", 4.4, 3.2)
    shelf = stood(task, "shelf", "0.8 m of bookcase", 0.6)
    (now,) = run(widen_groups, task, shelf)
    assert {p.size.depth for p in now.pieces} == {0.4}
    assert sum(p.size.width for p in now.pieces) == pytest.approx(3.6)


def test_shelves_grow_up_to_where_a_door_opens_and_no_farther():
    task = task_of_room("other", 4.4, 3.2)
    case = next(c for c in cases("shelf").groups if c.name == "0.8 m of bookcase")
    made = make_unplaced(task, (), Wish("shelf", 1), case)
    box = np.array([0.5, case.depth / 2, np.pi / 2, case.width, case.depth])
    (now,) = run(widen_groups, task, dress_group(task, made, case, box, NOTHING))
    end = max(p.pose.x + p.size.width / 2 for p in now.pieces)
    door = task.ground.keep_free[:, 0] - task.ground.keep_free[:, 3] / 2
    assert sum(p.size.width for p in now.pieces) > 0.8
    assert end <= door.min() - NEAR_DOOR + 0.01


def test_cupboards_of_bathrooms_are_tried_narrower_too():
    shallow = _list_forms("linen")[0]
    assert [round(f.width, 2) for f in _pick_forms(shallow, 2.0)] == [1.0, 0.8, 0.6]
    assert [round(f.width, 2) for f in _pick_forms(shallow, 0.65)] == [0.65]


def test_rooms_people_live_in_as_well_are_not_held_to_what_mere_kitchens_are():
    usual = PRESETS["default"].settings
    living = fit_settings(usual, ("living", "kitchen")).composing.costs
    assert fit_settings(usual, MERE_KITCHEN) == usual
    assert living.fridge_at_sink == living.abreast_wall == 0.0
    assert living == usual.composing.costs._replace(fridge_at_sink=0.0, abreast_wall=0.0)
    assert set(list_further("dining_wall")) < set(list_further("dining_wall", in_kitchen=True))
