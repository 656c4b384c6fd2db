"""Groups amid the floor are square to the hall, unless they go with a slanting wall near them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.domains.hall.retouch.square import _find_way, measure_askew, propose_squared
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.solving import problems

WIDE = [[0, 0], [14, 0], [14, 10], [0, 10]]
CUT = [[0, 0], [14, 0], [14, 6], [10, 10], [0, 10]]


def start(outline: list[list[float]], turn: float, x: float, y: float) -> tuple[StartedHall, Any]:
    room = {
        "name": "Hall",
        "outline": outline,
        "doors": [{"at": [2, 0], "width": 1.4}],
        "demands": [{"category": "display_table", "size": [1.6, 0.8, 0.9]}],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    (hall,) = problems(brief)
    pose = hall.start.pose.copy()
    pose[0, :3] = x, y, turn
    return hall, hall.start._replace(pose=pose)


@pytest.mark.parametrize(
    ("outline", "turn", "at", "askew"),
    [
        (WIDE, 0.0, (7, 5), False),
        (WIDE, 0.5 * np.pi, (7, 5), False),
        (WIDE, 0.3, (7, 5), True),
        (CUT, 0.25 * np.pi, (11, 7), False),
        (CUT, 0.25 * np.pi, (4, 4), True),
    ],
)
def test_only_what_goes_with_no_wall_counts(
    outline: list[list[float]], turn: float, at: tuple[float, float], askew: bool
) -> None:
    hall, kept = start(outline, turn, *at)
    boxes = np.array([[*at, turn, 1.6, 0.8]])
    assert (measure_askew(hall.problem, kept, boxes) > 0.0) == askew
    headings = [
        one.pose[0, 2] % (0.5 * np.pi) for one in propose_squared(hall.problem, kept, boxes)
    ]
    assert bool(headings) == askew
    assert all(min(h, 0.5 * np.pi - h) < 1e-9 for h in headings)


def test_a_round_hall_has_no_way_of_its_own() -> None:
    turns = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    ring = 6.0 * np.column_stack([np.cos(turns), np.sin(turns)])
    assert _find_way(np.hstack([ring, np.roll(ring, -1, 0)])) == ()


def test_a_lobby_has_no_desk_askew() -> None:
    room = {
        "name": "Lobby",
        "outline": CUT,
        "doors": [{"at": [5, 0], "width": 2.0}],
        "demands": [
            {"category": "info_desk", "count": 2, "size": [2.6, 0.9, 1.1]},
            {"category": "exhibit_island", "count": 3},
        ],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    found = scenewright.solve(brief, seed=1, threads=1)
    turns = [p.pose.heading % (0.25 * np.pi) for p in found.pieces if p.category == "info_desk"]
    assert len(turns) == 2
    assert all(min(turn, 0.25 * np.pi - turn) < 0.02 for turn in turns)
