"""Lecterns stand beside the screen their audience looks at: the speaker does not hide it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from scenewright.domains.hall.patterns import SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.places import before, stand_at
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import SPEAKER

BESIDE_SCREEN, AHEAD_OF_SCREEN = (0.6, 0.9, 1.3), (0.7, 1.1, 1.6)
"""Metres beside a screen and before it that are tried; the first is the best."""
OFF_PLACE, FARTHEST_OFF, LOOKS_AWAY = 0.6, 4.0, 1.0
"""Metres off its place that are near enough, beyond which more count no more, and what a lectern
counts that looks away from the audience."""


def find_lecterns(problem: HallProblem, kept: Kept) -> list[tuple[int, int]]:
    """Units of one lectern, and the object in their zone that an audience looks at."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    shown = [int(t) for t in np.unique(units.targets) if t >= 0 and not roles[t] & SPEAKER]
    return [
        (unit, int(units.spans[target, 0]))
        for unit in np.flatnonzero(roles & SPEAKER).tolist()
        for target in shown
        if units.zones[target] == units.zones[unit] and int(kept.rows[unit, 0]) == SINGLE
    ]


def lecterns_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """Metres by which lecterns of boxes (n, 5) are off their place at either side of a screen."""
    total = 0.0
    for unit, target in find_lecterns(problem, kept):
        box, screen = boxes[int(problem.units.spans[unit, 0])], boxes[target]
        spots = [
            _place(box, screen, side, BESIDE_SCREEN[0], AHEAD_OF_SCREEN[0]) for side in (-1.0, 1.0)
        ]
        far = min(float(np.hypot(*(box[:2] - spot[:2]))) for spot in spots)
        turned = 0.5 * LOOKS_AWAY * (1.0 - float(np.cos(box[2] - screen[2])))
        total += min(max(far - OFF_PLACE, 0.0), FARTHEST_OFF) + turned
    return total


def propose_lecterns(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one lectern at the side of the screen of its zone, looking as that does."""
    for unit, target in find_lecterns(problem, kept):
        box = boxes[int(problem.units.spans[unit, 0])]
        places = product((-1.0, 1.0), BESIDE_SCREEN, AHEAD_OF_SCREEN)
        yield from stand_at(kept, unit, (_place(box, boxes[target], *place) for place in places))


def _place(box: Floats, screen: Floats, side: float, beside: float, ahead: float) -> Floats:
    """The pose (3,) of a lectern at one ``side`` (-1 or 1) of a screen, ``beside`` and ``ahead``
    metres from it."""
    off = side * (0.5 * (screen[3] + box[3]) + beside)
    return before(screen, [0.5 * (screen[4] + box[4]) + ahead], [off])[0]
