"""The desk of who demonstrates stands on the stage, between the lectern and the piano."""

from __future__ import annotations

import math
from typing import Any

import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution

DESK: dict[str, Any] = {"category": "desk", "size": [2.4, 0.8, 0.9]}


def lecture(*more: dict[str, Any], stage: tuple[float, float, float] = (8, 3, 0.4)) -> Solution:
    room = {
        "name": "Lecture hall",
        "outline": [[0, 0], [12, 0], [12, 15], [0, 15]],
        "doors": [{"at": [2, 15], "width": 1.4}, {"at": [10, 15], "width": 1.4}],
        "demands": [{"category": "stage", "size": stage}, {"category": "lectern"}, *more],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, seed=0, threads=1)


def find(found: Solution, category: str) -> Any:
    return next(piece for piece in found.pieces if piece.category == category)


SEATS: dict[str, Any] = {"category": "auditorium_seat", "count": 60}


def test_who_stands_behind_it_looks_at_the_audience() -> None:
    found = lecture(SEATS, DESK)
    desk, stage = find(found, "desk"), find(found, "stage")
    assert desk.on == stage.id
    assert desk.pose.z == pytest.approx(stage.size.height)
    assert math.cos(desk.pose.heading - stage.pose.heading) == pytest.approx(-1.0)
    apart = math.dist(desk.pose[:2], find(found, "lectern").pose[:2])
    assert apart > 0.5 * desk.size.width + 0.3
    assert scenewright.check(found).valid


@pytest.mark.parametrize("low", [{"stage": (4, 3, 0.4)}, {"stage": (8, 1.8, 0.4)}])
def test_a_stage_without_room_for_it_carries_none(low: dict[str, Any]) -> None:
    assert find(lecture(SEATS, DESK, **low), "desk").on is None


def test_without_an_audience_and_where_it_is_said_otherwise_it_stands_on_the_floor() -> None:
    assert find(lecture(DESK), "desk").on is None
    assert find(lecture(SEATS, DESK | {"place": "wall"}), "desk").on is None
