"""Bare floor of halls: how large the largest empty circle is, and who moves there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.domains.hall.retouch.bare import find_circles, find_floor, measure_bare
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.solving import problems

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
    assert measure_bare(floor, started.start, rows(4.0, 5.5)) == 0.0
    assert measure_bare(floor, started.start, rows(2.0, 2.0)) > 1.5


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
