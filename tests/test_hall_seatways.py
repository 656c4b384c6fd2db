"""Chairs of tables in rows stand a seatway apart, and those before a column are left out."""

from __future__ import annotations

from typing import Any

import numpy as np

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.seats.reachable import keep_drawn_back
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams


def hall(table: dict[str, Any], **room: Any) -> Brief:
    found = {
        "name": "Hall",
        "outline": [[0, 0], [16, 0], [16, 12], [0, 12]],
        "doors": [{"at": [4, 0], "width": 2.0, "swing": "out"}],
        "demands": [table],
        **room,
    }
    return Brief.model_validate({"domain": "hall", "rooms": [found]})


ROUND: dict[str, Any] = {"category": "round_table", "size": [1.2, 1.2, 0.74]}


def boxes_of(problem: HallProblem, kept: Kept) -> np.ndarray:
    return layout_of(begin_chain(problem, kept, streams(0, 1)[0])).boxes


def chair(x: float, y: float, heading: float) -> Piece:
    return Piece(
        id=f"chair-{x}",
        category="dining_chair",
        asset="",
        space="hall",
        pose=Pose(x, y, 0.0, heading),
        size=Size(0.45, 0.5, 0.85),
    )


def test_no_chair_stands_right_before_a_column_while_walls_do_not_count() -> None:
    """A column of 0.4 m about (8, 6); one chair has it 0.2 m behind it, one 0.5 m, one a wall."""
    column = [[7.8, 5.8], [8.2, 5.8], [8.2, 6.2], [7.8, 6.2]]
    (space,) = spaces(hall(ROUND, holes=[column]))
    near, far, at_wall = chair(8.65, 6.0, 0.0), chair(8.95, 6.0, 0.0), chair(0.35, 3.0, 0.0)
    assert keep_drawn_back(space, (near, far, at_wall)) == (far, at_wall)
    (bare,) = spaces(hall(ROUND))
    assert keep_drawn_back(bare, (near, far)) == (near, far)
