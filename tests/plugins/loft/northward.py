"""A term with data of its own: how far from the north everything stands, 0 to 1."""

from __future__ import annotations

from typing import Any

import numpy as np

from scenewright.engine.rows import TermRow
from scenewright.geometry.boxes import Floats, Frame
from scenewright.geometry.compiled import inlined


@inlined
def layout_cost(frames: Floats, i: int, frame: Frame, data: Floats) -> float:
    """The mean over all items (n, 8), item ``i`` taken to ``frame``."""
    total = 0.0
    for j in range(frames.shape[0]):
        y = frame[1] if j == i else frames[j, 1]
        total += (data[1] - y) / (data[1] - data[0])
    return total / max(frames.shape[0], 1)


@inlined
def building_cost(frames: Floats, i: int, frame: Frame, data: Floats) -> float:
    """Of one building at ``frame``."""
    return (data[1] - frame[1]) / (data[1] - data[0])


def bounds(problem: Any) -> Floats:
    """Least and greatest y of the ground (2,), metres."""
    return np.ravel(problem.ground.bounds)[[1, 3]]


DOC, DATA = "share of the depth that things stand off the north", f"{__name__}:bounds"
HOME = TermRow(
    "northward", -1, "layout", 500, DOC, "loft", function=f"{__name__}:layout_cost", data=DATA
)
HALL = HOME._replace(kind="hall")
SITE = HOME._replace(kind="building", function=f"{__name__}:building_cost")
