"""The steps at which a source repeats itself: whole patches shifted by them go on with it."""

from __future__ import annotations

import numpy as np

from scenewright.domains.extend.problem import Floats

SAME, TURN, SIZE = 2.5, float(np.deg2rad(6.0)), 0.12
"""Metres, radians and log of a side by which two buildings that repeat may differ."""
LEAST, SHARE = 3, 0.5
"""Buildings that must repeat at a step, and their share of those that still lie on the ground of
the source when shifted."""
MOST = 6
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
    low, high = boxes[:, :2].min(0) - SAME, boxes[:, :2].max(0) + SAME
    turn = np.angle(np.exp(1j * (boxes[:, None, 2] - boxes[None, :, 2])))
    sides = np.abs(np.log(boxes[:, None, 3:]) - np.log(boxes[None, :, 3:])).max(-1)
    like = (np.abs(turn) < TURN) & (sides < SIZE)
    i, j = np.nonzero(like & ~np.eye(len(boxes), dtype=bool))
    steps = boxes[j, :2] - boxes[i, :2]
    ahead = (steps[:, 0] > SAME) | ((np.abs(steps[:, 0]) <= SAME) & (steps[:, 1] > 0))
    steps = steps[ahead]
    steps = steps[np.argsort(np.hypot(*steps.T), kind="stable")]
    found: list[Floats] = []
    for step in steps:
        if len(found) == MOST:
            break
        if any(np.hypot(*(step - one)) < SAME or _is_multiple(step, one) for one in found):
            continue
        moved = boxes[:, :2] + step
        inside = ((moved > low) & (moved < high)).all(1)
        away = np.hypot(*(moved[:, None] - boxes[None, :, :2]).transpose(2, 0, 1))
        met = ((away < SAME) & like).any(1) & inside
        if met.sum() >= LEAST and met.sum() >= SHARE * inside.sum():
            found.append(_mean_step(boxes, met, step, like))
    return np.array(found).reshape(-1, 2)


def _is_multiple(step: Floats, unit: Floats) -> bool:
    times = round(float(step @ unit / (unit @ unit)))
    return abs(times) > 1 and float(np.hypot(*(step - times * unit))) < SAME * abs(times)


def _mean_step(boxes: Floats, met: Floats, step: Floats, like: Floats) -> Floats:
    """The mean of the steps that a common one stands for."""
    rows = np.flatnonzero(met)
    away = boxes[None, :, :2] - boxes[rows, None, :2]
    off = np.where(like[rows], np.hypot(*(away - step).transpose(2, 0, 1)), np.inf)
    return np.asarray(np.median(away[np.arange(len(rows)), off.argmin(1)], axis=0))


def lattice_shifts(boxes: Floats, bounds: tuple[float, float, float, float]) -> Floats:
    """The shifts (m, 2) by whole numbers of two of the steps at which boxes repeat, by which their
    middle comes within ``bounds`` grown by half their extent."""
    steps = repeat_steps(boxes)
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
