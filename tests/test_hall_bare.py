"""Bare floor of halls: how large the largest empty circle is, and who moves there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.domains.hall.retouch.bare import (
    find_circles,
    find_floor,
    measure_bare,
    propose_moves,
)
from scenewright.domains.hall.retouch.mending import stand
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams

OUTLINE = [[0, 0], [26, 0], [26, 14], [0, 14]]


def hall(*demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Hall",
        "outline": OUTLINE,
        "doors": [{"at": [2, 0], "width": 1.8}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


@pytest.fixture(scope="module")
def started() -> StartedHall:
    (found,) = problems(hall({"category": "showcase", "count": 12}))
    return found


def rows(left: float, step: float) -> np.ndarray:
    """Twelve showcases in three rows from ``left`` on, ``step`` metres apart."""
    return np.array(
        [(left + step * k, 2.5 + 4.0 * j, 0.0, 1.2, 0.6) for j in range(3) for k in range(4)]
    )


def test_the_largest_circle_lies_between_walls_and_what_stands_there(started: StartedHall) -> None:
    circle = find_circles(find_floor(started.problem), rows(2.0, 2.0))[0]
    assert circle[0] > 15.0
    assert circle[2] == pytest.approx(7.0, abs=0.6)


def test_floor_all_over_which_objects_stand_is_not_bare(started: StartedHall) -> None:
    floor = find_floor(started.problem)
    close, crowd = np.concatenate([rows(2.5, 4.2), rows(19.3, 4.2)]), rows(2.0, 2.0)
    assert measure_bare(floor, started.start, close) == 0.0
    assert measure_bare(floor, started.start, crowd) > 2.0 * 4.0
    assert measure_bare(floor, started.start, rows(4.0, 5.5)) < 3.5  # a little too far apart


def test_a_layout_is_drawn_apart_over_its_hall(started: StartedHall) -> None:
    """A crowd at one side: some proposal leaves a quarter less floor far from all."""
    floor = find_floor(started.problem)
    chain = begin_chain(started.problem, started.start, streams(0, 1)[0])
    boxes = stand(chain)
    before, found = measure_bare(floor, started.start, boxes), []
    for kept in propose_moves(floor, started.start, boxes):
        if np.isfinite(bring_back(chain.p, chain.s, chain.work, kept)):
            found.append(measure_bare(floor, kept, stand(chain)))
    assert before > 4.0
    assert min(found) < 0.75 * before


def test_groups_fill_a_hall_that_was_bare_on_one_side() -> None:
    brief = hall(
        {"category": "bookcase", "count": 12},
        {"category": "armchair", "count": 6, "patterns": ["grid"]},
        {"category": "reading_table", "count": 6},
    )
    found = scenewright.solve(brief, seed=5, threads=1)
    assert scenewright.check(found).valid
    free = np.array([p.pose.x for p in found.pieces if p.category in ("armchair", "reading_table")])
    assert np.ptp(free) > 12.0
