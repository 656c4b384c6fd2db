"""Boxes are put square to their wall where they, or they a little aside, have room for it."""

from __future__ import annotations

import numpy as np
import pytest

from scenewright.geometry.wall_alignment import align_to_wall

ROOM = np.array([[0, 0, 4, 0], [4, 0, 4, 3], [4, 3, 0, 3], [0, 3, 0, 0]], float)
NONE = np.zeros((0, 5))
UP = np.pi / 2


def align(*boxes):
    """The first of some boxes, which alone is new."""
    new = np.arange(len(boxes)) == 0
    return align_to_wall(np.array(boxes, float), new, np.ones(len(boxes), bool), ROOM, ROOM, NONE)[
        0
    ]


@pytest.mark.parametrize("skew", [-0.04, 0.01, 0.04])
def test_a_skew_box_is_put_square_and_flush(skew):
    x, y, heading, *_ = align([2.0, 0.34, UP + skew, 1.2, 0.6])
    assert (y, heading) == pytest.approx((0.3, UP))
    assert x == pytest.approx(2.0, abs=0.03)


def test_between_neighbours_it_moves_aside():
    """Square it would reach 1 cm into the one on the left; there are 3 cm on its right."""
    left, right = [0.9, 0.3, UP, 1.01, 0.6], [3.14, 0.3, UP, 1.0, 0.6]
    x, _, heading, *_ = align([2.0, 0.34, UP - 0.03, 1.2, 0.6], left, right)
    assert heading == pytest.approx(UP)
    assert x - 0.6 >= 1.405 - 1e-9
    assert x + 0.6 <= 2.64 + 1e-9


def test_without_room_it_stays():
    left, right = [0.9, 0.3, UP, 1.06, 0.6], [3.08, 0.3, UP, 1.0, 0.6]
    box = [2.0, 0.34, UP + 0.03, 1.2, 0.6]
    assert align(box, left, right).tolist() == box


def test_what_is_square_and_meets_something_is_not_moved():
    box = [2.0, 0.3, UP, 1.2, 0.6]
    assert align(box, [2.5, 0.3, UP, 1.0, 0.6]).tolist() == box
