"""Villages composed: lanes into deep ground, fronts about squares, outbuildings behind houses."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains import plan_of
from scenewright.domains.village.lanes import opened
from scenewright.ground.ways.inner_lanes import area_of, lay_inner_lanes

NOTHING = np.zeros(0, object)
SOUTH = np.array([[[0.0, 0.0], [90.0, 0.0]]])


@pytest.fixture(scope="module")
def hamlet() -> sw.Solution:
    return sw.solve(sw.read("sample:village-hamlet"), preset="quick")


def test_a_deep_block_gets_a_loop_that_comes_back_to_its_street() -> None:
    lanes = lay_inner_lanes(shapely.box(0, 0, 90, 80), SOUTH, NOTHING, 3.6)
    assert lanes
    for lane in lanes:
        assert lane.head == 0.0
        assert np.abs(lane.line[[0, -1], 1]).max() < 0.1 or len(lanes) > 1


def test_a_shallow_block_gets_none() -> None:
    assert lay_inner_lanes(shapely.box(0, 0, 90, 30), SOUTH, NOTHING, 3.6) == ()


def test_lanes_keep_off_what_stands() -> None:
    stands = np.array([shapely.box(10, 20, 60, 60)], object)
    for lane in lay_inner_lanes(shapely.box(0, 0, 120, 110), SOUTH, stands, 3.6):
        assert area_of(lane).distance(stands[0]) > 1.0


def test_where_no_loop_fits_a_dead_end_has_a_turning_head() -> None:
    street = np.array([[[0.0, 0.0], [22.0, 0.0]]])
    (lane,) = lay_inner_lanes(shapely.box(0, 0, 22, 110), street, NOTHING, 3.0)
    assert lane.head >= 5.0
    head = shapely.Point(lane.line[-1]).buffer(lane.head - 0.1)
    assert area_of(lane).covers(head)
    assert shapely.box(0, 0, 22, 110).covers(head)


def test_houses_keep_off_laid_lanes_and_look_at_them(hamlet: sw.Solution) -> None:
    plan = opened(plan_of(hamlet.brief), hamlet).detail
    assert hamlet.detail
    houses = [p for p in hamlet.pieces if p.category == "building"]
    shapes = polygons_of(houses)
    lanes = plan.blocks[0].lanes
    assert shapely.area(shapely.intersection(shapes, lanes)).max() < 0.01
    ways = shapely.union_all(shapely.linestrings(plan.blocks[0].streets))
    assert (shapely.distance(shapes, ways) <= 12.0).mean() >= 0.8
    assert sw.check(hamlet).valid


@pytest.mark.parametrize("style", ["hui", "riviera"])
def test_houses_nearer_than_a_passage_stand_square_to_each_other(style: str) -> None:
    brief = sw.read("sample:village-dense").model_copy(update={"style": style})
    solution = sw.solve(brief, preset="quick", seed=5)
    houses = [p for p in solution.pieces if p.category == "building"]
    shapes = polygons_of(houses)
    turn = np.array([p.pose.heading for p in houses])
    away = shapely.distance(shapes[:, None], shapes[None])
    apart = np.abs((turn[:, None] - turn[None] + np.pi / 4) % (np.pi / 2) - np.pi / 4)
    near = (away < 1.5) & ~np.eye(len(houses), dtype=bool)
    assert near.sum() >= 20
    assert np.degrees(apart[near].max()) < 3.0


def test_the_referee_finds_a_house_on_a_laid_lane(hamlet: sw.Solution) -> None:
    from dataclasses import replace

    spot = hamlet.detail[0].line[len(hamlet.detail[0].line) // 2]
    first = hamlet.pieces[0]
    moved = replace(first, pose=first.pose._replace(x=float(spot[0]), y=float(spot[1])))
    told = sw.check(replace(hamlet, pieces=(moved, *hamlet.pieces[1:])))
    assert any("stands on a lane" in found.message for found in told.findings)


def test_fronts_stand_about_the_square(hamlet: sw.Solution) -> None:
    x, y, _, width, _ = hamlet.patches[0].box
    square = shapely.Point(x, y).buffer(width / 2, cap_style="square")
    houses = [p for p in hamlet.pieces if p.category == "building"]
    near = [p for p, s in zip(houses, polygons_of(houses), strict=True) if s.distance(square) < 6.0]
    looking = [
        p
        for p in near
        if np.cos(p.pose.heading) * (x - p.pose.x) + np.sin(p.pose.heading) * (y - p.pose.y) > 0
    ]
    assert len(looking) >= 2


def test_few_are_outbuildings_and_a_saved_village_reads_back(tmp_path) -> None:
    solution = sw.solve(sw.read("sample:village-street"), preset="quick")
    houses = [p for p in solution.pieces if p.category == "building"]
    small = sum(shape.area < 45 for shape in polygons_of(houses))
    assert small <= 0.35 * len(houses)
    sw.write(solution, tmp_path / "a.json")
    again = sw.read_solution(tmp_path / "a.json")
    assert len(again.detail or ()) == len(solution.detail or ())
    assert sw.check(again).valid == sw.check(solution).valid


def test_the_printed_method_lays_no_lanes() -> None:
    solution = sw.solve(sw.read("sample:village-hamlet"), preset="paper")
    assert solution.detail is None
