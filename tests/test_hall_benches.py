"""Benches keep off their neighbours where there is another place to look from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.accessories.benches import (
    BARS,
    BENCH_HIDDEN,
    FARS,
    PUSHED,
    WALL_BEHIND,
    WEDGED,
    find_bench_spots,
)
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
    wedged = find_costs(*(piece("interactive_table", x, 7.1, table) for x in (3.2, 6.8)))
    pushed = find_costs(*(piece("interactive_table", x, 7.1, table) for x in (3.4, 6.6)))
    apart = find_costs(*(piece("interactive_table", x, 7.1, table) for x in (2.4, 7.6)))
    assert np.allclose(wedged - free, WEDGED)
    assert np.allclose(pushed - free, WEDGED + PUSHED)
    assert np.allclose(apart, free)


def test_a_place_before_a_column_costs() -> None:
    """The benches stand about (5, 7), 2 to 3 m before a picture."""
    costs = [find_costs(walls=np.array([[4.8, y, 5.2, y]])) for y in (7.3, 5.0)]
    assert (costs[0] > costs[1]).any()
    assert not (costs[0] < costs[1]).any()
    assert np.allclose(costs[1], find_costs(walls=np.array([[4.8, 4.0, 5.2, 4.0]])))


def test_a_place_right_before_another_picture_costs() -> None:
    """Benches that look at the picture stand about (5, 7); another hangs beside them, or far."""
    wall = 0.5 * np.pi
    beside, far = (piece("wall_exhibit", 5.0, y, Size(1.2, 0.4, 2.2)) for y in (6.2, 2.0))
    turned = [one._replace(heading=wall) for one in (beside.pose, far.pose)]
    barred, free = (
        find_costs(replace(one, pose=pose)) for one, pose in zip((beside, far), turned, strict=True)
    )
    assert barred[: len(FARS)].min() > free[: len(FARS)].min() + BARS - 1e-9


def test_a_place_under_a_picture_is_the_last_at_a_wall() -> None:
    walls = np.array([[9.0, 10.0, 1.0, 10.0]])
    picture = piece("wall_exhibit", 5.0, 9.8, Size(1.2, 0.4, 2.2))
    spots = find_bench_spots(Setting((), walls, (picture,), np.zeros((0, 5))), BENCH)
    at_wall = np.abs(spots.boxes[:, 1] - 9.8) < 0.1
    near = np.abs(spots.boxes[:, 0] - 5.0) < 0.6
    assert (spots.costs[at_wall & near] >= WALL_BEHIND + BARS).all()
    assert spots.costs[at_wall & ~near].min() < WALL_BEHIND + BARS


def test_a_wall_is_a_better_place_than_beside_another_bench() -> None:
    walls = np.array([[1.0, 0.0, 9.0, 0.0]])
    picture = piece("wall_exhibit", 5.0, 9.8, Size(1.2, 0.4, 2.2))
    there = np.array([[5.0, 7.1, 0.5 * np.pi, *BENCH[:2]]])
    spots = find_bench_spots(Setting((), walls, (picture,), there), BENCH)
    assert spots.boxes[np.argmin(spots.costs), 1] < 1.0


def test_a_place_from_where_a_column_hides_the_picture_costs() -> None:
    """A column on the line from a bench about (5, 7) to the picture, or beside that."""
    hidden, beside = (
        find_costs(walls=np.array([[x, 8.6, x + 0.2, 8.6]]))[-len(FARS) :] for x in (4.9, 6.0)
    )
    free = find_costs()
    assert np.allclose(hidden - free, BENCH_HIDDEN)
    assert np.allclose(beside, free)


def test_a_place_at_a_wall_behind_a_column_costs() -> None:
    wall, column = [1.0, 0.0, 9.0, 0.0], [6.0, 0.9, 5.0, 0.9]
    setting = Setting((), np.array([wall, column]), (), np.zeros((0, 5)))
    spots = find_bench_spots(setting, BENCH)
    behind = (np.abs(spots.boxes[:, 0] - 5.5) < 0.5) & (spots.boxes[:, 1] < 0.5)
    free = (np.abs(spots.boxes[:, 0] - 3.0) < 0.5) & (spots.boxes[:, 1] < 0.5)
    assert (spots.costs[behind] >= WALL_BEHIND + BENCH_HIDDEN).all()
    assert (spots.costs[free] < WALL_BEHIND + BENCH_HIDDEN).all()
    assert behind.any()
    assert free.any()
