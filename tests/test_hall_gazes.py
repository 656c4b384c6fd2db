"""Rows of lounge seats look into a hall, not at a wall close before them."""

from __future__ import annotations

import numpy as np

from scenewright.core.brief import Brief
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.retouch.weigh_rows import look_rows, measure_rows
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


def test_such_a_row_is_turned_round_or_set_off_the_wall() -> None:
    problem, layout = put_row(1.5, 0.5 * np.pi)
    found = retouch_layout(problem, layout)
    seen = look_rows(("seats_look_at_wall",), problem)
    assert measure_rows(seen, layout.kept, layout.boxes) > 1.0
    assert measure_rows(seen, found.kept, found.boxes) < 0.2


def test_seats_that_turn_their_backs_to_a_door_are_turned_from_it() -> None:
    problem, layout = put_row(3.5, 0.5 * np.pi)
    found = retouch_layout(problem, layout)
    seen = look_rows(("seat_back",), problem)
    assert measure_rows(seen, layout.kept, layout.boxes) > 1.0
    assert measure_rows(seen, found.kept, found.boxes) == 0.0
