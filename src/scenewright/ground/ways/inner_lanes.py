"""Lanes into deep ground: loops from street to street, so that what lies behind has a way of its
own; a dead end with a turning head only where no loop fits.

Ground farther than :data:`REACH` from every street is deep. Of many lines between two places on
streets (straight, or in and out again at some depth) the one is taken that brings most deep ground
near a way for its length, and so on until nothing is worth a lane.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.ground.ways.lanes import round_bends

Floats = NDArray[np.float64]
Shapes = NDArray[np.object_]

REACH, WORTH = 21.0, 900.0
"""Metres from a way within which ground is served; square metres of deep ground worth a lane."""
STEP, CELL, MOST_CELLS, MOST_PLACES = 9.0, 3.0, 600, 160
"""Metres between the places on streets tried and between the points of ground looked at, and how
many of these and of those there are at most: lanes between all pairs of places are tried."""
DEPTHS = (24.0, 33.0, 42.0, 54.0)
"""Metres behind the street at which a lane may turn."""
APART, ASIDE = 24.0, 0.6
"""Metres between the ends of a loop at least, and the least cosine to the street's normal."""
SHARPEST, BESIDE, MIDDLE = -0.4, 14.0, np.linspace(0.3, 0.7, 5)
"""Least cosine of a bend, metres that a lane keeps from other ways in its middle part, and the
shares of its length at which that is looked at."""
ROOM = (13.0, 7.0, 3.0)
"""Metres kept from other ground, the first with which a lane is found."""
CLEAR, EACH = 1.5, 5.0
"""Metres kept from buildings, and square metres of deep ground that a metre of lane must serve."""
HEAD = 5.5
"""Radius in metres of a turning head."""
MOST_LANES = 3


class LaidLane(NamedTuple):
    """A lane that was laid: its middle line (n, 2), width in metres, and the radius of the turning
    head at its last point (0: it ends on a way)."""

    line: Points
    width: float
    head: float = 0.0


def area_of(lane: LaidLane) -> shapely.Geometry:
    """The ground of a lane with its head.

    >>> round(area_of(LaidLane(np.array([[0.0, 0.0], [10.0, 0.0]]), 3.0)).area, 6)
    30.0
    """
    line = shapely.LineString(lane.line)
    strip = shapely.buffer(line, lane.width / 2, cap_style="flat", join_style="round", quad_segs=3)
    if not lane.head:
        return strip
    return shapely.union(strip, shapely.Point(lane.line[-1]).buffer(lane.head, quad_segs=6))


def lay_inner_lanes(
    floor: shapely.Polygon, streets: Points, taken: Shapes, width: float
) -> tuple[LaidLane, ...]:
    """Lanes of some width on a floor between its street sides (s, 2, 2), off what is ``taken``.

    >>> deep = shapely.box(0, 0, 90, 90)
    >>> street = np.array([[[0.0, 0.0], [90.0, 0.0]]])
    >>> [round(lane.head) for lane in lay_inner_lanes(deep, street, np.zeros(0, object), 3.5)]
    [0]
    """
    found: list[LaidLane] = []
    ways = streets
    while len(found) < MOST_LANES:
        deep = _deep_points(floor, ways)
        lane = _best_loop(floor, ways, taken, deep, width) if len(deep) else None
        if lane is None and len(deep) and not found:
            lane = _best_end(floor, ways, taken, deep, width)
        if lane is None:
            break
        found.append(lane)
        ways = np.concatenate([ways, edges_of(lane)])
    return tuple(found)


def edges_of(lane: LaidLane) -> Points:
    """Both edges of a lane as sides (k, 2, 2), the ground beside it on their left."""
    line = shapely.simplify(shapely.LineString(lane.line), 0.15)
    rows = []
    for side in (1.0, -1.0):
        edge = shapely.get_coordinates(
            shapely.offset_curve(line, side * lane.width / 2, join_style="mitre", mitre_limit=2.0)
        )
        edge = edge if side > 0 else edge[::-1]
        rows.append(np.stack([edge[:-1], edge[1:]], 1))
    return np.concatenate(rows)


def _deep_points(floor: shapely.Polygon, streets: Points) -> Floats:
    """Points (k, 2) of deep ground, each for as much of it; none if it is not worth a lane."""
    step = max(CELL, float(np.sqrt(floor.area / MOST_CELLS)))
    west, south, east, north = floor.bounds
    x, y = np.arange(west + step / 2, east, step), np.arange(south + step / 2, north, step)
    grid = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    grid = grid[shapely.contains_xy(floor, grid[:, 0], grid[:, 1])]
    lines = shapely.union_all(shapely.linestrings(streets))
    deep = grid[shapely.distance(shapely.points(grid), lines) > REACH]
    return deep if len(deep) * step**2 >= WORTH else np.zeros((0, 2))


def _area_of_point(floor: shapely.Polygon) -> float:
    return max(CELL, float(np.sqrt(floor.area / MOST_CELLS))) ** 2


def _best_loop(
    floor: shapely.Polygon, streets: Points, taken: Shapes, deep: Floats, width: float
) -> LaidLane | None:
    """The loop that serves most, with as much room to other ground as can be."""
    at, into = _entries(floor, streets)
    lines = _keep_apart(_loops(at, into), streets)
    for room in ROOM:
        free = _free_ground(floor, streets, taken, width, room)
        best = _best(floor, lines, free, deep)
        if best is not None:
            centres = shapely.buffer(free, 0.01)
            return LaidLane(shapely.get_coordinates(round_bends(best, centres)), width)
    return None


def _best_end(
    floor: shapely.Polygon, streets: Points, taken: Shapes, deep: Floats, width: float
) -> LaidLane | None:
    """The dead end that serves most, with room for its head."""
    at, into = _entries(floor, streets)
    ends = [np.stack([at, at + depth * into], 1) for depth in (30.0, 42.0, 54.0, 70.0, 90.0)]
    lines = shapely.linestrings(np.concatenate([np.zeros((0, 2, 2)), *ends]))
    free = _free_ground(floor, streets, taken, width, ROOM[-1])
    heads = shapely.buffer(shapely.get_point(lines, -1), HEAD + CLEAR - width / 2)
    shapely.prepare(free)
    best = _best(floor, lines[shapely.covers(free, heads)], free, deep)
    return None if best is None else LaidLane(shapely.get_coordinates(best), width, HEAD)


def _entries(floor: shapely.Polygon, streets: Points) -> tuple[Floats, Floats]:
    """Places (k, 2) on streets and the directions (k, 2) from there onto the floor."""
    places, ways = [np.zeros((0, 2))], [np.zeros((0, 2))]
    lengths = np.hypot(*(streets[:, 1] - streets[:, 0]).T)
    step = max(STEP, float(lengths.sum()) / MOST_PLACES)
    for (start, end), long in zip(streets, lengths.tolist(), strict=True):
        count = int(long // step) + (long > 0.67 * step)
        if not count:
            continue
        along = (end - start) / long
        into = np.array([-along[1], along[0]])
        middle = (start + end) / 2
        into *= 1.0 if shapely.contains_xy(floor, *(middle + 0.5 * into)) else -1.0
        places.append(start + ((np.arange(count) + 0.5) / count * long)[:, None] * along)
        ways.append(np.tile(into, (count, 1)))
    return np.concatenate(places), np.concatenate(ways)


def _loops(at: Floats, into: Floats) -> Shapes:
    """Lines between two entries: straight where both look along it, else by two bends."""
    i, j = np.triu_indices(len(at), 1)
    step = at[j] - at[i]
    long = np.hypot(*step.T)
    keep = long >= APART
    i, j, step, long = i[keep], j[keep], step[keep], long[keep]
    unit = step / long[:, None]
    ahead = ((unit * into[i]).sum(1) > ASIDE) & ((-unit * into[j]).sum(1) > ASIDE)
    straight = shapely.linestrings(np.stack([at[i], at[j]], 1)[ahead])
    bent = [np.stack([at[i], at[i] + d * into[i], at[j] + d * into[j], at[j]], 1) for d in DEPTHS]
    rows = np.concatenate([np.zeros((0, 4, 2)), *bent])
    bows = shapely.linestrings(rows[_turns_wide(rows)])
    return np.concatenate([straight, bows[shapely.is_simple(bows)]])


def _turns_wide(rows: Floats) -> NDArray[np.bool_]:
    """Which lines of two bends (k, 4, 2) are no hairpins and turn by no sharp angle."""
    legs = np.diff(rows, axis=1)
    long = np.hypot(legs[..., 0], legs[..., 1])
    unit = legs / np.maximum(long, 1e-9)[..., None]
    bends = (unit[:, 1:] * unit[:, :-1]).sum(2)
    found: NDArray[np.bool_] = (long[:, 1] >= APART) & (bends >= SHARPEST).all(1)
    return found


def _keep_apart(lines: Shapes, streets: Points) -> Shapes:
    """The lines whose middle parts run well off all streets: none runs beside or across one."""
    if not len(lines):
        return lines
    at = shapely.line_interpolate_point(lines[:, None], MIDDLE[None], normalized=True)
    away = shapely.distance(at, shapely.union_all(shapely.linestrings(streets))).min(1)
    return lines[away >= BESIDE]


def _free_ground(
    floor: shapely.Polygon, streets: Points, taken: Shapes, width: float, room: float
) -> shapely.Geometry:
    """Where the middle of a lane may lie."""
    lines = shapely.union_all(shapely.linestrings(streets))
    rest = shapely.difference(floor.exterior, shapely.buffer(lines, 0.5))
    off = shapely.buffer(rest, room + width / 2)
    solid = shapely.buffer(shapely.union_all(taken), CLEAR + width / 2)
    return shapely.difference(shapely.buffer(floor, 0.05), shapely.union(off, solid))


def _best(
    floor: shapely.Polygon, lines: Shapes, free: shapely.Geometry, deep: Floats
) -> shapely.LineString | None:
    """The line on free ground that serves most deep ground beyond its own length's worth."""
    shapely.prepare(free)
    lines = lines[shapely.covers(free, lines)] if len(lines) else lines
    if not len(lines):
        return None
    few = shapely.points(deep[:: max(1, len(deep) // 40)])
    near = (shapely.distance(few[:, None], lines[None]) < REACH).mean(0) * len(deep)
    each, long = _area_of_point(floor), shapely.length(lines)
    first = np.argsort(-(near * each - EACH * long), kind="stable")[:40]
    served = (shapely.distance(shapely.points(deep)[:, None], lines[None, first]) < REACH).sum(0)
    worth = served * each - EACH * long[first]
    best = int(np.argmax(np.round(worth, 3)))
    found: shapely.LineString = lines[first[best]]
    return found if worth[best] > 0 and served[best] * each >= WORTH / 2 else None
