"""Bays of a car park: a drive in the middle, a row of bays on each side of it."""

from __future__ import annotations

import numpy as np

from scenewright.core.space import Points
from scenewright.ground.works import PavedArea

BAY_WIDTH, BAY_DEPTH, DRIVE = 2.5, 5.0, 6.0
"""Size of a bay, and width of the drive between two rows of them, in metres."""


def list_bay_lines(area: PavedArea) -> Points:
    """Both ends (n, 2, 2) of the lines between the bays of a car park whose first edge lies on the
    street; none where its outline is no rectangle of its bays.

    >>> lot = PavedArea("parking", ((0, 0), (16, 0), (16, 5), (0, 5)), 4)
    >>> list_bay_lines(lot)[1].tolist()
    [[0.0, 2.5], [5.0, 2.5]]
    """
    ring = np.array(area.outline, float)
    if area.kind != "parking" or len(ring) != 4:
        return np.zeros((0, 2, 2))
    along, into = ring[1] - ring[0], ring[3] - ring[0]
    wide, deep = float(np.hypot(*along)), float(np.hypot(*into))
    rows = int(deep / BAY_WIDTH + 0.1)
    if rows < 1 or wide < 2.0 * BAY_DEPTH:
        return np.zeros((0, 2, 2))
    along, into = along / wide, into / deep
    at = ring[0] + BAY_WIDTH * np.arange(rows + 1)[:, None] * into
    left = np.stack([at, at + BAY_DEPTH * along], 1)
    right = left + (wide - BAY_DEPTH) * along
    return np.concatenate([left[: rows + 1], right[: rows + 1]])
