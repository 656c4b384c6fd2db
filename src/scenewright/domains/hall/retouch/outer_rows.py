"""Outer rows: what is looked at from both faces has an aisle before the wall as well.

Rows as far apart as their aisles ask for may leave a slot between the outermost and a wall that
nobody enters. The same objects in fewer or more rows take all of their zone, their aisles and those
at its walls alike.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import ALONG, CHAIN
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.retouch.places import fill_floor
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, GUIDE, MAIN, SPEAKER, TILL

AISLE, LEAST, WORTH = 1.0, 2, 3.0
"""How wide an aisle before a wall is at least, in metres, how many rows have one, and what each
metre that it lacks counts."""
FRONT, BACK = 0, 2
"""The columns of ``clear`` that say how much free floor is before and behind an object."""
ASIDE = (0.0, 0.5, -0.5, 1.0, -1.0)
"""Metres along the rows beside where they are that are tried."""
STRAIGHT = 0.02  # by how much rows may be turned to the axes of their zone, radians
SOLE = 1.0  # a gap between neighbours of a row up to which they stand as one, metres


def measure_slots(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """Metres that aisles between outer rows and walls lack, each :data:`WORTH` times."""
    faults = (_measure_slots(problem, kept, boxes, unit) for unit in _find_rows(problem, kept))
    return float(sum(faults))


def _find_rows(problem: HallProblem, kept: Kept) -> list[int]:
    """The units in straight rows whose objects are looked at from before and behind, and that
    neither serve nor guide nor look at anything."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    firsts = units.spans[:, 0]
    both = (units.clear[firsts][:, (FRONT, BACK)] > 0.0).all(1) & (units.targets < 0)
    square = np.abs(np.sin(2.0 * kept.pose[:, 2])) < STRAIGHT
    rows = (kept.rows[:, 0] == CHAIN) & (kept.rows[:, 1] >= LEAST)
    shown = ~(roles & (FIRST | TILL | GUIDE | SPEAKER | MAIN)).astype(bool)
    return [
        int(unit)
        for unit in np.flatnonzero(both & square & rows & shown)
        if kept.layers[find_layers(problem, int(unit))[0], ALONG] < SOLE
    ]


def _measure_slots(problem: HallProblem, kept: Kept, boxes: Floats, unit: int) -> float:
    """The same of one unit: of each outer row by its middle, to the walls across."""
    ahead = _ahead(kept, unit)
    mine = boxes[slice(*problem.units.spans[unit])]
    across = mine[:, :2] @ ahead
    total = 0.0
    for side, edge in ((1.0, across.max()), (-1.0, across.min())):
        row = mine[np.abs(across - edge) < 0.5 * mine[:, 4].min()]
        face = row[:, :2].mean(0) + side * 0.5 * row[0, 4] * ahead
        free = _look(problem.ground.edges, face, side * ahead)
        total += WORTH * max(AISLE - free, 0.0)
    return total


def _ahead(kept: Kept, unit: int) -> Floats:
    heading = kept.pose[unit, 2]
    return np.array([np.cos(heading), np.sin(heading)])


def _look(walls: Floats, point: Floats, way: Floats) -> float:
    """Metres from a point along a way (2,) to the first of the walls (e, 4)."""
    start, end = walls[:, :2] - point, walls[:, 2:4] - point
    left = np.array([-way[1], way[0]])
    one, other = start @ left, end @ left
    crossed = one * other < 0.0
    share = one[crossed] / (one - other)[crossed]
    far = (start[crossed] + share[:, None] * (end - start)[crossed]) @ way
    return float(far[far > 0.0].min(initial=np.inf))


def propose_lines(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the objects of one unit in rows that lie evenly across their zone, an aisle at
    either end."""
    for unit in _find_rows(problem, kept):
        if _measure_slots(problem, kept, boxes, unit) > 0.0:
            yield from fill_floor(problem, kept, boxes, unit, ASIDE)
