"""The k-d tree gives what a full sort gives."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st

from scenewright.geometry.kd_tree import nearest_first, plant

COARSE = st.integers(0, 6).map(float)  # many equal coordinates and distances
PLACES = st.tuples(COARSE, COARSE)


@given(st.lists(PLACES, max_size=40), PLACES)
def test_order_is_that_of_a_full_sort(
    points: list[tuple[float, float]], place: tuple[float, float]
) -> None:
    wanted = sorted(range(len(points)), key=lambda i: (math.dist(points[i], place), i))
    assert list(nearest_first(plant(points), place)) == wanted


@given(st.lists(PLACES, max_size=40), PLACES, PLACES)
def test_limits_leave_out_larger_points(
    points: list[tuple[float, float]], place: tuple[float, float], most: tuple[float, float]
) -> None:
    every = nearest_first(plant(points), place)
    wanted = [i for i in every if points[i][0] <= most[0] and points[i][1] <= most[1]]
    assert list(nearest_first(plant(points), place, most)) == wanted
