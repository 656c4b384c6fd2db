"""Tidy a dressed layout: square to the walls, close gaps, fill rows from wall to wall."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.classes import UNITS
from scenewright.domains.home.problem import Ground
from scenewright.geometry.fit import settle
from scenewright.geometry.wall_alignment import align_to_wall

Floats = NDArray[np.float64]

CLOSE = 0.3  # gaps up to this many metres beside a patch are closed


def tidy_groups(
    groups: tuple[str, ...], boxes: Floats, new: NDArray[np.bool_], ground: Ground
) -> Floats:
    """Boxes ``(n, 5)`` of groups put square and pushed together, where they still stand free.

    Only those that are ``new`` move; those without a wish to nestle stay where they are.
    """
    zones = np.concatenate([ground.keep_free, ground.obstacles, ground.fronts])
    backs = np.array([GROUPS[g].back > 0 for g in groups])
    square = align_to_wall(boxes, new, backs, ground.walls, ground.edges, zones)
    nestle = np.array([GROUPS[g].nestle > 0 for g in groups]) & new
    grow = np.array([g in UNITS for g in groups])
    return settle(square, nestle, grow, ground.edges, zones, CLOSE)
