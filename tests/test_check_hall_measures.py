"""The paper's measures of a hall on layouts whose values are known."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from tests.judged_halls import EAST, group, judge, piece

from hall_floors import figures, grid, two_zones
from scenewright.domains.hall.check.measures import aesthetic, circulation, principal_direction


def test_measures_of_a_grid_of_four():
    """Two lines each way through the middles, four through the edges; nothing is too close."""
    cases = grid()
    told = figures(judge(two_zones(*cases, groups=(group("h/cases", "west", *cases),))))
    assert told["aesthetic"] == pytest.approx(3 / 8, abs=1e-4)
    assert told["aesthetic_edges"] == pytest.approx(3 / 12, abs=1e-4)
    assert told["circulation"] == told["circulation_all"] == 0
    area = abs(4 / 36 - 4 / 72) + 4 / 72
    assert told["uniformity"] == pytest.approx(area / 2, abs=1e-4)
    assert told["floor_used"] == pytest.approx(4 / 72, abs=1e-4)


def test_two_readings_of_circulation():
    """Side by side 1 cm apart across, 0.4 m apart along; diagonals 0.4 m and a hair."""
    boxes = np.array([shapely.box(x, y, x + 1, y + 1) for x in (0, 1.01) for y in (0, 1.4)])
    diagonal = 0.6 - math.hypot(0.4, 0.01)
    apart, every = circulation(boxes)
    assert apart == pytest.approx(2 * 0.2 + 2 * diagonal)
    assert every == pytest.approx(2 * 0.2 + 2 * diagonal + 2 * 0.59)


def test_uniformity_of_walls():
    """A shelf 3 m long at the west zone's outer wall: 3 m of 14.4 m there, of 33.6 m in all."""
    shelf = piece("shelf", 0.2, 3, 3.0, 0.4, heading=EAST)
    told = figures(judge(two_zones(shelf, groups=(group("h/s", "west", shelf),))))
    lengths = 6 + 6 + 6 - 1.6, 6 + 6 + 6 - 1.6
    area = abs(1.2 / 36 - 1.2 / 72) + 1.2 / 72
    walls = abs(3 / lengths[0] - 3 / sum(lengths)) + 3 / sum(lengths)
    assert told["uniformity"] == pytest.approx((area + walls) / 2, rel=0.02)


@given(st.lists(st.tuples(st.floats(0, 20), st.floats(0, 20)), min_size=1, max_size=12))
def test_alignment_does_not_depend_on_order_or_mirroring(points):
    centres = np.array(points)
    corners = centres[:, None] + np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])[None] / 2
    assert aesthetic(corners, 0.0) == aesthetic(corners[::-1] * [-1, 1], 0.0)
    assert aesthetic(corners, 0.0)[0] >= aesthetic(corners, 0.0)[1]


def test_the_main_walls_give_the_direction():
    bent = shapely.Polygon([(0, 0), (6, 0), (6, 4), (3, 6), (0, 6)])
    assert principal_direction(bent) == pytest.approx(0, abs=1e-9)
    turned_ = principal_direction(shapely.affinity.rotate(bent, 20))
    assert turned_ == pytest.approx(math.radians(20), abs=1e-6)
