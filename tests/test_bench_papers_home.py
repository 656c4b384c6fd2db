"""The paper's experiments on homes: every room is its problem, and ours is below every method."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.papers_home import EVALUATIONS, METHODS, markdown_lines, records
from benchmarks.papers_home_rooms import BOXED, FOUR, ROOMS, case_of

from scenewright.domains.home.presets import PAPER


@pytest.mark.parametrize("room", [*ROOMS, FOUR], ids=lambda room: room.name)
def test_rooms_are_the_papers_problem(room):
    case = case_of(room)
    ground = case.problem.ground
    living = room.groups[0] == "seating"
    assert 10.0 < ground.area < 40.0
    assert (ground.area > 25.0) == living
    assert case.problem.weights == PAPER
    assert (case.problem.items.back_to_wall == 1.0).all()
    assert (len(ground.paths) > 0) == (len(room.doors) > 1)
    assert np.hypot(*(ground.main_wall[0, 2:] - ground.main_wall[0, :2])) >= 1.5


def test_three_boxes_a_door_overlap_and_take_more_than_the_printed_area():
    for room in ROOMS:
        one, three = (
            case_of(room._replace(name=room.name + more)).problem.ground.keep_free
            for more in ("", BOXED)
        )
        area = float((one[:, 3] * one[:, 4]).sum()) / len(room.doors)
        assert area == pytest.approx(np.pi * 0.8**2 / 4, rel=0.01)
        assert len(three) == 3 * len(room.doors)
        assert float((three[:, 3] * three[:, 4]).sum()) > 2.0 * area * len(room.doors)


def test_quick_form_has_every_method_and_ours_is_at_least_as_good():
    told = list(records(quick=True))
    costs = {(r["case"], r["baseline_name"]): r for r in told if r["unit"] == "cost"}
    for room in (ROOMS[0].name, ROOMS[4].name):
        for name in (*METHODS, EVALUATIONS):
            row = costs[room, name]
            assert row["least"] <= row["baseline"] <= row["most"]
            assert row["ours"] <= row["baseline"]
    table = list(markdown_lines(told))
    assert sum(line.startswith("| ") for line in table) == 1 + 4 + 3
    assert "52.74 (43.2–75.9)" in table[6]
    verdicts = [line for line in table if line.startswith("* ours below")]
    assert len(verdicts) == len(METHODS)
    assert all("in 2 of 2 rooms" in line and "in 2 of 2 in no" in line for line in verdicts)
