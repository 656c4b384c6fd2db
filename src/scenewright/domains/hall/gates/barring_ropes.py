"""Ropes that bar the way to where people are served: a row of counters is one object to the search
and reached as one, but each of them has to be."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, measure_layout


def find_served_at(pieces: Collection[Piece]) -> Floats:
    """The boxes (k, 5) of the pieces at whose front people are served."""
    found = [box for piece in pieces if piece.category in SERVING for box in boxes_of(piece)]
    return np.array(found).reshape(-1, 5)


def count_missed_among(problem: HallProblem, layout: MeasuredLayout, served: Floats) -> float:
    """What the route misses of a layout and of the fronts of boxes (k, 5), less those it would miss
    in an empty hall."""
    ground = problem.ground
    fronts = np.tile([1.0, 0.0, 0.0, 0.0], (len(served), 1))
    among = ground._replace(
        standing=np.concatenate([ground.standing.reshape(-1, 5), served]),
        standing_access=np.concatenate([ground.standing_access.reshape(-1, 4), fronts]),
    )
    return measure_layout(problem._replace(ground=among), layout)[2]
