"""Stages without an audience, such as a band's: they too back onto the middle of a wall."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.banquets import find_banquets
from scenewright.domains.hall.retouch.lines import count_objects
from scenewright.domains.hall.retouch.stages import measure_stage, propose_stages
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import STAGE


def find_bands(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of single stages at which nobody looks, from seats or from the tables of a
    banquet."""
    seen = {*problem.units.targets.tolist(), *(b.stage for b in find_banquets(problem, kept))}
    stages = (problem.visitors.roles.astype(int) & STAGE > 0) & (count_objects(problem) == 1)
    return [int(unit) for unit in np.flatnonzero(stages) if int(unit) not in seen]


def measure_bands(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """How far those stages among boxes (n, 5) are from the middle of a wall, in metres."""
    return sum(measure_stage(problem, boxes, unit) for unit in find_bands(problem, kept))


def propose_bands(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one of them at another wall of its zone."""
    for unit in find_bands(problem, kept):
        yield from (moved for moved, _ in propose_stages(problem, kept, boxes, unit))
