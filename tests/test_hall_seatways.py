"""Chairs of tables in rows stand a seatway apart, and those before a column are left out."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.domains.hall.holdings import SEATWAY
from scenewright.domains.hall.patterns import ACROSS, ALONG
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.retouch.seatways import (
    WORTH,
    find_seated,
    measure_seatways,
    propose_seatways,
)
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


def test_high_tables_without_chairs_need_no_seatway() -> None:
    problem, kept = pack(ROUND | {"size": [0.7, 0.7, 1.1]})
    assert find_seated(problem, kept) == []
    assert measure_seatways(problem, kept, boxes_of(problem, kept)) == 0.0


def test_no_chair_stands_where_it_cannot_be_drawn_back() -> None:
    """Tables all over a hall with many columns: some chair would have one right behind it."""
    holes = [
        [[x, y], [x + 0.4, y], [x + 0.4, y + 0.4], [x, y + 0.4]] for x in (4, 8, 12) for y in (4, 8)
    ]
    asked = hall({"category": "dining_table", "count": 16}, holes=holes)
    middles = np.array([np.mean(ring, axis=0) for ring in holes])
    for seed in (0, 1):
        found = scenewright.solve(asked, seed=seed, threads=1)
        for chair in (p for p in found.pieces if p.category == "dining_chair"):
            back = np.array([np.cos(chair.pose.heading), np.sin(chair.pose.heading)])
            at = np.array(chair.pose[:2]) - (0.5 * chair.size.depth + 0.15) * back
            assert (np.abs(middles - at).max(1) > 0.2).all()
