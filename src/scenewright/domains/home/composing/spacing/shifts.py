"""A free-standing table or sofa shifted a little."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.composing.judging import JudgedRoom, Placed, RoomJudge
from scenewright.domains.home.composing.places.moving import AMID, FREE, stand_at
from scenewright.domains.home.composing.places.walked_places import WalkedPlace, furnish_places
from scenewright.domains.home.composing.spacing.askew import square_up
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.geometry.fit import is_backed

Floats = NDArray[np.float64]

SHIFTED = FREE | {"seating"}
"""What is shifted; a sofa is not turned."""
SHIFT_REACH, SHIFT_STEP = 1.0, 0.1
"""How far it is shifted along and across, and between two places, metres."""
FARTHER, WIDER = 2.6, 0.2
"""The same of what may be turned as well, beyond that."""
QUARTER: Floats = np.array([0.0, 0.0, np.pi / 2, 0.0, 0.0])
TRIED = 60  # places that are furnished, those first that cost least


def list_shifted(
    judge: RoomJudge, placed: Placed, at: int, most: float, backed: bool = False
) -> Iterator[JudgedRoom]:
    """The rooms with a free-standing group, or also one ``backed`` by a wall, shifted
    along and across, squared up to a wall, turned by a quarter or not, where it stands free and the
    room costs at most ``most``, the cheapest by energy first."""
    task, group = judge.task, placed[at]
    box = group.dressed.box.copy()
    if group.wish.group not in SHIFTED or (not backed and is_backed(box, task.ground.walls, AMID)):
        return
    box[2] = square_up(float(box[2]), task.ground)
    pieces = (p for k, g in enumerate(placed) for p in g.pieces if k != at)
    standing = standing_of((*task.fixed, *task.beside, *pieces), flat_kinds(task.catalog))
    boxes = stand_at(task, group.dressed.case, _shift(box, group.wish.group in FREE), standing)
    if not len(boxes):
        return
    layouts = np.repeat(np.array([[p.dressed.box for p in placed]]), len(boxes), axis=0)
    layouts[:, at] = boxes
    energies = judge.energies_of(layouts)
    order = np.argsort(energies, kind="stable")[:TRIED].tolist()
    places = (WalkedPlace(float(energies[k]), group.dressed.case, boxes[k]) for k in order)
    yield from furnish_places(judge, placed, at, places, most)


def _shift(box: Floats, turned: bool) -> Floats:
    """Boxes (n, 5) of one box (5,) shifted along its sides, itself not among them, then the same
    ``turned`` by a quarter."""
    farther = _list_steps(FARTHER, WIDER)
    farther = farther[(np.abs(farther).max(axis=1) > SHIFT_REACH + SHIFT_STEP / 2) & turned]
    along, across = np.concatenate([_list_steps(SHIFT_REACH, SHIFT_STEP), farther]).T
    moved = np.hypot(along, across) > SHIFT_STEP / 2
    boxes = np.repeat(box[None], int(moved.sum()), axis=0)
    c, s = np.cos(box[2]), np.sin(box[2])
    boxes[:, 0] += along[moved] * c - across[moved] * s
    boxes[:, 1] += along[moved] * s + across[moved] * c
    return np.concatenate([boxes, boxes + QUARTER]) if turned else boxes


def _list_steps(far: float, step: float) -> Floats:
    """Steps (n, 2) along and across, so ``far`` and as wide apart as a ``step``."""
    steps = np.arange(-far, far + step / 2, step)
    return np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
