"""Kitchens made to measure: free walls, lines along them, and what is told of them beforehand."""

from __future__ import annotations

from itertools import islice

import numpy as np
import pytest
import shapely
from benchmarks import composition_kitchen

from scenewright.core.brief import Brief, Room
from scenewright.core.scene import Piece, Pose
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import Missing
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.kitchens.corners import list_us
from scenewright.domains.home.composing.kitchens.fitted import FreeWalls, list_steps
from scenewright.domains.home.composing.kitchens.foreseen import foresee_cost
from scenewright.domains.home.composing.kitchens.free_walls import list_stretches
from scenewright.domains.home.composing.kitchens.mend import mend_kitchens
from scenewright.domains.home.composing.kitchens.ways import is_walked, trim_to_ways, ways_of
from scenewright.domains.home.composing.places.forms import cost_of_case
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.furnishing.whole import Gone
from scenewright.domains.home.groups.fitted_kitchen import (
    FittedKitchen,
    KitchenWall,
    UnitLine,
    assemble,
    list_solid,
    overlap,
)
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget

ROOM = {
    "function": "kitchen",
    "outline": [[0, 0], [3.4, 0], [3.4, 3.0], [0, 3.0]],
    "doors": [{"at": [2.6, 0.0], "width": 0.8}],
    "windows": [{"at": [1.6, 3.0], "width": 1.0, "sill": 1.0}, {"at": [3.4, 2.0], "width": 0.8}],
}


def task_of(stated):
    from scenewright.building.plan import spaces
    from scenewright.catalog.loading import catalog_of

    brief = Brief(rooms=[Room(id="kitchen", **stated)])
    catalog = catalog_of(())
    tasks, _ = prepare_rooms(brief, spaces(brief), catalog, PRESETS["default"], "anneal", 0)
    return tasks[0]


@pytest.fixture(scope="module")
def task():
    return task_of(ROOM)


@pytest.fixture(scope="module")
def free(task):
    standing = standing_of(task.fixed, frozenset())
    low = list_stretches(task.ground, standing, 0.6, 0.9, 0.45)
    tall = list_stretches(task.ground, standing, 0.64, 1.9, 0.5)
    return FreeWalls(low, tall, task.ground.area)


def box_shape(box):
    x, y, turn, wide, deep = box
    across, ahead = np.array([np.sin(turn), -np.cos(turn)]), np.array([np.cos(turn), np.sin(turn)])
    return shapely.Polygon(
        [(x, y) + across * a * wide / 2 + ahead * b * deep / 2 for a, b in
         ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    )  # fmt: skip


@pytest.mark.parametrize(("depth", "height"), [(0.6, 0.9), (0.64, 1.9), (0.3, 0.5)])
def test_free_stretches_are_those_a_probe_finds(task, depth, height):
    ground = task.ground
    found = list_stretches(ground, standing_of((), frozenset()), depth, height, 0.05)
    taken = [box_shape(b) for b in ground.keep_free]
    taken += [box_shape(w[:5]) for w in ground.windows if w[5] < height]
    taken = shapely.union_all(taken)
    for number, (x0, y0, x1, y1) in enumerate(ground.walls):
        length = np.hypot(x1 - x0, y1 - y0)
        u = np.array([x1 - x0, y1 - y0]) / length
        for t in np.arange(0.015, length, 0.01):
            at = np.array([x0, y0]) + u * t
            ray = shapely.LineString(at + np.outer((0.03, depth - 0.03), (-u[1], u[0])))
            ends = [abs(t - e) for s in found if s.number == number for e in (s.start, s.end)]
            if min([*ends, t, length - t]) < 0.03:
                continue
            held = any(s.number == number and s.start < t < s.end for s in found)
            assert held == (not ray.intersects(taken)), (number, t)


def test_kitchens_of_every_step_stand_in_the_room_and_their_units_apart(task, free):
    floor = shapely.Polygon(task.space.outline).buffer(1e-6)
    shapes = set()
    for step in list_steps(free):
        listed = [k for k in islice(step(), 200) if not overlap(k)]
        assert listed
        for kitchen in listed[::3]:
            case, box = assemble(kitchen)
            solid = shapely.union_all([box_shape(b) for b in list_solid(kitchen)])
            assert floor.contains(solid)
            units = [m for m in case.members if m.z < 0.3 and m.category != "corner_cabinet"]
            areas = [m.size.width * m.size.depth for m in units]
            pieces = [_placed(m, box) for m in units]
            assert shapely.union_all(pieces).area == pytest.approx(sum(areas), abs=1e-3)
            assert solid.buffer(0.05).contains(shapely.union_all(pieces))
            names = {m.category for m in case.members}
            assert {"hob_cabinet", "sink_cabinet", "fridge"} <= names
            assert case.function == "kitchen"
            shapes.add((len(kitchen.lines), len(kitchen.corners)))
    assert {(1, 0), (2, 1), (2, 0), (3, 0)} <= shapes


def _placed(member, box):
    x, y, turn = box[:3]
    c, s = np.cos(turn), np.sin(turn)
    at = (x + member.x * s + member.y * c, y - member.x * c + member.y * s)
    return box_shape((*at, turn + member.heading, member.size.width, member.size.depth))


def test_faults_of_fitted_kitchens_are_those_the_benchmark_counts(free):
    counted = {
        "worktop": composition_kitchen.short_worktop,
        "hob_at_sink": composition_kitchen.hob_at_sink,
        "hob_at_end": composition_kitchen.hob_at_end,
    }
    for step in list_steps(free):
        for kitchen in list(islice(step(), 60))[::2]:
            case, _ = assemble(kitchen)
            found = {name for name, _ in find_case_faults(case)}
            pieces = [
                Piece(f"{k}", m.category, "", "room", Pose(m.x, m.y, m.z, m.heading + np.pi / 2),
                      m.size)
                for k, m in enumerate(case.members)
            ]  # fmt: skip
            assert {name for name, fault in counted.items() if fault(pieces)} <= found


@pytest.mark.parametrize(("area", "alone"), [(7.0, True), (9.0, False)])
def test_a_sink_stands_alone_at_its_wall_in_small_kitchens_at_most(free, area, alone):
    short = [free.low[0], free.low[1]._replace(start=0.0, end=0.6)]
    walls = free._replace(low=short, area=area)
    lines = [k.lines[1].units for step in list_steps(walls)[2:3] for k in step()]
    assert any([name for name, _ in units] == ["sink_cabinet"] for units in lines) == alone


def test_what_is_foreseen_of_a_kitchen_is_near_what_its_case_costs(free):
    rule = PRESETS["default"].settings.composing
    for area in (5.0, 12.0):
        pairs = [
            (foresee_cost(k, area, rule), cost_of_case(assemble(k)[0], area, rule))
            for step in list_steps(free)
            for k in list(islice(step(), 60))[::2]
            if not overlap(k)
        ]
        told, seen = np.array(pairs).T
        assert np.mean(np.abs(told - seen)) < 1.5
        if area > 9.0:
            assert np.corrcoef(told, seen)[0, 1] > 0.9


def test_three_walls_hold_a_u_with_two_corner_cabinets(free):
    wide = task_of(ROOM | {"outline": [[0, 0], [3.6, 0], [3.6, 3.4], [0, 3.4]],
                           "windows": []})  # fmt: skip
    low = list_stretches(wide.ground, standing_of((), frozenset()), 0.6, 0.9, 0.45)
    found = list(list_us(low, 2.3))
    assert found
    assert all(len(k.corners) == 2 for k in found)
    assert not [k for k in found if overlap(k)]
    sound = [dict(find_case_faults(assemble(k)[0])) for k in found]
    assert min(max(faults.values(), default=0.0) for faults in sound) < 0.1
    mild = {"triangle", "few_rings", "small_sink", "fridge_at_sink"}
    assert {name for faults in sound for name in faults} <= mild


def test_kitchens_of_rooms_people_live_in_are_no_longer_than_these_ask_for(free):
    def longest(walls):
        return max(
            sum(wide for line in kitchen.lines for _, wide in line.units)
            for kitchen in list_steps(walls)[2]()
        )

    assert longest(free._replace(more=0.4)) < longest(free) - 0.3


def test_lines_that_share_floor_overlap():
    one = UnitLine(KitchenWall(0.0, 0.0, 1.0, 0.0), 0.0, (("hob_cabinet", 0.6),))
    other = UnitLine(KitchenWall(0.0, 2.0, 0.0, -1.0), 0.0, (("sink_cabinet", 0.6),))
    near = other._replace(start=1.6)
    assert not overlap(FittedKitchen((one, other)))
    assert overlap(FittedKitchen((one, near)))


def test_what_nobody_can_come_to_is_not_walked(task, free):
    ways = ways_of(task, (), frozenset())
    open_walls = trim_to_ways(ways, free.low, 0.45)
    assert sum(s.end - s.start for s in open_walls) <= sum(s.end - s.start for s in free.low)
    line = UnitLine(
        KitchenWall(0.0, 3.0, 0.0, -1.0), 0.4, (("sink_cabinet", 0.6), ("hob_cabinet", 0.6))
    )
    known = {}
    assert is_walked(ways, FittedKitchen((line,)), known)
    across = UnitLine(KitchenWall(1.9, 0.65, 1.0, 0.0), 0.0, (("hob_cabinet", 1.5),))
    assert not is_walked(ways, FittedKitchen((across, line)), known)
    assert len(known) == 2


def test_a_kitchen_of_four_metres_square_turns_the_corner():
    brief = Brief(rooms=[Room(id="kitchen", **ROOM)])
    solution = solve(brief, seed=0, steps=1500)
    assert not check(solution).findings
    names = [p.category for p in solution.pieces]
    assert {"hob_cabinet", "sink_cabinet", "fridge"} <= set(names)
    pieces = list(solution.pieces)
    assert not composition_kitchen.short_worktop(pieces)
    assert not composition_kitchen.hob_at_end(pieces)
    assert not composition_kitchen.hob_at_sink(pieces)


def faults_of(*lines, corners=()):
    return dict(find_case_faults(assemble(FittedKitchen(lines, corners))[0]))


def test_sinks_without_worktop_and_units_by_themselves_are_faults():
    south, north = KitchenWall(0.0, 0.0, 1.0, 0.0), KitchenWall(4.0, 2.4, -1.0, 0.0)
    west = KitchenWall(0.0, 2.4, 0.0, -1.0)
    top, hob, sink = ("drawer_cabinet", 0.6), ("hob_cabinet", 0.6), ("sink_cabinet", 0.6)
    fridge, named = ("fridge", 0.6), {"sink_alone", "fridge_alone", "split"}
    run = UnitLine(south, 0.0, (fridge, sink, top, hob, top))
    assert not named & faults_of(run).keys()
    cooking = UnitLine(south, 1.0, (top, hob, top))
    assert (
        named
        <= faults_of(cooking, UnitLine(west, 0.0, (sink,)), UnitLine(north, 0.0, (fridge,))).keys()
    )
    assert not named & faults_of(cooking, UnitLine(north, 1.0, (top, sink, fridge))).keys()
    past = UnitLine(north, -0.6, (top, sink, fridge))
    assert named & faults_of(cooking, past).keys() == {"split"}
    facing = faults_of(cooking, UnitLine(north, 1.0, (top, sink, fridge)))
    assert facing["across"] == 1.0
    assert faults_of(cooking, UnitLine(north, 1.6, (sink,)))["across"] > 1.0
    assert "across" not in faults_of(run)
    beyond = KitchenWall(4.0, 5.0, -1.0, 0.0)
    assert named & faults_of(cooking, UnitLine(beyond, 1.0, (top, sink, fridge))).keys() == {
        "split"
    }
    corner = UnitLine(west, 0.3, (fridge, sink))
    joined = faults_of(UnitLine(south, 0.9, (hob, top)), corner, corners=(south,))
    assert not named & joined.keys()


def without_kitchen(task, found):
    gone = [g for g in found.placed if g.wish.group in ("kitchen", "kitchenette", "fridge")]
    missing = tuple(Missing(g.wish, "no walking route of the stated width") for g in gone)
    rest = tuple(g for g in found.placed if g not in gone)
    return found._replace(placed=rest, missing=(*found.missing, *missing))


def test_a_kitchen_that_was_lost_to_the_ways_is_made_to_measure(task):
    wish = Wish("kitchen", 0, core=True)
    answer = furnish_by_use(task, (wish,), Budget(threads=1, steps=3000))
    bare = without_kitchen(task, answer)
    assert bare.missing
    (mended,) = mend_kitchens([task], [bare], list)
    assert [g.wish.group for g in mended.placed] == ["kitchen"]
    assert not mended.missing
    names = {p.category for g in mended.placed for p in g.pieces}
    assert {"hob_cabinet", "sink_cabinet", "fridge"} <= names
    shut = [without_kitchen(task, mended)]
    assert mend_kitchens([task], [bare], lambda _: shut) == [bare]


def test_no_further_kitchen_is_looked_for_once_cancelled(task):
    wish = Wish("kitchen", 0, core=True)
    answer = furnish_by_use(task, (wish,), Budget(threads=1, steps=3000))
    bare, opened = without_kitchen(task, answer), []

    def refuse(trial):
        opened.append(trial)
        return [bare]

    mend_kitchens([task], [bare], refuse)
    assert len(opened) > 1
    opened.clear()
    assert mend_kitchens([task._replace(cancel=lambda: bool(opened))], [bare], refuse) == [bare]
    assert len(opened) == 1


def test_a_kitchen_that_lost_its_cabinets_to_the_ways_is_made_to_measure(task):
    wish = Wish("kitchen", 0, core=True)
    answer = furnish_by_use(task, (wish,), Budget(threads=1, steps=3000))
    (whole,) = mend_kitchens([task], [without_kitchen(task, answer)], list)
    (run,) = whole.placed
    tops = ("drawer_cabinet", "base_cabinet", "corner_cabinet", "dishwasher")
    fewer = tuple(p for p in run.pieces if p.category not in tops)
    robbed = whole._replace(
        placed=(run._replace(pieces=fewer),), gone=(Gone("drawer_cabinet", "it would bar"),)
    )
    (mended,) = mend_kitchens([task], [robbed], list)
    names = {p.category for g in mended.placed for p in g.pieces}
    assert names.intersection(tops)
    assert not mended.gone
