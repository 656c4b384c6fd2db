"""A line of poufs opens to an arc or a circle, unless a brief asks for a line."""

from __future__ import annotations

from typing import Any

import numpy as np

from scenewright.core.brief import Brief
from scenewright.domains.hall.patterns import CHAIN, FAN, GRID, RADIATION
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.retouch.poufs import measure_fences, propose_circles
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams


def in_a_line(count: int = 7, **more: Any) -> tuple[HallProblem, MeasuredLayout]:
    """Poufs side by side in the middle of a hall of 8 by 7 m."""
    room = {
        "name": "Corner",
        "outline": [[0, 0], [8, 0], [8, 7], [0, 7]],
        "doors": [{"at": [2, 0], "width": 1.2}],
        "demands": [{"category": "pouf", "count": count, **more}],
    }
    (one,) = problems(Brief.model_validate({"domain": "hall", "rooms": [room]}))
    kept = line_up(one.problem, one.start, 0, (4.0, 3.5, 0.5 * np.pi))
    chain = begin_chain(one.problem, kept, streams(0, 1)[0])
    return one.problem, layout_of(chain)


def test_seven_poufs_in_a_line_open_to_an_arc_or_a_circle() -> None:
    problem, layout = in_a_line()
    assert measure_fences(problem, layout.kept, layout.boxes) == 5.0
    found = retouch_layout(problem, layout)
    assert int(found.kept.rows[0, 0]) in (FAN, RADIATION)
    assert found.missed <= layout.missed
    off = found.boxes[:, None, :2] - found.boxes[None, :, :2]
    apart = np.hypot(off[..., 0], off[..., 1])[~np.eye(7, dtype=bool)]
    assert apart.min() > found.boxes[0, 3] + 0.1


def test_lines_asked_for_and_short_ones_stay() -> None:
    for one in (in_a_line(3), in_a_line(patterns=["chain"]), in_a_line(place="wall")):
        problem, layout = one
        assert measure_fences(problem, layout.kept, layout.boxes) == 0.0
        assert not list(propose_circles(problem, layout.kept, layout.boxes))
    problem, layout = in_a_line(patterns=["chain"])
    assert int(retouch_layout(problem, layout).kept.rows[0, 0]) == CHAIN


def test_a_loose_grid_of_poufs_is_drawn_together() -> None:
    """Their free floor lies under one another then: that costs nothing."""
    problem, layout = in_a_line(8)
    rows, layers = layout.kept.rows.copy(), layout.kept.layers.copy()
    rows[0] = GRID, 2
    layers[:2] = (4.0, 1.07, 2.285, GRID, 0.0)
    kept = layout.kept._replace(rows=rows, layers=layers)
    loose = layout_of(begin_chain(problem, kept, streams(0, 1)[0]))
    assert measure_fences(problem, loose.kept, loose.boxes) == 2.0
    found = retouch_layout(problem, loose)
    assert int(found.kept.rows[0, 0]) in (FAN, RADIATION)
    assert np.ptp(found.boxes[:, :2], axis=0).max() < 4.5
