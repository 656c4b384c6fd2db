"""A stage before which nobody has a seat stands with its back at a wall."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.bands import find_bands, measure_bands
from scenewright.domains.hall.retouch.exhibit import find_exhibit
from scenewright.domains.hall.retouch.stages import MOST, OFF_WALL
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams

STAGE: dict[str, Any] = {"category": "stage", "size": [5, 3, 0.4]}


def dance(*more: dict[str, Any]) -> Brief:
    room = {
        "name": "Dance hall",
        "outline": [[0, 0], [14, 0], [14, 12], [0, 12]],
        "doors": [{"at": [7, 0], "width": 2.0, "swing": "out"}],
        "demands": [STAGE, *more],
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


def put_amid() -> tuple[HallProblem, MeasuredLayout]:
    """The hall with its stage in the middle of the floor."""
    (one,) = problems(dance())
    pose = one.start.pose.copy()
    pose[0, :3] = 7.0, 6.0, 0.0
    chain = begin_chain(one.problem, one.start._replace(pose=pose), streams(0, 1)[0])
    return one.problem, layout_of(chain)


def test_a_stage_amid_the_floor_is_set_at_a_wall() -> None:
    problem, layout = put_amid()
    assert measure_bands(problem, layout.kept, layout.boxes) == pytest.approx(OFF_WALL * MOST)
    found = retouch_layout(problem, layout)
    assert measure_bands(problem, found.kept, found.boxes) < 0.1


def test_the_stage_of_a_band_is_not_the_main_exhibit_as_that_of_a_banquet_may_be() -> None:
    (alone,) = problems(dance())
    assert find_exhibit(alone.problem) is None
    tables = {"category": "round_table", "count": 6, "size": [1.2, 1.2, 0.74]}
    (gala,) = problems(dance(tables))
    assert find_exhibit(gala.problem) is not None


@pytest.mark.parametrize("seed", [0, 1])
def test_the_stage_of_a_band_has_its_back_at_a_wall(seed: int) -> None:
    high = {"category": "round_table", "count": 4, "size": [0.7, 0.7, 1.1]}
    found = scenewright.solve(dance(high), seed=seed, threads=1)
    (stage,) = (piece for piece in found.pieces if piece.category == "stage")
    front = np.array([np.cos(stage.pose.heading), np.sin(stage.pose.heading)])
    back = np.array(stage.pose[:2]) - 0.5 * stage.size.depth * front
    assert min(*back, *(np.array([14.0, 12.0]) - back)) < 0.1
    assert scenewright.check(found).valid


def test_a_stage_that_seats_look_at_is_none_of_a_band() -> None:
    for more, bands in (((), 1), (({"category": "auditorium_seat", "count": 40},), 0)):
        (one,) = problems(dance(*more))
        boxes = layout_of(begin_chain(one.problem, one.start, streams(0, 1)[0])).boxes
        assert len(find_bands(one.problem, one.start)) == bands
        assert measure_bands(one.problem, one.start, boxes) >= 0.0
