"""Free floor to queue on before tills with lanes: goods stand farther off, or the tills nearer to
the way out."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from scenewright.core.layout import corners
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.lines import count_objects
from scenewright.domains.hall.retouch.places import shift
from scenewright.domains.hall.retouch.tills import find_tills
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import GUIDE

DEEP, PER_QUEUE = 2.0, 3.0
"""Metres that are free before the lanes, over all of them, and what each that lacks counts."""
TILL_BEHIND = 1.0
"""Metres between tills and the point inside the way out at least where they move towards it."""
STEPS = (0.0, 0.2, 0.4, 0.6)
"""Metres by which tills move towards the way out that are tried."""
ACROSS_LANES = 0.1
"""Metres across the lanes by which something stands before them that counts."""


class Lanes(NamedTuple):
    """A row of tills with lanes: its unit, the middle of its end that people queue before, the unit
    direction from there into the hall, half of its width across the lanes, and metres from its
    other end to the way out."""

    unit: int
    end: Floats
    ahead: Floats
    half: float
    behind: float


def find_lanes(problem: HallProblem, kept: Kept, boxes: Floats) -> list[Lanes]:
    """All rows of tills with lanes among boxes (n, 5)."""
    rows = find_tills(problem, kept)
    return [_read_lanes(problem, unit, boxes[slice(*problem.units.spans[unit])]) for unit in rows]


def _read_lanes(problem: HallProblem, unit: int, tills: Floats) -> Lanes:
    x, y, heading, wide, deep = box_round(tills)
    right = np.array([np.sin(heading), -np.cos(heading)])
    exits = problem.visitors.exits - (x, y)
    out = float(exits[int(np.hypot(*exits.T).argmin())] @ right)
    ahead = -right if out > 0.0 else right
    end = np.array([x, y]) + 0.5 * wide * ahead
    return Lanes(unit, end, ahead, 0.5 * float(deep), abs(out) - 0.5 * float(wide))


def measure_queues(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """What the metres count that floor before lanes lacks (:data:`DEEP`), by the nearest object."""
    lanes = find_lanes(problem, kept, boxes)
    return PER_QUEUE * sum(
        float(_measure_lack(problem, boxes, one).max(initial=0.0)) for one in lanes
    )


def _measure_lack(problem: HallProblem, boxes: Floats, lanes: Lanes) -> Floats:
    """By how many metres each of boxes (n, 5) stands too near before a row of tills; ropes and the
    tills never do."""
    off = corners(boxes) - lanes.end
    ahead, aside = off @ lanes.ahead, off @ (-lanes.ahead[1], lanes.ahead[0])
    over = np.minimum(aside.max(1), lanes.half) - np.maximum(aside.min(1), -lanes.half)
    counts = np.diff(problem.units.spans, axis=1)[:, 0]
    guides = (problem.visitors.roles.astype(int) & GUIDE).astype(bool)
    guides[lanes.unit] = True
    before = (over > ACROSS_LANES) & (ahead.max(1) > 0.0) & ~np.repeat(guides, counts)
    lack: Floats = np.where(before, np.maximum(DEEP - ahead.min(1), 0.0), 0.0)
    return lack


def propose_queues(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the tills of one row nearer to the way out and the objects before them farther
    off."""
    owner = np.repeat(np.arange(len(problem.units.spans)), count_objects(problem))
    for lanes in find_lanes(problem, kept, boxes):
        lack = _measure_lack(problem, boxes, lanes)
        for back in (step for step in STEPS if not step or lanes.behind - step >= TILL_BEHIND):
            near = sorted({int(unit) for unit in owner[lack > back]})
            moved = shift(kept, [lanes.unit], -back * lanes.ahead)
            whole = max(float(lack.max()) - back, 0.0)
            for far in sorted({0.0, whole, *(step for step in STEPS if step < whole)}):
                yield shift(moved, near, far * lanes.ahead)
