"""Two rows back to back are reached from both sides, other objects from one."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.core.brief import Brief
from scenewright.domains.hall.build_problem import EACH
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import measure_layout
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams

HALL = {
    "name": "Canteen",
    "outline": [[0, 0], [9, 0], [9, 7], [0, 7]],
    "doors": [{"at": [2, 0], "width": 1.2}],
}


@pytest.mark.parametrize(
    ("wide", "each", "missed"), [(9.0, 1.0, 0.0), (9.0, EACH, 1.0), (3.0, EACH, 0.0)]
)
def test_sides_that_must_each_be_reached_are(wide: float, each: float, missed: float) -> None:
    table = {"category": "display_table", "size": [wide - 0.02, 1.0, 0.9]}
    brief = Brief.model_validate({"domain": "hall", "rooms": [HALL | {"demands": [table]}]})
    (hall,) = problems(brief)
    access = each * np.array([[1.0, 0.0, 1.0, 0.0]])
    problem = hall.problem._replace(units=hall.problem.units._replace(access=access))
    pose = hall.start.pose.copy()
    pose[0, :3] = 4.5, 4.0, 0.5 * np.pi
    chain = begin_chain(problem, hall.start._replace(pose=pose), streams(0, 1)[0])
    assert measure_layout(problem, layout_of(chain))[2] == missed
