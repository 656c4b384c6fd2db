"""Benches keep off what stands beside them where there is another place to look from."""

from __future__ import annotations

import numpy as np

from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.accessories.benches import WEDGED, find_bench_spots
from scenewright.domains.hall.accessories.setting import Setting

NOWHERE = np.zeros((0, 4))
BENCH = Size(1.2, 0.38, 0.45)


def piece(name: str, x: float, y: float, size: Size) -> Piece:
    pose = Pose(x, y, 0.0, -0.5 * np.pi)
    return Piece(id=f"{name}-{x}", category=name, asset="", space="hall", pose=pose, size=size)


def find_costs(*pieces: Piece, walls: np.ndarray = NOWHERE) -> np.ndarray:
    picture = piece("wall_exhibit", 5.0, 9.8, Size(1.2, 0.4, 2.2))
    setting = Setting((), walls, (picture, *pieces), np.zeros((0, 5)))
    return find_bench_spots(setting, BENCH).costs


def test_a_place_wedged_between_two_tables_costs() -> None:
    table = Size(1.4, 0.8, 0.9)
    free = find_costs()
    wedged = find_costs(*(piece("interactive_table", x, 7.1, table) for x in (3.4, 6.6)))
    apart = find_costs(*(piece("interactive_table", x, 7.1, table) for x in (2.4, 7.6)))
    assert np.allclose(wedged - free, WEDGED)
    assert np.allclose(apart, free)


def test_a_place_before_a_column_costs() -> None:
    """The benches stand about (5, 7), 2 to 3 m before a picture."""
    costs = [find_costs(walls=np.array([[4.8, y, 5.2, y]])) for y in (7.3, 5.0)]
    assert (costs[0] > costs[1]).any()
    assert not (costs[0] < costs[1]).any()
    assert np.allclose(costs[1], find_costs(walls=np.array([[4.8, 4.0, 5.2, 4.0]])))
