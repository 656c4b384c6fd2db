"""Seats that the search leaves turned away are set up before their stage, or left out by name."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.retouch.audience import measure_audience
from scenewright.domains.hall.seats import seat_audiences
from scenewright.domains.hall.seats.turns import count_away


def lay_out(seed: int, **room: Any) -> Solution:
    brief = Brief.model_validate(
        {"domain": "hall", "rooms": [{"name": "Hall", "height": 4.0} | room]}
    )
    return scenewright.solve(brief, seed=seed, threads=1)


def measure(found: Solution, seats: str, shown: str) -> tuple[int, int, float]:
    """How many seats stand, look away, and how far the nearest is from what is shown."""
    boxes = {
        name: np.array(
            [(*p.pose[:2], p.pose.heading, *p.size[:2]) for p in found.pieces if p.category == name]
        )
        for name in (seats, shown)
    }
    stage = boxes[shown][0]
    ahead = (boxes[seats][:, :2] - stage[:2]) @ (np.cos(stage[2]), np.sin(stage[2]))
    first = float((ahead - 0.5 * (boxes[seats][:, 4] + stage[4])).min())
    return len(boxes[seats]), count_away(boxes[seats], stage), first


LECTURES = {
    "outline": [[0, 0], [18, 0], [20, 24], [-2, 24]],
    "doors": [
        {"at": [1.5, 24], "width": 1.8, "swing": "out"},
        {"at": [16.5, 24], "width": 1.8, "swing": "out"},
    ],
    "zones": [
        {"id": "front", "outline": [[0, 0], [18, 0], [18.5, 6], [-0.5, 6]]},
        {"id": "audience", "outline": [[-0.5, 6], [18.5, 6], [19.6667, 20], [-1.6667, 20]]},
    ],
    "demands": [
        {"category": "stage", "zone": "front", "size": [10, 4, 0.5]},
        {"category": "screen", "zone": "front", "size": [6, 0.5, 3.4]},
        {"category": "auditorium_seat", "zone": "audience", "fill": 0.6},
    ],
}


@pytest.mark.parametrize("seed", [0, 1])
def test_a_lecture_hall_that_narrows_looks_at_its_stage(seed: int) -> None:
    found = lay_out(seed, **LECTURES)
    many, away, first = measure(found, "auditorium_seat", "stage")
    assert many > 250
    assert away == 0
    assert 1.5 < first < 4.0
    assert scenewright.check(found).valid


def test_rows_far_from_their_stage_are_a_fault() -> None:
    """Of two alike blocks on the axis of a stage the one 15 m off counts 11 m more."""
    stage = np.array([0.0, 0.0, 0.0, 6.0, 3.0])
    rows = np.array([(x, y, np.pi, 0.55, 0.62) for x in (0.0, 1.2) for y in (-0.6, 0.0, 0.6)])
    ahead = np.array([1.81, 0.0, 0.0, 0.0, 0.0])
    near, far = (
        measure_audience(rows + ahead + np.array([x, 0, 0, 0, 0]), stage, np.pi)
        for x in (4.0, 15.0)
    )
    assert near == pytest.approx(0.0, abs=1e-6)
    assert far == pytest.approx(11.0)


def test_seats_without_room_before_their_stage_are_left_out_by_name(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(seat_audiences, "_seat", lambda *_: None)
    found = lay_out(0, **LECTURES)
    assert not any(piece.category == "auditorium_seat" for piece in found.pieces)
    assert [one.reason for one in found.left_out] == [seat_audiences.REASON]
