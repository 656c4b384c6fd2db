"""What a sofa looks at close by."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from scenewright.core.catalog import Group
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.living import AHEAD
from scenewright.domains.home.rules.weigh_home import sum_rows

NONE = np.zeros((0, 5))


def _ground(wide: float) -> Ground:
    """A room from x = -0.45 on, 4 m deep about the axis of x."""
    x0, x1 = -0.45, wide - 0.45
    ring = [(x0, -2.0), (x1, -2.0), (x1, 2.0), (x0, 2.0)]
    edges = np.array([[*a, *b] for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)])
    bounds = np.array([x0, -2.0, x1, 2.0])
    return Ground(edges, edges, NONE, NONE, NONE, NONE, NONE, NONE, bounds, 4.0 * wide)


def _group(name: str, category: str, pose: Pose, size: Size) -> FurnishedGroup:
    patch = FurnishedPatch(Group(name, name, 1.0, 1.0, ()), np.zeros(5), (True,), 0)
    return FurnishedGroup(Wish(name, 0), name, patch, (Piece(name, category, "", "a", pose, size),))


SOFA = _group("seating", "sofa", Pose(0.0, 0.0, 0.0, 0.0), Size(2.0, 0.9, 0.8))
CORNER = _group("seating", "corner_sofa", Pose(0.4, 0.0, 0.0, 0.0), Size(2.4, 1.7, 0.8))


def _bed_at(x: float, y: float = 0.0) -> FurnishedGroup:
    return _group("sleeping", "double_bed", Pose(x, y, 0.0, pi), Size(1.6, 2.0, 0.5))


def cost_of_outlook(groups, ground, cost, fixed=()):
    return cost * sum_rows(("outlook", "feet"), groups, ground, fixed)


def test_a_bed_before_a_sofa_costs_the_more_the_nearer_it_is():
    far = 0.45 + 1.0 + AHEAD
    near = [cost_of_outlook((SOFA, _bed_at(x)), _ground(6.0), 10.0) for x in (1.7, 2.2, far, 4.0)]
    assert near[0] > near[1] > near[2] == near[3] == 0.0


@pytest.mark.parametrize("y", [-1.6, 1.6])
def test_what_stands_beside_what_it_looks_over_costs_nothing(y):
    assert cost_of_outlook((SOFA, _bed_at(2.0, y)), _ground(6.0), 10.0) == 0.0


def test_a_column_at_the_feet_of_one_seat_costs():
    column = _group("chest", "column", Pose(0.65, 0.7, 0.0, 0.0), Size(0.3, 0.3, 2.5))
    aside = _group("chest", "column", Pose(0.65, 1.0, 0.0, 0.0), Size(0.3, 0.3, 2.5))
    assert cost_of_outlook((SOFA, column), _ground(6.0), 10.0) > 0.0
    assert cost_of_outlook((SOFA, aside), _ground(6.0), 10.0) == 0.0


def test_a_wall_is_seen_as_a_bed_is_and_its_own_table_is_not():
    table = _group("seating", "coffee_table", Pose(1.0, 0.0, 0.0, 0.0), Size(0.9, 0.5, 0.4))
    rug = _group("sleeping", "rug", Pose(1.0, 0.0, 0.0, 0.0), Size(2.0, 1.4, 0.01))
    assert cost_of_outlook((SOFA, table, rug), _ground(6.0), 10.0) == 0.0
    assert cost_of_outlook((SOFA, table), _ground(1.6), 10.0) > 5.0


def test_the_long_seat_of_a_corner_sofa_is_not_what_it_looks_from():
    bed = _bed_at(0.4 - 0.85 + 0.95 + AHEAD + 1.0)
    assert cost_of_outlook((CORNER, bed), _ground(6.0), 10.0) == 0.0


def test_rooms_without_a_sofa_and_what_stands_fixed():
    fixed = _bed_at(1.8).pieces
    assert cost_of_outlook((_bed_at(1.0),), _ground(6.0), 10.0, fixed) == 0.0
    assert cost_of_outlook((SOFA,), _ground(6.0), 10.0, fixed) > 5.0
