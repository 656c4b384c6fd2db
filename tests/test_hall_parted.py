"""Rows that run through a partition move to one side of it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from scenewright.domains.hall.patterns import CHAIN, WALL
from scenewright.domains.hall.retouch import RETOUCHES
from scenewright.domains.hall.retouch.parted import measure_parted, propose_sides

PITCH = 2.0


def hall_with_wall(x: float, length: float = 4.0) -> Any:
    """A problem of five panels, and a border along y at some ``x`` for a partition on it."""
    units = SimpleNamespace(spans=np.array([[0, 5]]))
    ground = SimpleNamespace(hosts=np.array([[x, 0.0, x, length, 0.0, 1.0]]))
    return SimpleNamespace(units=units, ground=ground)


def layout(pattern: int = CHAIN, wall: tuple[float, float] = (0.0, 4.0)) -> Any:
    layers = np.zeros((40, 5))
    layers[0] = (5.0, PITCH - 1.0, 0.0, pattern, 0.0)
    return SimpleNamespace(
        rows=np.array([[pattern, 1]]),
        walls=np.array([wall]),
        offsets=np.zeros(1),
        pose=np.array([[4.0, 2.0, 0.5 * np.pi, 0.0]]),
        layers=layers,
        _replace=lambda **new: SimpleNamespace(**new),
    )


def panels(y: float = 2.0) -> np.ndarray:
    return np.array([(PITCH * k, y, 0.5 * np.pi, 1.0, 0.4) for k in range(5)])


def test_a_partition_through_a_row_or_at_its_line_counts() -> None:
    assert measure_parted(hall_with_wall(7.0), layout(), panels()) == 3.0
    assert measure_parted(hall_with_wall(7.0), layout(), panels(4.0)) == 3.0
    assert measure_parted(hall_with_wall(7.0), layout(), panels(4.6)) == 0.0
    assert measure_parted(hall_with_wall(9.0), layout(), panels()) == 0.0
    assert measure_parted(hall_with_wall(7.0), layout(wall=(0.0, 0.0)), panels()) == 0.0
    assert measure_parted(hall_with_wall(7.0), layout(WALL), panels()) == 0.0


def test_rows_at_both_sides_of_a_partition_are_not_cut() -> None:
    turned = panels()
    turned[:, 2] = 0.0
    assert measure_parted(hall_with_wall(7.0), layout(), turned) == 0.0


def test_a_row_is_moved_along_its_line_with_narrower_gaps() -> None:
    found = list(propose_sides(hall_with_wall(7.0), layout(), panels()))
    assert {round(float(one.pose[0, 0]), 2) for one in found} >= {1.0, 3.0, 4.0, 7.0}
    assert min(float(one.layers[0, 1]) for one in found) < PITCH - 1.0
    assert not list(propose_sides(hall_with_wall(9.0), layout(), panels()))


def test_rows_are_parted_before_they_spread() -> None:
    names = [row.name for row in RETOUCHES]
    assert names.index("parted") < names.index("spread")
