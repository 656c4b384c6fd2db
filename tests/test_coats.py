"""Coats of a room that is kitchen and hall keep off the units."""

from __future__ import annotations

import numpy as np

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.domains.home.attempt import RoomAnswer
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.coats import is_splashed, move_coats
from scenewright.domains.home.composing.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.obstacles import standing_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms


def stood(task, group, x):
    """A group in its first form at the upper wall."""
    case = cases(group).groups[0]
    box = np.array([x, 2.6 - case.depth / 2, -np.pi / 2, case.width, case.depth])
    made = make_unplaced(task, (), Wish(group, 1), case)
    found = dress_group(task, made, case, box, standing_of((), frozenset()))
    assert found is not None
    return found


def test_coats_beside_a_run_move_off_it_and_those_away_from_it_stay():
    room = Room(
        id="room",
        function=["kitchen", "hall"],
        outline=[[0, 0], [6.0, 0], [6.0, 2.6], [0, 2.6]],
        doors=[{"at": [5.0, 0.0], "width": 0.8}],
    )
    brief = Brief(rooms=[room])
    made = spaces(brief)
    task = prepare_rooms(brief, made, catalog_of(()), PRESETS["default"], "anneal", 0)[0][0]
    run = stood(task, "kitchenette", 1.6)
    end = 1.6 + run.dressed.case.width / 2
    for x, moves in ((end + 0.3, True), (5.7, False)):
        coats = stood(task, "coats", x)
        answer = RoomAnswer(0.0, (run, coats), (), (), None, 0.0, 0)
        _, now = move_coats(task, answer, frozenset()).placed
        assert (now is not coats) == moves
        assert not is_splashed(now.dressed.box, list(run.pieces))
