"""Gates across the way they control: before the door people come in by, or on the border over which
they come into their zone, where rails close what they leave open.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from scenewright.domains.hall.gates.rails import RowOfGates, find_way_in, measure_rails
from scenewright.domains.hall.patterns import CHAIN, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round, find_met
from scenewright.domains.hall.retouch.lines import forgive_space, line_up
from scenewright.domains.hall.retouch.places import before, shift
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.visitors import FIRST

MOST = 12
"""Gates of one row at most."""
NEAREST, FARTHEST_GATE = 1.6, 3.1
"""Metres from a door or a border between which gates stand."""
PER_GATE_ASIDE, MOST_ASIDE, GATES_ALONG, PER_ROW_OF_GATES = 0.5, 9.0, 2.0, 1.0
"""What a metre off the middle of the way counts and beyond how many more count no more, what a row
along the way counts, and each row of gates but the first; metres."""
SHUT, BARRED, MOST_BARRED, RAIL_FREE = 1.0, 0.5, 3.0, 0.05
"""What it counts that their rails cannot stand, and each metre of them that cannot, the most that
counts, and how much of them others may stand in; metres."""
PER_CROWDED, NEEDED = 0.5, 0.8
"""Cost of a metre of their rails on floor that others need, and how much of it they need."""
FORGIVEN = 0.97
"""What is forgiven of the free floor of gates that doors need too: farther off is still better."""
STEPS = (1.72, 2.0, 2.4, 2.8, 3.4)
SHIFTS = tuple(0.65 * k for k in range(-8, 9))
FEWER = SHIFTS[4:-4]
"""Metres ahead and aside that are tried, and aside where each of several doors has gates."""
PARALLEL, MOST_STEP = 0.99, 1.5
"""The cosine between two ways that are one, and metres from row to row along them beyond which
these are two lines."""
NUDGES = (0.05, -0.05, 0.1, -0.1, 0.2, -0.2, 0.3, -0.3)
"""Metres along their row that are tried where they stand."""


def find_gates(problem: HallProblem, kept: Kept) -> list[int]:
    """The units people pass through: come to first, and used from the front and the back."""
    access, spans = problem.units.access, problem.units.spans
    met = find_met(problem, kept, FIRST, MOST, (CHAIN, SINGLE))
    return [unit for unit in met if access[spans[unit, 0], ::2].all()]


def gates_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all rows of gates of boxes (n, 5), in metres."""
    found = find_gates(problem, kept)
    steps = (max(map(abs, list_steps(problem, boxes, unit, found)), default=0.0) for unit in found)
    return sum(measure_gates(problem, kept, boxes, unit) for unit in found) + sum(steps)


def list_steps(problem: HallProblem, boxes: Floats, unit: int, units: list[int]) -> list[float]:
    """Metres by which each of the rows ``units`` before a unit that people pass the same way stands
    ahead of it among boxes (n, 5): side by side, rows are in one line."""
    spans, zones = problem.units.spans, problem.units.zones
    mine, own = boxes[slice(*spans[unit])][:, :2].mean(0), find_way_in(problem, unit)
    found = list[float]()
    for other in units[: units.index(unit)]:
        off = boxes[slice(*spans[other])][:, :2].mean(0) - mine
        along = find_way_in(problem, other).way @ own.way > PARALLEL
        ahead = float(off @ own.way)
        if along and zones[other] == zones[unit] and abs(ahead) < MOST_STEP:
            found.append(ahead)
    return found


def measure_gates(problem: HallProblem, kept: Kept, boxes: Floats, unit: int) -> float:
    """How far the gates of a unit are from a row across the way in, and what bars their rails;
    metres."""
    way_in = find_way_in(problem, unit)
    mine = boxes[slice(*problem.units.spans[unit])]
    off = mine[:, :2].mean(0) - way_in.start
    way = way_in.way
    ahead, aside = float(off @ way), abs(float(off @ (-way[1], way[0])))
    turned = 1.0 - abs(
        float(np.cos(kept.pose[unit, 2]) * way[0] + np.sin(kept.pose[unit, 2]) * way[1])
    )
    parted = PER_ROW_OF_GATES * (int(kept.rows[unit, 1]) - 1) if len(mine) > 1 else 0.0
    far = min(max(NEAREST - ahead, ahead - FARTHEST_GATE, 0.0), MOST_ASIDE)
    total = PER_GATE_ASIDE * min(aside, MOST_ASIDE) + GATES_ALONG * turned + far + parted
    if turned > 0.01 or parted:
        return total + MOST_BARRED
    row = find_row(problem, boxes, unit)
    barred, crowded = min(measure_rails(problem, row, side) for side in (-1, 1))
    total += PER_CROWDED * min(crowded, MOST_BARRED)
    return total + (min(SHUT + BARRED * barred, MOST_BARRED) if barred > RAIL_FREE else 0.0)


def find_row(problem: HallProblem, boxes: Floats, unit: int) -> RowOfGates:
    """The row of gates of a unit among boxes (n, 5)."""
    span = problem.units.spans[unit]
    others = np.delete(boxes, np.arange(*span), axis=0)
    clear = NEEDED * np.delete(problem.units.clear, np.arange(*span), axis=0)
    front, left, back, right = clear.T
    ahead, aside = 0.5 * (front - back), 0.5 * (left - right)
    cos, sin = np.cos(others[:, 2]), np.sin(others[:, 2])
    needed = others + np.column_stack(
        [
            cos * ahead - sin * aside,
            sin * ahead + cos * aside,
            0.0 * cos,
            left + right,
            front + back,
        ]
    )
    row = box_round(boxes[slice(*span)])
    return RowOfGates(row, find_way_in(problem, unit), others, needed)


def forgive_doors(
    problem: HallProblem,
    kept: Kept,
    boxes: Floats,  # noqa: ARG001
    p: PreparedHall,
    s: State,
) -> float:
    """What of the energy of a measured state comes from the free floor of gates that lies on that
    of the door they belong to, or at walls: both are for the same people."""
    total = 0.0
    for unit in find_gates(problem, kept):
        total += forgive_space(p, s, unit, float(s.covered[unit, :2].sum()))
    return FORGIVEN * total


def propose_gates(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the gates of one unit that are not there side by side across the way, or in
    line with those of another."""
    units = find_gates(problem, kept)
    faults = {unit: measure_gates(problem, kept, boxes, unit) for unit in units}
    for unit in units:
        way_in = find_way_in(problem, unit)
        start, way = way_in.start, way_in.way
        left = np.array([-way[1], way[0]])
        steps = [s for s in list_steps(problem, boxes, unit, units) if abs(s) > RAIL_FREE]
        for step, aside in product(steps, (0.0, *NUDGES)):
            yield shift(kept, unit, step * way + aside * left)
        if faults[unit] <= RAIL_FREE:
            continue
        frame = np.array([*start, np.arctan2(way[1], way[0])])
        for pose in before(frame, STEPS, SHIFTS if len(units) == 1 else FEWER, np.pi):
            yield line_up(problem, kept, unit, pose)
        for aside in NUDGES:
            yield shift(kept, unit, aside * left)
