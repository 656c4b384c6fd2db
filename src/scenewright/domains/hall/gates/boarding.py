"""What meets a door is set there before all else, once and for all: gates of a zone that people
only leave by stand in one row before its exit, with barriers back to the wall beside them, and
where people sit and wait to board, so do the desks beside it; cash machines stand beside the way
in."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import DoorApproach, door_zone, edges_of, gates
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece, Pose
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.classes import is_audience_seat
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.furnishing.pieces import make_piece
from scenewright.domains.hall.gates.barriers import make_barriers
from scenewright.domains.hall.gates.rails import LANE, RowOfGates, WayIn, lay_rails, sides_of
from scenewright.domains.hall.measures import DOOR_OUTSIDE, QUEUE
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.places import walk_edges
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in
from scenewright.domains.hall.visit.roles import GATE

BOARDING_OFF = (1.3, 1.9, 2.3)
"""Metres between gates and the exit they stand before, farther where its leaves open inwards."""
BOARDING_LITTLE = 0.005
BESIDE_LEAST, ALONG_STEP = 0.5, 0.3
"""Metres between a door and what stands beside it at least, and between the places tried."""


class DoorRole(NamedTuple):
    """What of a ``category`` stands at a door: one people only ``leave`` by, else the main
    entrance; across the way to it, or ``beside`` it at walls within so many metres, ``off`` these,
    with floor ``before`` it for those who come."""

    category: str
    leave: bool
    beside: float = 0.0
    off: float = 0.0
    before: float = 0.0


DOOR_ROLES = {
    role.category: role
    for role in (
        DoorRole(GATE, leave=True),
        DoorRole("counter", leave=True, beside=4.5, off=0.9, before=QUEUE),
        DoorRole("cash_machine", leave=False, beside=5.0, off=0.02),
    )
}
"""By category; gates come first."""


class SetAtDoors(NamedTuple):
    """A hall with what stands at its doors, the demands less that, and its pieces."""

    hall: HallContext
    asked: list[HallDemand]
    pieces: tuple[Piece, ...]


def set_at_doors(
    hall: HallContext, asked: list[HallDemand], catalog: Catalog, together: bool = False
) -> SetAtDoors:
    """What meets doors in its place there, gates in one row before each exit, where they and the
    route beside them find free floor; none where all are laid out ``together``."""
    used, rest, found = set[str](), list[HallDemand](), list[Piece]()
    seats = any(is_audience_seat(w.category, 0.0) and not w.facing for w in asked)
    boards = seats and any(wish.category == GATE for wish in asked)
    for wish in sorted(asked, key=lambda wish: wish.category != GATE):
        role = None if together or not wish.unstated else DOOR_ROLES.get(wish.category)
        doors = _find_doors(hall, wish, role, boards) if role else []
        free = [d for d in doors if d.opening.id not in used or wish.category != GATE]
        there = (*hall.fixed, *found)
        rows = ((door, line) for door in free for line in _line_up(hall, wish, door))
        ahead = max(role.before if role else 0.0, hall.route)
        fits = _is_free if wish.category == GATE else partial(_is_served, ahead)
        row = next((row for row in rows if fits(hall, row[1], there)), None)
        if row is None:
            rest.append(wish)
            continue
        used.add(row[0].opening.id)
        found += _make_row(hall, wish, row[1], catalog)
        if wish.category == GATE:
            name = f"{hall.space.id}/{wish.id}"
            rails = _lay_rails(hall, row[0], row[1], there)
            found += make_barriers(hall.space, name, wish.id, rails, catalog)
    return SetAtDoors(hall._replace(fixed=(*hall.fixed, *found)), rest, tuple(found))


def _find_doors(
    hall: HallContext, wish: HallDemand, role: DoorRole, boards: bool
) -> list[DoorApproach]:
    """The doors a demand is set at: of what stands at the entrance, the main one, if it is in its
    zone; of a hall where one ``boards``, those that nobody comes in by; else of gates those
    visitors leave their zone by, if none comes in there."""
    ways = [door.id for door in ways_in(hall.space)]
    leave = [door.id for door in visitor_exits(hall.space)]
    if len(wish.zones) == 1:
        outline = hall.plan.zones[hall.names.index(wish.zones[0])].outline
        low, high = outline.min(0) - DOOR_OUTSIDE, outline.max(0) + DOOR_OUTSIDE
        near = {g.opening.id: g for g in gates(hall.space) if _lies_in(g.face, low, high)}
    else:
        near = {g.opening.id: g for g in gates(hall.space)}
    if not role.leave:
        return [near[name] for name in ways[:1] if name in near]
    if boards and len(wish.zones) != 1:
        return [near[name] for name in leave if name not in ways]
    if wish.category != GATE or len(wish.zones) != 1 or any(name in near for name in ways):
        return []
    return [near[name] for name in leave if name in near]


def _lies_in(point: Floats, low: Floats, high: Floats) -> bool:
    return bool((low <= point).all() and (point <= high).all())


def _line_up(hall: HallContext, wish: HallDemand, door: DoorApproach) -> Iterator[Floats]:
    """Boxes (n, 5) of gates side by side across the way to a door, looking into the room; of what
    stands beside it at walls, the nearest to it first."""
    role, long = DOOR_ROLES[wish.category], sum(size.width for size in wish.sizes)
    if not role.beside:
        for off in BOARDING_OFF:
            yield _stand_along(wish, door.face, door.inward, -0.5 * long, off)
        return
    rows = list[tuple[float, Floats]]()
    right = np.array([door.inward[1], -door.inward[0]])
    half = 0.5 * door.opening.width * right
    way = shapely.LineString([door.face - half, door.face + half])
    walls = [(w.x0, w.y0, w.x1, w.y1) for one in hall.walls for w in one]
    for start, along, left, length in walk_edges(np.array(walls).reshape(-1, 4)):
        for at in np.arange(0.5 * long, length - 0.5 * long + 1e-9, ALONG_STEP):
            off = max(role.off, wish.clearance[2] if role.before else 0.0)
            row = _stand_along(wish, start + at * along, left, -0.5 * long, off)
            far = float(shapely.polygons(corners(box_round(row)[None]))[0].distance(way))
            rows += [(far, row)] if BESIDE_LEAST <= far <= role.beside else []
    yield from (row for _, row in sorted(rows, key=lambda one: one[0]))


def _stand_along(wish: HallDemand, face: Floats, inward: Floats, at: float, off: float) -> Floats:
    """Boxes (n, 5) in a row along a wall from ``at`` metres to the right of a point on it, ``off``
    metres from the wall, and looking ``inward``."""
    heading, right = np.arctan2(*inward[::-1]), np.array([inward[1], -inward[0]])
    found = list[list[float]]()
    for size in wish.sizes:
        middle = face + (off + 0.5 * size.depth) * inward
        x, y = middle + (at + 0.5 * size.width) * right
        found.append([float(x), float(y), float(heading), size.width, size.depth])
        at += size.width
    return np.array(found)


def _is_free(hall: HallContext, row: Floats, there: tuple[Piece, ...]) -> bool:
    """Whether boxes (n, 5) and the route beside them lie on the free floor of a hall."""
    return _covers(hall, row + np.array([0.0, 0.0, 0.0, 2.0 * hall.route, 0.0]), there)


def _is_served(deep: float, hall: HallContext, row: Floats, there: tuple[Piece, ...]) -> bool:
    """Whether boxes (n, 5), the route at one end of them and floor so ``deep`` before them are
    free."""
    box, turn = box_round(row), float(row[0, 2])
    ahead = np.array([np.cos(turn), np.sin(turn)])
    aside = 0.5 * hall.route * np.array([ahead[1], -ahead[0]])
    wider = np.append(box[:2] + 0.5 * deep * ahead, box[2:])
    wider += np.array([0.0, 0.0, 0.0, hall.route, deep])
    ends = (np.append(wider[:2] + side * aside, wider[2:]) for side in (1.0, -1.0))
    return any(_covers(hall, end[None], there) for end in ends)


def _covers(hall: HallContext, boxes: Floats, there: tuple[Piece, ...]) -> bool:
    """Whether the floor of a hall that is free of pieces covers boxes (n, 5)."""
    little = np.array([0.0, 0.0, 0.0, 0.0, 2.0 * BOARDING_LITTLE])
    needed = shapely.union_all(shapely.polygons(corners(boxes - little)))
    solid = [box for piece in there for box in boxes_of(piece)]
    solid += [list(box) for gate in gates(hall.space) for box in door_zone(hall.space, gate)]
    taken = shapely.polygons(corners(np.array(solid).reshape(-1, 5)))
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    return bool(floor.covers(needed) and not shapely.intersects(taken, needed).any())


def _lay_rails(
    hall: HallContext, door: DoorApproach, gates: Floats, there: tuple[Piece, ...]
) -> Floats:
    """Boxes (k, 5) of the rails beside gates (n, 5) back to the wall of their door, a wide gate at
    one end; none where they would not stand free."""
    way = WayIn(door.face, door.inward, 0.5 * door.opening.width, max(LANE, hall.route))
    others = np.array([box for piece in there for box in boxes_of(piece)]).reshape(-1, 5)
    row = RowOfGates(box_round(gates), way, others, others)
    stops = np.concatenate([edges_of(hall.space), sides_of(others)])
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    taken = shapely.polygons(corners(np.concatenate([others, gates])))
    for side in (1, -1):
        rails = lay_rails(stops, row, side)
        needed = shapely.polygons(corners(rails))
        free = bool(floor.covers(shapely.union_all(needed)))
        if free and not shapely.intersects(needed[:, None], taken[None, :]).any():
            return rails
    return np.zeros((0, 5))


def _make_row(
    hall: HallContext, wish: HallDemand, row: Floats, catalog: Catalog
) -> tuple[Piece, ...]:
    """The pieces of some gates at their boxes (n, 5)."""
    group = f"{hall.space.id}/{wish.id}"
    return tuple(
        make_piece(hall, wish, group, number, (Pose(x, y, 0.0, turn), size), catalog)
        for number, (size, (x, y, turn, *_)) in enumerate(
            zip(wish.sizes, row.tolist(), strict=True), 1
        )
    )
