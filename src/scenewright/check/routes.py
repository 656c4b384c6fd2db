"""Routes: where a person can walk, and how much of the floor is navigable.

A person is a disc. Where its centre may be is exact: the rooms of a level joined by their
doorways, shrunk by the radius, less every footprint grown by it (Minkowski; discs as 32-gons).
SceneEval (Tam et al. 2025, after PhyScene, Yang et al. 2024) rasters the same region at 256 x 256
for its *navigability*, the largest connected part over the whole, with a robot of 0.2 m and
without objects above 2 m; its doors are not joined, ours are.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.check.bodies import Bodies, Rooms, Shape, Shapes, standing_in
from scenewright.check.ceilings import HEADROOM, SHOULDERS, lower_than
from scenewright.core.space import Opening, StairEnd

ROBOT_RADIUS = 0.2
"""Radius of the robot whose navigable share is given (SceneEval), and of a person sideways."""

TURNING = 1.5
"""Diameter of the circle a wheelchair turns in, in metres."""

_SLACK = 0.01


class JoinedFloor(NamedTuple):
    """One group of rooms joined by doors: their numbers, the joined floor with its doorways where
    a person has room for the shoulders, the part of it too ``low`` for the head, the
    doorways of each room, the points where one comes in from outside, or to another level by
    stairs (empty: not known; doors that are only exits do not count unless all are), and the
    doors to the ``outer`` world."""

    rooms: NDArray[np.int64]
    floor: Shape
    low: Shape
    doorways: dict[int, list[Shape]]
    ways_in: Shapes
    outer: tuple[Opening, ...]


class Walk(NamedTuple):
    """Where the disc's centre may be in a ground: ``bare`` in the empty rooms, ``free`` less the
    ``grown`` footprints of the pieces ``blocking`` (their rows); ``bare_reached`` and ``reached``
    are the parts of both that are joined to ``start``."""

    radius: float
    bare: Shape
    bare_reached: Shape
    blocking: NDArray[np.int64]
    grown: Shapes
    start: Shape
    free: Shape
    reached: Shape


def navigable_share(bodies: Bodies, rooms: Rooms, grounds: list[JoinedFloor]) -> dict[str, float]:
    """Largest connected part over the whole region open to a disc of 0.2 m, by level.

    Where rooms of one level are not joined by any door (two storeys drawn side by side) the
    largest part of each group of rooms counts. 1 for a level with no room for the disc.
    """
    parts = {level: [0.0, 0.0] for level in rooms.levels}
    for ground in grounds:
        inside = np.flatnonzero(standing_in(bodies, ground.rooms) & bodies.underfoot)
        free = _less(_open(ground, ROBOT_RADIUS), _grow_footprints(bodies, inside, ROBOT_RADIUS))
        areas = shapely.area(shapely.get_parts(free))
        total = parts[rooms.levels[rooms.level[ground.rooms[0]]]]
        total[0] += float(areas.max(initial=0.0))
        total[1] += float(areas.sum())
    return {level: round(most / all_, 4) if all_ else 1.0 for level, (most, all_) in parts.items()}


def reachable_share(
    bodies: Bodies, rooms: Rooms, grounds: list[JoinedFloor], walks: list[Walk]
) -> dict[str, float]:
    """Floor a disc of 0.2 m reaches that comes in by the entrances, by level; ``walks`` are where
    it goes in each of ``grounds``.

    The share is of the region open to the disc, as in :func:`navigable_share`, but counted within
    the rooms and with the seats that go under tables pushed aside. Where no entrance is known
    (an upper storey) the disc starts in the largest part; rooms no door joins to anything are
    not reached unless a staircase stands in them. 1 for a level with no room for the disc.
    """
    parts = {level: [0.0, 0.0] for level in rooms.levels}
    stairs = {piece.space for piece in bodies.pieces if piece.category == "staircase"}
    stairs |= {space.id for space in rooms.spaces if space.stairs}
    for ground, walk in zip(grounds, walks, strict=True):
        inside = shapely.union_all(rooms.shapes[ground.rooms])
        total = parts[rooms.levels[rooms.level[ground.rooms[0]]]]
        if ground.doorways or any(rooms.spaces[i].id in stairs for i in ground.rooms):
            total[0] += float(shapely.area(shapely.intersection(walk.reached, inside)))
        total[1] += float(shapely.area(shapely.intersection(walk.free, inside)))
    return {level: round(part / all_, 4) if all_ else 1.0 for level, (part, all_) in parts.items()}


def grounds_of(rooms: Rooms, route_width: float) -> list[JoinedFloor]:
    """Groups of rooms joined by doors and passages, each with its floor."""
    number = {space.id: i for i, space in enumerate(rooms.spaces)}
    found = {(s.level, *o.spaces, o.id, o.x, o.y): o for s in rooms.spaces for o in s.openings}
    doors = [opening for opening in found.values() if opening.kind != "window"]
    links = [[number[s] for s in o.spaces if s in number] for o in doors]
    group = _components(len(rooms.spaces), [(a[0], a[1]) for a in links if len(a) == 2])
    grounds = []
    for g in range(int(group.max(initial=-1)) + 1):
        members = np.flatnonzero(group == g)
        near = [(o, a) for o, a in zip(doors, links, strict=True) if a and group[a[0]] == g]
        ways = [(o, a, _doorway(o, rooms, a, route_width)) for o, a in near]
        doorways: dict[int, list[Shape]] = {}
        for _, joined, way in ways:
            for room in joined:
                doorways.setdefault(room, []).append(way)
        floor = shapely.union_all([*rooms.shapes[members], *(way for _, _, way in ways)])
        outer = tuple(o for o, a in near if len(a) == 1)
        entrances = [o for o in outer if o.use != "exit"] or outer
        doorsteps = [shapely.points(o.x, o.y) for o in entrances]
        arrivals = [
            _before(end, route_width)
            for room in members
            for end in rooms.spaces[room].stairs
            if end.arrival
        ]
        points = np.array(arrivals or doorsteps, object)
        floor = shapely.difference(floor, _lower(rooms, members, SHOULDERS))
        low = _lower(rooms, members, HEADROOM)
        grounds.append(JoinedFloor(members, floor, low, doorways, points, outer))
    return grounds


def _before(end: StairEnd, route_width: float) -> Shape:
    """Where the middle of a route is that has just left stairs."""
    away = route_width / 2 + _SLACK
    return shapely.points(end.x + away * np.cos(end.heading), end.y + away * np.sin(end.heading))


def _components(n: int, links: list[tuple[int, int]]) -> NDArray[np.int64]:
    """The number of the connected part each of ``n`` nodes is in, counted in order.

    >>> _components(4, [(3, 1)]).tolist()
    [0, 1, 2, 1]
    """
    least = np.arange(n)
    for a, b in links:
        least[least == max(least[a], least[b])] = min(least[a], least[b])
    return np.asarray(np.unique(least, return_inverse=True)[1], np.int64)


def _doorway(opening: Opening, rooms: Rooms, joined: list[int], route_width: float) -> Shape:
    """The floor of a doorway, a little into the rooms on both sides.

    However narrow, a door lets people through, so it counts as a centimetre more than the route;
    a way in from outside goes on outside so that a person can stand in the door.
    """
    along = np.array([opening.ux, opening.uy])
    left = np.array([-along[1], along[0]])
    centre = np.array([opening.x, opening.y])
    side = along * max(opening.width, route_width + 2 * _SLACK) / 2
    half = opening.thickness / 2 + _SLACK
    reach = np.array([half, half])
    if len(joined) == 1:
        apart = shapely.distance(
            shapely.points(np.stack([centre + left * half, centre - left * half])),
            rooms.shapes[joined[0]],
        )
        reach[int(np.argmax(apart))] = half + route_width
    back, fore = centre - left * reach[1], centre + left * reach[0]
    return shapely.polygons(np.stack([back - side, back + side, fore + side, fore - side]))


def walk_in(bodies: Bodies, ground: JoinedFloor, radius: float) -> Walk:
    """Where a disc of ``radius`` metres may go in a ground, and the part joined to the way in.

    The way in is where outer doors are; the largest free part if there are none, or if they are
    too tight even in the empty rooms.
    """
    blocking = blocking_in(bodies, ground.rooms)
    bare, grown = _open(ground, radius), _grow_footprints(bodies, blocking, radius)
    free = _less(bare, grown)
    doors = shapely.multipoints(ground.ways_in) if len(ground.ways_in) else shapely.MultiPoint()
    start = shapely.buffer(doors, 2 * _SLACK)
    if not shapely.intersects(start, bare):
        start = _somewhere_in_largest(free if not free.is_empty else bare)
    bare_reached, reached = _select_connected(bare, start), _select_connected(free, start)
    return Walk(radius, bare, bare_reached, blocking, grown, start, free, reached)


def room_for(bodies: Bodies, ground: JoinedFloor, radius: float) -> Shape:
    """Where the centre of a disc of ``radius`` metres may be in a ground, reached or not."""
    blocking = blocking_in(bodies, ground.rooms)
    return _less(_open(ground, radius), _grow_footprints(bodies, blocking, radius))


def blocking_in(bodies: Bodies, within: NDArray[np.int64]) -> NDArray[np.int64]:
    """Rows of the pieces in some rooms that stand in the way: seats can be pushed aside, and a
    piece on or over another takes no floor of its own.

    ``within`` (r,) numbers of the rooms; the rows (k,).
    """
    rows = np.flatnonzero(standing_in(bodies, within) & bodies.underfoot & ~bodies.seat)
    if not len(rows):
        return rows
    wider = shapely.buffer(bodies.footprints[rows], _SLACK, join_style="mitre")
    small, large = shapely.STRtree(wider).query(bodies.footprints[rows], predicate="covered_by")
    area = shapely.area(bodies.footprints[rows])
    under = (area[large] > area[small]) | ((area[large] == area[small]) & (large < small))
    under &= (small != large) & (bodies.low[rows[small]] > _SLACK)
    return np.delete(rows, np.unique(small[under]))


def squeeze_in(bodies: Bodies, ground: JoinedFloor, walk: Walk, within: Shape) -> Shape:
    """Where a person gets who has walked to a narrow room by the route and goes on sideways, as
    a disc of 0.2 m: in the floor of the room and its doorways, and just before them."""
    near = shapely.intersection(ground.floor, shapely.buffer(within, 2 * walk.radius))
    bare = _open(ground._replace(floor=near), ROBOT_RADIUS)
    free = _less(bare, _grow_footprints(bodies, walk.blocking, ROBOT_RADIUS))
    return _select_connected(free, walk.reached)


def _open(ground: JoinedFloor, radius: float) -> Shape:
    """Where the middle of a disc may be in the empty rooms, its head under the ceiling."""
    bare = shapely.buffer(ground.floor, -radius, quad_segs=8)
    return bare if ground.low.is_empty else shapely.difference(bare, ground.low)


def _lower(rooms: Rooms, members: NDArray[np.int64], height: float) -> Shape:
    """The floor of some rooms over which their slopes are lower than a height."""
    sloped = [i for i in members if rooms.spaces[i].slopes]
    return shapely.union_all([lower_than(rooms.spaces[i], rooms.shapes[i], height) for i in sloped])


def _grow_footprints(bodies: Bodies, rows: NDArray[np.int64], radius: float) -> Shapes:
    return np.asarray(shapely.buffer(bodies.footprints[rows], radius, quad_segs=8), object)


def _less(region: Shape, shapes: Shapes) -> Shape:
    return shapely.difference(region, shapely.union_all(shapes)) if len(shapes) else region


def _somewhere_in_largest(region: Shape) -> Shape:
    parts = shapely.get_parts(region)
    if not len(parts):
        return shapely.Point()
    return shapely.point_on_surface(parts[int(np.argmax(shapely.area(parts)))])


def _select_connected(free: Shape, start: Shape) -> Shape:
    """The connected parts of ``free`` that meet ``start``."""
    parts = shapely.get_parts(free)
    return shapely.multipolygons(parts[shapely.intersects(parts, start)])


def walk_without(walk: Walk, away: NDArray[np.int64]) -> Shape:
    """The targets reached if these blocking pieces (indices) were not there.

    ``away`` (k,) rows of ``walk``'s pieces.
    """
    gone = shapely.union_all(walk.grown[away])
    touching = np.setdiff1d(np.flatnonzero(shapely.intersects(walk.grown, gone)), away)
    freed = _less(shapely.intersection(walk.bare, gone), walk.grown[touching])
    return _select_connected(shapely.union(walk.free, freed), walk.start)
