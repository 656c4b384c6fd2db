"""Armchairs and sofas near enough to one another to talk."""

from __future__ import annotations

from math import pi

import pytest

from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.filling.talking import is_left_alone, joins_sofa
from scenewright.domains.home.programme import Wish


def _group(category: str, x: float, y: float, heading: float) -> FurnishedGroup:
    piece = Piece(category, category, "", "a", Pose(x, y, 0.0, heading), Size(0.8, 0.8, 0.8))
    return FurnishedGroup(Wish(category, 1), category, None, (piece,))


SOFA = _group("sofa", 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("x", "y", "heading", "talks"),
    [(1.8, 0.0, pi, True), (1.0, 1.2, -pi / 2, True), (2.6, 0.0, pi, False), (1.8, 0.0, 0, False)],
)
def test_one_talks_within_reach_and_turned_to_the_sofa(x, y, heading, talks):
    chair = _group("armchair", x, y, heading)
    assert joins_sofa(chair, (SOFA,)) == talks
    assert is_left_alone(chair, (SOFA,)) != talks


def test_nothing_is_left_alone_without_a_sofa_or_an_armchair():
    assert not is_left_alone(_group("armchair", 5.0, 0.0, 0.0), ())
    assert not is_left_alone(_group("plant", 5.0, 0.0, 0.0), (SOFA,))
