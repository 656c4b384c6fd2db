"""Where the layers of a unit lie in a layout, and units set up in straight lines and rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, CODE, GRID, NUMBER
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.table import SPACE, space_cost


def count_objects(problem: HallProblem) -> Ints:
    """The objects (g,) of each unit."""
    counts: Ints = np.diff(problem.units.spans, axis=1)[:, 0]
    return counts


def find_layers(problem: HallProblem, unit: int) -> tuple[int, int]:
    """The first row of the layers of a unit, and how many it may have."""
    room = capacity(count_objects(problem))
    return int(room[:unit].sum()), int(room[unit])


def line_up(
    problem: HallProblem,
    kept: Kept,
    unit: int,
    pose: Sequence[float] | Floats,
    lines: int = 1,
    apart: float = 0.0,
) -> Kept:
    """The layout with a unit at a pose (3,), side by side in ``lines`` lines, ``apart`` metres from
    one another; a single object keeps its pattern."""
    first, number = find_layers(problem, unit)[0], int(count_objects(problem)[unit])
    poses, layers, rows = kept.pose.copy(), kept.layers.copy(), kept.rows.copy()
    poses[unit, :3] = pose[:3]
    if number > 1:
        for k in range(lines):
            each = number // lines + (1 if k < number % lines else 0)
            layers[first + k] = (float(each), 0.0, apart, CHAIN, 0.0)
        rows[unit], poses[unit, 3] = (CHAIN, lines), 0.0
    return kept._replace(pose=poses, layers=layers, rows=rows)


def turn_half_round(kept: Kept, unit: int, steps: Sequence[float]) -> Iterator[Kept]:
    """Layouts with a unit turned half round, each of ``steps`` metres ahead of where it stands."""
    heading = float(kept.pose[unit, 2])
    for step in steps:
        pose = kept.pose.copy()
        pose[unit, :2] += step * np.array([np.cos(heading), np.sin(heading)])
        pose[unit, 2] += np.pi
        yield kept._replace(pose=pose)


def set_rows(
    kept: Kept,
    unit: int,
    first: int,
    number: int,
    many: Floats,
    gaps: Floats,
    pose: tuple[float, ...],
) -> Kept:
    """The layout with a unit at a pose in rows of so ``many`` (2,) columns, with such gaps (2,), a
    grid where it is one and they are full."""
    poses, layers, rows = kept.pose.copy(), kept.layers.copy(), kept.rows.copy()
    columns, used = (int(n) for n in many)
    each = [number // used + (1 if k >= used - number % used else 0) for k in range(used)]
    code = GRID if number == columns * used and int(kept.rows[unit, 0]) == GRID else CHAIN
    for k, count in enumerate(each):
        layers[first + k, [NUMBER, ALONG, ACROSS, CODE]] = count, gaps[0], gaps[1], code
    rows[unit], poses[unit] = (code, used), (*pose, 0.0)
    return kept._replace(pose=poses, layers=layers, rows=rows)


def forgive_space(p: PreparedHall, s: State, unit: int, covered: float) -> float:
    """By how much the energy of a measured state would be less if only ``covered`` square metres of
    the free floor of a unit were."""
    least = space_cost(covered, float(p.beta[unit]))
    return float(p.weights[SPACE]) * (float(s.costs[SPACE, unit]) - least)
