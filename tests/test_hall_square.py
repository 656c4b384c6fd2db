"""Free-standing groups are square to the hall, unless they go with a slanting wall near them."""

from __future__ import annotations

import numpy as np

import scenewright
from scenewright.core.brief import Brief

CUT = [[0, 0], [14, 0], [14, 6], [10, 10], [0, 10]]


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
