"""Places along curved walls: a wall of many short straight pieces that bend one way is one wall.

Objects with free floor at their sides stand on it at even distances, all along it; others side by
side. Each place is a stretch as wide as the widest object, its ends on the curve where the room
bulges out, touching it in its middle where the wall bulges in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
import shapely.ops

from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.zoning.borders import WallStretch

LEAST_BEND, MOST_BEND = math.radians(1.0), math.radians(35.0)
"""Angles between two pieces that follow one another on a curve."""
PIECES, JOIN = 4, 0.15
"""Fewest pieces of a curve, and how far the ends of two may lie apart, in metres."""
HOLLOW = 0.04
"""Metres that may lie between the middle of a back and a wall that bulges behind it."""
BULGE = 0.2
"""Metres of it behind the middle of what is as wide as a place from which on none is on a curve."""
CURVE_SPARE = 0.02
"""Metres by which a place is wider than its object, and between two places."""


class WallNeed(NamedTuple):
    """What is to stand along the walls of a zone: the widest and deepest object, how many there
    are, and whether they want free floor at their sides."""

    width: float
    depth: float
    number: int
    apart: bool


def space_places(walls: Sequence[WallStretch], need: WallNeed) -> list[WallStretch]:
    """The stretches of a zone with those on curves replaced by places for single objects."""
    found, total = list[WallStretch](), sum(map(_length, walls))
    for run in find_runs(walls):
        curved = len(run) >= PIECES and need.number > 0
        line, bend = _line(run), _bend(run)
        stands = curved and not (bend > 0.0 and _stands_off(line, need.width))
        found += _places(line, bend, need, total) if stands else run
    return found


def _stands_off(line: Floats, width: float) -> bool:
    """Whether a line (k, 2) bulges out too far behind an object ``width`` metres wide for it to
    stand there."""
    curve = shapely.LineString(line)
    return _bulge(curve, 0.5 * curve.length, 0.5 * width) > BULGE


def find_runs(walls: Sequence[WallStretch]) -> list[list[WallStretch]]:
    """Stretches that follow one another and bend the same way, each alone where none does."""
    runs: list[list[WallStretch]] = []
    for wall in walls:
        run = runs[-1] if runs else []
        if run and _follows(run[-1], wall) and _same_way(run, wall):
            run.append(wall)
        else:
            runs.append([wall])
    if len(runs) > 1 and _follows(runs[-1][-1], runs[0][0]) and _same_way(runs[-1], runs[0][0]):
        runs[0] = runs.pop() + runs[0]
    return runs


def longest_place(run: Sequence[WallStretch]) -> float:
    """Metres of wall for one object: all of a curve, else the longest stretch."""
    lengths = [_length(wall) for wall in run]
    return sum(lengths) if len(run) >= PIECES else max(lengths)


def _places(line: Floats, bend: float, need: WallNeed, total: float) -> list[WallStretch]:
    """Places along a line (k, 2) that bends by ``bend`` radians to the left."""
    length = float(np.hypot(*np.diff(line, axis=0).T).sum())
    inner = max(1.0 - need.depth * bend / length, 0.3) if bend > 0.0 else 1.0
    pitch = need.width / inner + CURVE_SPARE
    most = int(length / pitch)
    if most == 0:
        return []
    count = most
    if need.apart:
        count = min(max(math.ceil(need.number * length / total - 1e-6), 1), most)
        pitch = length / count
    first = 0.5 * (length - count * pitch)
    middles = first + pitch * (np.arange(count) + 0.5)
    return [_place(shapely.LineString(line), float(t), need.width, bend > 0.0) for t in middles]


def _place(line: shapely.LineString, at: float, width: float, outward: bool) -> WallStretch:
    """A place about the point ``at`` metres along a line: a chord of it, or a tangent."""
    half = 0.5 * width + 0.5 * CURVE_SPARE
    if outward and _bulge(line, at, half) > HOLLOW:
        at = _within_piece(line, at, half)
    reach = half if outward else 0.01
    low, high = max(at - reach, 0.0), min(at + reach, line.length)
    a, b = (np.array(line.interpolate(t).coords[0]) for t in (low, high))
    way = (b - a) / max(float(np.hypot(*(b - a))), 1e-9)
    middle = 0.5 * (a + b)
    (x0, y0), (x1, y1) = (middle + side * half * way for side in (-1.0, 1.0))
    return WallStretch(float(x0), float(y0), float(x1), float(y1))


def _bulge(line: shapely.LineString, at: float, half: float) -> float:
    """How far a line bulges out behind the chord about the point ``at`` metres along it."""
    low, high = max(at - half, 0.0), min(at + half, line.length)
    part = shapely.get_coordinates(shapely.ops.substring(line, low, high))
    way = (part[-1] - part[0]) / max(float(np.hypot(*(part[-1] - part[0]))), 1e-9)
    off = part - part[0]
    return float(np.abs(off[:, 0] * way[1] - off[:, 1] * way[0]).max())


def _within_piece(line: shapely.LineString, at: float, half: float) -> float:
    """The point of a line nearest to ``at`` metres along it about which a place lies on one piece;
    ``at`` itself where that piece is shorter."""
    ends = np.cumsum([0.0, *np.hypot(*np.diff(shapely.get_coordinates(line), axis=0).T)])
    k = min(int(np.searchsorted(ends, at, side="right")), len(ends) - 1)
    low, high = ends[k - 1] + half, ends[k] - half
    return float(min(max(at, low), high)) if low <= high else at


def _line(run: Sequence[WallStretch]) -> Floats:
    """The corners (k, 2) of a run, the ends of two pieces joined in their middle."""
    joints = [((a.x1 + b.x0) / 2, (a.y1 + b.y0) / 2) for a, b in pairwise(run)]
    return np.array([(run[0].x0, run[0].y0), *joints, (run[-1].x1, run[-1].y1)])


def _length(wall: WallStretch) -> float:
    return math.hypot(wall.x1 - wall.x0, wall.y1 - wall.y0)


def _follows(before: WallStretch, after: WallStretch) -> bool:
    near = math.hypot(after.x0 - before.x1, after.y0 - before.y1) < JOIN
    return near and LEAST_BEND < abs(_turn(before, after)) < MOST_BEND


def _same_way(run: Sequence[WallStretch], wall: WallStretch) -> bool:
    return len(run) < 2 or _turn(run[-2], run[-1]) * _turn(run[-1], wall) > 0.0


def _turn(before: WallStretch, after: WallStretch) -> float:
    """The angle from one stretch to another, to the left, -π to π."""
    a = math.atan2(before.y1 - before.y0, before.x1 - before.x0)
    b = math.atan2(after.y1 - after.y0, after.x1 - after.x0)
    return (b - a + math.pi) % (2.0 * math.pi) - math.pi


def _bend(run: Sequence[WallStretch]) -> float:
    """The angles between the pieces of a run, summed."""
    return sum(_turn(a, b) for a, b in pairwise(run))
