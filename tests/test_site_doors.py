"""Doors of sites: a walk to each, room before it, a lane near by; said by name where one lacks."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains import check, scene_of
from scenewright.domains.site.plan import plans_of, site_plan
from scenewright.formats import solution_json
from scenewright.geometry.wavefront import find_quickest
from scenewright.ground.ways.path_tree import cut_tree, square_off
from scenewright.ground.ways.pathways import lay_pathways
from scenewright.ground.works import Pathway
from sites import building, site

SAMPLES = ("site-30", "site-courtyards", "site-landmarks")
ROAD = {"id": "lane", "line": [(0, 60), (120, 60)], "width": 8}


@pytest.fixture(scope="module")
def solved() -> Solution:
    return sw.solve(sw.read("sample:site-30"))


def judged(ground, pieces, pathways=None):
    """What the referee finds, by kind, of buildings to which ways are laid out, or some ways."""
    document = ground.model_dump()
    brief = Brief.model_validate({"domain": "site", "name": "x", "sites": [document]})
    blank = sw.solve(brief.model_copy(update={}), steps=1)
    (works,) = blank.detail
    plan = plans_of(brief)[0]
    if pathways is None:
        corners = [shapely.get_coordinates(_shape(p))[:-1] for p in pieces]
        headings = np.array([p.pose.heading for p in pieces])
        pathways = lay_pathways(plan, corners, headings, 4.0, ground.fire_reach).pathways
    works = works._replace(pathways=tuple(pathways))
    found = check(replace(blank, pieces=tuple(pieces), detail=(works,)))
    return sorted(f.kind for f in found.findings)


def _shape(piece):
    x, y, turn = piece.pose.x, piece.pose.y, piece.pose.heading
    box = shapely.box(*(-np.array(piece.size[1::-1]) / 2), *(np.array(piece.size[1::-1]) / 2))
    turned = shapely.affinity.rotate(box, turn, origin=(0, 0), use_radians=True)
    return shapely.affinity.translate(turned, x, y)


@pytest.mark.parametrize("sample", SAMPLES)
def test_every_door_of_the_samples_is_served(sample):
    solution = sw.solve(sw.read(f"sample:{sample}"))
    report = check(solution)
    assert report.valid, report.findings
    assert not solution.left_out
    (figures,) = report.figures["sites"].values()
    assert figures["doors_served"] == figures["near_lane_share"] == 1.0


def test_a_walk_taken_away_is_missed(solved):
    (works,) = solved.detail
    lanes = tuple(row for row in works.pathways if row.kind == "lane")
    report = check(replace(solved, detail=(works._replace(pathways=lanes),)))
    assert len(report.of("unserved_door")) > 20
    walks = tuple(row for row in works.pathways if row.kind == "walk")
    report = check(replace(solved, detail=(works._replace(pathways=walks),)))
    assert report.of("far_from_lane")
    narrow = tuple(row._replace(width=min(row.width, 3.0)) for row in works.pathways)
    report = check(replace(solved, detail=(works._replace(pathways=narrow),)))
    assert report.of("far_from_lane")
    assert not report.of("unserved_door")


def test_what_says_nothing_of_ways_is_not_judged_by_them_but_drawn_with_them(solved):
    silent = replace(solved, detail=None)
    assert [found.kind for found in check(silent).findings] == ["missing"]
    assert "doors_served" not in check(silent).figures["sites"][_id(silent)]
    assert [s.kind for s in scene_of(silent).surfaces] == [
        s.kind for s in scene_of(solved).surfaces
    ]


def _id(solution):
    return plans_of(solution.brief)[0].id


def test_ways_survive_a_file(solved):
    again = solution_json.loads(solution_json.dumps(solved))
    assert again.detail == solved.detail
    assert check(again).to_dict() == check(solved).to_dict()


def test_a_building_on_a_lane_and_a_door_at_the_border_are_told():
    ground = site(roads=[ROAD])
    north = building("a", 40, 70, heading=-np.pi / 2)
    assert judged(ground, [north]) == []
    lane = Pathway("lane", 4.0, ((60.0, 58.0), (60.0, 20.0)))
    on_it = building("b", 60, 30, heading=np.pi / 2)
    assert "blocked_path" in judged(ground, [on_it], [lane])
    out = building("c", 40, 7.0, heading=-np.pi / 2)
    assert "door_at_border" in judged(ground, [out])
    assert "door_at_border" not in judged(ground, [building("c", 40, 9.1, heading=-np.pi / 2)])
    free = site(door_distance=0.0, roads=[ROAD])
    assert "door_at_border" not in judged(free, [out])


def test_hours_of_sun_are_a_rule_only_where_the_brief_says_so():
    wall = building("wall", 60, 40, 60, 10, 40)
    dark = building("dark", 60, 55, 20, 10, 6)
    asked = {"roads": [ROAD | {"line": [(0, 4), (120, 4)]}], "day": 355, "latitude": 45.0}
    assert "lack_of_sun" not in judged(site(**asked), [wall, dark])
    assert judged(site(**asked, sun_required=True), [wall, dark]).count("lack_of_sun") == 1


def test_the_default_keeps_hours_of_sun_where_they_are_a_rule():
    brief = sw.read("sample:site-30")
    (asked,) = brief.part.sites
    ruled = asked.model_copy(update={"sun_required": True, "sun_hours": 3.0})
    part = brief.part.model_copy(update={"sites": [ruled]})
    solution = sw.solve(brief.model_copy(update={"part": part}))
    report = check(solution)
    assert report.valid, report.findings
    placed = report.figures["sites"][_id(solution)]["buildings"]
    assert placed >= 27
    assert bool(solution.left_out) == (placed < 30)
    assert not check(sw.solve(brief)).of("lack_of_sun")


@settings(max_examples=12, deadline=None)
@given(st.integers(0, 10**6))
def test_ways_keep_off_buildings_wherever_these_stand(seed):
    rng = np.random.default_rng(seed)
    ground = site(120, 80, roads=[ROAD])
    rows = [
        building(f"b{k}", x, y, *rng.uniform(6, 16, 2), 9, heading=float(rng.uniform(-3, 3)))
        for k, (x, y) in enumerate(rng.uniform((12, 8), (108, 40), (6, 2)))
    ]
    shapes = [_shape(row) for row in rows]
    kept = [k for k in range(6) if all(shapes[k].distance(shapes[j]) > 2 for j in range(k))]
    corners = [shapely.get_coordinates(shapes[k])[:-1] for k in kept]
    headings = np.array([rows[k].pose.heading for k in kept])
    network = lay_pathways(site_plan(ground), corners, headings, 4.0, 25.0)
    for row in network.pathways:
        line = shapely.LineString(row.line)
        if row.kind == "lane":
            assert min(shapes[k].distance(line) for k in kept) > 1.9
    found = judged(ground, [rows[k] for k in kept], network.pathways)
    wrong = {"unserved_door": ~network.served, "far_from_lane": ~network.near}
    for kind, lost in wrong.items():
        assert found.count(kind) == lost.sum(), (found, network)
    assert "blocked_path" not in found


def test_trees_of_ways_are_the_quickest_and_share_no_piece():
    rng = np.random.default_rng(3)
    slow = np.where(rng.random((24, 30)) < 0.2, np.inf, 1.0)
    slow[0, 0] = 1.0
    times, before = find_quickest(slow, 1.0, np.array([0], np.int32))
    goals = np.flatnonzero(np.isfinite(times))[5::37]
    pieces = cut_tree(before, goals.tolist())
    steps = [pair for piece in pieces for pair in pairwise(piece)]
    assert len(steps) == len(set(steps))
    ends = {piece[-1] for piece in pieces}
    assert ends <= {piece[0] for piece in pieces} | {0}
    for goal in goals:
        total, here = 0.0, int(goal)
        while before[here] >= 0:
            last = int(before[here])
            total += np.hypot(here // 30 - last // 30, here % 30 - last % 30)
            here = last
        assert total == pytest.approx(times[goal])


@given(st.integers(0, 10_000))
def test_stretches_aslant_become_two_legs_over_free_ground(seed: int) -> None:
    rng = np.random.default_rng(seed)
    slow = np.where(rng.random((20, 26)) < 0.15, np.inf, rng.uniform(1, 2, (20, 26)))
    path = rng.integers(0, slow.size, 4).astype(np.int32)
    slow.reshape(-1)[path] = 1.0
    found = square_off(path, slow).tolist()
    assert [cell for cell in found if cell in path] == path.tolist() or len(set(path)) < 4
    corners = [k for k, cell in enumerate(found) if cell not in path]
    for k in corners:
        for a, b in ((found[k - 1], found[k]), (found[k], found[k + 1])):
            (r0, c0), (r1, c1) = divmod(a, 26), divmod(b, 26)
            assert r0 == r1 or c0 == c1
            rows, columns = sorted((r0, r1)), sorted((c0, c1))
            leg = slow[rows[0] : rows[1] + 1, columns[0] : columns[1] + 1]
            assert np.isfinite(leg).all()
    empty = square_off(path, np.ones_like(slow)).tolist()
    steps = [np.subtract(divmod(a, 26), divmod(b, 26)) for a, b in pairwise(empty)]
    assert all(np.abs(step).min() < 2 for step in steps)
