"""Rows looked at from both faces have an aisle before the walls as well."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.patterns import CHAIN
from scenewright.domains.hall.retouch.weigh_rows import HallRows, look_rows, measure_rows
from scenewright.domains.hall.rules.exhibits import BEFORE_WALL
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.solving import problems

DEEP = 8.0


def library(**more: Any) -> Brief:
    stacks = {"category": "book_stack", "count": 20, "patterns": ["chain"]} | more
    room = {
        "name": "Stacks",
        "outline": [[0, 0], [16, 0], [16, DEEP], [0, DEEP]],
        "doors": [{"at": [0, 4], "width": 1.8}],
        "demands": [stacks],
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


@pytest.fixture(scope="module")
def started() -> StartedHall:
    (found,) = problems(library())
    pose, rows = found.start.pose.copy(), found.start.rows.copy()
    pose[:, :3], rows[:] = (8.0, DEEP / 2, np.pi / 2), (CHAIN, 4)
    return found._replace(start=found.start._replace(pose=pose, rows=rows))


def stacks(*at: float) -> np.ndarray:
    """Rows of five stacks across a room at some heights."""
    return np.array([(5.5 + k, y, np.pi / 2, 1.0, 0.6) for y in at for k in range(5)])


@pytest.fixture(scope="module")
def seen(started: StartedHall) -> HallRows:
    return look_rows(("slot_before_rows", "slot_behind_rows"), started.problem)


def test_what_aisles_before_walls_lack_counts(started: StartedHall, seen: HallRows) -> None:
    slots = stacks(0.7, 2.6, 5.0, DEEP - 1.0)
    lacking = (BEFORE_WALL - 0.4) + (BEFORE_WALL - 0.7)
    assert measure_rows(seen, started.start, slots) == pytest.approx(3.0 * lacking)
    assert measure_rows(seen, started.start, stacks(1.5, 3.2, 4.9, 6.5)) == 0.0


def test_rows_turned_to_the_walls_and_rings_are_left_alone(
    started: StartedHall, seen: HallRows
) -> None:
    pose, rows = started.start.pose.copy(), started.start.rows.copy()
    pose[:, 2], rows[:] = 0.4, (CHAIN, 1)
    slots = stacks(0.7, 2.6, 5.0, DEEP - 1.0)
    assert measure_rows(seen, started.start._replace(pose=pose), slots) == 0.0
    assert measure_rows(seen, started.start._replace(rows=rows), slots) == 0.0


def least_aisle(solution: Solution) -> float:
    """Metres from the faces of stacks that are not end on to a wall to that."""
    at = np.array([p.pose for p in solution.pieces if p.category == "book_stack"])
    upright = np.abs(np.sin(at[:, 3])) > 0.5
    if not upright.all():
        return float(min(at[:, 0].min(), 16.0 - at[:, 0].max())) - 0.3
    return float(min(at[:, 1].min(), DEEP - at[:, 1].max())) - 0.3


@pytest.mark.parametrize("seed", range(3))
def test_a_library_has_no_slot_at_its_walls(seed: int) -> None:
    found = scenewright.solve(library(count=40), seed=seed, steps=2000, threads=1)
    assert scenewright.check(found).valid
    assert least_aisle(found) > 0.85
