"""The referee on sites: every rule seen to fail and to hold; figures against sums by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from benchmarks.site_reco import compounds

from deadline import within
from scenewright.core.report import KINDS
from scenewright.core.scene import Piece, Pose
from scenewright.domains import check
from scenewright.domains.site.check import figures as referee
from scenewright.domains.site.check.sun import sun, sunny_sides
from scenewright.domains.site.plan import site_plans
from sites import SOUTH, answer, building, field, quarter, site


def judge_sites(sites, pieces):
    return referee.judge_sites(sites, pieces, site_plans(sites))


def kinds(ground, *pieces):
    return sorted(found.kind for found in judge_sites([ground], pieces).findings)


def only(ground, *pieces):
    findings = judge_sites([ground], pieces).findings
    assert len(findings) == 1, findings
    return findings[0]


def figures(ground, *pieces):
    return judge_sites([ground], pieces).figures["s"]


def test_buildings_side_by_side_are_fine_and_overlaps_are_told():
    assert kinds(site(), building("a", 30, 40), building("b", 40, 40)) == []
    found = only(site(), building("a", 30, 40), building("b", 39, 41))
    assert (found.kind, found.piece, found.other) == ("collision", "a", "b")
    assert found.amount == pytest.approx(1.0)
    assert found.area == pytest.approx(7.0)
    mark = {"id": "m", "outline": [(50, 30), (70, 30), (50, 50)], "height": 8.0}
    piece = Piece("m", "building", "", "s", Pose(60, 40, 0, SOUTH), (20, 20, 8), fixed=True)
    ground = site(landmarks=[mark])
    assert kinds(ground, building("a", 68, 46), piece) == []  # the box about it, not itself
    assert kinds(ground, building("a", 58, 38), piece) == ["collision"]


def test_what_leaves_the_site_floats_or_is_too_high():
    found = only(site(height_limit=20.0), building("a", 3, 40))
    assert (found.kind, found.amount, found.area) == ("out_of_bounds", 2.0, 16.0)
    holed = site(holes=[[(50, 30), (60, 30), (60, 40), (50, 40)]])
    assert kinds(holed, building("a", 50, 36)) == ["out_of_bounds"]
    assert kinds(holed, building("a", 55, 35, 2, 2)) == ["out_of_bounds", "unreachable_building"]
    high = only(site(height_limit=20.0), building("a", 30, 40, h=21.5))
    assert (high.kind, high.amount) == ("too_high", 1.5)
    assert kinds(site(), building("a", 30, 40, z=0.5)) == ["floating"]
    assert kinds(site(), building("a", 30, 40, z=-0.5)) == ["sunk"]


def test_setbacks_from_the_border_and_from_roads():
    road = {"id": "lane", "line": [(60, 0), (60, 80)], "width": 6.0}
    ground = site(setback=5.0, road_setback=2.0, roads=[road])
    assert kinds(ground, building("a", 10, 40), building("b", 50, 40)) == []
    near = only(ground, building("a", 9, 40))
    assert (near.kind, near.amount) == ("setback", 1.0)
    assert "stands 4.00 m from the border of the site, 5 m are required" in near.message
    lane = only(ground, building("a", 51.5, 40))
    assert (lane.kind, lane.other, lane.amount) == ("setback", "lane", 1.5)
    on = only(ground, building("a", 54, 40))
    assert (on.kind, on.other, on.amount) == ("blocked_path", "lane", 2.0)
    pond = site(setback=5.0, holes=[[(50, 30), (60, 30), (60, 40), (50, 40)]])
    assert only(pond, building("a", 67, 35)).amount == pytest.approx(3.0)


def test_spacing_names_distance_and_partner():
    ground = site(spacing=6.0)
    assert kinds(ground, building("a", 30, 40), building("b", 46, 40)) == []
    found = only(ground, building("a", 30, 40), building("b", 45, 40))
    assert (found.kind, found.piece, found.other, found.amount) == ("spacing", "a", "b", 1.0)
    diagonal = only(ground, building("a", 30, 30), building("b", 43, 42))
    assert diagonal.amount == pytest.approx(6 - 5)


def test_distance_for_the_sun_counts_behind_a_building_only():
    ground = site(sun_spacing=1.5)
    low, high = building("low", 60, 20, h=6.0), building("high", 60, 20, h=12.0)
    behind, beside = building("n", 60, 38), building("e", 71, 30)
    assert kinds(ground, low, behind) == []  # 10 m behind 6 m: 9 are needed
    found = only(ground, high, behind)
    assert (found.piece, found.other, found.amount) == ("n", "high", pytest.approx(8.0))
    assert kinds(ground, high, beside) == []
    assert kinds(ground, behind, building("s", 60, 56, h=12.0)) == ["spacing"]
    overlapping = [building("south", 60, 30), building("north", 60, 36)]
    told = [f.piece for f in judge_sites([ground], overlapping).findings if f.kind == "spacing"]
    assert told == ["north"]
    austral = site(sun_spacing=1.5, latitude=-35.0)
    assert only(austral, low, building("n", 60, 38, h=12.0)).piece == "low"


def test_the_fire_brigade_needs_a_way_of_its_width():
    road = {"line": [(0, 5), (120, 5)], "width": 6.0}
    ring = [
        building("w", 40, 50, 4, 44),
        building("e", 80, 50, 4, 44),
        building("n", 60, 74, 44, 4),
        building("s1", 48, 26, 18, 4),
        building("s2", 72, 26, 18, 4),
    ]
    gate = 72 - 48 - 18
    assert gate == 6
    yard = building("yard", 60, 50)
    assert kinds(site(roads=[road], fire_access=5.9), *ring, yard) == []
    found = only(site(roads=[road], fire_access=6.1), *ring, yard)
    assert (found.kind, found.piece) == ("unreachable_building", "yard")
    off = site(roads=[road | {"line": [(0, 5), (0.1, 5)]}], fire_access=4.0)
    assert kinds(off, building("bar", 20, 40, 4, 80), yard) == ["unreachable_building"]


def test_paths_are_entered_but_not_driven():
    path = {"line": [(60, 10), (60, 70)], "width": 3.0, "kind": "path"}
    ends_inside = site(roads=[path])
    assert kinds(ends_inside, building("a", 30, 40)) == []  # no entrance: from the outline
    bar = building("bar", 60, 40, 120, 4, heading=math.pi / 2)
    crossing = site(roads=[path | {"line": [(20, 0), (20, 30)]}])
    far = kinds(crossing, bar, building("a", 30, 60))
    assert far == ["unreachable_building"]


def test_landmarks_stay_as_they_are():
    ground = site(landmarks=[{"id": "m", "at": (60, 40), "size": (10, 8, 9)}])
    there = building("m", 60, 40, fixed=True)
    assert kinds(ground, there) == []
    assert kinds(ground) == ["changed_landmark"]
    for other in (
        replace(there, pose=Pose(60.5, 40, 0, SOUTH)),
        replace(there, pose=Pose(60, 40, 0, SOUTH + 0.1)),
        building("m", 60, 40, h=12),
    ):
        assert only(ground, other).kind == "changed_landmark"
    near = only(
        site(landmarks=[{"id": "m", "at": (60, 40), "size": (10, 8, 9)}], spacing=6.0),
        there,
        building("a", 75, 40),
    )
    assert (near.kind, near.piece, near.other) == ("spacing", "a", "m")
    assert not near.given


def test_landmarks_may_be_named_with_their_site_and_trees_are_let_be():
    ground = site(landmarks=[{"id": "m", "at": (60, 40), "size": (10, 8, 9)}])
    tree = replace(building("t", 60, 40), category="tree")
    assert kinds(ground, building("s/m", 60, 40, fixed=True), tree) == []
    assert only(ground, building("s/m", 61, 40, fixed=True), tree).piece == "m"


def test_locked_buildings_are_told_but_not_blamed():
    locked = [building("a", 30, 40, fixed=True), building("b", 39, 40, fixed=True)]
    assert only(site(), *locked).given
    assert not only(site(), replace(locked[0], fixed=False), locked[1]).given


def test_broken_pieces_are_findings():
    broken = [
        building("nan", math.nan, 40),
        building("flat", 30, 40, h=0.0),
        building("lost", 30, 40, space="t"),
        building("far", 1e9, 40),
    ]
    assert kinds(site(), *broken) == ["malformed"] * 4
    assert figures(site())["south_share"] == 1.0


def test_figures_by_hand():
    wish = {"model": "modern_residential", "floors": 5, "size": (10, 8, 9)}
    ground = site(buildings=[wish | {"model": "modern_residential"}], sun_hours=2.0)
    pieces = [
        building("a", 30, 40),
        building("b", 60, 40, heading=SOUTH + 0.5),
        building("c", 90, 40, heading=SOUTH + 0.6, asset="villa"),
    ]
    found = figures(ground, *pieces)
    assert found["coverage"] == pytest.approx(240 / 9600)
    assert found["floor_area"] == pytest.approx(80 * 5 + 80 * 5 + 80 * 3)
    assert found["floor_area_ratio"] == pytest.approx(1040 / 9600, abs=1e-4)
    assert found["south_share"] == pytest.approx(2 / 3, abs=1e-4)
    gaps = shapely.distance(*np.array([[shapely.box(25, 36, 35, 44)], [_turned(60, 0.5)]]))
    assert found["least_spacing"] <= float(gaps[0]) + 1e-3
    assert found["reached_share"] == 1.0


def _turned(x, angle):
    return shapely.affinity.rotate(shapely.box(x - 5, 36, x + 5, 44), angle, use_radians=True)


def test_the_sun_of_an_open_field_and_behind_a_wall():
    """South fronts see the sun from 8 to 16 in winter; a long wall to the south hides it while
    its shadow on the sill is longer than the gap: tan(altitude) < (H - 0.9) / gap along the
    sun's way, worked out here minute by minute."""
    ground = site(600, 400, latitude=35.0, day=20)
    alone = figures(ground, building("a", 300, 200))["sun_hours"]
    assert alone["a"] == pytest.approx(8.0)
    gap, high = 24.0, 15.0
    wall = building("wall", 300, 200 - 4 - gap - 1, 598, 2, high)
    hidden = figures(ground, building("a", 300, 200), wall)["sun_hours"]["a"]
    hours = np.arange(8 + 1 / 120, 16, 1 / 60)
    tilt = math.radians(-20.14)
    phi, turn = math.radians(35.0), (hours - 12) * math.pi / 12
    up = math.sin(phi) * math.sin(tilt) + math.cos(phi) * math.cos(tilt) * np.cos(turn)
    north = math.cos(phi) * math.sin(tilt) - math.sin(phi) * math.cos(tilt) * np.cos(turn)
    lit = (high - 0.9) * -north / up < gap
    assert 0.5 < hidden < 7.5
    assert hidden == pytest.approx(lit.mean() * 8, abs=0.3)


def test_sunny_sides_and_the_sun_itself():
    corners = np.array([[(5, 4), (5, -4), (-5, -4), (-5, 4)]], float)
    assert sunny_sides(corners[:, [0, 3, 2, 1]], 30.0)[0][:, 1].tolist() == [-4, -4]
    assert sunny_sides(corners[:, [0, 3, 2, 1]], -30.0)[0][:, 1].tolist() == [4, 4]
    path = sun(40.0, 355)
    noon = path[np.argmax(path[:, 2])]
    assert math.degrees(math.asin(noon[2])) == pytest.approx(90 - 40 - 23.45, abs=0.2)
    assert noon[1] < 0
    assert np.linalg.norm(path, axis=1) == pytest.approx(1.0)
    assert (sun(-40.0, 355)[:, 1] > -0.8).all()


@pytest.mark.parametrize("angle", [0.37, 1.9])
def test_findings_do_not_depend_on_how_the_site_lies(angle):
    ground, pieces = quarter()
    cos, sin = math.cos(angle), math.sin(angle)

    def spun(p):
        return cos * p[0] - sin * p[1] + 50, sin * p[0] + cos * p[1] - 20

    document = ground.model_dump()
    document["outline"] = [spun(p) for p in document["outline"]]
    document["holes"] = [[spun(p) for p in hole] for hole in document["holes"]]
    for road in document["roads"]:
        road["line"] = [spun(p) for p in road["line"]]
    for mark in document["landmarks"]:
        if mark["at"]:
            mark["at"], mark["heading"] = spun(mark["at"]), mark["heading"] + angle
        if mark["outline"]:
            mark["outline"] = [spun(p) for p in mark["outline"]]
    turned = [
        replace(p, pose=Pose(*spun(p.pose[:2]), p.pose.z, p.pose.heading + angle)) for p in pieces
    ]
    before = judge_sites([ground], pieces)
    after = judge_sites([type(ground).model_validate(document)], turned)
    key = [(f.kind, f.piece, f.other) for f in before.findings]
    assert [(f.kind, f.piece, f.other) for f in after.findings] == key
    assert [f.amount for f in after.findings] == pytest.approx(
        [f.amount for f in before.findings], abs=2e-3
    )
    for name in ("coverage", "floor_area_ratio", "least_spacing", "mean_spacing"):
        assert after.figures["s"][name] == pytest.approx(before.figures["s"][name], abs=2e-3)


def test_the_quarter_has_just_its_faults():
    ground, pieces = quarter()
    found = {(f.kind, f.piece, f.other) for f in judge_sites([ground], pieces).findings}
    assert ("blocked_path", "kiosk", "walk") in found
    assert ("changed_landmark", "rotunda", "") in found
    assert {kind for kind, *_ in found} <= set(KINDS)


def test_check_judges_briefs_of_sites():
    ground, pieces = quarter()
    report = check(answer(ground, pieces))
    assert not report.valid
    assert report.figures["counts"]["blocked_path"] == 1
    assert report.figures["sites"]["s"]["buildings"] == 8
    assert "blocked path" in str(report)


def test_a_large_site_is_judged():
    ground, pieces = field(6000)
    with within(60):
        found = judge_sites([ground], pieces)
    assert found.findings == []
    assert len(found.figures["s"]["sun_hours"]) == 120
    assert found.figures["s"]["least_spacing"] == pytest.approx(14.0)


@pytest.mark.realdata(quick=True)
def test_designers_are_judged(real_data):
    """What designers built never crashes the referee, and mostly overlaps nothing."""
    rows = compounds(
        real_data / "site_reco_sample" / "reco_sample.json", id="s", spacing=0.0, setback=0.0
    )
    for ground, designed in rows[:30]:
        pieces = [
            building(f"b{k}", x, y, w, d, h, heading=a)
            for k, ((x, y, a, w, d), h) in enumerate(
                zip(designed.boxes.tolist(), designed.heights.tolist(), strict=True)
            )
        ]
        found = figures(ground, *pieces)
        assert 0.02 < found["coverage"] < 0.8
        assert 0 <= found["sun_mean"] <= 8
