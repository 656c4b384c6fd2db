"""Which groups of a hall visitors meet in a certain part, and how such a group stands as one."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import CHAIN
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.terms.state import Kept


def find_met(
    problem: HallProblem, kept: Kept, role: int, most: int, codes: Collection[int] = (CHAIN,)
) -> list[int]:
    """The units with one of the bits of a ``role``, of ``most`` objects at most and in one of some
    patterns; none without an entrance one comes in by."""
    if not len(problem.visitors.inward) or not len(problem.visitors.entrances):
        return []
    return [
        unit
        for unit, (first, last) in enumerate(problem.units.spans)
        if int(problem.visitors.roles[unit]) & role
        and last - first <= most
        and int(kept.rows[unit, 0]) in codes
    ]


def box_round(boxes: Floats) -> Floats:
    """The box (5,) round some objects (n, 5), its front that of the first."""
    heading = float(boxes[0, 2])
    ahead = np.array([np.cos(heading), np.sin(heading)])
    axes = np.array([(ahead[1], -ahead[0]), ahead])
    seen = corners(boxes).reshape(-1, 2) @ axes.T
    low, high = seen.min(0), seen.max(0)
    return np.array([*(0.5 * (low + high) @ axes), heading, *(high - low)])
