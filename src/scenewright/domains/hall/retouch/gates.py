"""Gates across the way they control: before the door people come in by, or on the border over which
they come into their zone.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.patterns import CHAIN
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST

MOST = 12
"""Gates of one row at most."""
NEAREST, FARTHEST = 2.5, 5.5
"""Metres from a door or a border between which gates stand."""
ASIDE, MOST_ASIDE, TURNED, PARTED = 0.5, 4.0, 2.0, 1.0
"""What a metre off the middle of the way counts and beyond how many more count no more, what a row
along the way counts, and each row of gates but the first; metres."""
STEPS = (2.6, 3.2, 4.0, 4.8, 5.4)
SHIFTS = tuple(0.8 * k for k in range(-10, 11))
"""Metres ahead and aside that are tried."""
INSIDE = 0.6
"""How far outside the bounds of its zone a door may lie, in metres."""


def find_gates(problem: HallProblem, kept: Kept) -> list[int]:
    """The units people pass through: come to first, and used from the front and the back."""
    roles, units = problem.visitors.roles, problem.units
    if not len(problem.visitors.inward) or not len(problem.visitors.entrances):
        return []
    return [
        unit
        for unit, (first, last) in enumerate(units.spans)
        if int(roles[unit]) & FIRST
        and int(kept.rows[unit, 0]) == CHAIN
        and last - first <= MOST
        and units.access[first, 0]
        and units.access[first, 2]
    ]


def find_way(problem: HallProblem, unit: int) -> tuple[Floats, Floats]:
    """Where people come into the zone of a unit, and the unit direction of their way: by the main
    entrance, else over the middle of the linked border nearest to it."""
    zone, door = int(problem.units.zones[unit]), problem.visitors.entrances[0]
    bounds = problem.ground.zone_bounds[zone]
    borders = problem.ground.borders
    mine = [
        row[:4]
        for row in borders
        if zone in problem.ground.links[int(row[4]), :2].astype(int).tolist()
    ]
    at_door = (door >= bounds[:2] - INSIDE).all() and (door <= bounds[2:] + INSIDE).all()
    if at_door or not mine:
        return door, problem.visitors.inward[0]
    middles = np.array([(0.5 * (r[0] + r[2]), 0.5 * (r[1] + r[3])) for r in mine])
    near = int(np.hypot(*(middles - door).T).argmin())
    along = np.array([mine[near][2] - mine[near][0], mine[near][3] - mine[near][1]])
    across = np.array([-along[1], along[0]]) / max(float(np.hypot(*along)), 1e-9)
    centre = 0.5 * (bounds[:2] + bounds[2:])
    return middles[near], across * (1.0 if (centre - middles[near]) @ across >= 0.0 else -1.0)


def gates_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all rows of gates of boxes (n, 5), in metres."""
    total = 0.0
    for unit in find_gates(problem, kept):
        start, way = find_way(problem, unit)
        off = boxes[slice(*problem.units.spans[unit]), :2].mean(0) - start
        ahead, aside = float(off @ way), abs(float(off @ (-way[1], way[0])))
        front = np.array([np.cos(kept.pose[unit, 2]), np.sin(kept.pose[unit, 2])])
        total += ASIDE * min(aside, MOST_ASIDE) + TURNED * (1.0 - abs(float(front @ way)))
        total += min(max(NEAREST - ahead, ahead - FARTHEST, 0.0), MOST_ASIDE)
        total += PARTED * (int(kept.rows[unit, 1]) - 1)
    return total


def propose_gates(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:  # noqa: ARG001
    """Layouts with the gates of one unit side by side across the way."""
    counts = np.diff(problem.units.spans, axis=1)[:, 0]
    starts = np.concatenate([[0], np.cumsum(capacity(counts))])
    for unit in find_gates(problem, kept):
        start, way = find_way(problem, unit)
        for ahead in STEPS:
            for aside in SHIFTS:
                pose, layers, rows = kept.pose.copy(), kept.layers.copy(), kept.rows.copy()
                pose[unit, :2] = start + ahead * way + aside * np.array([-way[1], way[0]])
                pose[unit, 2] = np.arctan2(-way[1], -way[0])
                layers[int(starts[unit])] = (float(counts[unit]), 0.0, 0.0, CHAIN, 0.0)
                rows[unit] = (CHAIN, 1)
                yield kept._replace(pose=pose, layers=layers, rows=rows)
