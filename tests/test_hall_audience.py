"""Audiences look at their stage, and the referee notes those that do not."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import scenewright
from scenewright.core.brief import Brief

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


@pytest.mark.parametrize("seed", [0, 1])
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
