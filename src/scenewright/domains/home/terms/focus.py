"""What one sees on coming in, and what lies even about the axis of the room's main piece."""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.home.problem import Problem
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined

HIDING = 0.3  # metres of tall furniture on a line of sight that hide what is behind it
TALL = 1.3  # least height that blocks the view of people entering, metres
REACH = 1.0  # farther than this from where it mirrors another a piece is no counterpart, metres


@inlined
def focal_sight(frames: Floats, i: int, frame: Frame, room: Floats) -> float:
    """mean_d min_f min(1, L(d, f) / 0.3): whether from each door d some focal point f is seen.

    L(d, f) is the length, in metres, of the line from the middle of the door to f that runs
    through items taller than 1.3 m, f itself left out. Focal points are the windows, the
    fireplaces that stand, the item that faces the main wall and the one before it (sofa, screen,
    bed). In [0, 1]; 0 where every door
    looks at something, or where there is no door or nothing to look at. Item ``i`` is taken to
    stand at ``frame``; -1: all stand where ``frames`` (n, 8) say. ``room`` as :func:`find_sights`
    gives it.

    After the focal point of Merrell et al. (2011, emphasis) and of Ching, Binggeli (2012, Interior
    Design Illustrated, dominance), which neither states as a formula of sight.
    """
    if room.shape[0] == 0:
        return 0.0
    n, doors, spots = frames.shape[0], int(room[0]), int(room[1])
    points = 2 + 2 * n
    total = 0.0
    for d in range(doors):
        x, y = room[points + 2 * d], room[points + 2 * d + 1]
        least = 1.0
        for f in range(spots + n):
            if f < spots:
                at = points + 2 * (doors + f)
                fx, fy = room[at], room[at + 1]
            elif room[2 + n + f - spots] == 0.0:
                continue
            else:
                goal = frame if f - spots == i else read_frame(frames, f - spots)
                fx, fy = goal[0], goal[1]
            hidden = 0.0
            for j in range(n):
                if room[2 + j] > TALL and j != f - spots:
                    item = frame if j == i else read_frame(frames, j)
                    hidden += chord(item, x, y, fx, fy)
            least = min(least, hidden / HIDING)
        total += least
    return total / doors


@inlined
def chord(item: Frame, x0: float, y0: float, x1: float, y1: float) -> float:
    """Metres of the line from (x0, y0) to (x1, y1) that lie within an item."""
    c, s = item[2], item[3]
    a, b = (x0 - item[0]) * c + (y0 - item[1]) * s, (y0 - item[1]) * c - (x0 - item[0]) * s
    du, dv = (x1 - x0) * c + (y1 - y0) * s, (y1 - y0) * c - (x1 - x0) * s
    first, last = 0.0, 1.0
    for start, step, half in ((a, du, item[5]), (b, dv, item[4])):
        if abs(step) < 1e-12:
            if abs(start) > half:
                return 0.0
            continue
        near, far = (-half - start) / step, (half - start) / step
        first, last = max(first, min(near, far)), min(last, max(near, far))
    return max(last - first, 0.0) * math.sqrt(du * du + dv * dv)


def find_sights(problem: Problem) -> Floats:
    """What :func:`focal_sight` knows of a room: how many doors there are, and how many windows and
    fireplaces, the heights (n,) of the items and 1 for each that is a focal point (n,), then the
    middles (k, 2) of doors, windows and fireplaces; empty where the term weighs nothing or there
    is no door."""
    ground, items = problem.ground, problem.items
    if not problem.weights.get("focal_sight") or not len(ground.doors):
        return np.zeros(0)
    doors = ground.doors[:, :2]
    spots = np.concatenate([ground.windows[:, :2], ground.hearths[:, :2]])
    roles = (items.main_wall != 0.0).astype(np.float64)
    if not len(spots) and not roles.any():
        return np.zeros(0)
    counts = np.array([len(doors), len(spots)], np.float64)
    return np.concatenate([counts, items.height, roles, doors.ravel(), spots.ravel()])


@inlined
def axis_symmetry(frames: Floats, i: int, frame: Frame, axis: Floats) -> float:
    """Σ_j A_j min(1, min_k (|m(c_j) - c_k| + |w_j - w_k| + |d_j - d_k|)) / Σ_j A_j over all items j
    but the one whose axis it is.

    c, w, d and A are the middles, widths, depths and areas of items, m mirrors a point over the
    axis through the middle of a fireplace that stands, else of the screen or bed, along its
    heading; lengths in metres, the
    distance of a piece without a counterpart counts as 1 m. A piece on the axis is its own
    counterpart. In [0, 1]; 0 where every piece has one or there is none but the axis. Item ``i``
    is taken to stand at ``frame``; -1: all stand where ``frames`` (n, 8) say. ``axis`` (5,), (1,)
    or (0,) as :func:`find_axis` gives it.

    Merrell et al. (2011, symmetry) take the counterpart nearest to the mirror image in the same
    way but leave distances uncapped and the weights unprinted.
    """
    if axis.shape[0] == 0:
        return 0.0
    a, total, mass = int(axis[0]), 0.0, 0.0
    if a < 0:
        x0, y0, c, s = axis[1], axis[2], axis[3], axis[4]
    else:
        line = frame if a == i else read_frame(frames, a)
        x0, y0, c, s = line[0], line[1], line[2], line[3]
    for j in range(frames.shape[0]):
        if j == a:
            continue
        item = frame if j == i else read_frame(frames, j)
        aside = (item[1] - y0) * c - (item[0] - x0) * s
        x, y = item[0] + 2.0 * aside * s, item[1] - 2.0 * aside * c
        least = REACH
        for k in range(frames.shape[0]):
            if k == a:
                continue
            other = frame if k == i else read_frame(frames, k)
            dx, dy = other[0] - x, other[1] - y
            unlike = 2.0 * (abs(other[4] - item[4]) + abs(other[5] - item[5]))
            least = min(least, math.sqrt(dx * dx + dy * dy) + unlike)
        area = 4.0 * item[4] * item[5]
        total, mass = total + area * least / REACH, mass + area
    return total / mass if mass > 0.0 else 0.0


def find_axis(problem: Problem) -> Floats:
    """Whose axis counts: -1, then x, y, cos and sin of the fireplace that stands, (5,); else the
    number (1,) of the item that backs the main wall, a screen or a bed; empty where there is none
    or the term weighs nothing."""
    roles, hearths = problem.items.main_wall, problem.ground.hearths
    if not problem.weights.get("axis_symmetry"):
        return np.zeros(0)
    if len(hearths):
        return np.concatenate([[-1.0], hearths[0]])
    return np.array([float(np.argmax(roles < 0.0))]) if (roles < 0.0).any() else np.zeros(0)
