"""Chairs of tables in rows stand a seatway apart, and those before a column are left out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.demands.holdings import SEATWAY
from scenewright.domains.hall.patterns import ACROSS, ALONG
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch import retouch_named
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.retouch.mending import SeenTouch, mend
from scenewright.domains.hall.retouch.seatways import (
    WORTH,
    find_seated,
    measure_seatways,
    propose_seatways,
)
from scenewright.domains.hall.seats.reachable import keep_drawn_back
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solving import problems
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


def pack(table: dict[str, Any]) -> tuple[HallProblem, Kept]:
    """Nine tables in a grid with no room between the chairs of two rows."""
    (one,) = problems(hall(table | {"count": 9, "patterns": ["grid"]}))
    first, used = find_layers(one.problem, 0)[0], int(one.start.rows[0, 1])
    layers = one.start.layers.copy()
    layers[first : first + used, ACROSS] = 0.02
    layers[first : first + used, ALONG] = 1.0
    return one.problem, one.start._replace(layers=layers)


ROUND: dict[str, Any] = {"category": "round_table", "size": [1.2, 1.2, 0.74]}


def boxes_of(problem: HallProblem, kept: Kept) -> np.ndarray:
    return layout_of(begin_chain(problem, kept, streams(0, 1)[0])).boxes


def test_what_gaps_lack_counts_and_some_proposal_has_all_of_it() -> None:
    problem, kept = pack(ROUND)
    boxes = boxes_of(problem, kept)
    assert find_seated(problem, kept) == [0]
    assert measure_seatways(problem, kept, boxes) == pytest.approx(WORTH * (SEATWAY - 0.02))
    proposed = list(propose_seatways(problem, kept, boxes))
    assert min(measure_seatways(problem, other, boxes) for other in proposed) == 0.0


def test_tables_packed_together_are_set_apart() -> None:
    problem, kept = pack(ROUND)
    layout = layout_of(begin_chain(problem, kept, streams(0, 1)[0]))
    found = mend(problem, layout, [SeenTouch(retouch_named("seatways"), problem)], 0)
    assert measure_seatways(problem, found.kept, found.boxes) < 0.1
    assert found.missed <= layout.missed


def test_high_tables_without_chairs_need_no_seatway() -> None:
    problem, kept = pack(ROUND | {"size": [0.7, 0.7, 1.1]})
    assert find_seated(problem, kept) == []
    assert measure_seatways(problem, kept, boxes_of(problem, kept)) == 0.0


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
