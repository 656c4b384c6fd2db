"""Lanes, drives and footways through a block are no ground to build on."""

from __future__ import annotations

import json

import pytest
import shapely

import scenewright as sw
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains import adjust
from scenewright.domains.village.check.judge import judge_blocks
from scenewright.domains.village.check.lanes import find_on_lanes
from scenewright.domains.village.plan import plan_village
from sites import building

MAIN = {"id": "main", "line": [[-10, -3], [90, -3]], "width": 6}
ACROSS = {
    "lane": {"id": "drive", "line": [[40, -3], [42, 30], [60, 60]], "width": 4},
    "path": {"id": "walk", "line": [[20, -3], [60, 60]], "width": 2, "kind": "path"},
    "along the street side": {"id": "drive", "line": [[-5, 2], [85, 2]], "width": 4},
}


def brief(*lanes, **block) -> sw.Brief:
    outline = [[0, 0], [80, 0], [80, 50], [0, 50]]
    return sw.Brief.model_validate(
        {
            "domain": "village",
            "blocks": [{"id": "b", "outline": outline, "streets": [0], "count": 9} | block],
            "lanes": [MAIN, *lanes],
        }
    )


def houses_on(solution: sw.Solution, lane: dict) -> float:
    houses = [piece for piece in solution.pieces if piece.category == "building"]
    ground = shapely.LineString(lane["line"]).buffer(lane["width"] / 2, cap_style="flat")
    return float(shapely.intersection(shapely.union_all(polygons_of(houses)), ground).area)


@pytest.mark.parametrize("lane", ACROSS.values(), ids=ACROSS)
@pytest.mark.parametrize("preset", ["quick", "paper"])
def test_no_house_stands_on_a_lane_through_its_block(lane, preset):
    solution = sw.solve(brief(lane), preset=preset, seed=1)
    assert sum(piece.category == "building" for piece in solution.pieces) >= 4
    assert houses_on(solution, lane) < 0.3
    assert [f.message for f in sw.check(solution).findings if f.kind == "blocked_path"] == []


def test_without_the_lane_houses_stand_there():
    """So the test above can fail."""
    bare = sw.solve(brief(), preset="quick", seed=1)
    assert any(houses_on(bare, lane) > 5.0 for lane in ACROSS.values())


def test_the_referee_sees_a_house_on_a_lane():
    asked = brief(ACROSS["lane"])
    barn = building("b/barn", 41, 20, 10, 10, space="b")
    plan = plan_village(asked)
    findings, _ = judge_blocks([barn], (), plan.detail.blocks, asked.part.lanes)
    (found,) = [f for f in findings if f.kind == "blocked_path"]
    assert found.message.startswith("b/barn stands on drive by 4")
    assert found.area == pytest.approx(40.1, abs=0.3)
    beside = building("b/barn", 50, 10, 10, 10, space="b")
    assert find_on_lanes([beside], polygons_of([beside]), asked.part.lanes) == []


def test_a_house_that_stands_already_is_given():
    fixed = {"id": "old", "at": [41, 20], "heading": -1.5707963, "size": [8, 8, 6]}
    solution = sw.solve(brief(ACROSS["lane"], fixed=[fixed]), preset="quick", seed=1)
    rows = [f for f in sw.check(solution).findings if f.kind == "blocked_path"]
    assert [f.piece for f in rows] == ["old"]
    assert rows[0].given


def test_a_square_keeps_off_lanes_and_trees_do_too():
    solution = sw.solve(brief(ACROSS["path"], square=150), preset="quick", seed=1)
    ground = plan_village(solution.brief).detail.blocks[0].lanes
    assert ground.area > 90.0
    (square,) = [patch for patch in solution.patches if patch.function == "square"]
    half = square.box[3] / 2
    reach = shapely.Point(square.box[:2]).buffer(half)
    assert shapely.intersection(reach, ground).area < 0.01
    trees = [shapely.Point(p.pose[:2]) for p in solution.pieces if p.category == "tree"]
    assert not any(ground.contains(tree) for tree in trees)


def test_service_roads_of_a_map_are_lanes(tmp_path):
    """As OpenStreetMap draws a drive: ``highway=service``."""

    def feature(kind, points, **tags):
        ring = [[7.4 + x * 1.37e-5, 43.75 + y * 9e-6] for x, y in points]
        shape = [ring] if kind == "Polygon" else ring
        return {
            "type": "Feature",
            "properties": tags,
            "geometry": {"type": kind, "coordinates": shape},
        }

    outline = [(0, 0), (80, 0), (80, 50), (0, 50), (0, 0)]
    features = [
        feature("Polygon", outline, village="yes", block="yes", name="b"),
        feature("LineString", [(-10, -3), (90, -3)], highway="residential"),
        feature("LineString", ACROSS["lane"]["line"], highway="service"),
    ]
    path = tmp_path / "village.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    read = sw.read(path)
    assert read.domain == "village"
    (block,) = plan_village(read).detail.blocks
    assert block.lanes.area > 150.0
    solution = sw.solve(read, preset="quick", seed=0)
    assert [f.message for f in sw.check(solution).findings if f.kind == "blocked_path"] == []


@pytest.fixture(scope="module")
def inner_lanes():
    """A block deep enough for lanes of its own, as built once."""
    deep = brief(outline=[[0, 0], [160, 0], [160, 120], [0, 120]], count=24)
    return sw.solve(deep, steps=1, seed=1)


def adjust_house(before, at):
    """The lanes after the first house is moved, and the ids of what stands elsewhere then."""
    house = next(p for p in before.pieces if p.category == "building")
    x, y = (house.pose.x + 0.1, house.pose.y) if at is None else at
    after = adjust(before, move={house.id: (x, y)}).solution
    stood = {p.id: p.pose for p in before.pieces}
    elsewhere = {p.id for p in after.pieces if stood.get(p.id) != p.pose}
    return [lane.line.tolist() for lane in after.detail or ()], elsewhere - {house.id}


def test_a_house_moved_a_little_leaves_lanes_and_trees_where_they_are(inner_lanes):
    lanes = [lane.line.tolist() for lane in inner_lanes.detail]
    assert lanes
    assert adjust_house(inner_lanes, None) == (lanes, set())


def test_lanes_are_laid_anew_where_a_house_is_put_on_one(inner_lanes):
    lanes = [lane.line.tolist() for lane in inner_lanes.detail]
    middle = shapely.LineString(lanes[0]).interpolate(0.5, normalized=True)
    assert adjust_house(inner_lanes, (middle.x, middle.y))[0] != lanes
