"""The site benchmark: what it measures is what it says, on the smallest of runs."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from benchmarks import site_compounds, site_methods, site_scale, site_speed
from benchmarks.shapely_site import shapely_site, site_terms
from benchmarks.site_instances import example_site
from benchmarks.site_reco import Designed, compounds
from benchmarks.site_scenes import SIZES, judged, posed, scene_brief

from scenewright.brief_site import Site
from scenewright.geometry.saliency import saliency
from scenewright.solvers.site_found import SiteFound

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
    piled = SiteFound(boxes, np.arange(6) < 3, {}, 1)
    row = judged(scene, piled)
    assert row["overlaps"] == 3
    assert row["valid"] == 0.0
    assert row["left_out"] == 3
    found = site_methods.run(scene, "default", "evaluations", 0)
    assert (found["overlaps"], found["left_out"], found["valid"]) == (0, 0.0, 1.0)
    assert found["value"] > row["value"]


def test_methods_tell_records() -> None:
    rows = site_methods.rows(1, (6, 15), ("evaluations",))
    records = site_methods.summary(rows)
    short = site_methods.summary(rows, site_methods.MAIN)
    assert 0 < len(short) < 0.5 * len(records)
    assert all(row in records for row in short)
    assert {row["method"] for row in rows} == set(site_methods.METHODS)
    assert all(list(record) == KEYS for record in records)
    assert all(row["overlaps"] == row["outside"] == 0 for row in rows)
    assert site_methods.converged([3.0, -1.0, -2.0, -2.01]) == 3


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


@pytest.mark.realdata
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
