"""Screens that grow beyond their stand leave the ways of the home open."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.kept_ways import keep_ways
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.solving import prepare_rooms

HOME = Brief.model_validate(
    {
        "rooms": [
            {
                "name": "Living room",
                "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
                "doors": [{"at": [0, 1.5], "width": 0.9}],
            },
            {
                "name": "Bedroom",
                "outline": [[0, 3.1], [4, 3.1], [4, 6], [0, 6]],
                "doors": [{"at": [1.5, 3.1], "width": 0.8, "swing": "slide"}],
            },
        ]
    }
)


@pytest.mark.parametrize(("x", "kept"), [(3.0, True), (1.5, False)])
def test_a_wider_screen_stays_unless_it_bars_a_way(x, kept):
    rooms = plan_rooms(HOME).spaces
    tasks, _ = prepare_rooms(HOME, rooms, catalog_of([]), PRESETS["default"], "anneal", 0)
    space = rooms[0].id
    stand = Piece("s", "tv_stand", "", space, Pose(3.2, 2.78, 0, -pi / 2), Size(0.9, 0.4, 0.45))
    screen = Piece("t", "tv", "", space, Pose(3.2, 2.78, 0.45, -pi / 2), Size(0.75, 0.2, 0.5))
    screen = replace(screen, on="s")
    wide = replace(screen, pose=screen.pose._replace(x=x), size=Size(1.26, 0.2, 0.8))
    placed, grown = [(stand, screen), ()], [[stand, wide], []]
    found = keep_ways(tasks, placed, grown, 0.6)
    assert found == (grown if kept else [[stand, screen], []])
