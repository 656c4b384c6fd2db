"""A hall is laid out again where nobody can serve at a desk, or something was given up."""

from __future__ import annotations

from itertools import pairwise
from math import pi
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.hall import solving
from scenewright.domains.hall.assemble import Laid
from scenewright.domains.hall.hall_layout import PlacedGroup
from scenewright.domains.hall.lack import measure_unserved
from scenewright.domains.hall.unserved import ROOM, count_unserved

HALL = Space("hall", "Hall", (), "ground", np.array([[0.0, 0], [8, 0], [8, 6], [0, 6]]))


def put(name: str, category: str, x: float, y: float, turn: float = pi / 2) -> Piece:
    return Piece(name, category, "", "hall", Pose(x, y, 0.0, turn), Size(2.0, 0.6, 1.0))


@pytest.mark.parametrize("turn", [0.0, pi / 2, pi, -pi / 2])
def test_a_wall_right_behind_a_desk_leaves_nobody_room_to_serve(turn: float) -> None:
    away = {0.0: (0, 3), pi / 2: (4, 0), pi: (8, 3), -pi / 2: (4, 6)}[turn]
    ahead = np.array([np.cos(turn), np.sin(turn)])
    for gap, count in ((0.0, 1), (0.5 * ROOM, 1), (ROOM - 0.02, 1), (ROOM + 0.02, 0)):
        x, y = np.array(away) + (gap + 0.3) * ahead
        assert count_unserved(HALL, [put("desk", "counter", x, y, turn)]) == count
        assert count_unserved(HALL, [put("desk", "sideboard", x, y, turn)]) == 0
    built = Piece("w", "partition", "", "hall", Pose(4.0, 1.7, 0.0, 0.0), Size(0.15, 3.0, 2.5))
    desk = put("desk", "counter", 4.0, 2.4)
    assert count_unserved(HALL, [desk]) == 0
    assert count_unserved(HALL, [desk, built]) == 1


def lay(*pieces: Piece) -> Laid:
    names = tuple(piece.id for piece in pieces)
    group = PlacedGroup("hall/g", "g", "hall", "all", "single", (0.0, 0.0, 0.0), (), names)
    return Laid(pieces, (group,), (), (), (), 0.0, 0, None)


def test_a_desk_nobody_can_serve_at_is_as_good_as_none() -> None:
    free, other = put("a", "counter", 2.0, 3.0), put("b", "counter", 5.0, 3.0)
    cramped = put("b", "counter", 5.0, 0.5)
    rows = [lay(free, other), lay(free, cramped), lay(free)]
    values = [measure_unserved(HALL, row) for row in rows]
    assert values[0] < values[1] == values[2]
    assert all(before <= after for before, after in pairwise(values))


@pytest.mark.parametrize("seed", [3, 5])
def test_a_hall_laid_out_again_holds_no_less(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    demands: list[dict[str, Any]] = [
        {"category": "dining_table", "count": 7},
        {"category": "counter", "count": 2},
        {"category": "vending_machine", "count": 3},
    ]
    room = {
        "name": "Cafe",
        "outline": [[0, 0], [10, 0], [10, 6.5], [0, 6.5]],
        "doors": [{"at": [2, 0], "width": 1.2}],
        "demands": demands,
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    again = scenewright.solve(brief, seed=seed, threads=1)
    monkeypatch.setattr(solving, "AFRESH", 0)
    once = scenewright.solve(brief, seed=seed, threads=1)
    asked = ("dining_table", "counter", "vending_machine")
    counts = [sum(p.category in asked for p in found.pieces) for found in (once, again)]
    assert counts[0] <= counts[1]
