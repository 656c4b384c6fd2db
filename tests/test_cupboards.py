"""Cupboards that are built in: their floor is not furnished."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.grounds.cupboards import list_cupboards
from scenewright.domains.home.grounds.ground import ground_of
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
        (1.6, 0.08, None),  # a free-standing screen
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


def boxes_of(y, depth, outline=None, category="wardrobe", turn=0.0, holes=()):
    """The cupboards of a room whose doors look up, all turned about the origin."""
    c, s = np.cos(turn), np.sin(turn)
    shape = np.array(outline or [[0, 0], [4, 0], [4, 2], [0, 2]]) @ [[c, s], [-s, c]]
    brief = Brief.model_validate({"rooms": [room_of(1.0, 0.08)]})
    space = replace(spaces(brief)[0], outline=tuple(map(tuple, shape)), holes=holes)
    at = Pose(*(np.array([2.0, y]) @ [[c, s], [-s, c]]).tolist(), 0.0, pi / 2 + turn)
    door = Piece("d", category, "", space.id, at, Size(1.8, depth, 2.4))
    return list(list_cupboards(space, [door]))


@pytest.mark.parametrize("deep", [0.2, 0.24, 0.26, 0.4, 0.8, 0.89, 0.91, 1.1])
def test_a_cupboard_is_as_deep_as_floor_is_behind_its_doors(deep):
    found = [box[4] for box in boxes_of(deep + 0.04, 0.08)]
    assert found == ([pytest.approx(deep)] if 0.25 <= deep <= 0.9 else [])


@pytest.mark.parametrize("turn", [0.0, 0.7, pi / 2, 2.5, -1.9])
def test_a_cupboard_turns_with_its_room(turn):
    ((x, y, heading, width, depth),) = boxes_of(0.7, 0.08, turn=turn)
    c, s = np.cos(turn), np.sin(turn)
    assert (x, y) == pytest.approx((2 * c - 0.33 * s, 2 * s + 0.33 * c))
    assert (heading, width, depth) == pytest.approx((pi / 2 + turn, 1.8, 0.66))


def test_only_thin_wardrobes_are_doors_and_columns_are_walls():
    assert boxes_of(0.7, 0.14)
    assert not boxes_of(0.7, 0.16)
    assert not boxes_of(0.7, 0.08, category="bookcase")
    column = ((1.8, 0.2), (2.2, 0.2), (2.2, 0.3), (1.8, 0.3))
    assert boxes_of(0.7, 0.08, holes=(column,))[0][4] == pytest.approx(0.36)


def test_nothing_is_put_behind_the_doors_of_a_cupboard():
    solution = solve(Brief.model_validate({"rooms": [room_of(0.7, 0.08)]}))
    low = [p for p in solution.pieces if p.pose.z < 1.0 and not p.fixed]
    assert not any(abs(p.pose.x - 2.0) < 0.9 and p.pose.y < 0.66 for p in low)
