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
from scenewright.ground.ways.path_tree import grow_paths, straighten, trace

Walk: TypeAlias = shapely.LineString
Raster: TypeAlias = tuple[Points, NDArray[np.bool_], float]

AHEAD = (2.0, 1.2, 3.5, 5.0)
"""Metres from a door at which a walk may bend; the first that gets through is taken."""
CELL, MOST_CELLS = 0.7, 60_000
"""Metres of the raster on which long walks are found, and of how many cells it is at most."""
CLEAR, LONGEST, NEIGHBOURS = 0.6, 80.0, 12
"""Metres kept from houses and of a walk at most; how many neighbours are tried."""
NARROW, FINE, AROUND = 0.3, 0.15, 18.0
"""Metres kept from houses in a passage, where nothing wider leads to a door; of the raster on which
it is found, and about the door up to which."""
SHORTER, TRIED = 0.8, 3
"""The share of the way to a goal by which a walk is shorter that joins another; walks tried."""


class WalkGround(NamedTuple):
    """Where walks lie: the ground that may be walked on, the ``goals`` they lead to, and whether
    they are ``joined`` to those laid before where that is shorter."""

    floor: shapely.Polygon
    goals: shapely.Geometry
    joined: bool = False


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
    doors, ways = find_doors(standing)
    found: dict[int, Walk] = {}
    for ahead in AHEAD:
        _lay(doors, doors + ahead * ways, ground, taken, found)
    return tuple(found[i] for i in sorted(found))


def lay_long_walks(
    ground: WalkGround, houses: Sequence[Piece], laid: Sequence[Walk]
) -> tuple[Walk, ...]:
    """Walks to the doors that none of those ``laid`` begins at: round the corners of houses, to a
    goal or to a walk."""
    standing = [p for p in houses if np.isfinite([*p.pose, *p.size]).all()]
    doors, ways = find_doors(standing)
    begun = {tuple(np.round(walk.coords[0], 3).tolist()) for walk in laid}
    left = [k for k, at in enumerate(doors) if tuple(np.round(at, 3).tolist()) not in begun]
    if not left:
        return ()
    shapes = polygons_of(standing)
    raster = _raster(ground.floor, shapes, CELL, CLEAR)
    served, walks = _go_round(ground, laid, doors[left], ways[left], raster)
    for k in [k for row, k in enumerate(left) if ground.joined and row not in served]:
        near = ground.floor.intersection(shapely.Point(doors[k]).buffer(AROUND))
        raster = _raster(near, shapes, FINE, NARROW)
        walks += _go_round(ground, [*laid, *walks], doors[[k]], NARROW * ways[[k]], raster)[1]
    return tuple(walks)


def _go_round(
    ground: WalkGround, laid: Sequence[Walk], doors: Points, steps: Points, raster: Raster
) -> tuple[list[int], list[Walk]]:
    """Which doors (n, 2), reached over cells within two of ``steps`` (n, 2) before them, have a
    quickest way to a goal or a walk, and these ways; they are one tree where walks are joined."""
    cells, open_, cell = raster
    spots = shapely.points(cells)
    goals = shapely.union_all([ground.goals, *laid])
    shapely.prepare(goals)
    free = np.flatnonzero(open_)
    starts = free[shapely.dwithin(spots[free], goals, cell)].astype(np.int32)
    slow = np.where(open_, 1.0, np.inf)
    times, before = find_quickest(slow, cell, starts)
    places: dict[int, int] = {}
    for k, at in enumerate(doors + steps):
        away = np.hypot(*(cells - at).T)
        away[~np.isfinite(times)] = np.inf
        if away.min() <= 2 * cell:
            places[k] = int(np.argmin(away))
    found = [[doors[k], cells[nearest]] for k, nearest in places.items()]
    if ground.joined:
        rows = grow_paths(slow, cell, starts, np.array([*places.values()], np.int32), before)
    else:
        rows = [np.array(trace(before, k, ()), np.int32) for k in places.values()]
    walks = []
    for k, row in enumerate(rows):
        line = cells[straighten(row, slow, cell)]
        if before[row[-1]] < 0:
            end = shapely.shortest_line(spots[row[-1]], goals)
            line = np.vstack([line, shapely.get_coordinates(end)[1:]])
        walks.append(line if ground.joined else np.vstack([found[k][0], line]))
    stubs = found if ground.joined else []
    return list(places), [Walk(line) for line in (*walks, *stubs) if len(line) > 1]


def _raster(
    floor: shapely.Polygon, shapes: NDArray[np.object_], size: float, clear: float
) -> Raster:
    """The middles (k, 2) of cells over a floor, which of them (rows, columns) may be walked on, and
    their size."""
    west, south, east, north = floor.bounds
    cell = max(size, float(np.sqrt((east - west) * (north - south) / MOST_CELLS)))
    x, y = np.arange(west, east + cell, cell), np.arange(south, north + cell, cell)
    cells = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    open_ = shapely.contains_xy(shapely.buffer(floor, 0.2), *cells.T)
    taken = shapely.union_all(shapely.buffer(shapes, clear, quad_segs=2))
    shapely.prepare(taken)
    open_ &= ~shapely.contains_xy(taken, *cells.T)
    return cells, open_.reshape(len(y), len(x)), cell


def find_doors(houses: Sequence[Piece]) -> tuple[Points, Points]:
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
    doors: Points, knees: Points, ground: WalkGround, taken: shapely.STRtree, found: dict[int, Walk]
) -> None:
    """Add the walks that bend at ``knees`` (n, 2), the nearest to a street first."""
    floor = ground.floor
    direct = shapely.shortest_line(shapely.points(knees), ground.goals)
    away = shapely.length(direct)
    first = shapely.covers(floor, shapely.linestrings(np.stack([doors, knees], 1)))
    through = first & shapely.covers(floor, direct) & _free(taken, direct) & (away <= LONGEST)
    for i in (int(i) for i in np.argsort(away, kind="stable") if int(i) not in found):
        end = _join(knees[i], SHORTER * away[i], ground, taken, found) if first[i] else None
        if end is not None:
            found[i] = _line(doors[i], knees[i], end)
        elif through[i]:
            found[i] = _line(doors[i], knees[i], shapely.get_coordinates(direct[i])[-1])
        if i in found:
            continue
        near = np.argsort(np.hypot(*(knees - knees[i]).T))[1 : NEIGHBOURS + 1].tolist()
        others = [j for j in near if j in found]
        bends = [shapely.get_coordinates(found[j])[1] for j in others]
        ways = [Walk([knees[i], bend]) for bend in bends]
        for bend, way, free in zip(bends, ways, _free(taken, ways), strict=True):
            if free and first[i] and floor.covers(way) and way.length <= LONGEST:
                found[i] = _line(doors[i], knees[i], bend)
                break


def _join(
    knee: Points, most: float, ground: WalkGround, taken: shapely.STRtree, found: dict[int, Walk]
) -> Points | None:
    """Where a walk from ``knee`` meets one of those ``found``, within ``most`` metres and clear of
    houses; ``None`` where it meets none."""
    if not ground.joined or not found:
        return None
    lines = np.array(list(found.values()), object)
    steps = shapely.shortest_line(shapely.Point(knee), lines)
    long = shapely.length(steps)
    for k in np.argsort(long, kind="stable")[:TRIED].tolist():
        if long[k] <= most and ground.floor.covers(steps[k]) and _free(taken, [steps[k]])[0]:
            return np.asarray(shapely.get_coordinates(steps[k])[-1])
    return None


def _free(taken: shapely.STRtree, lines: Sequence[Walk]) -> NDArray[np.bool_]:
    """Whether each line keeps clear of all houses."""
    blocked = np.zeros(len(lines), np.bool_)
    if len(lines):
        blocked[taken.query(lines, predicate="dwithin", distance=CLEAR)[0]] = True
    return ~blocked


def _line(door: Points, knee: Points, end: Points) -> Walk:
    """Door, knee and the end."""
    return Walk([door, knee, end] if np.hypot(*(end - knee)) > 0.05 else [door, knee])
