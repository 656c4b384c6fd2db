"""A fridge that stands apart from its kitchen when a home is done, and the kitchen in one piece."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.arranging.verdict import better
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.domains.home.attempts.attempt import RoomAnswer, find_blocked
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.kitchens.far_fridges import has_far_fridge
from scenewright.domains.home.composing.kitchens.fridge_places import list_ends, list_fridge_moves
from scenewright.domains.home.composing.kitchens.remade import find_faults
from scenewright.domains.home.composing.kitchens.trades import list_moved
from scenewright.domains.home.composing.mend_rooms import mend_rooms
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.composing.verdict import judge_room, measure_held
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.groups.fitted_kitchen import (
    FittedKitchen,
    KitchenWall,
    UnitLine,
    assemble,
)
from scenewright.domains.home.groups.kitchen import short_counters
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms

RUN = (
    ("drawer_cabinet", 0.3),
    ("hob_cabinet", 0.6),
    ("drawer_cabinet", 0.6),
    ("sink_cabinet", 0.6),
)
SCANT = (*RUN[:2], ("drawer_cabinet", 0.3), RUN[3])
"""The same with hardly any worktop."""
WIDE, DEEP = 4.2, 3.4
SOUTH = KitchenWall(0.0, 0.0, 1.0, 0.0)
NORTH = KitchenWall(WIDE, DEEP, -1.0, 0.0)


def task_of(wide=WIDE):
    room = {
        "id": "live",
        "function": ["living", "kitchen"],
        "outline": [[0, 0], [wide, 0], [wide, DEEP], [0, DEEP]],
        "doors": [{"at": [wide - 0.6, DEEP], "width": 0.8, "swing": "out"}],
        "windows": [{"at": [0.0, 1.7], "width": 1.0, "sill": 0.9}],
    }
    brief = Brief(rooms=[Room.model_validate(room)])
    preset, rooms = PRESETS["default"], spaces(brief)
    return prepare_rooms(brief, rooms, catalog_of(()), preset, preset.solver, 0)[0][0]


def holds_less(after, before):
    held = [measure_held(placed) for placed in (after, before)]
    return any(held[0][k] < held[1][k] - 0.1 for k in held[0])


def put(task, name, case, box, beside=()):
    group = make_unplaced(task, beside, Wish(name, 0), case)
    standing = standing_of([p for g in beside for p in g.pieces], flat_kinds(task.catalog))
    dressed = dress_group(task, group, case, np.array(box), standing)
    assert dressed is not None
    return dressed


def kitchen(task, start=0.0, fridge=3.4):
    """A run at the south wall and its fridge at the north wall."""
    lines = (UnitLine(SOUTH, start, RUN), UnitLine(NORTH, fridge, (("fridge", 0.6),)))
    return put(task, "kitchen", *assemble(FittedKitchen(lines)))


def chest(task, x, beside):
    case = next(c for c in cases("chest").groups if c.width <= 1.0)
    box = [x + case.width / 2, case.depth / 2, np.pi / 2, case.width, case.depth]
    return put(task, "chest", case, box, beside)


def join(task, *placed, opened=list):
    (answer,) = mend_rooms([task], [RoomAnswer(0.0, placed, (), (), None, 0.0, 0)], opened)
    return answer.placed


def cold(placed):
    return next(p for g in placed for p in g.pieces if p.category == "fridge")


def test_a_fridge_stands_at_the_end_of_its_run_instead_of_across_the_room():
    task = task_of()
    before = kitchen(task)
    assert has_far_fridge((before,))
    assert cold((before,)).pose.y > 2.9
    after = join(task, before)
    assert not has_far_fridge(after)
    assert not find_blocked(with_narrow_ways(task), after)
    assert not holds_less(after, (before,))


def test_a_fridge_takes_the_place_of_a_chest_beside_the_run_which_goes_elsewhere():
    task = task_of()
    run = kitchen(task)
    before = (run, chest(task, 2.1, (run,)))
    after = join(task, *before)
    assert not has_far_fridge(after)
    moved = next(g for g in after if g.wish.group == "chest")
    assert moved.dressed.case.width >= before[1].dressed.case.width - 0.25
    assert np.hypot(*(moved.dressed.box - before[1].dressed.box)[:2]) > 0.3


def test_a_fridge_that_would_bar_a_way_of_the_home_stays():
    task = task_of()
    before = kitchen(task)

    def barred(answers):
        return [answer._replace(gone=(*answer.gone, "way")) for answer in answers]

    assert join(task, before, opened=barred) == (before,)


def test_a_fridge_near_its_run_is_left_alone():
    task = task_of()
    near = kitchen(task, 0.7)
    case = next(c for c, _ in list_ends(near.dressed.case))
    joined = put(task, "kitchen", case, near.dressed.box)
    assert not has_far_fridge((joined,))
    assert join(task, joined) == (joined,)


def test_the_ends_of_a_run_are_where_nothing_of_it_follows():
    task = task_of()
    run = kitchen(task, 0.7)
    ends = [fridge for _, fridge in list_ends(run.dressed.case)]
    along = sorted(round(f.x, 2) for f in ends)
    half = sum(wide for _, wide in RUN) / 2
    assert along == pytest.approx([-half - 0.3, -half - 0.25, half + 0.25, half + 0.3])
    moved = list(list_moved(task, (run,), list_fridge_moves(task, (run,))))
    assert {away for _, away in moved} == {()}


def test_a_hob_before_a_window_finds_a_place_beside_it():
    task = task_of()
    east = KitchenWall(WIDE, 0.0, 0.0, 1.0)
    west = KitchenWall(0.0, DEEP, 0.0, -1.0)
    units = (*RUN, ("fridge", 0.6))
    before = put(task, "kitchen", *assemble(FittedKitchen((UnitLine(west, 0.6, units),))))
    bright = put(task, "kitchen", *assemble(FittedKitchen((UnitLine(east, 0.2, units),))))
    assert (find_faults(task, (before,)), find_faults(task, (bright,))) == ((0, 1, 0), (0, 0, 0))
    after = join(task, before)
    assert find_faults(task, after) == (0, 0, 0)
    assert not holds_less(after, (before,))
    assert join(task, bright) == (bright,)


def join_second_run(task, units, opened=list):
    """A room with a run at the south wall and one cabinet across, before and after."""
    line = UnitLine(SOUTH, 0.05, (("fridge", 0.6), *units))
    run = put(task, "kitchen", *assemble(FittedKitchen((line,))))
    case = next(c for c in short_counters() if c.width == 0.6)
    box = [0.7, DEEP - case.depth / 2, -np.pi / 2, case.width, case.depth]
    placed = (run, put(task, "counter", case, box, (run,)))
    answer = RoomAnswer(0.0, placed, (), (), None, 0.0, 0)
    return placed, mend_rooms([task], [answer], opened)[0]


def test_a_single_cabinet_goes_beside_the_run():
    before, after = join_second_run(task_of(), RUN)
    (cabinet,) = (g for g in after.placed if g.wish.group == "counter")
    assert cabinet.dressed.box[1] < 1.0
    assert measure_held(after.placed) == pytest.approx(measure_held(before))
    assert not after.missing


@pytest.mark.parametrize(("units", "stays"), [(RUN, False), (SCANT, True)])
def test_a_single_cabinet_with_no_place_there_stays_only_for_want_of_worktop(units, stays):
    before, after = join_second_run(task_of(2.8), units)
    names = [g.name for g in before if stays or g.name != "counter"]
    assert [g.name for g in after.placed] == names
    assert [m.wish.group for m in after.missing] == ([] if stays else ["counter"])


def test_neither_a_fridge_nor_a_window_is_worth_a_sink_away_from_its_hob():
    task = task_of()
    west = KitchenWall(0.0, DEEP, 0.0, -1.0)
    lines = (UnitLine(SOUTH, 2.0, RUN[:3]), UnitLine(west, 0.1, (("fridge", 0.6), RUN[3])))
    apart = put(task, "kitchen", *assemble(FittedKitchen(lines)))
    verdict = judge_room(task, RoomAnswer(0.0, (apart,), (), (), None, 0.0, 0))
    far = judge_room(task, RoomAnswer(0.0, (kitchen(task),), (), (), None, 0.0, 0))
    assert (verdict.findings["split"], far.findings["far fridge"]) == (1, 1)
    assert not better(verdict, far)
