"""A hall is laid out again where nobody can serve at a desk, or something was given up."""

from __future__ import annotations

from itertools import pairwise
from math import pi
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.hall.desks.unserved import ROOM, WITHIN, count_unserved
from scenewright.domains.hall.furnishing.assemble import Laid
from scenewright.domains.hall.hall_layout import PlacedGroup
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.shortfall.measures import measure_shortfall_and_staff
from scenewright.domains.hall.solving import laying
from scenewright.engine.solve import Budget

HALL = Space("hall", "Hall", (), "ground", np.array([[0.0, 0], [8, 0], [8, 6], [0, 6]]))


def put(name: str, category: str, x: float, y: float, turn: float = pi / 2) -> Piece:
    return Piece(name, category, "", "hall", Pose(x, y, 0.0, turn), Size(2.0, 0.6, 1.0))


@pytest.mark.parametrize("turn", [0.0, pi / 2, pi, -pi / 2])
def test_a_wall_right_behind_a_desk_leaves_nobody_room_to_serve(turn: float) -> None:
    away = {0.0: (0, 3), pi / 2: (4, 0), pi: (8, 3), -pi / 2: (4, 6)}[turn]
    ahead = np.array([np.cos(turn), np.sin(turn)])
    for gap, count in ((0.0, 1), (0.5 * ROOM, 1), (ROOM - WITHIN - 0.02, 1), (ROOM + 0.02, 0)):
        x, y = np.array(away) + (gap + 0.3) * ahead
        assert count_unserved(HALL, [put("desk", "counter", x, y, turn)]) == count
        assert count_unserved(HALL, [put("desk", "sideboard", x, y, turn)]) == 0
    built = Piece("w", "partition", "", "hall", Pose(4.0, 1.7, 0.0, 0.0), Size(0.15, 3.0, 2.5))
    desk = put("desk", "counter", 4.0, 2.4)
    assert count_unserved(HALL, [desk]) == 0
    assert count_unserved(HALL, [desk, built]) == 1


def lay(*pieces: Piece) -> Laid:
    names = tuple(piece.id for piece in pieces)
    group = PlacedGroup("hall/g", "g", "hall", "all", "single", (0.0, 0.0, 0.0), (), names)
    return Laid(pieces, (group,), (), (), (), 0.0, 0, None)


def test_a_desk_nobody_can_serve_at_is_as_good_as_none() -> None:
    free, other = put("a", "counter", 2.0, 3.0), put("b", "counter", 5.0, 3.0)
    cramped = put("b", "counter", 5.0, 0.5)
    rows = [lay(free, other), lay(free, cramped), lay(free)]
    values = [measure_shortfall_and_staff(HALL, row) for row in rows]
    assert values[0] < values[1] == values[2]
    assert all(before <= after for before, after in pairwise(values))


FREE, CRAMPED = put("a", "counter", 2.0, 3.0), put("b", "counter", 5.0, 0.5)
FULL = put("b", "counter", 5.0, 3.0)


@pytest.mark.parametrize(
    ("answers", "tried", "kept"),
    [
        ([lay(FREE, FULL)], 1, 0),
        ([lay(FREE)._replace(given_up=True), lay(FREE, FULL)], 2, 1),
        ([lay(FREE, FULL)._replace(given_up=True), lay(FREE)], 2, 0),
        ([lay(FREE)._replace(given_up=True)] * 5, 2, 0),
        ([lay(FREE, CRAMPED), lay(FREE), lay(FREE, FULL)], 3, 2),
        ([lay(FREE, CRAMPED)] * 5, 1 + laying.AFRESH, 0),
    ],
    ids=["fine", "given up", "no better", "once only", "served", "never"],
)
def test_the_layout_with_most_in_it_is_kept(answers: list[Laid], tried: int, kept: int) -> None:
    """Each from another seed, until nothing is wrong or it was tried often enough."""
    seen = list[int]()

    def answer(task: laying.HallTask) -> Laid:
        seen.append(task.seed)
        return answers[len(seen) - 1]

    preset = PRESETS["default"]
    hall: Any = SimpleNamespace(space=HALL)
    task = laying.HallTask(hall, 0, preset, preset.solver, Budget(), 7, 0)
    room = {"name": "Hall", "outline": [[0, 0], [8, 0], [8, 6], [0, 6]]}
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    found = laying.lay_best(brief, task, answer, lambda: False)
    assert found is answers[kept]
    assert len(seen) == len(set(seen)) == tried
    seen.clear()
    assert laying.lay_best(brief, task, answer, lambda: True) is answers[0]
    assert len(seen) == 1
    seen.clear()
    timed = task._replace(budget=Budget(seconds=1.0))
    assert laying.lay_best(brief, timed, answer, lambda: False) is answers[0]
