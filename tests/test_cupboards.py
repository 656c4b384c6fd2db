"""Cupboards that are built in: their floor is not furnished."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.domains.home.cupboards import list_cupboards
from scenewright.domains.home.ground import ground_of
from scenewright.domains.home.solving import solve


def room_of(y: float, depth: float) -> dict:
    """A hall of 4 m by 2 m with a fixed wardrobe whose middle is ``y`` metres off its lower wall,
    its front to the room, and a chest that finds free wall in the cupboard first of all."""
    front = {"category": "wardrobe", "at": [2.0, y], "heading": pi / 2, "size": [1.8, depth, 2.4]}
    return {
        "function": "hall",
        "outline": [[0, 0], [4, 0], [4, 2], [0, 2]],
        "doors": [{"at": [0.0, 1.3], "width": 0.9}, {"at": [4.0, 1.3], "width": 0.9}],
        "fixed": [front],
        "ask": [{"group": "chest"}],
    }


@pytest.mark.parametrize(
    ("y", "depth", "expected"),
    [
        (0.7, 0.08, [2.0, 0.33, pi / 2, 1.8, 0.66]),
        (0.7, 0.6, None),  # a whole wardrobe
        (0.15, 0.08, None),  # doors on the wall
        (1.6, 0.08, None),  # a screen amid the room
    ],
)
def test_floor_between_doors_and_wall_is_a_cupboard(y, depth, expected):
    brief = Brief.model_validate({"rooms": [room_of(y, depth)]})
    (space,) = spaces(brief)
    fixed = tuple(fixed_pieces(brief.rooms[0], space, shipped()))
    found = list(list_cupboards(space, fixed))
    if expected is None:
        assert found == []
    else:
        np.testing.assert_allclose(found, [expected], atol=1e-9)
        np.testing.assert_allclose(ground_of(space, fixed, 6.0).keep_free[-1], expected, atol=1e-9)


def test_nothing_is_put_behind_the_doors_of_a_cupboard():
    solution = solve(Brief.model_validate({"rooms": [room_of(0.7, 0.08)]}))
    low = [p for p in solution.pieces if p.pose.z < 1.0 and not p.fixed]
    assert not any(abs(p.pose.x - 2.0) < 0.9 and p.pose.y < 0.66 for p in low)
