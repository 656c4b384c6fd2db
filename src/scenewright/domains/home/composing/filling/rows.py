"""Shelves along one wall pushed together: no gap between two of them, nor to the corner."""

from __future__ import annotations

from math import cos, remainder, sin, tau

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.attempt import FurnishedGroup, RoomAnswer, RoomTask, bars_no_more
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.places.moving import dress_group, with_margin
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.geometry.fit import side_gaps

Floats = NDArray[np.float64]

SHELVES = frozenset(("shelf", "storage"))
SHELVES_TOUCH, ONE_ROW = 0.03, 1.0
"""Shelves nearer to each other touch, and those farther apart are not one row, metres."""
IN_LINE, TURNED = 0.1, 0.05  # what is farther before its wall, or turned, is in no row, m and rad
CORNER = 2.0  # weight of metres to a corner, to the next shelf 1
WORTH = 1.0  # what a room may cost more for a gap that is closed


def close_gaps(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer with each shelf that stands near to another of its wall, or to the corner, moved
    along the wall until it touches, where that bars no way; the least gap is closed first."""
    tried: set[str] = set()
    while not task.cancelled():
        gaps = _list_gaps(task, answer.placed, tried)
        if not gaps:
            return answer
        _, _, group, gap = min(gaps, key=lambda row: row[:2])
        tried.add(group.name)
        placed = _move(task, answer.placed, group, gap)
        if placed and bars_no_more(with_margin(task), placed, barred):
            answer = answer._replace(placed=placed)
    return answer


def _list_gaps(
    task: RoomTask, placed: Placed, tried: set[str]
) -> list[tuple[float, str, FurnishedGroup, float]]:
    """What closing the gap beside each shelf that touches nothing is put off by, the name, the
    shelf and how far to the right it is to move, metres; empty in rooms with one shelf."""
    rows = [p for p in placed if p.wish.group in SHELVES]
    found = []
    for group in rows if len(rows) > 1 else ():
        gaps = _measure_gaps(task, group, [p for p in rows if p is not group])
        if group.name in tried or any(abs(gap) <= SHELVES_TOUCH for gap, _ in gaps):
            continue
        near = [(abs(gap) * worse, gap) for gap, worse in gaps if abs(gap) < ONE_ROW]
        found += [(*min(near), group)] if near else []
    return [(off, group.name, group, gap) for off, gap, group in found]


def _measure_gaps(
    task: RoomTask, group: FurnishedGroup, others: list[FurnishedGroup]
) -> list[tuple[float, float]]:
    """Metres from a shelf to the corners and the others of its row, to the right if positive, and
    by what each counts: a corner is to be reached after the next shelf."""
    box, walls = group.dressed.box, task.ground.walls
    x, y, heading, width, depth = box.tolist()
    c, s = cos(heading), sin(heading)
    ways = walls[:, 2:] - walls[:, :2]
    across = np.abs(ways @ (s, -c)) < IN_LINE * np.hypot(*ways.T)
    left, right = side_gaps(box, walls[across])
    found = [(-left, CORNER), (right, CORNER)]
    for other in others:
        u, v, turn, wide, deep = other.dressed.box.tolist()
        along, ahead = (u - x) * s - (v - y) * c, (u - x) * c + (v - y) * s
        back = ahead - (deep - depth) / 2
        if abs(back) < IN_LINE and abs(remainder(turn - heading, tau)) < TURNED:
            gap = max(abs(along) - (width + wide) / 2, 0.0)
            found.append((gap if along > 0 else -gap, 1.0))
    return found


def _move(task: RoomTask, placed: Placed, group: FurnishedGroup, way: float) -> Placed | None:
    """The groups with one moved ``way`` metres to its right; None where it loses something there
    or the room costs over :data:`WORTH` more."""
    box, at = group.dressed.box.copy(), placed.index(group)
    box[:2] += way * np.array([sin(box[2]), -cos(box[2])])
    rest = (p for other in placed if other is not group for p in other.pieces)
    standing = standing_of((*task.fixed, *task.beside, *rest), flat_kinds(task.catalog))
    moved = dress_group(task, group, group.dressed.case, box, standing)
    if moved is None:
        return None
    judge, whole = judge_of(task, placed), (*placed[:at], moved, *placed[at + 1 :])
    return whole if judge.cost_of(whole).cost <= judge.cost_of(placed).cost + WORTH else None
