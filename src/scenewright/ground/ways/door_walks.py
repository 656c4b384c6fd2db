"""Walks from doors to a way: straight out, a bend, straight to the way, or to the bend of a
neighbour's walk; those that none of these lead to go round the corners."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.scene import Piece
from scenewright.core.space import Points
from scenewright.geometry.wavefront import find_quickest
from scenewright.ground.ways.path_tree import straighten, trace

Walk: TypeAlias = shapely.LineString

AHEAD = (2.0, 1.2, 3.5, 5.0)
"""Metres from a door at which a walk may bend; the first that gets through is taken."""
CELL, MOST_CELLS = 0.7, 60_000
"""Metres of the raster on which long walks are found, and of how many cells it is at most."""
CLEAR, LONGEST, NEIGHBOURS = 0.6, 80.0, 12
"""Metres kept from houses and of a walk at most; how many neighbours are tried."""


class WalkGround(NamedTuple):
    """Where walks lie: the ground that may be walked on, and the ``goals`` they lead to."""

    floor: shapely.Polygon
    goals: shapely.Geometry


def lay_walks_to_doors(
    ground: WalkGround, houses: Sequence[Piece], others: Sequence[Piece] = ()
) -> tuple[Walk, ...]:
    """The middle lines of walks of one bend, clear of ``others`` too; houses that none can reach
    have none."""
    standing = [p for p in houses if np.isfinite([*p.pose, *p.size]).all()]
    if not standing:
        return ()
    taken = shapely.STRtree(polygons_of([*standing, *others]))
    shapely.prepare(ground.floor)
    doors, ways = _doors(standing)
    found: dict[int, Walk] = {}
    for ahead in AHEAD:
        _lay(doors, doors + ahead * ways, ground.goals, taken, ground.floor, found)
    return tuple(found[i] for i in sorted(found))


def lay_long_walks(
    ground: WalkGround, houses: Sequence[Piece], laid: Sequence[Walk]
) -> tuple[Walk, ...]:
    """Walks to the doors that none of those ``laid`` begins at: round the corners of houses, to a
    goal or to a walk."""
    standing = [p for p in houses if np.isfinite([*p.pose, *p.size]).all()]
    doors, ways = _doors(standing)
    begun = {tuple(np.round(walk.coords[0], 3).tolist()) for walk in laid}
    left = [k for k, at in enumerate(doors) if tuple(np.round(at, 3).tolist()) not in begun]
    if not left:
        return ()
    cells, open_, cell = _raster(ground.floor, polygons_of(standing))
    spots = shapely.points(cells)
    goals = shapely.union_all([ground.goals, *laid])
    shapely.prepare(goals)
    free = np.flatnonzero(open_)
    starts = free[shapely.dwithin(spots[free], goals, cell)]
    slow = np.where(open_, 1.0, np.inf)
    times, before = find_quickest(slow, cell, starts.astype(np.int32))
    found = []
    for k in left:
        away = np.hypot(*(cells - doors[k] - ways[k]).T)
        away[~np.isfinite(times)] = np.inf
        nearest = int(np.argmin(away))
        if away[nearest] <= 2 * cell:
            path = straighten(trace(before, nearest, ()), slow, cell)
            end = shapely.get_coordinates(shapely.shortest_line(spots[path[-1]], goals))[1:]
            found.append(Walk(np.vstack([doors[k], cells[path], end])))
    return tuple(found)


def _raster(
    floor: shapely.Polygon, shapes: NDArray[np.object_]
) -> tuple[Points, NDArray[np.bool_], float]:
    """The middles (k, 2) of cells over a floor, which of them (rows, columns) may be walked on, and
    their size."""
    west, south, east, north = floor.bounds
    cell = max(CELL, float(np.sqrt((east - west) * (north - south) / MOST_CELLS)))
    x, y = np.arange(west, east + cell, cell), np.arange(south, north + cell, cell)
    cells = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    open_ = shapely.contains_xy(shapely.buffer(floor, 0.2), *cells.T)
    taken = shapely.union_all(shapely.buffer(shapes, CLEAR, quad_segs=2))
    shapely.prepare(taken)
    open_ &= ~shapely.contains_xy(taken, *cells.T)
    return cells, open_.reshape(len(y), len(x)), cell


def _doors(houses: Sequence[Piece]) -> tuple[Points, Points]:
    """The middle of the side farthest ahead of each house (n, 2), and the direction out (n, 2)."""
    turn = np.array([p.pose.heading for p in houses])
    ways = np.stack([np.cos(turn), np.sin(turn)], 1)
    doors = np.zeros((len(houses), 2))
    for k, piece in enumerate(houses):
        ring = outline_of(piece)
        middle = (ring + np.roll(ring, -1, axis=0)) / 2
        doors[k] = middle[int(np.argmax(np.round(middle @ ways[k], 6)))]
    return doors, ways


def _lay(
    doors: Points,
    knees: Points,
    streets: shapely.Geometry,
    taken: shapely.STRtree,
    floor: shapely.Polygon,
    found: dict[int, Walk],
) -> None:
    """Add the walks that bend at ``knees`` (n, 2), the nearest to a street first."""
    direct = shapely.shortest_line(shapely.points(knees), streets)
    away = shapely.length(direct)
    first = shapely.covers(floor, shapely.linestrings(np.stack([doors, knees], 1)))
    through = first & shapely.covers(floor, direct) & _free(taken, direct) & (away <= LONGEST)
    for i in (int(i) for i in np.argsort(away, kind="stable") if int(i) not in found):
        if through[i]:
            found[i] = _line(doors[i], knees[i], shapely.get_coordinates(direct[i])[-1])
            continue
        near = np.argsort(np.hypot(*(knees - knees[i]).T))[1 : NEIGHBOURS + 1].tolist()
        others = [j for j in near if j in found]
        bends = [shapely.get_coordinates(found[j])[1] for j in others]
        ways = [Walk([knees[i], bend]) for bend in bends]
        for bend, way, free in zip(bends, ways, _free(taken, ways), strict=True):
            if free and first[i] and floor.covers(way) and way.length <= LONGEST:
                found[i] = _line(doors[i], knees[i], bend)
                break


def _free(taken: shapely.STRtree, lines: Sequence[Walk]) -> NDArray[np.bool_]:
    """Whether each line keeps clear of all houses."""
    blocked = np.zeros(len(lines), np.bool_)
    if len(lines):
        blocked[taken.query(lines, predicate="dwithin", distance=CLEAR)[0]] = True
    return ~blocked


def _line(door: Points, knee: Points, end: Points) -> Walk:
    """Door, knee and the end."""
    return Walk([door, knee, end] if np.hypot(*(end - knee)) > 0.05 else [door, knee])
