"""Two groups side by side at one wall in each other's place: a screen where the wardrobe was."""

from __future__ import annotations

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.places.moving import dress_group, stand_at
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of

Floats = NDArray[np.float64]

ONE_WALL = 0.15
"""How far the backs of two groups at one wall are from one line, in metres, and how far, in
radians, they are turned."""


def swap_along_wall(task: RoomTask, placed: Placed, one: int, other: int) -> Placed | None:
    """The groups with two of them in each other's place along their wall, between the same ends;
    None where they stand at no common wall, or do not stand free so."""
    boxes = exchange(placed[one].dressed.box, placed[other].dressed.box)
    if boxes is None:
        return None
    found = list(placed)
    rest = [p for k, p in enumerate(placed) if k not in (one, other)]
    for at, box in zip((one, other), boxes, strict=True):
        moved = _stand(task, placed[at], box, rest)
        if moved is None:
            return None
        found[at] = moved
        rest.append(moved)
    return tuple(found)


def _stand(
    task: RoomTask, group: FurnishedGroup, box: Floats, beside: list[FurnishedGroup]
) -> FurnishedGroup | None:
    """A group on a box (5,) beside others, where it stands free."""
    there = (*task.fixed, *task.beside, *(piece for p in beside for piece in p.pieces))
    standing, case = standing_of(there, flat_kinds(task.catalog)), group.dressed.case
    free = stand_at(task, case, box[None], standing)
    return dress_group(task, group, case, box, standing) if len(free) else None


def exchange(one: Floats, other: Floats) -> tuple[Floats, Floats] | None:
    """Two boxes (5,) at one wall in each other's place, between the same ends; None at two walls.

    >>> a, b = np.array([1.0, 0.3, np.pi / 2, 2.0, 0.6]), np.array([3.0, 0.2, np.pi / 2, 1.0, 0.4])
    >>> [float(box[0].round(3)) for box in exchange(a, b)]
    [2.5, 0.5]
    """
    turn = float(one[2])
    ahead, along = np.array([cos(turn), sin(turn)]), np.array([-sin(turn), cos(turn)])
    backs = [float(box[:2] @ ahead) - 0.5 * box[4] for box in (one, other)]
    turned = abs(np.remainder(other[2] - turn + np.pi, 2.0 * np.pi) - np.pi)
    if max(abs(backs[0] - backs[1]), turned) > ONE_WALL:
        return None
    at = [float(box[:2] @ along) for box in (one, other)]
    wide = [0.5 * float(box[3]) for box in (one, other)]
    low = min(a - w for a, w in zip(at, wide, strict=True))
    high = max(a + w for a, w in zip(at, wide, strict=True))
    new = (high - wide[0], low + wide[1]) if at[0] < at[1] else (low + wide[0], high - wide[1])
    moved = (one.copy(), other.copy())
    for box, old, place in zip(moved, at, new, strict=True):
        box[:2] += (place - old) * along
    return moved
