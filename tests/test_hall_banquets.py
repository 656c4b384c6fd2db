"""Tables stand before the stage of their zone, over all of that floor, with passages between."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall import retouch
from scenewright.domains.hall.retouch.banquets import find_banquets, measure_banquet
from scenewright.domains.hall.solving import problems

WIDE, DEEP = 26.0, 14.0
ZONE = np.array([0.0, 0.0, WIDE, DEEP])


def gala(*more: dict[str, Any], **tables: Any) -> Brief:
    """A stage of 8 m and round tables of 1.8 m in a hall of 26 by 14 m."""
    room = {
        "name": "Hall",
        "outline": [[0, 0], [WIDE, 0], [WIDE, DEEP], [0, DEEP]],
        "doors": [{"at": [6, 0], "width": 2.0, "swing": "out"}],
        "demands": [
            {"category": "stage", "size": [8, 3.5, 0.6]},
            {"category": "round_table", "size": [1.8, 1.8, 0.74], **tables},
            *more,
        ],
    }
    return Brief.model_validate({"domain": "hall", "passage_width": 1.8, "rooms": [room]})


def read_boxes(solution: Solution, category: str, more: float = 0.0) -> np.ndarray:
    """Boxes (n, 5) of the pieces of a category, ``more`` metres wider and deeper."""
    mine = [piece for piece in solution.pieces if piece.category == category]
    return np.array(
        [(*p.pose[:2], p.pose.heading, p.size.width + more, p.size.depth + more) for p in mine]
    )


def measure(solution: Solution) -> float:
    tables = read_boxes(solution, "round_table", 0.8)
    return measure_banquet(tables, read_boxes(solution, "stage")[0], ZONE, 1.8)


def test_tables_beside_a_stage_off_its_axis_and_packed_count() -> None:
    stage = np.array([1.75, 7.0, 0.0, 8.0, 3.5])
    x, y = (part.ravel() for part in np.meshgrid(6.5 + 4.4 * np.arange(5), (2.6, 7.0, 11.4)))
    tables = np.column_stack([x, y, 0.0 * x, 2.6 + 0.0 * x, 2.6 + 0.0 * x])
    off_axis = np.array([0.0, 1.0, 0.0, 0.0, 0.0])
    assert measure_banquet(tables, stage, ZONE, 1.8) == pytest.approx(0.0, abs=0.05)
    assert measure_banquet(tables + off_axis, stage, ZONE, 1.8) == pytest.approx(0.8)
    packed = tables * (0.8, 1.0, 1.0, 1.0, 1.0)
    assert measure_banquet(packed, stage, ZONE, 1.8) > 3.0
    corner = np.array([4.0, 12.25, -0.5 * np.pi, 8.0, 3.5])
    assert measure_banquet(tables, corner, ZONE, 1.8) > 4.0


def test_only_tables_in_the_zone_of_a_stage_that_nobody_else_looks_at_are_its_banquet() -> None:
    def count(brief: Brief) -> int:
        (one,) = problems(brief)
        return len(find_banquets(one.problem, one.start))

    assert count(gala(count=10, patterns=["grid"])) == 1
    assert count(gala(count=3, patterns=["grid"])) == 0
    seats = {"category": "auditorium_seat", "count": 40}
    assert count(gala(seats, count=10, patterns=["grid"])) == 0


def test_ten_tables_stand_before_their_stage(monkeypatch: pytest.MonkeyPatch) -> None:
    brief = gala(count=10)
    found = [scenewright.solve(brief, seed=seed, threads=1) for seed in range(3)]
    assert all(scenewright.check(one).valid and not one.left_out for one in found)
    assert max(measure(one) for one in found) < 2.0
    touches = tuple(row for row in retouch.RETOUCHES if row.name != "banquets")
    monkeypatch.setattr(retouch, "RETOUCHES", touches)
    before = [scenewright.solve(brief, seed=seed, threads=1) for seed in range(3)]
    assert max(measure(one) for one in before) > 4.0


def test_a_hall_is_filled_with_as_many_tables_as_leave_the_passages_it_asks_for() -> None:
    found = scenewright.solve(gala(count=8, fill=0.7), seed=1, threads=1)
    tables = read_boxes(found, "round_table", 0.8)
    off = np.abs(tables[:, None, :2] - tables[None, :, :2]).max(-1) - 2.6
    assert 10 <= len(tables) <= 15
    assert off[~np.eye(len(tables), dtype=bool)].min() > 1.5
    assert scenewright.check(found).valid
