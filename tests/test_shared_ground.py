"""What footprints share, where houses stand wall to wall."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from scenewright.check.shared_ground import intersect_footprints

EAST = "01030000000100000005000000"
ROUND = (
    "E670AF4525202D401C6EF78004385340EE2651741E670D40F0DC99628FD35240ABF1B09C75FB1240E00081DB78F85"
    "04000A0F37618442F400C92DEF9ED5C5140E670AF4525202D401C6EF78004385340"
)
BESIDE = (
    "00A0F37618442F400C92DEF9ED5C5140ADF1B09C75FB1240E00081DB78F85040ED4F39FF5B4317409F49D0A8C43A4E"
    "4090E71BD405B43040F76B8BE5AE034F4000A0F37618442F400C92DEF9ED5C5140"
)


def test_houses_wall_to_wall_share_no_ground() -> None:
    """Their common side differs in its last digit: GEOS 3.14 returns one house whole."""
    one, other = (shapely.from_wkb(bytes.fromhex(EAST + ring)) for ring in (ROUND, BESIDE))
    assert one.area == pytest.approx(82.5)
    for a, b in ((one, other), (other, one)):
        assert intersect_footprints(a, b).area == 0.0
    both = intersect_footprints(np.array([one, one]), np.array([other, one]))
    assert shapely.area(both).tolist() == pytest.approx([0.0, 82.5])


side = st.floats(0.5, 20)


@given(st.floats(-10, 10), st.floats(-10, 10), st.floats(0, 3), side, side)
def test_what_truly_overlaps_is_as_large_as_it_was(
    x: float, y: float, turn: float, width: float, depth: float
) -> None:
    one = shapely.box(0, 0, 8, 11)
    other = shapely.affinity.rotate(shapely.box(x, y, x + width, y + depth), turn, use_radians=True)
    shared = intersect_footprints(one, other)
    assert shared.area == pytest.approx(shapely.intersection(one, other).area, abs=1e-6)
