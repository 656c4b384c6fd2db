"""Audiences look at their stage, and the referee notes those that do not."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution

CONFERENCE = Brief.model_validate(
    {
        "domain": "hall",
        "rooms": [
            {
                "name": "Conference",
                "outline": [[0, 0], [20, 0], [20, 13], [0, 13]],
                "doors": [
                    {"id": "in", "at": [3, 0], "width": 1.8},
                    {"at": [0, 11], "width": 1.2, "swing": "out"},
                ],
                "zones": [
                    {"id": "plenary", "area": 160},
                    {"id": "coffee", "area": 60, "door": "in"},
                ],
                "demands": [
                    {"category": "stage", "zone": "plenary", "size": [6, 2.5, 0.6]},
                    {"category": "auditorium_seat", "count": 110, "zone": "plenary"},
                    {"category": "round_table", "count": 4, "zone": "coffee"},
                ],
            }
        ],
    }
)


@pytest.mark.parametrize("seed", [2, 5])
def test_a_large_audience_sits_before_its_stage(seed: int) -> None:
    found = scenewright.solve(CONFERENCE, seed=seed, threads=1)
    stage = next(piece for piece in found.pieces if piece.category == "stage")
    seats = [piece for piece in found.pieces if piece.category == "auditorium_seat"]
    report = scenewright.check(found)
    assert report.valid
    assert len(seats) == 110
    assert all(math.cos(seat.pose.heading - stage.pose.heading) < -0.99 for seat in seats)
    assert not any("look away" in note.message for note in report.notes)


def test_seats_that_look_away_are_noted() -> None:
    found = scenewright.solve(CONFERENCE, seed=0, threads=1)
    turned = tuple(
        replace(piece, pose=piece.pose._replace(heading=piece.pose.heading + math.pi))
        if piece.category == "auditorium_seat"
        else piece
        for piece in found.pieces
    )
    notes = scenewright.check(replace(found, pieces=turned)).notes
    assert any("of 110 seats (auditorium seat) look away" in note.message for note in notes)


def lay_out(
    outline: list[list[float]], seed: int, *demands: dict[str, Any], steps: int | None = None
) -> Solution:
    """A hall with its door in the south."""
    room = {"outline": outline, "doors": [{"at": [4, 0], "width": 1.8}], "demands": list(demands)}
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, seed=seed, threads=1, steps=steps)


def test_chairs_of_a_narrow_hall_look_along_it_at_a_stage_amid_a_wall() -> None:
    chairs = {"category": "dining_chair", "count": 60}
    narrow = [[0, 0], [8, 0], [8, 20], [0, 20]]
    found = lay_out(narrow, 1, {"category": "stage", "size": [4, 2, 0.4]}, chairs)
    (stage,) = (piece for piece in found.pieces if piece.category == "stage")
    assert scenewright.check(found).valid
    assert (stage.pose.x, stage.pose.y) == pytest.approx((4.0, 19.0), abs=0.1)
    seats = [piece for piece in found.pieces if piece.category == "dining_chair"]
    assert all(math.cos(seat.pose.heading - stage.pose.heading) < -0.99 for seat in seats)


@pytest.mark.parametrize("seed", [47, 59])
def test_an_audience_sits_amid_its_hall_where_a_door_shortens_the_wall(seed: int) -> None:
    """The stage keeps off an exit at one end of its wall, not the middle of what that leaves."""
    found = scenewright.solve(scenewright.read("sample:hall-auditorium"), seed=seed)
    stage = next(piece for piece in found.pieces if piece.category == "stage")
    seats = [piece.pose.x for piece in found.pieces if piece.category == "auditorium_seat"]
    assert stage.pose.x == pytest.approx(12.0, abs=0.5)
    assert sum(seats) / len(seats) == pytest.approx(12.0, abs=0.5)


def test_long_rows_before_a_stage_have_aisles(tmp_path: Path) -> None:
    seats = {"category": "auditorium_seat", "count": 220}
    demands = {"category": "stage", "size": [12, 6, 1]}, seats
    found = lay_out([[0, 0], [20, 0], [20, 26], [0, 26]], 0, *demands, steps=300)
    assert scenewright.check(found).valid
    (group,) = (group for group in found.detail.layout.groups if "seat" in group.demand)
    (part,) = group.parts
    assert max(layer.number for layer in part.layers) > 14
    assert part.aisle == 1.2
    scenewright.write(found, tmp_path / "saved.json")
    saved = scenewright.read_solution(tmp_path / "saved.json")
    assert saved.detail.layout.groups == found.detail.layout.groups


def test_chairs_of_a_long_zone_look_at_the_screen_on_its_side() -> None:
    room = {
        "id": "f",
        "name": "Trade fair",
        "outline": [[0, 0], [22, 0], [22, 14], [0, 14]],
        "doors": [{"id": "in", "at": [11, 0], "width": 3, "swing": "slide"}],
        "zones": [{"id": "talks", "area": 90}, {"id": "stands"}],
        "demands": [
            {"category": "screen", "zone": "talks"},
            {"category": "dining_chair", "count": 40, "zone": "talks"},
            {"category": "exhibit_island", "count": 6, "size": [3, 3, 2.5], "zone": "stands"},
            {"category": "rope_barrier", "count": 4},
        ],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    report = scenewright.check(scenewright.solve(brief, seed=0, threads=1))
    assert report.valid
    assert not any("look away" in note.message for note in report.notes)


@pytest.mark.parametrize("seed", [1, 401])
def test_a_small_audience_sits_together(seed: int) -> None:
    """Rows one behind the other down a long zone, with two metres between neighbours, are none."""
    chairs = {"category": "dining_chair", "count": 12}
    narrow = [[0, 0], [7, 0], [7, 20], [0, 20]]
    found = lay_out(narrow, seed, {"category": "stage", "size": [4, 2.5, 0.4]}, chairs)
    (stage,) = (piece for piece in found.pieces if piece.category == "stage")
    seats = np.array([p.pose[:2] for p in found.pieces if p.category == "dining_chair"])
    ahead = np.array([math.cos(stage.pose.heading), math.sin(stage.pose.heading)])
    deep, wide = np.ptp(seats @ ahead), np.ptp(seats @ [ahead[1], -ahead[0]])
    assert len(seats) == 12
    assert max(deep, wide) < 5.0
    assert deep < wide + 0.6
    assert scenewright.check(found).valid
