"""Rows of seats before a screen: the first not under it.

From nearer than six tenths of its width nobody sees all of a screen at ease: the rows move away
from it, closer together where the room asks for that.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import ACROSS, CHAIN, GRID
from scenewright.domains.hall.patterns.fan import ROW
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.terms.state import Kept

NEAREST, MOST = 0.6, 3.0
"""Widths of a screen the first row keeps from it, and metres beyond which more count no more."""
GAPS, SHIFTS = (1.1, 0.9, 0.75, ROW + 0.01), (0.0, 0.3, 0.8, 1.5)
"""Gaps of rows, and metres farther away, that are tried."""


def find_rows(problem: HallProblem, kept: Kept) -> list[tuple[int, int]]:
    """Units in rows and the object that each looks at, where that is as high as the eyes."""
    targets, spans = problem.units.targets, problem.units.spans
    return [
        (unit, int(spans[target, 0]))
        for unit, target in enumerate(targets)
        if target >= 0
        and problem.visitors.tall[int(spans[target, 0])]
        and int(kept.rows[unit, 0]) in (CHAIN, GRID)
    ]


def sit_too_near(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """Metres by which first rows of boxes (n, 5) are too near to their screens."""
    total = 0.0
    for unit, target in find_rows(problem, kept):
        ahead = _ahead(kept, unit)
        mine = boxes[slice(*problem.units.spans[unit])]
        gap = float(((boxes[target, :2] - mine[:, :2]) @ ahead - 0.5 * mine[:, 4]).min())
        total += min(max(NEAREST * float(boxes[target, 3]) - gap, 0.0), MOST)
    return total


def propose_rows(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the rows of one unit behind one another from the least distance on."""
    for unit, target in find_rows(problem, kept):
        row, used = find_layers(problem, unit)[0], int(kept.rows[unit, 1])
        ahead, screen = _ahead(kept, unit), boxes[target]
        deep = float(problem.units.sizes[slice(*problem.units.spans[unit]), 1].max())
        for gap in (float(kept.layers[row, ACROSS]), *GAPS):
            layers, whole = kept.layers.copy(), used * deep + (used - 1) * gap
            layers[row : row + used, ACROSS] = gap
            for more in SHIFTS:
                far = NEAREST * float(screen[3]) + 0.5 * whole + more
                pose = kept.pose.copy()
                pose[unit, :2] = screen[:2] - far * ahead
                yield kept._replace(pose=pose, layers=layers)


def _ahead(kept: Kept, unit: int) -> Floats:
    """The way a unit looks."""
    heading = kept.pose[unit, 2]
    return np.array([np.cos(heading), np.sin(heading)])
