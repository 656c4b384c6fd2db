"""The ways from door to door over a room's floor (Liu et al. 2017, cost 3, *Path*).

The paper shades them and prints no rule. Here a way runs through the middle of both doors and is
the shortest over the floor that leaves half its width to either side, where possible; all
ways are united, so that floor on two of them counts once, and none of it lies outside the room.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.door_approach import DoorApproach
from scenewright.core.layout import corners
from scenewright.core.space import Space
from scenewright.domains.home.measures import HAIR

Floats = NDArray[np.float64]

WIDTH = 0.7
"""How wide a way is, metres."""
MARGINS = (0.35, 0.2, 0.05)
"""Metres a way keeps from walls and fixed pieces, the widest that joins two doors first."""
BEGINS_OFF = 0.6
"""How far off the line through a door its way may begin, metres."""
MOST_BENDS = 160
"""Corners that ways are led round, where a floor has more: those nearest to the straight lines
between the doors. The search is cubic in them."""


def door_paths(space: Space, doors: tuple[DoorApproach, ...], solids: Floats) -> Floats:
    """Directed edges ``(m, 4)`` of the united ways between every pair of doors, the inside on
    their left; ``solids`` ``(k, 5)`` are boxes that ways go round where they can. Empty with fewer
    than two doors; a pair that no floor joins has no way."""
    if len(doors) < 2:
        return np.zeros((0, 4))
    room = shapely.Polygon(space.outline, list(space.holes))
    taken = shapely.union_all(shapely.polygons(corners(np.reshape(solids, (-1, 5)))))
    floors = [room.difference(taken), room] if len(solids) else [room]
    lines: dict[tuple[int, int], Floats] = {}
    for floor in floors:
        for margin in MARGINS:
            missing = [p for p in combinations(range(len(doors)), 2) if p not in lines]
            lines.update(_lines(floor, doors, margin, missing))
    ways = [
        shapely.LineString(line).buffer(WIDTH / 2, 2, cap_style="flat") for line in lines.values()
    ]
    return _edges(shapely.union_all(ways).intersection(room))


def _lines(
    floor: shapely.Geometry,
    doors: tuple[DoorApproach, ...],
    margin: float,
    pairs: list[tuple[int, int]],
) -> Iterator[tuple[tuple[int, int], Floats]]:
    """The shortest lines between pairs of doors that keep a margin, from wall face to wall face."""
    free = floor.buffer(-margin, join_style="mitre")
    if not pairs or free.is_empty:
        return
    starts = np.array([_start(free, door, margin) for door in doors])
    bends = _near_lines(_inner_corners(free), starts, pairs)
    nodes = np.concatenate([starts, bends])
    length, after = _shortest(nodes, free)
    for i, j in pairs:
        if np.isfinite(length[i, j]):
            steps = [i]
            while steps[-1] != j:
                steps.append(int(after[steps[-1], j]))
            yield (i, j), np.array([doors[i].face, *nodes[steps], doors[j].face])


def _start(free: shapely.Geometry, door: DoorApproach, margin: float) -> Floats:
    """Where a way leaves a door: straight in, or the nearest free floor; NaN if that is far."""
    ahead = door.face + max(margin, MARGINS[0]) * door.inward
    nearest = np.array(shapely.shortest_line(free, shapely.Point(ahead)).coords[0])
    return nearest if np.hypot(*(nearest - ahead)) <= BEGINS_OFF else np.full(2, np.nan)


def _inner_corners(free: shapely.Geometry) -> Floats:
    """Corners ``(k, 2)`` that a shortest line may bend at: those that point into the floor."""
    found = [np.zeros((0, 2))]
    for part in shapely.get_parts(shapely.orient_polygons(free)):
        for ring in (part.exterior, *part.interiors):
            points = np.array(ring.coords)[:-1]
            back, ahead = points - np.roll(points, 1, 0), np.roll(points, -1, 0) - points
            found.append(points[back[:, 0] * ahead[:, 1] - back[:, 1] * ahead[:, 0] < 0.0])
    return np.concatenate(found)


def _near_lines(bends: Floats, starts: Floats, pairs: list[tuple[int, int]]) -> Floats:
    """Of the corners ``(k, 2)`` the :data:`MOST_BENDS` nearest to the straight lines between the
    starts of pairs, in their order; all if there are no more."""
    ends = starts[np.array(pairs)]
    ends = ends[np.isfinite(ends).all((1, 2))]
    if len(bends) <= MOST_BENDS or not len(ends):
        return bends[:MOST_BENDS]
    tree = shapely.STRtree(shapely.linestrings(ends))
    (asked, _), away = tree.query_nearest(
        shapely.points(bends), return_distance=True, all_matches=False
    )
    return bends[np.sort(asked[np.argsort(away, kind="stable")[:MOST_BENDS]])]


def _shortest(nodes: Floats, free: shapely.Geometry) -> tuple[Floats, NDArray[np.int64]]:
    """Lengths ``(n, n)`` of the shortest lines between nodes within the floor, and the node that
    follows i on the way to j (Floyd 1962)."""
    n = len(nodes)
    i, j = np.triu_indices(n, 1)
    known = np.isfinite(nodes[i]).all(-1) & np.isfinite(nodes[j]).all(-1)
    i, j = i[known], j[known]
    area = free.buffer(HAIR, join_style="mitre")
    shapely.prepare(area)
    seen = shapely.covers(area, shapely.linestrings(np.stack([nodes[i], nodes[j]], axis=1)))
    i, j = i[seen], j[seen]
    length = np.full((n, n), np.inf)
    length[i, j] = length[j, i] = np.linalg.norm(nodes[i] - nodes[j], axis=1)
    after = np.tile(np.arange(n), (n, 1))
    for k in range(n):
        over = length[:, k, None] + length[k]
        less = over < length - HAIR
        after = np.where(less, after[:, k, None], after)
        length = np.where(less, over, length)
    return length, after


def _edges(shape: shapely.Geometry) -> Floats:
    """Directed edges ``(m, 4)`` of all polygons of a shape, the inside on their left."""
    found = [np.zeros((0, 4))]
    for part in shapely.get_parts(shapely.orient_polygons(shape)):
        if isinstance(part, shapely.Polygon) and part.area > HAIR:
            for ring in (part.exterior, *part.interiors):
                points = np.array(ring.coords)
                found.append(np.hstack([points[:-1], points[1:]]))
    return np.ascontiguousarray(np.concatenate(found))
