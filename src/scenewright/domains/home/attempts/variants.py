"""Variants of a room: arranged around another wall, or with other groups for the same use."""

from __future__ import annotations

import numpy as np

from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.grounds.ground import MAIN_WALL, main_wall
from scenewright.domains.home.programme import Wish

INSTEAD = {"bath": "shower", "dining": "dining_wall", "vanity": "desk", "bunk": "single"}
"""Groups that a variant takes for others of the same use."""
FIRMLY = 8.0  # how many times more a variant's main wall weighs


def vary_task(task: RoomTask, variant: int) -> RoomTask:
    """The task arranged around the ``variant``-th of its long walls, from 1; 0: as it is."""
    walls = long_walls(task) if variant and task.preset.settings.exact else ()
    if not len(walls):
        return task
    chosen = walls[(variant - 1) % len(walls)]
    weights = task.preset.weights | {
        "main_wall": FIRMLY * task.preset.weights.get("main_wall", 0.0)
    }
    return task._replace(
        ground=task.ground._replace(main_wall=chosen[None].copy()),
        preset=task.preset._replace(weights=weights),
    )


def long_walls(task: RoomTask) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Walls ``(w, 4)`` that a room may be arranged around: straight for at least 1.5 m; those that
    look another way than the usual one first, the longer the earlier."""
    walls = task.ground.walls
    along = walls[:, 2:] - walls[:, :2]
    length = np.hypot(along[:, 0], along[:, 1])
    usual = main_wall(task.space, task.fixed)
    alike = np.zeros(len(walls))
    if usual is not None:
        way = np.array(usual[2:]) - np.array(usual[:2])
        alike = np.round((along @ way) / np.maximum(length * np.hypot(*way), 1e-9), 3)
    order = np.lexsort((-length, np.abs(alike - 1.0) < 0.3))
    return walls[order[length[order] >= MAIN_WALL]]


def other_groups(wishes: tuple[Wish, ...], variant: int) -> tuple[Wish, ...]:
    """Every second variant takes other groups for the same use, but what the user asked for."""
    if variant % 2 == 0:
        return wishes
    have = {wish.group for wish in wishes}
    return tuple(
        wish._replace(group=INSTEAD[wish.group])
        if not wish.required and wish.group in INSTEAD and INSTEAD[wish.group] not in have
        else wish
        for wish in wishes
    )
