"""Stands and panels turn their fronts to the entrance, not a wall of backs."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import CHAIN, GRID, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import turn_half_round
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import ALOOF
from scenewright.domains.hall.visit.roles import FRONT

AISLE = 2.0
"""Metres free before stands at least, none behind or beside them."""
TURNED = 1.5
"""What a group of them counts that all look straight away from the way in, in metres."""
STEPS = tuple(0.3 * k for k in range(-12, 13))
"""Metres ahead of where they stand that are tried with stands turned half round."""


def _find_stands(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of stands with closed backs, and of what has a front, in straight rows that look at
    nothing of their own."""
    units = problem.units
    clear = units.clear[units.spans[:, 0]]
    closed = (clear[:, 0] >= AISLE) & (clear[:, 1:] == 0.0).all(1) & (units.targets < 0)
    roles = problem.visitors.roles.astype(int)
    shown = closed & (roles & ALOOF > 0) | (units.targets < 0) & (roles & FRONT > 0)
    straight = np.isin(kept.rows[:, 0].astype(int), (CHAIN, GRID, SINGLE))
    return [int(unit) for unit in np.flatnonzero(shown & straight)]


def measure_backs(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """What groups of stands count that turn their backs to the main entrance: up to
    :data:`TURNED` each, by the cosine of the angle between their fronts and the way to it."""
    if not len(problem.visitors.entrances):
        return 0.0
    return sum(_measure_away(problem, boxes, unit) for unit in _find_stands(problem, kept))


def _measure_away(problem: HallProblem, boxes: Floats, unit: int) -> float:
    mine = boxes[slice(*problem.units.spans[unit])]
    way = problem.visitors.entrances[0] - mine[:, :2].mean(0)
    front = np.array([np.cos(mine[0, 2]), np.sin(mine[0, 2])])
    return TURNED * max(-float(front @ way) / max(float(np.hypot(*way)), 1e-9), 0.0)


def propose_turns(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one group of stands that looks away turned half round, a little ahead of or
    behind where it stands."""
    for unit in _find_stands(problem, kept):
        if _measure_away(problem, boxes, unit) > 0.0:
            yield from turn_half_round(kept, unit, STEPS)
