"""The steps at which a source repeats itself: whole patches shifted by them go on with it."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

Floats = NDArray[np.float64]

SAME, TURN, SIZE = 2.5, float(np.deg2rad(6.0)), 0.12
"""Metres, radians and log of a side by which two buildings that repeat may differ."""
LEAST, SHARE = 3, 0.5
"""Buildings that must repeat at a step, and their share of those that still lie on the ground of
the source when shifted."""
MOST, TRIED = 6, 2000
"""Steps that are found, and that are looked at, at most."""
MANY = 400
"""Most buildings, from the middle of a source, that its repeats are learned from."""
SHORTEST = 2 * SAME
"""Shorter steps, in metres, are as good as none."""
FARTHEST = 40
"""Steps in one direction."""


def repeat_steps(boxes: Floats) -> Floats:
    """The steps (m, 2) in metres at which boxes (n, 5) repeat, the shortest first: shifted by one,
    at least half of those that stay within the whole's bounds meet one of their size and turn.

    >>> grid = np.stack(np.meshgrid(np.arange(4) * 20.0, np.arange(3) * 30.0), -1).reshape(-1, 2)
    >>> rows = np.concatenate([grid, np.tile([0.0, 9.0, 6.0], (12, 1))], 1)
    >>> repeat_steps(rows)[:2].tolist()
    [[20.0, 0.0], [0.0, 30.0]]
    """
    away = np.hypot(*(boxes[:, :2] - np.median(boxes[:, :2], axis=0)).T)
    boxes = boxes[np.sort(np.argsort(away, kind="stable")[:MANY])]
    like = _find_alike(boxes)
    i, j = np.nonzero(like)
    steps = boxes[j, :2] - boxes[i, :2]
    there = shapely.STRtree(shapely.points(boxes[:, :2]))
    found: list[Floats] = []
    for step in _list_common(boxes, steps):
        if len(found) == MOST:
            break
        if any(np.hypot(*(step - one)) < SAME or _is_multiple(step, one) for one in found):
            continue
        a, b = there.query(shapely.points(boxes[:, :2] + step), predicate="dwithin", distance=SAME)
        pairs = like[a, b]
        met = np.zeros(len(boxes), bool)
        met[a[pairs]] = True
        inside = _stay_inside(boxes, step[None])[0]
        if (met & inside).sum() >= max(LEAST, SHARE * inside.sum()):
            found.append(_mean_step(boxes, met & inside, step, like))
    return np.array(found).reshape(-1, 2)


def _find_alike(boxes: Floats) -> NDArray[np.bool_]:
    """Which pairs (n, n) of different boxes (n, 5) have the same size and turn."""
    turn = np.angle(np.exp(1j * (boxes[:, None, 2] - boxes[None, :, 2])))
    sides = np.abs(np.log(boxes[:, None, 3:]) - np.log(boxes[None, :, 3:])).max(-1)
    return np.asarray((np.abs(turn) < TURN) & (sides < SIZE) & ~np.eye(len(boxes), dtype=bool))


def _list_common(boxes: Floats, steps: Floats) -> Floats:
    """Of the steps (m, 2) between pairs those, ahead and shortest first, near which lie as many
    others as must meet: counted in three by three cells, so never too few."""
    cells = np.floor(steps / SAME).astype(np.int64)
    known, where, counts = np.unique(cells, axis=0, return_inverse=True, return_counts=True)
    held = {(int(x), int(y)): int(n) for (x, y), n in zip(known, counts, strict=True)}
    around = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    votes = np.array([sum(held.get((x + a, y + b), 0) for a, b in around) for x, y in held])
    ahead = (steps[:, 0] > SAME) | ((np.abs(steps[:, 0]) <= SAME) & (steps[:, 1] > 0))
    length = np.hypot(*steps.T)
    chosen = np.flatnonzero(ahead & (length >= SHORTEST))
    chosen = chosen[votes[where.reshape(-1)[chosen]] >= LEAST]
    chosen = chosen[np.argsort(length[chosen], kind="stable")][: 10 * TRIED]
    enough = [
        k
        for part in np.array_split(chosen, max(len(chosen) // TRIED, 1))
        for k, held_in in zip(part, _stay_inside(boxes, steps[part]).sum(1), strict=True)
        if votes[where.reshape(-1)[k]] >= SHARE * held_in
    ]
    return np.asarray(steps[enough[:TRIED]]).reshape(-1, 2)


def _stay_inside(boxes: Floats, steps: Floats) -> NDArray[np.bool_]:
    """Which boxes (n, 5) stay within the bounds of all when moved by each of steps (m, 2)."""
    low, high = boxes[:, :2].min(0) - SAME, boxes[:, :2].max(0) + SAME
    moved = boxes[None, :, :2] + steps[:, None]
    return np.asarray(((moved > low) & (moved < high)).all(2))


def _is_multiple(step: Floats, unit: Floats) -> bool:
    times = round(float(step @ unit / (unit @ unit)))
    return abs(times) > 1 and float(np.hypot(*(step - times * unit))) < SAME * abs(times)


def _mean_step(
    boxes: Floats, met: NDArray[np.bool_], step: Floats, like: NDArray[np.bool_]
) -> Floats:
    """The mean of the steps that a common one stands for."""
    rows = np.flatnonzero(met)
    away = boxes[None, :, :2] - boxes[rows, None, :2]
    off = np.where(like[rows], np.hypot(*(away - step).transpose(2, 0, 1)), np.inf)
    return np.asarray(np.median(away[np.arange(len(rows)), off.argmin(1)], axis=0))


def lattice_shifts(
    boxes: Floats, steps: Floats, bounds: tuple[float, float, float, float]
) -> Floats:
    """The shifts (m, 2) by whole numbers of two of the ``steps`` (k, 2) at which boxes (n, 5)
    repeat, by which their middle comes within ``bounds`` grown by half their extent."""
    if not len(steps):
        return np.zeros((0, 2))
    cross = np.abs(steps[:, 0] * steps[0, 1] - steps[:, 1] * steps[0, 0])
    askew = np.flatnonzero(cross > 0.3 * np.hypot(*steps[0]) * np.hypot(*steps.T))
    count = np.arange(-FARTHEST, FARTHEST + 1)
    second = steps[askew[0]] if len(askew) else np.zeros(2)
    others = count if len(askew) else np.zeros(1)
    shifts = (count[:, None, None] * steps[0] + others[None, :, None] * second).reshape(-1, 2)
    half = np.ptp(boxes[:, :2], axis=0) / 2
    middle = boxes[:, :2].min(0) + half + shifts
    low, high = np.array(bounds[:2]) - half, np.array(bounds[2:]) + half
    return np.asarray(shifts[((middle > low) & (middle < high)).all(1)])
