"""Poufs: a line of them side by side, a fence amid the floor, opens to an arc or a circle.

Poufs are sat down on to listen or to talk: whoever sets them out leaves them loosely round a rug,
open to who tells or shows something.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import product

import numpy as np

from scenewright.domains.hall.patterns import CHAIN, FAN, GRID, RADIATION
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import count_objects, find_layers, forgive_space
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.visitors import LOUNGE

FEWEST, EACH = 4, 1.0
"""Poufs in one line from which on it is a fence, and what each of them more than two counts, in
metres."""
GAPS, SECTOR = (0.35, 0.2), 1.1 * np.pi
"""Gaps of poufs that are tried, in metres, and the sector of an arc, in radians."""
SHIFTS = (0.0, -0.6, 0.6, -1.2, 1.2)
"""By how much the middle of a group is moved along both axes, in metres."""
STEPS = 9
"""Places along each side of the zone that are tried besides."""


def measure_fences(problem: HallProblem, kept: Kept, boxes: Floats) -> float:  # noqa: ARG001
    """What straight lines of poufs among ``boxes`` (n, 5) count, in metres."""
    return float(sum(EACH * (_longest(problem, kept, u) - 2) for u in _find_fences(problem, kept)))


def _longest(problem: HallProblem, kept: Kept, unit: int) -> int:
    """Poufs in the longest line of a unit, along its rows or across."""
    number, rows = int(count_objects(problem)[unit]), max(int(kept.rows[unit, 1]), 1)
    return max(-(-number // rows), rows)


def _find_fences(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of seats without a front that stand in a long line and might stand in rows as well
    as in a grid: a brief that states one of these has it."""
    return [
        unit
        for unit in _find_poufs(problem, kept, (CHAIN, GRID))
        if _longest(problem, kept, unit) >= FEWEST
    ]


def _find_poufs(problem: HallProblem, kept: Kept, codes: Collection[int]) -> list[int]:
    """The units of seats without a front in some patterns, to which a brief leaves rows and
    grids."""
    roles, units = problem.visitors.roles.astype(int), problem.units
    return [
        unit
        for unit in range(len(roles))
        if roles[unit] & LOUNGE
        and int(kept.rows[unit, 0]) in codes
        and units.choices[unit, [CHAIN, GRID]].all()
        and units.access[units.spans[unit, 0]].all()
    ]


def forgive_poufs(
    problem: HallProblem,
    kept: Kept,
    boxes: Floats,  # noqa: ARG001
    p: PreparedHall,
    s: State,
) -> float:
    """What of the energy of a measured state comes from the free floor of poufs on a curve on which
    others of it stand: they are drawn together."""
    return sum(
        forgive_space(p, s, unit, float(s.covered[unit, 1:].sum()))
        for unit in _find_poufs(problem, kept, (RADIATION, FAN))
    )


def propose_circles(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one line of poufs among ``boxes`` (n, 5) in an arc, open to each side in turn,
    or in a circle, near where they stand or elsewhere in their zone."""
    for unit in _find_fences(problem, kept):
        mine = boxes[slice(*problem.units.spans[unit])]
        middle, number = mine[:, :2].mean(0), len(mine)
        near = [middle + np.array(shift) for shift in product(SHIFTS, SHIFTS)]
        for gap, at in product(GAPS, (*near, *_spread(problem, unit))):
            pitch = float(mine[:, 3:].max()) + gap
            yield _curve(problem, kept, unit, (*at, 0.0, 0.0), RADIATION, pitch / (2.0 * np.pi))
            for turn in range(4) if number > 1 else ():
                pose = (*at, kept.pose[unit, 2] + 0.5 * np.pi * turn, SECTOR)
                yield _curve(problem, kept, unit, pose, FAN, pitch / SECTOR)


def _spread(problem: HallProblem, unit: int) -> Iterator[Floats]:
    """Points (2,) all over the zone of a unit."""
    low, high = problem.ground.zone_bounds[int(problem.units.zones[unit])].reshape(2, 2)
    parts = (np.arange(STEPS) + 0.5) / STEPS
    for part in product(parts, repeat=2):
        yield low + np.array(part) * (high - low)


def _curve(
    problem: HallProblem, kept: Kept, unit: int, pose: tuple[float, ...], pattern: int, each: float
) -> Kept:
    """The layout with a unit on one curve, at a pose (4,), ``each`` metre of radius an object."""
    first, number = find_layers(problem, unit)[0], int(count_objects(problem)[unit])
    poses, layers, rows = kept.pose.copy(), kept.layers.copy(), kept.rows.copy()
    poses[unit], rows[unit] = pose, (pattern, 1)
    layers[first] = (float(number), 0.0, number * each, pattern, 0.0)
    return kept._replace(pose=poses, layers=layers, rows=rows)
