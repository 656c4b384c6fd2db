"""Runs: rows too long to walk round get aisles through them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import ALONG, CHAIN, NUMBER
from scenewright.domains.hall.patterns.chain import BLOCK
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.terms.state import Kept

LONGEST_ROW, MOST_TOO_LONG = 12.0, 3.0
"""Metres from which on a row is too long, and how many more count at most."""
AISLES_THROUGH = (1.8, 1.5, 1.2)
"""How wide aisles through rows are made, in metres, the best first."""


def measure_runs(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """Metres by which rows without an aisle are too long."""
    return sum(
        min(_measure_row(problem, kept, boxes, unit) - LONGEST_ROW, MOST_TOO_LONG)
        for unit in _find_long(problem, kept, boxes)
    )


def _find_long(problem: HallProblem, kept: Kept, boxes: Floats) -> list[int]:
    """The units in rows that are too long, look at nothing and have enough objects for aisles
    between them (:mod:`..patterns.chain`)."""
    return [
        unit
        for unit in range(len(problem.names))
        if int(kept.rows[unit, 0]) == CHAIN
        and problem.units.targets[unit] < 0
        and kept.pose[unit, 3] <= 0.0
        and _most_of_row(problem, kept, unit) > BLOCK
        and _measure_row(problem, kept, boxes, unit) > LONGEST_ROW
    ]


def _most_of_row(problem: HallProblem, kept: Kept, unit: int) -> int:
    first = find_layers(problem, unit)[0]
    return int(kept.layers[first : first + int(kept.rows[unit, 1]), NUMBER].max())


def _measure_row(problem: HallProblem, kept: Kept, boxes: Floats, unit: int) -> float:
    """How long the rows of a unit are, in metres."""
    heading = float(kept.pose[unit, 2])
    mine = boxes[slice(*problem.units.spans[unit])]
    along = mine[:, :2] @ (np.sin(heading), -np.cos(heading))
    return float(np.ptp(along) + mine[:, 3].max())


def propose_runs(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with aisles through the rows of one unit, their neighbours closer together
    where it has gaps."""
    for unit in _find_long(problem, kept, boxes):
        first, number = find_layers(problem, unit)[0], _most_of_row(problem, kept, unit)
        mine = slice(first, first + int(kept.rows[unit, 1]))
        for aisle in AISLES_THROUGH:
            pose = kept.pose.copy()
            pose[unit, 3] = aisle
            wider = kept._replace(pose=pose)
            yield wider
            layers = kept.layers.copy()
            less = aisle * (-(-number // BLOCK) - 1) / (number - 1)
            layers[mine, ALONG] = np.maximum(layers[mine, ALONG] - less, 0.0)
            yield wider._replace(layers=layers)
