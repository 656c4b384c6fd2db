"""Screens that grow beyond their stand leave the ways of the home open."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.walking.home_floor import join_floors
from scenewright.domains.home.walking.kept_ways import find_barring_screens

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
    space = rooms[0].id
    stand = Piece("s", "tv_stand", "", space, Pose(3.2, 2.78, 0, -pi / 2), Size(0.9, 0.4, 0.45))
    screen = Piece("t", "tv", "", space, Pose(3.2, 2.78, 0.45, -pi / 2), Size(0.75, 0.2, 0.5))
    screen = replace(screen, on="s")
    wide = replace(screen, pose=screen.pose._replace(x=x), size=Size(1.26, 0.2, 0.8))
    floors, catalog = join_floors(rooms, 0.6), catalog_of([])
    found = find_barring_screens([stand, screen], [stand, wide], rooms, floors, catalog)
    assert found == ({} if kept else {"t": screen})
