"""Walks: how people get from a street to the door of every building, for the eye only.

From the middle of each front a walk leads some metres ahead, then straight to the nearest street;
where a building stands between, to the door of a neighbour nearer to a street.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.footprint import polygons_of
from scenewright.core.scene import Piece
from scenewright.core.space import Points
from scenewright.ground.plan import SitePlan

AHEAD = (2.5, 6.0, 10.0)
"""How far a walk may lead straight ahead, in metres; the first that gets through is taken."""
CLEAR, LONGEST, NEIGHBOURS = 1.2, 80.0, 12
"""Metres kept from buildings and of a walk at most; how many doors of neighbours are tried."""

Walk: TypeAlias = shapely.LineString


def walks(plan: SitePlan, buildings: Sequence[Piece]) -> tuple[Walk, ...]:
    """The middle lines of the walks of a site, inside it; buildings that none can reach have
    none."""
    areas = [shapely.Polygon(a.outline, a.holes) for way in plan.roads for a in way.areas]
    standing = [p for p in buildings if np.isfinite([*p.pose, *p.size]).all()]
    if not standing or not areas:
        return ()
    streets = shapely.union_all(areas)
    shapely.prepare(streets)
    taken = shapely.STRtree(polygons_of(standing))
    floor = shapely.Polygon(plan.outline, plan.holes)
    shapely.prepare(floor)
    found: dict[int, Walk] = {}
    for ahead in AHEAD:
        _lay(standing, ahead, streets, taken, floor, found)
    return tuple(found[i] for i in sorted(found))


def _nearest(places: Points) -> list[list[int]]:
    """For each place the nearest to it within reach of a walk, itself first."""
    points = shapely.points(places)
    one, other = shapely.STRtree(points).query(points, predicate="dwithin", distance=LONGEST)
    order = np.lexsort((other, np.hypot(*(places[one] - places[other]).T), one))
    parts = np.split(other[order], np.cumsum(np.bincount(one, minlength=len(places)))[:-1])
    return [part[:NEIGHBOURS].tolist() for part in parts]


def _lay(
    buildings: Sequence[Piece],
    ahead: float,
    streets: shapely.Geometry,
    taken: shapely.STRtree,
    floor: shapely.Polygon,
    found: dict[int, Walk],
) -> None:
    """Add the walks that bend so far ahead of the doors, the nearest to a street first."""
    doors, knees = _doors(buildings, ahead)
    direct = shapely.shortest_line(shapely.points(knees), streets)
    away = shapely.length(direct)
    first = shapely.linestrings(np.stack([doors, knees], 1))
    within = shapely.covers(floor, first) & shapely.covers(floor, direct)
    through = within & _free(taken, direct) & (away <= LONGEST)
    near = _nearest(knees)
    for i in (int(i) for i in np.argsort(away, kind="stable") if int(i) not in found):
        if through[i]:
            found[i] = _line(doors[i], knees[i], shapely.get_coordinates(direct[i])[-1])
            continue
        bends = [shapely.get_coordinates(found[j])[1] for j in near[i] if j in found]
        ways = [Walk([knees[i], bend]) for bend in bends]
        for bend, way, there in zip(bends, ways, _free(taken, ways), strict=True):
            inside = there and floor.covers(first[i]) and floor.covers(way)
            if inside and way.length <= LONGEST:
                found[i] = _line(doors[i], knees[i], bend)
                break


def _doors(buildings: Sequence[Piece], far: float) -> tuple[Points, Points]:
    """The middle of every front ``(n, 2)``, and the point so far ahead of it."""
    poses = np.array([(p.pose.x, p.pose.y, p.pose.heading, p.size.depth) for p in buildings])
    ahead = np.stack([np.cos(poses[:, 2]), np.sin(poses[:, 2])], 1)
    doors = poses[:, :2] + ahead * poses[:, 3:] / 2
    return doors, doors + ahead * far


def _free(taken: shapely.STRtree, lines: Sequence[Walk]) -> NDArray[np.bool_]:
    """Whether each line keeps clear of all buildings."""
    blocked = np.zeros(len(lines), np.bool_)
    if len(lines):
        blocked[taken.query(lines, predicate="dwithin", distance=CLEAR)[0]] = True
    return ~blocked


def _line(door: Points, knee: Points, end: Points) -> Walk:
    """Door, knee and 0.2 m beyond the end."""
    step = end - knee
    length = float(np.hypot(*step))
    beyond = end + step / length * 0.2 if length > 1e-6 else end
    points = [door, knee, beyond] if length > 0.05 else [door, knee]
    return Walk(points)
