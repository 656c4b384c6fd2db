"""Fronts look to the way beside them; lanes go on or end in a head; landmarks have their walk."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.domains import check, plan_of
from scenewright.domains.site.facing import face_ways, find_box_doors
from scenewright.domains.site.solvers.blocks.front import on_square
from scenewright.domains.site.solvers.blocks.shares import list_edges, order_blocks
from scenewright.domains.site.solving import problems
from scenewright.ground.streetside.fronts import find_fronting, list_ways
from scenewright.ground.ways.lane_ends import BACK, LONG, TURN, find_dead_ends, lay_head, link_ends
from scenewright.ground.ways.pathways import lay_pathways
from scenewright.ground.ways.walks import find_doors

NORTH, SOUTH, EAST = math.pi / 2, -math.pi / 2, 0.0


def ground(**more: object) -> Brief:
    site = {
        "outline": [[0, 0], [120, 0], [120, 80], [0, 80]],
        "roads": [{"line": [[0, 40], [120, 40]], "width": 6}],
        "buildings": [{"model": "villa", "count": 2}],
    }
    return Brief.model_validate({"domain": "site", "name": "Fronts", "sites": [site | more]})


def turned(heading: float, brief: Brief, width: float = 10.0) -> float:
    """The heading of a house 5 metres south of the street after fronts are turned to it."""
    plan, problem = plan_of(brief).detail[0], problems(brief)[0]
    box = np.array([[60.0, 27.0, heading, width, 10.0]])
    return float(face_ways(plan, problem, box, np.ones(1, bool))[0, 2])


@pytest.mark.parametrize("heading", [NORTH, SOUTH, EAST])
def test_a_house_turns_to_its_street(heading: float) -> None:
    assert math.sin(turned(heading, ground())) == pytest.approx(1.0)


def test_a_slab_that_would_leave_its_ground_turned_by_a_quarter_stays() -> None:
    assert turned(EAST, ground(), 130.0) == EAST
    assert turned(SOUTH, ground(), 70.0) == pytest.approx(SOUTH + math.pi)


def test_who_stands_by_a_way_and_who_fronts_it() -> None:
    plan = plan_of(ground()).detail[0]
    rows = np.array([[60.0, 27, NORTH, 10, 10], [60.0, 27, SOUTH, 10, 10], [60.0, 10, NORTH, 9, 9]])
    by, fronting = find_fronting(
        list_ways(plan, ()), shapely.polygons(corners(rows)), find_box_doors(rows)
    )
    assert by.tolist() == [True, True, False]
    assert fronting.tolist() == [True, False, False]


def test_lanes_go_on_where_ground_is_free_and_turn_where_it_is_not() -> None:
    street, free = shapely.box(0, -5, 100, 0), shapely.box(-50, -50, 150, 80)
    lanes = [shapely.LineString([(x, 50), (x, 0)]) for x in (20, 60)]
    assert sorted(find_dead_ends(lanes, street, 2.0)) == [0, 1]
    links = link_ends(lanes, street, free, 2.0)
    assert not find_dead_ends([*lanes, *links], street, 2.0)
    narrow = shapely.box(17, -50, 23, 80)
    assert not link_ends(lanes[:1], shapely.Point(20, 0), narrow, 2.0)
    lane, end = lanes[0], shapely.Point(lanes[0].coords[0])
    head = lay_head(lane, end, free, free)
    assert [width for _, width in head] == [0.0, 2.0 * TURN]
    assert not lay_head(lane, end, free, shapely.box(100, 0, 120, 80))
    before = lay_head(lane, end, free, shapely.box(20, 30, 40, 34))
    assert before[0][0].length == pytest.approx(lane.length - 8.0)
    assert before[2][0].length == pytest.approx(8.0)
    assert max(BACK) < LONG


def test_a_landmark_has_its_walk_and_nothing_breaks_a_rule() -> None:
    solution = sw.solve(ground(landmarks=[{"id": "temple", "model": "pavilion", "at": [60, 66]}]))
    (works,), plan = solution.detail, plan_of(solution.brief).detail[0]
    ways = [shapely.LineString(row.line).buffer(row.width / 2) for row in works.pathways]
    streets = [shapely.Polygon(a.outline) for way in plan.roads for a in way.areas]
    mark = shapely.Polygon(plan.landmarks[0].footprint)
    assert min(mark.distance(way) for way in [*ways, *streets]) < 0.5
    assert check(solution).valid


def test_the_skyline_steps_up_to_the_square_or_the_landmark() -> None:
    roads = [{"line": [[x, -5], [x, 90]], "width": 6} for x in (40, 80)]
    square = [{"name": "Market", "area": 400, "at": [118, 40]}]
    for asked in ({"squares": square}, {"landmarks": [{"model": "villa", "at": [100, 40]}]}):
        (problem,) = problems(ground(roads=roads, **asked))
        middles = [list_edges(problem, b)[:, 0].mean() for b in order_blocks(problem)]
        assert middles == sorted(middles)


def test_a_row_that_shows_its_side_to_the_street_gets_a_lane_before_its_fronts() -> None:
    brief = ground(
        roads=[{"line": [[4, 0], [4, 80]], "width": 6}],
        buildings=[{"model": "villa", "size": [30, 10, 9], "count": 1}],
    )
    plan = plan_of(brief).detail[0]
    ring = corners(np.array([[27.0, 40.0, SOUTH, 30.0, 10.0]]))[0]
    shapes = np.array([shapely.Polygon(ring)])
    fronting = []
    for free in (None, np.zeros(1, bool)):
        network = lay_pathways(plan, [ring], np.array([SOUTH]), 4.0, 25.0, free)
        doors = find_doors([ring], network.headings)
        by, looks = find_fronting(list_ways(plan, network.pathways), shapes, doors)
        assert by.all()
        assert network.served.all()
        fronting.append(bool(looks[0]))
    assert fronting == [False, True]


def test_fronts_line_a_square_and_keep_off_the_border() -> None:
    brief = ground(
        outline=[[0, 0], [160, 0], [160, 120], [0, 120]],
        roads=[{"line": [[0, 60], [160, 60]], "width": 6}],
        squares=[{"area": 900, "at": [80, 60]}],
        buildings=[{"model": "classical_residence", "size": [12, 8, 9], "count": 14}],
    )
    solution, problem = sw.solve(brief), problems(brief)[0]
    boxes = np.array([[*p.pose[:2], p.pose.heading, *p.size[:2]] for p in solution.pieces
                      if p.category == "building"])  # fmt: skip
    assert len(boxes) == 14
    assert on_square(problem, boxes).sum() >= 4
    border = shapely.Polygon(brief.part.sites[0].outline).exterior
    off = shapely.distance(border, shapely.polygons(corners(boxes)))
    assert (off > 4.9).mean() >= 0.8
