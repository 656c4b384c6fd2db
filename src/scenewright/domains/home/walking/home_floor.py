"""Where people walk through a whole home, as exact regions of plan: the search's own measure.

A person is a disc of radius r. Its middle may be wherever the disc lies on free floor: with F the
rooms of a storey joined by their doorways and S the obstacles, the region is F less S, eroded
by r (discs as 32-gons), less the floor too low for the head. Metres.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.ceiling import HEADROOM, SHOULDERS, below, planes
from scenewright.building.door_approach import DoorApproach, gates
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.core.space import Opening, Space
from scenewright.domains.home.measures import FLATTEST, HEAD_HEIGHT

Shape = Any  # a shapely geometry
Floats = NDArray[np.float64]

SLACK = 0.01  # what a doorway reaches into its rooms, metres
UNSEEN = 1e-3  # of another room this much may be taken unseen, square metres
ENTERED = 0.1  # how far inside a room the middle of the route has to come, metres
SOFT = ("curtain", "blind")


class HomeFloor(NamedTuple):
    """Rooms joined by doors: the floor of each by id, that of all (``inside``), of each with its
    doorways, of all where there is room for the shoulders, the part of it too ``low`` for the head,
    and the points one comes in by (none: not known). For discs of ``radius`` metres: where their
    middle may be while all is empty (``clear``), where it starts (empty: no entry is known that
    lets it in) and what of this is ``joined`` to the start, which rooms are nowhere as wide as two
    of them side by side (``narrow``), and the floor of each farther than :data:`ENTERED` from its
    walls (``inner``)."""

    rooms: Mapping[str, Shape]
    inside: Shape
    within: Mapping[str, Shape]
    whole: Shape
    low: Shape
    entries: tuple[Shape, ...]
    radius: float
    clear: Shape
    start: Shape
    joined: Shape
    narrow: frozenset[str]
    inner: Mapping[str, Shape]


class Obstacle(NamedTuple):
    """What takes floor a person needs: the id of the piece and its footprint."""

    piece: str
    footprint: Shape


class FloorWalk(NamedTuple):
    """Where the middle of a disc may be on a floor: in the ``empty`` rooms as far as joined to the
    ``start``, everywhere between the obstacles (``free``), and the part of that joined to it."""

    floor: HomeFloor
    obstacles: tuple[Obstacle, ...]
    radius: float
    empty: Shape
    start: Shape
    free: Shape
    reached: Shape


def join_floors(spaces: Sequence[Space], width: float) -> list[HomeFloor]:
    """The floors of rooms that doors and passages join, for routes of ``width`` metres."""
    rooms = {space.id: shapely.Polygon(space.outline, list(space.holes)) for space in spaces}
    doors = _list_doors(spaces)
    return [
        _join([space for space in spaces if space.id in names], rooms, doors, width)
        for names in _find_joined([space.id for space in spaces], doors)
    ]


def _list_doors(spaces: Sequence[Space]) -> list[tuple[DoorApproach, tuple[str, ...]]]:
    """Every opening one walks through, once, and the rooms it is of."""
    known = {space.id for space in spaces}
    found: dict[tuple[Any, ...], tuple[DoorApproach, tuple[str, ...]]] = {}
    for space in spaces:
        for gate in gates(space):
            door = gate.opening
            if door.kind != "window":
                key = (space.level, door.spaces, door.id, door.x, door.y)
                found.setdefault(key, (gate, tuple(s for s in door.spaces if s in known)))
    return list(found.values())


def _find_joined(
    names: Sequence[str], doors: Sequence[tuple[DoorApproach, tuple[str, ...]]]
) -> list[set[str]]:
    """The sets of rooms that doors join, in the order of their first rooms."""
    joined = {name: {name} for name in names}
    for _, rooms in doors:
        if len(rooms) == 2:
            both = joined[rooms[0]] | joined[rooms[1]]
            joined |= dict.fromkeys(both, both)
    return [joined[name] for name in names if name == next(n for n in names if n in joined[name])]


def _join(
    spaces: Sequence[Space],
    rooms: Mapping[str, Shape],
    doors: Sequence[tuple[DoorApproach, tuple[str, ...]]],
    width: float,
) -> HomeFloor:
    mine = [space.id for space in spaces]
    here = [(gate, own, _doorway(gate, len(own) == 1, width)) for gate, own in doors if own]
    here = [row for row in here if row[1][0] in mine]
    ways = {name: [way for _, own, way in here if name in own] for name in mine}
    whole = shapely.union_all([*(rooms[name] for name in mine), *(way for _, _, way in here)])
    whole = whole.difference(_lower_than(spaces, rooms, SHOULDERS))
    low, inside = _lower_than(spaces, rooms, HEADROOM), shapely.union_all([rooms[n] for n in mine])
    entries = _find_entries(spaces, [gate.opening for gate, own, _ in here if len(own) == 1], width)
    clear = erode(whole, (), low, width / 2)
    start = shapely.union_all([entry.buffer(2 * SLACK) for entry in entries])
    start = start if start.intersects(clear) else shapely.Point()
    joined = join_to(start, clear)
    within = {name: shapely.union_all([rooms[name], *ways[name]]) for name in mine}
    shapely.prepare([inside, joined, *within.values()])
    return HomeFloor(
        {name: rooms[name] for name in mine},
        inside,
        within,
        whole,
        low,
        entries,
        width / 2,
        clear,
        start,
        joined,
        frozenset(name for name in mine if _is_narrow(rooms[name], 2 * width)),
        {name: rooms[name].buffer(-ENTERED) for name in mine},
    )


def _is_narrow(room: Shape, wide: float) -> bool:
    """Whether a room is nowhere ``wide`` metres wide."""
    if room.area >= 4 * wide**2:
        return False
    return bool(2 * shapely.maximum_inscribed_circle(room, tolerance=0.005).length < wide)


def _doorway(gate: DoorApproach, outer: bool, width: float) -> Shape:
    """The floor of a doorway, a little into the rooms on both sides; however narrow, a door lets
    the route through, and an outer one goes on outside for as much as a person takes."""
    door, beyond = gate.opening, width if outer else 0.0
    normal = np.array([-door.uy, door.ux])
    normal = normal if normal @ gate.inward > 0 else -normal
    x, y = np.array([door.x, door.y]) - normal * beyond / 2
    heading = float(np.arctan2(normal[1], normal[0]))
    wide = max(door.width, width + 2 * SLACK)
    box = [x, y, heading, wide, door.thickness + 2 * SLACK + beyond]
    return shapely.Polygon(corners(np.array([box]))[0])


def _lower_than(spaces: Sequence[Space], rooms: Mapping[str, Shape], height: float) -> Shape:
    sloped = [space for space in spaces if space.slopes]
    return shapely.union_all(
        [below(rooms[space.id], planes(space), space.height, height) for space in sloped]
    )


def _find_entries(
    spaces: Sequence[Space], outer: Sequence[Opening], width: float
) -> tuple[Shape, ...]:
    """Where one arrives by stairs, else comes in from outside; by doors that are only exits where
    there are no others."""
    away = width / 2 + SLACK
    arrivals = [
        shapely.Point(end.x + away * np.cos(end.heading), end.y + away * np.sin(end.heading))
        for space in spaces
        for end in space.stairs
        if end.arrival
    ]
    doors = [door for door in outer if door.use != "exit"] or outer
    return tuple(arrivals or [shapely.Point(door.x, door.y) for door in doors])


def list_bearing(pieces: Sequence[Piece], floor: HomeFloor, catalog: Catalog) -> tuple[Piece, ...]:
    """Of the pieces of a storey those that bear on one of its floors: all of its own rooms, and of
    others what is in the way there."""
    strange = [p for p in pieces if p.space not in floor.rooms and _takes_floor(p, catalog)]
    if not strange:
        return tuple(p for p in pieces if p.space in floor.rooms)
    shapes = polygons_of(strange)
    met = np.flatnonzero(shapely.intersects(floor.inside, shapes))
    areas = shapely.area(shapely.intersection(shapes[met], floor.inside))
    reaching = {strange[k].id for k, area in zip(met, areas, strict=True) if area > UNSEEN}
    return tuple(p for p in pieces if p.space in floor.rooms or p.id in reaching)


def list_obstacles(pieces: Sequence[Piece], catalog: Catalog) -> tuple[Obstacle, ...]:
    """What is in the way of the ``pieces`` that bear on a floor. Seats are pushed aside, and a
    piece on or over another takes no floor of its own."""
    solid = [p for p in pieces if _takes_floor(p, catalog)]
    shapes = polygons_of(solid)
    carried = _find_carried(np.array([p.pose.z for p in solid]), shapes)
    return tuple(Obstacle(p.id, shapes[k]) for k, p in enumerate(solid) if k not in carried)


def _find_carried(heights: Floats, shapes: NDArray[np.object_]) -> set[int]:
    """Those of the pieces that stand on or hang over one lower than they are."""
    found, bounds = set(), shapely.bounds(shapes)
    for i in np.flatnonzero(heights > SLACK).tolist():
        over = heights < heights[i]
        over &= (bounds[:, :2] <= bounds[i, :2] + 2 * SLACK).all(1)
        over &= (bounds[:, 2:] >= bounds[i, 2:] - 2 * SLACK).all(1)
        if not over.any():
            continue
        wide = shapely.buffer(shapes[over], SLACK, join_style="mitre")
        if shapely.covers(wide, shapes[i]).any():
            found.add(i)
    return found


def _takes_floor(piece: Piece, catalog: Catalog) -> bool:
    kind = catalog.kinds.get(piece.category)
    flat = kind is not None and kind.flat and piece.size.height <= FLATTEST
    aside = kind is not None and bool(kind.under)
    soft = any(word in piece.category for word in SOFT)
    return not (flat or aside or soft) and piece.pose.z < HEAD_HEIGHT


def walk(floor: HomeFloor, obstacles: tuple[Obstacle, ...]) -> FloorWalk:
    """Where a disc of the floor's radius may go that comes in by the entries; where there are none,
    or none that lets it in, it starts in the largest part."""
    start, joined, radius = floor.start, floor.joined, floor.radius
    free = keep_off(floor.clear, [o.footprint for o in obstacles], radius)
    if start.is_empty:
        parts = shapely.get_parts(free if not free.is_empty else floor.clear)
        areas = shapely.area(parts)
        start = parts[int(np.argmax(areas))].point_on_surface() if len(parts) else shapely.Point()
        joined = join_to(start, floor.clear)
    reached = join_to(start, free)
    shapely.prepare(reached)
    return FloorWalk(floor, obstacles, radius, joined, start, free, reached)


def erode(floor: Shape, solid: Sequence[Shape], low: Shape, radius: float) -> Shape:
    """Where the middle of a disc may be on a floor less what is ``solid``, not below what is
    ``low``.

    >>> erode(shapely.box(0, 0, 4, 2), [], shapely.Polygon(), 0.5).bounds
    (0.5, 0.5, 3.5, 1.5)
    """
    clear = floor.difference(shapely.union_all(list(solid))) if len(solid) else floor
    region = clear.buffer(-radius, quad_segs=8)
    return region if low.is_empty else region.difference(low)


def keep_off(clear: Shape, solid: Sequence[Shape], radius: float) -> Shape:
    """Where the middle of a disc may still be when something ``solid`` stands on a floor that is
    ``clear`` for it: what is farther from that than the radius. The same as eroding the floor anew,
    F less S eroded is F eroded less S grown, without the many corners of its rooms.

    >>> keep_off(shapely.box(0.5, 0.5, 3.5, 1.5), [shapely.box(0, 0, 1, 2)], 0.5).bounds
    (1.5, 0.5, 3.5, 1.5)
    """
    if not len(solid):
        return clear
    return clear.difference(shapely.union_all(list(solid)).buffer(radius, quad_segs=8))


def join_to(start: Shape, region: Shape) -> Shape:
    """The parts of a region that meet a start."""
    parts = shapely.get_parts(region)
    return shapely.multipolygons(parts[shapely.intersects(parts, start)])


def reach_without(
    walked: FloorWalk, parts: NDArray[np.object_], away: Sequence[int]
) -> NDArray[np.object_]:
    """What would be reached if some of the obstacles (by number) were not there, as shapes that
    overlap; ``parts`` are those of the free floor.

    Only middles nearer than r to one of them are new, and only what is nearer than 2 r to it bears
    on these.
    """
    radius, floor = walked.radius, walked.floor
    gone = shapely.union_all([walked.obstacles[k].footprint for k in away])
    near = gone.buffer(radius + SLACK, join_style="mitre")
    left = [o.footprint for k, o in enumerate(walked.obstacles) if k not in away]
    others = np.array(left, object)
    others = others[shapely.dwithin(near, others, radius + SLACK)]
    opened = shapely.get_parts(keep_off(floor.clear.intersection(near), others, radius))
    return _join_parts(walked.start, np.concatenate([parts, opened]), len(parts))


def _join_parts(start: Shape, parts: NDArray[np.object_], old: int) -> NDArray[np.object_]:
    """Those of the parts that meet a start or another that does; neither the first ``old`` ones
    meet each other nor the rest."""
    meet = np.zeros((len(parts), len(parts)), bool)
    meet[:old, old:] = shapely.intersects(parts[:old, None], parts[None, old:])
    meet |= meet.T
    joined = np.asarray(shapely.intersects(parts, start))
    while (more := meet[joined].any(axis=0) & ~joined).any():
        joined |= more
    return np.asarray(parts[joined], object)
