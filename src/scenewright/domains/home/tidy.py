"""Tidy a dressed layout: square to the walls, close gaps, fill rows from wall to wall."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.groups import GROUPS
from scenewright.geometry.fit import settle, stands
from scenewright.problem import Ground

Floats = NDArray[np.float64]

CLOSE = 0.3  # gaps up to this many metres beside a patch are closed
NEAR = 0.08  # a back within this many metres of a wall belongs to it
SKEW = np.radians(5)  # what is turned by less is meant to be square
ROWS = frozenset(("kitchen", "kitchenette", "counter"))  # groups that widen over a small gap


def tidied(
    groups: tuple[str, ...], boxes: Floats, new: NDArray[np.bool_], ground: Ground
) -> Floats:
    """Boxes ``(n, 5)`` of groups put square and pushed together, where they still stand free.

    Only those that are ``new`` move; those without a wish to nestle stay where they are.
    """
    zones = np.concatenate([ground.keep_free, ground.obstacles, ground.fronts])
    square = boxes.copy()
    for i in map(int, np.flatnonzero(new)):
        before = square[i].copy()
        square[i] = _squared(before, GROUPS[groups[i]].back > 0, ground.walls)
        if not stands(square, i, ground.edges, zones):
            square[i] = before
    nestle = np.array([GROUPS[g].nestle > 0 for g in groups]) & new
    grow = np.array([g in ROWS for g in groups])
    return settle(square, nestle, grow, ground.edges, zones, CLOSE)


def _squared(box: Floats, wants_wall: bool, walls: Floats) -> Floats:
    """A box turned square to the nearest wall if it is nearly so, its back flush if it is near."""
    along = walls[:, 2:] - walls[:, :2]
    length = np.maximum(np.linalg.norm(along, axis=1), 1e-9)
    along = along / length[:, None]
    inward = np.stack([-along[:, 1], along[:, 0]], 1)
    back = box[:2] - np.array([np.cos(box[2]), np.sin(box[2])]) * box[4] / 2
    part = ((back - walls[:, :2]) * along).sum(1)
    apart = ((back - walls[:, :2]) * inward).sum(1)
    off = np.hypot(apart, np.maximum(np.maximum(-part, part - length), 0))
    skew = (box[2] - np.arctan2(inward[:, 1], inward[:, 0])) / (np.pi / 2)
    skew = (skew - np.round(skew)) * (np.pi / 2)
    k = int(np.argmin(off + 10 * (np.abs(skew) > SKEW)))
    if abs(skew[k]) > SKEW:
        return box
    found = box.copy()
    found[2] -= skew[k]
    faces = np.cos(found[2]) * inward[k, 0] + np.sin(found[2]) * inward[k, 1] > 0.99
    if wants_wall and faces and off[k] < NEAR:
        foot = walls[k, :2] + along[k] * part[k]
        found[:2] = foot + inward[k] * box[4] / 2
    return found
