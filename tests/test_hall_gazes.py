"""Rows of lounge seats look into a hall, not at a wall close before them."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.core.brief import Brief
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.gazes import TURNED, measure_gazes
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams


def put_row(
    off_wall: float, heading: float, deep: float = 8.0
) -> tuple[HallProblem, MeasuredLayout]:
    """Four armchairs in a row so far from the wall at the back of a hall so deep."""
    room = {
        "name": "Showroom",
        "outline": [[0, 0], [12, 0], [12, deep], [0, deep]],
        "doors": [{"at": [6, 0], "width": 1.4, "swing": "out"}],
        "demands": [{"category": "armchair", "count": 4, "patterns": ["chain"]}],
    }
    (one,) = problems(Brief.model_validate({"domain": "hall", "rooms": [room]}))
    start = line_up(one.problem, one.start, 0, (6.0, deep - off_wall, heading))
    return one.problem, layout_of(begin_chain(one.problem, start, streams(0, 1)[0]))


def faults(problem: HallProblem, layout: MeasuredLayout) -> float:
    return measure_gazes(problem, layout.kept, layout.boxes)


@pytest.mark.parametrize(
    ("off_wall", "heading", "deep", "fault"),
    [
        (1.5, 0.5 * np.pi, 8.0, TURNED),  # at the wall
        (1.4, -0.5 * np.pi, 8.0, 0.1),  # into the hall, a metre off the wall
        (3.5, 0.5 * np.pi, 8.0, 0.0),  # at a wall that is far
        (1.6, 0.5 * np.pi, 3.2, 0.12),  # a wall is as near behind them
    ],
)
def test_a_row_that_looks_at_a_wall_close_before_it_is_a_fault(
    off_wall: float, heading: float, deep: float, fault: float
) -> None:
    assert faults(*put_row(off_wall, heading, deep)) == pytest.approx(fault, abs=0.001)


def test_such_a_row_is_turned_round_or_set_off_the_wall() -> None:
    problem, layout = put_row(1.5, 0.5 * np.pi)
    found = retouch_layout(problem, layout)
    assert faults(problem, found) < 0.2
