"""The hall benchmark: what it measures is what it says, on the smallest of runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks import (
    draw_hall_lists,
    hall_ablation,
    hall_malls,
    hall_methods,
    hall_scale,
    papers_halls,
    papers_halls_forms,
    papers_halls_lists,
    papers_halls_measures,
    papers_halls_scenes,
)
from benchmarks.hall_measure import energies_of, gaps_of, least_tree, own_energy
from benchmarks.papers_halls_markdown import markdown_lines
from benchmarks.papers_halls_scenes import read_scene

from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.solving import solve
from scenewright.formats import read
from thoroughness import only_thorough

CASE = "sample:hall-irregular"
KEYS = ["case", "metric", "unit", "ours", "baseline", "baseline_name", "ratio", "runs"]


@pytest.fixture(scope="module")
def solved() -> Solution:
    return solve(read(CASE), seed=1, steps=2000)


def test_the_common_measure_sees_what_gets_worse(solved: Solution) -> None:
    found = energies_of(solved)
    assert found.least - 1e-6 <= found.space + found.proportion
    every = [piece for piece in solved.pieces if piece.function == "finds"]
    seats = [piece for piece in every if piece.group == every[0].group]
    middle = np.mean([piece.pose[:2] for piece in seats], axis=0)
    inmost = min(seats, key=lambda piece: float(np.hypot(*(piece.pose[:2] - middle))))
    onto = [replace(piece, pose=inmost.pose) for piece in seats]
    moved = {piece.id: piece for piece in onto}
    worse = replace(solved, pieces=tuple(moved.get(p.id, p) for p in solved.pieces))
    assert energies_of(worse).space > found.space + 1.0
    assert energies_of(worse).fill == pytest.approx(found.fill, rel=0.2)


def test_least_tree_and_gaps() -> None:
    boxes = np.array([[0, 0, 0, 1, 1], [3, 0, 0, 1, 1], [3, 5, 0, 1, 1.0]])
    gaps = gaps_of(boxes)
    assert gaps[0, 1] == pytest.approx(2.0)
    assert gaps[1, 2] == pytest.approx(4.0)
    assert np.allclose(gaps, gaps.T)
    assert sorted(tuple(sorted(pair)) for pair in least_tree(gaps)) == [(0, 1), (1, 2)]


def test_methods_and_quality_tell_records() -> None:
    rows = [hall_methods.run(CASE, name, 0) for name in ("default", "paper", "random")]
    records = hall_methods.summary(rows)
    assert {record["baseline_name"] for record in records} == {"paper", "random"}
    assert all(list(record) == KEYS for record in records)
    assert rows[0]["overlaps"] == rows[0]["outside"] == 0
    quality = hall_methods.quality(1, [CASE])
    assert all(list(record) == KEYS for record in quality)


def test_own_energy_is_the_sum_of_the_printed_terms(solved: Solution) -> None:
    printed = [
        term for term in solved.terms if term.term in ("space", "fill", "access", "proportion")
    ]
    assert own_energy(solved) == pytest.approx(sum(term.value for term in printed))


def test_ablation_shows_the_failures_of_space_and_proportion() -> None:
    brief = Brief.model_validate(hall_ablation.HALL)
    full, bare, wide = (
        [hall_ablation.ablated(brief, name, seed, "anneal").figures for seed in range(3)]
        for name in ("all", "space", "proportion")
    )
    middle = {name: sorted(f[name] for f in full)[1] for name in ("covered", "gap")}
    assert sorted(f["covered"] for f in bare)[1] > middle["covered"] + 0.02
    assert sorted(f["gap"] for f in wide)[1] > middle["gap"] * 1.3
    rows = hall_ablation.rows(1)
    assert all(list(record) == KEYS for record in hall_ablation.summary(rows))


def test_walls_are_generated_in_three_of_the_samples() -> None:
    runs = [hall_ablation.run(case, "gd-mh", "all", 0) for case in hall_methods.halls()]
    assert sum(row["walls"] > 0 for row in runs) == 3


def test_scaled_halls_hold_what_they_say() -> None:
    for objects in hall_scale.SIZES:
        room = hall_scale.scaled_brief(objects).rooms[0]
        assert sum(demand.count or 0 for demand in room.demands) == objects
        outline = np.array(room.outline)
        assert np.ptp(outline, axis=0).prod() / objects == pytest.approx(6.5)
    records = hall_scale.summary(hall_scale.rows((20,), runs=1, steps=50))
    assert all(list(record) == KEYS for record in records)
    assert records[-1]["ours"] == 1.0


def test_growth_exponent() -> None:
    sizes = [20.0, 100.0, 500.0]
    assert hall_scale.growth(sizes, [3 * size**1.5 for size in sizes]) == pytest.approx(1.5)


@only_thorough
@pytest.mark.realdata
@pytest.mark.slow
@pytest.mark.usefixtures("real_data")
def test_a_real_station_is_filled_unit_by_unit() -> None:
    records = hall_malls.records(maps=["apb"])
    assert all(list(record) == KEYS for record in records)
    assert records[0]["metric"] == "valid units"
    assert records[0]["runs"] == 1


def test_the_paper_s_table_counts_only_whole_and_valid_runs() -> None:
    good = {"valid": 1.0, "whole": True, "aesthetic": 0.02}
    rows = [
        good,
        good | {"whole": False, "aesthetic": 0.5},
        good | {"valid": 0.0, "aesthetic": 0.9},
    ]
    assert papers_halls_measures.counted(rows) == [good]
    assert papers_halls_measures.figure(rows, "aesthetic").mean == 0.02
    ours = papers_halls_measures.MeasuredFigure(1.0, 0.0, 5)
    assert not papers_halls_measures.no_worse(ours, ours._replace(mean=1.1), "aesthetic")
    assert papers_halls_measures.no_worse(ours, ours._replace(mean=1.1), "circulation")


def test_the_paper_s_table_in_brief() -> None:
    found = list(papers_halls.records(quick=True))
    assert all(list(record)[:8] == KEYS for record in found)
    names = {record["baseline_name"] for record in found if record["metric"] == "uniformity"}
    tried = {"default", "paper", "paper-repaired", "by hand"}
    assert {name.split(",")[0] for name in names} == tried
    share = [r for r in found if r["metric"] == "valid and complete"]
    assert all(record["ours"] == 1.0 for record in share)
    table = "\n".join(markdown_lines(found))
    assert table.count("\n| **ours** | 100% |") == 2
    assert table.count("\n| home | by hand | 100% |") == 1
    assert table.count("No worse than: aesthetic, ") == 2
    assert table.count("\n| irregular | gd-mh | 2 |") == 1
    assert table.count("\n| paintings | 45 | 100% | 3 |") == 1


def test_every_requirement_list_finds_room_in_the_one_outline() -> None:
    layouts = {name: papers_halls_lists.lay_out(name, 0) for name in papers_halls_lists.lists()}
    assert len(layouts) == 4
    assert not any(one.left_out for one in layouts.values())
    assert len({len(one.pieces) for one in layouts.values()}) == 4
    picture = draw_hall_lists.panel(layouts["paintings"], "paintings")
    dots = set(map(tuple, np.asarray(picture).reshape(-1, 3).tolist()))
    assert {draw_hall_lists.WALL, draw_hall_lists.DOOR} <= dots


@pytest.mark.parametrize("case", papers_halls_scenes.SCENES)
def test_layouts_drawn_by_hand_hold_what_is_asked_for_and_are_valid(case: str) -> None:
    row = papers_halls_measures.run_by_hand(case)
    assert row["valid"] == 1.0, row["told"]
    assert row["whole"]
    asked = read_scene(case).rooms[0].demands
    assert sum(demand.count or 0 for demand in asked) <= row["objects"]


def test_the_printed_fill_is_blind_to_expansion() -> None:
    found = papers_halls_forms.printed_forms("sample:hall-reading-room")
    fill = [record for record in found if record["metric"].startswith("E_u")]
    space = [record for record in found if record["metric"].startswith("E_s")]
    assert len({record["baseline"] for record in fill}) == 1
    assert len({record["ours"] for record in fill}) == len(papers_halls_forms.SPREADS)
    assert all(record["baseline"] == record["ours"] for record in space), "both have β"
