"""Fridges under the worktop: where they stand, what they are worth, what they look like."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks import composition_kitchen

from scenewright.catalog.assets.furniture import cooking
from scenewright.catalog.assets.materials import STONE
from scenewright.core.brief import Brief, Room
from scenewright.core.scene import Size
from scenewright.domains import check
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.groups.fitted_kitchen import (
    FittedKitchen,
    KitchenWall,
    UnitLine,
    assemble,
)
from scenewright.domains.home.groups.kitchen import fill, sequence
from scenewright.domains.home.groups.low_fridges import LOW, SHORTEST, pantry, take_in
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.solving import solve

SOUTH, WEST = KitchenWall(0.0, 0.0, 1.0, 0.0), KitchenWall(0.0, 3.0, 0.0, -1.0)
SINK, HOB, TOP = ("sink_cabinet", 0.5), ("hob_cabinet", 0.3), ("drawer_cabinet", 0.3)
WIDE = ("drawer_cabinet", 0.6)


def case_of(*lines):
    walls = (SOUTH, WEST)
    placed = (UnitLine(w, 0.5, units) for w, units in zip(walls, lines, strict=False))
    return assemble(FittedKitchen(tuple(placed)))[0]


def faults_of(*lines):
    return dict(find_case_faults(case_of(*lines)))


@pytest.mark.parametrize("length", [SHORTEST, 1.35, 1.42, 1.5, 1.59, 1.75])
def test_a_pantry_kitchen_takes_its_length_and_keeps_hob_and_sink_apart(length):
    units = pantry(length)
    assert sum(wide for _, wide in units) == pytest.approx(length)
    found = faults_of(tuple(units))
    assert "hob_at_sink" not in found
    assert found.get("worktop", 0.0) < 0.2
    assert "fridge_alone" not in found


@pytest.mark.parametrize("length", [1.7, 1.8, 2.2, 2.4, 3.0, 3.6])
def test_a_run_takes_in_a_fridge_and_nothing_of_it_is_lost(length):
    units = take_in(tuple(sequence(length)))
    assert sum(wide for _, wide in units) == pytest.approx(length)
    (cold,) = [wide for name, wide in units if name == LOW]
    assert 0.48 < cold <= 0.65
    assert not {"worktop", "hob_at_sink", "hob_at_end"} & faults_of(units).keys()
    assert take_in((SINK, TOP, HOB)) is None


def cold_of(*units):
    """The widths of the low fridge that a run takes in, and of what is left beside it."""
    taken = take_in(units)
    assert taken is not None
    assert sum(w for _, w in taken) == pytest.approx(sum(w for _, w in units))
    return [(name, round(wide, 2)) for name, wide in taken]


@pytest.mark.parametrize(
    ("wide", "cold", "rest"),
    [(0.5, 0.5, 0), (0.6, 0.6, 0), (0.65, 0.65, 0), (0.7, 0.6, 0.1), (0.79, 0.6, 0.19),
     (0.8, 0.5, 0.3), (0.95, 0.6, 0.35)],
)  # fmt: skip
def test_a_place_for_a_fridge_is_filled_or_leaves_a_cabinet_worth_having(wide, cold, rest):
    low, top = (LOW, cold), fill(rest)
    assert cold_of(SINK, ("drawer_cabinet", wide), HOB) == [SINK, low, *top, HOB]
    assert cold_of(HOB, ("drawer_cabinet", wide), SINK) == [HOB, *top, low, SINK]


def test_a_fridge_goes_under_the_longest_piece_of_worktop_else_for_the_dishwasher():
    long = ("base_cabinet", 0.6)
    beyond = ("drawer_cabinet", 0.5)
    assert cold_of(SINK, long, HOB, beyond) == [SINK, (LOW, 0.6), HOB, beyond]
    assert cold_of(beyond, SINK, long, HOB) == [beyond, SINK, (LOW, 0.6), HOB]
    washer = ("dishwasher", 0.6)
    assert cold_of(SINK, washer, beyond, HOB) == [SINK, washer, (LOW, 0.5), HOB]
    assert cold_of(SINK, washer, TOP, HOB) == [SINK, (LOW, 0.6), TOP, HOB]
    assert take_in((SINK, ("drawer_cabinet", 0.49), HOB)) is None


@pytest.mark.parametrize(
    ("length", "widths"),
    [(SHORTEST, (0.5, 0.5)), (1.35, (0.5, 0.55)), (1.4, (0.5, 0.6)), (1.6, (0.7, 0.6)),
     (1.7, (0.5, 0.6, 0.3))],
)  # fmt: skip
def test_a_pantry_gives_its_fridge_what_it_can_and_its_sink_a_sliver(length, widths):
    sink, cold, hob, *beyond = pantry(length)
    assert hob == ("hob_cabinet", 0.3)
    assert [sink[0], cold[0]] == ["sink_cabinet", LOW]
    assert [w for _, w in (sink, cold, *beyond)] == pytest.approx(list(widths))


def test_there_is_worktop_over_a_low_fridge_of_the_run_and_none_over_a_tall_one():
    low = faults_of((SINK, (LOW, 0.6), HOB, TOP))
    assert low["low_fridge"] == 1.0
    assert "worktop" not in low
    tall = faults_of((SINK, ("fridge", 0.6), HOB, TOP))
    assert tall["worktop"] == 0.5
    assert "low_fridge" not in tall
    assert faults_of((SINK, TOP, HOB, TOP), ((LOW, 0.6),))["worktop"] == 0.5


def test_above_a_fridge_of_the_run_hangs_a_cabinet():
    raised = [m.category for m in case_of((SINK, (LOW, 0.6), HOB, TOP)).members if m.z > 1.0]
    assert sorted(raised) == ["hood", "wall_cabinet", "wall_cabinet", "wall_cabinet"]
    alone = case_of((SINK, TOP, HOB, TOP), ((LOW, 0.6),))
    assert sum(m.z > 1.0 for m in alone.members) == 4


def test_a_small_kitchen_rather_has_a_low_fridge_and_a_larger_one_a_tall_one():
    rule = PRESETS["default"].settings.composing
    low = case_of((SINK, (LOW, 0.6), HOB, TOP))
    apart = case_of((SINK, WIDE, HOB, TOP), (("fridge", 0.6),))
    short = case_of((("fridge", 0.6), SINK, TOP, HOB, TOP))
    whole = case_of((("fridge", 0.6), SINK, WIDE, HOB, TOP))
    costs = [cost_of_case(case, 5.0, rule) for case in (whole, low, apart, short)]
    assert costs == sorted(costs)
    assert costs[1] < costs[3] / 2
    low, whole = (cost_of_case(case, 12.0, rule) for case in (low, whole))
    assert whole + rule.costs.short_run < low


def test_the_worktop_goes_through_over_a_low_fridge():
    def tops(size):
        found = cooking._fridge(size)
        return np.concatenate([part.vertices for part in found if part.material is STONE] or [[]])

    low, beside = tops(Size(0.6, 0.6, 0.9)), cooking._dishwasher(Size(0.6, 0.6, 0.9))
    other = next(part.vertices for part in beside if part.material is STONE)
    assert np.allclose([low.min(0), low.max(0)], [other.min(0), other.max(0)])
    assert not tops(Size(0.6, 0.64, 1.9)).size


def kitchen_of(width):
    outline = [[0, 0], [width, 0], [width, 1.6], [0, 1.6]]
    doors = [{"at": [x, 0.5], "width": 0.8} for x in (0.0, width)]
    stated = {"function": "kitchen", "outline": outline, "doors": doors}
    solution = solve(Brief(rooms=[Room(id="kitchen", **stated)]), seed=0, steps=1500)
    assert not [f for f in check(solution).findings if "fridge" in f.text]
    return [p for p in solution.pieces if p.space == "kitchen"]


@pytest.mark.parametrize(("width", "tall"), [(1.75, False), (2.6, True)])
def test_only_a_kitchen_without_room_for_a_tall_fridge_has_a_low_one(width, tall):
    pieces = kitchen_of(width)
    (fridge,) = [p for p in pieces if p.category == "fridge"]
    assert (fridge.size.height > 1.0) == tall
    assert not composition_kitchen.short_worktop(pieces)
    assert not composition_kitchen.hob_at_sink(pieces)
