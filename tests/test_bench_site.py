"""The site benchmark: what it measures is what it says, on the smallest of runs."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from benchmarks import comparison, site_compounds, site_methods, site_scale, site_speed, sites
from benchmarks.shapely_site import shapely_site, site_terms
from benchmarks.site_instances import example_site
from benchmarks.site_reco import Designed, compounds
from benchmarks.site_scenes import SIZES, judged, posed, scene_brief

from scenewright.core.brief import Brief
from scenewright.domains.site.brief import Site
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.solving import solve
from scenewright.engine.solve import Found
from scenewright.geometry.saliency import saliency

KEYS = ["case", "metric", "unit", "ours", "baseline", "baseline_name", "ratio", "runs"]


def test_scenes_hold_what_they_say_at_one_density() -> None:
    for size in SIZES:
        scene = posed(scene_brief(size))
        problem = scene.problems["default"]
        sizes, spacing = problem.buildings.sizes, problem.spacing
        ground = ((sizes[:, :2] + spacing).prod(1)).sum() / scene.plan.buildable
        assert len(scene.wishes) == size
        assert 0.5 < ground < 0.7


def test_the_common_measure_sees_overlaps_and_what_is_left_out() -> None:
    scene = posed(scene_brief(6))
    middle = np.mean(scene.plan.blocks[0].outline, axis=0)
    sizes = scene.problems["default"].buildings.sizes[:, :2]
    boxes = np.column_stack([np.tile([*middle, 0.0], (6, 1)), sizes])
    piled = Found((SiteLayout(boxes, np.arange(6) < 3, {}),), 1)
    row = judged(scene, piled)
    assert row["overlaps"] == 3
    assert row["valid"] == 0.0
    assert row["left_out"] == 3
    found = site_methods.run(scene, "default", "evaluations", 0)
    assert (found["overlaps"], found["left_out"], found["valid"]) == (0, 0.0, 1.0)
    assert found["value"] > row["value"]


def test_methods_tell_records() -> None:
    rows = site_methods.rows(1, (3, 6), ("evaluations",))
    records = site_methods.summary(rows)
    short = site_methods.summary(rows, site_methods.MAIN)
    assert 0 < len(short) < 0.5 * len(records)
    assert all(row in records for row in short)
    assert {row["method"] for row in rows} == set(site_methods.METHODS)
    assert all(list(record) == KEYS for record in records)
    assert all(row["overlaps"] == row["outside"] == 0 for row in rows)
    assert site_methods.converged([3.0, -1.0, -2.0, -2.01]) == 3


def test_falls_are_told_with_their_runs_and_no_share_of_nothing() -> None:
    values = {("a", 6): (0.5, 0.6, 0.7), ("a", 15): (0.3,), ("b", 6): (0.0,), ("b", 15): (0.2,)}
    rows = [
        {"method": method, "equal": "seconds", "buildings": size, "value": value}
        for (method, size), found in values.items()
        for value in found
    ]
    a, b = site_methods.falls(rows)
    assert (a["ours"], a["baseline"], a["ratio"], a["runs"]) == (0.3, 0.6, 0.5, 3)
    assert (b["ours"], b["baseline"], b["ratio"], b["runs"]) == (0.2, 0.0, None, 1)


def test_ratios_of_seconds_say_how_many_times_faster() -> None:
    ours, theirs = ([{"seconds": s, "valid": v}] * 3 for s, v in ((0.5, 0.9), (2.0, 0.6)))
    told = [
        comparison.record("case", name, unit, ours, theirs, "theirs", ("valid",))
        for name, unit in (("seconds", "s"), ("valid", "share"))
    ]
    assert [row["ratio"] for row in told] == [4.0, 1.5]
    assert [(row["ours"], row["baseline"]) for row in told] == [(0.5, 2.0), (0.9, 0.6)]
    assert comparison.ratio(0.0, 1.0, "s") is comparison.ratio(1.0, 0.0, "1") is None


def test_samples_stand_beside_their_aims() -> None:
    records = site_scale.samples_records(1, ["sample:site-120"])
    found = {row["metric"]: row for row in records}
    took = found["seconds"]
    assert took["baseline"] == site_scale.LIMIT
    assert took["ratio"] == pytest.approx(site_scale.LIMIT / took["ours"], rel=1e-2)
    assert found["valid"]["ratio"] == found["valid"]["ours"] == 1.0


def test_growing_sites_tell_records() -> None:
    records = site_scale.scale_records((15, 30), runs=1)
    assert all(list(record) == KEYS for record in records)
    wrong = [r for r in records if r["metric"] in ("overlaps", "outside", "blocked", "near")]
    assert len(wrong) == 8
    assert all(record["ours"] == 0 for record in wrong)


def test_a_moved_building_changes_the_slow_terms_as_a_whole_look_does() -> None:
    problem = example_site(12)
    boxes = site_speed.start_of(problem)
    after = boxes.copy()
    after[3, :3] += (9.0, -7.0, 0.4)
    change = shapely_site(problem, boxes).change(3, boxes[3], after[3])
    assert change == pytest.approx(site_terms(problem, after) - site_terms(problem, boxes))


def test_the_ball_is_whole() -> None:
    mesh = site_speed.bumpy_ball(24)
    assert len(mesh.faces) == 2 * 24 * 24
    assert saliency(mesh).values.max() > 0.0


def test_designed_footprints_go_where_ours_stand() -> None:
    outline = [(0.0, 0.0), (90.0, 0.0), (90.0, 70.0), (0.0, 70.0)]
    bent = shapely.Polygon([(10, 10), (40, 10), (40, 20), (20, 20), (20, 40), (10, 40)])
    slab = shapely.box(50, 50, 80, 60)
    boxes = np.array([[25, 25, -np.pi / 2, 30, 30], [65, 55, -np.pi / 2, 30, 10.0]])
    designed = Designed(boxes, np.array([6, 6]), np.array([18.0, 18.0]), (bent, slab), 0)
    pair = site_compounds.compare(Site(id="s", name="S", outline=outline), designed)
    assert pair.ours["left_out"] == 0
    assert pair.ours["coverage"] == pytest.approx(pair.theirs["coverage"])
    assert pair.theirs["valid"] == pair.ours["valid"] == 1.0
    assert pair.site.setback == 3.0


@pytest.mark.realdata(quick=True)
@pytest.mark.usefixtures("real_data")
def test_pieces_cut_by_tiles_are_one_building_again() -> None:
    rows = compounds(site_compounds.file())
    buildings = [shape for _, designed in rows for shape in designed.footprints]
    assert len(rows) == 91
    assert 1400 < len(buildings) < 1700


@pytest.mark.realdata
@pytest.mark.usefixtures("real_data")
def test_real_compounds_are_laid_out_anew() -> None:
    records = site_compounds.compound_records(6)
    found = {record["metric"]: record["ours"] for record in records}
    assert all(list(record) == KEYS for record in records)
    assert found["overlaps, sum"] == found["outside, sum"] == found["unreached, sum"] == 0
    assert found["valid, mean"] == 1.0


@pytest.mark.realdata(quick=True)
@pytest.mark.usefixtures("real_data")
def test_a_door_where_its_walk_begins_needs_no_stub() -> None:
    """In this compound one lies on a point of the raster that ways are found on."""
    site, designed = compounds(site_compounds.file())[40]
    ruled = site.model_copy(update=site_compounds.own_rules(site, designed))
    wishes = site_compounds.asked(ruled, designed, site_compounds.MODEL)
    asked = wishes.model_copy(update={"form": "peripheral"})
    solved = solve(Brief.model_validate({"domain": "site", "name": "S", "sites": [asked]}))
    assert all(len(path.line) > 1 for path in solved.detail[0].pathways)


@pytest.mark.realdata
def test_the_composition_of_compounds_is_told_beside_the_designers() -> None:
    records = list(sites.records(seed=1, count=2))
    assert all(list(record) == KEYS for record in records)
    assert [row["metric"] for row in records] == [figure.name for figure in sites.FIGURES]
    by_name = {row["metric"]: row for row in records}
    assert by_name["overlaps, sum"]["ours"] == 0.0
    assert by_name["hours of sun, median"]["baseline"] > 1.0
    assert list(sites.records(seed=1, count=2))[:6] == records[:6]
