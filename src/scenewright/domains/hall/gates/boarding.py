"""What meets a door by its role is set there before all else, once and for all: gates of a zone
that people only leave by in one row before its exit, with barriers back to the wall beside them;
cash machines beside the way in; desks at walls in sight of their door (:mod:`.service`)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import DoorApproach, edges_of, gates
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece, Pose
from scenewright.domains.hall.accessories.stools import COUNTER, STOOL
from scenewright.domains.hall.build_problem import HallContext, taken_floor
from scenewright.domains.hall.classes import QUEUED_AT, is_audience_seat
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.demands.themes import BOARDING, Role
from scenewright.domains.hall.desks.chairs import desk_chairs
from scenewright.domains.hall.furnishing.pieces import make_piece
from scenewright.domains.hall.gates.barriers import make_barriers
from scenewright.domains.hall.gates.nave import furnish_nave
from scenewright.domains.hall.gates.rails import LANE, RowOfGates, WayIn, lay_rails, sides_of
from scenewright.domains.hall.gates.service import (
    Service,
    find_service,
    furnish_service,
    place_ropes,
)
from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.places import walk_edges
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in
from scenewright.domains.hall.visit.roles import GATE
from scenewright.domains.hall.visit.visitor_plan import BELT

BOARDING_OFF = (1.3, 1.9, 2.3)
"""Metres between gates and the exit they stand before, farther where its leaves open inwards."""
BOARDING_LITTLE = 0.005
LANES_OFF, LANES_ASIDE = (2.0, 2.6, 3.4), tuple(0.6 * k for k in range(-9, 10))
"""Metres between a way out and the lanes before it, and beside it, that are tried."""
ROPE, LANE_ROPES = "rope_barrier", 4
"""Barriers of a queue, and the most of them that make one straight lane before desks."""
STOOLS_DEEP, TILLS_APART = 0.9, 1.0
"""Metres before a counter with stools, and between tills with belts."""
BEHIND = "/behind"
"""What the group of goods behind a line is called after that of the others."""
BESIDE_OFF, ALONG_STEP = 0.02, 0.3
"""Metres off the wall of what stands beside a door, and between the places tried."""


class SetAtDoors(NamedTuple):
    """A hall with what stands at its doors, the demands less that, its pieces, and the demands that
    stand so."""

    hall: HallContext
    asked: list[HallDemand]
    pieces: tuple[Piece, ...]
    played: list[HallDemand]


def set_at_doors(
    hall: HallContext, asked: list[HallDemand], catalog: Catalog, roles: tuple[Role, ...]
) -> SetAtDoors:
    """What meets doors by its role in its place there, gates in one row before each exit, desks
    with their staff and queue, where they and the route beside them find free floor."""
    before, lines = asked, list[Service]()
    by_kind, rest, used = {r.category: r for r in roles}, list[HallDemand](), set[str]()
    taken = dict[str, int]()
    found, doors = list[Piece](), {gate.opening.id: gate for gate in gates(hall.space)}
    for way in ways_in(hall.space)[: bool(roles)]:
        asked, pieces = furnish_nave(hall, asked, doors[way.id], catalog)
        hall, found = hall._replace(fixed=(*hall.fixed, *pieces)), [*pieces]
    seats = roles is BOARDING or any(
        is_audience_seat(w.category, 0.0) and not w.facing for w in asked
    )
    boards = seats and any(wish.category == GATE for wish in asked)
    stools = any(wish.category == STOOL for wish in asked)
    winding = any(w.category == ROPE and len(w.sizes) > LANE_ROPES for w in asked)
    for wish in sorted(asked, key=lambda wish: wish.category != GATE):
        role = by_kind.get(wish.category) if wish.unstated else None
        if role is not None and role.stands == "served" and (winding or wish.zones):
            role = None  # what winds, and what a zone says, is laid out by the search
        if role is not None and _has_belts(wish):
            role = role._replace(stands="lanes")
        if role is not None and stools and wish.category == COUNTER:
            role = role._replace(queue=STOOLS_DEEP)
        near = _find_doors(hall, wish, role, boards) if role else []
        free = [door for door in near if door.opening.id not in used or wish.category != GATE]
        goods = _find_goods(asked, role, taken) if role else None
        made = _set_one(hall, wish, role, free, catalog, goods) if role else None
        if made is None:
            rest.append(wish)
            continue
        hall, pieces, door, line = made
        if goods and line:
            taken[goods.id] = len(line.goods)
        found += pieces
        used.add(door)
        lines += [line] if line and wish.category in QUEUED_AT else []
    rest = [w._replace(sizes=w.sizes[taken.get(w.id, 0) :]) for w in rest]
    rest = [w for w in rest if w.sizes]
    names = {wish.id: wish.name for wish in asked}
    desks = tuple(piece for piece in found if piece.function in names)
    chairs = desk_chairs(desks, names, (), tuple(found), catalog)
    hall, rest, ropes = _set_ropes(hall, rest, lines, catalog)
    left = {wish.id for wish in rest}
    played = [wish for wish in before if wish.id not in left]
    return SetAtDoors(hall, rest, (*found, *chairs, *ropes), played)


def _set_ropes(
    hall: HallContext, asked: list[HallDemand], lines: list[Service], catalog: Catalog
) -> tuple[HallContext, list[HallDemand], tuple[Piece, ...]]:
    """Ropes two by two before the first line of desks people queue at, with a lane between them, on
    floor that stays free."""
    wish = next((w for w in asked if w.category == ROPE and w.unstated), None)
    row = place_ropes(hall, lines[0], wish) if wish and lines else None
    if wish is None or row is None:
        return hall, asked, ()
    pieces = _make_row(hall, wish, row, catalog)
    rest = [other for other in asked if other is not wish]
    lane = box_round(row) + np.array([0.0, 0.0, 0.0, hall.route, hall.route])
    queues = (*hall.queues, tuple(lane.tolist()))
    return hall._replace(fixed=(*hall.fixed, *pieces), queues=queues), rest, pieces


def _find_goods(asked: list[HallDemand], role: Role, taken: dict[str, int]) -> HallDemand | None:
    """Goods at walls that are handed over where people are served by a role, as bread: by their
    names."""
    for wish in asked:
        said = f"{wish.id} {wish.name}".casefold()
        mine = wish.at_wall and wish.unstated and wish.id not in taken and not wish.zones
        if mine and any(word in said for word in role.behind.split()):
            return wish
    return None


def _has_belts(wish: HallDemand) -> bool:
    """Whether a demand is of several tills with lanes between them."""
    belts = wish.category == "checkout" and len(wish.sizes) > 1
    return belts and min(size.depth for size in wish.sizes) > BELT


def _set_one(
    hall: HallContext,
    wish: HallDemand,
    role: Role,
    doors: list[DoorApproach],
    catalog: Catalog,
    goods: HallDemand | None,
) -> tuple[HallContext, tuple[Piece, ...], str, Service | None] | None:
    """The hall with a demand at the first door that has room for it, its pieces, that door, and the
    line of desks they are."""
    for door in doors:
        if role.stands == "served":
            place = find_service(hall, wish, role, door, goods.sizes if goods else ())
            if place is None:
                place = find_service(hall, wish, role, door, ())
            if place is None:
                continue
            pieces, stand = furnish_service(hall, wish, place, catalog)
            if goods:
                pieces = (*pieces, *_make_row(hall, goods, place.goods, catalog, BEHIND))
            free = (tuple(place.queue), *map(tuple, place.way))
            hall = hall._replace(fixed=(*hall.fixed, *stand), queues=(*hall.queues, *free))
            return hall, pieces, door.opening.id, place
        row = next((r for r in _line_up(hall, wish, role, door) if _is_free(hall, r, role)), None)
        if row is None:
            continue
        pieces = _make_row(hall, wish, row, catalog)
        if wish.category == GATE:
            rails = _lay_rails(hall, door, row, hall.fixed)
            name = f"{hall.space.id}/{wish.id}"
            pieces = (*pieces, *make_barriers(hall.space, name, wish.id, rails, catalog))
        return hall._replace(fixed=(*hall.fixed, *pieces)), pieces, door.opening.id, None
    return None


def _find_doors(
    hall: HallContext, wish: HallDemand, role: Role, boards: bool
) -> list[DoorApproach]:
    """The doors a demand is set at: the main entrance, or those visitors leave by; where one
    ``boards``, those that nobody comes in by; of gates else those visitors leave their zone by, if
    none comes in there."""
    ways = [door.id for door in ways_in(hall.space)]
    leave = [door.id for door in visitor_exits(hall.space)]
    near = {gate.opening.id: gate for gate in gates(hall.space)}
    if len(wish.zones) == 1:
        outline = hall.plan.zones[hall.names.index(wish.zones[0])].outline
        low, high = outline.min(0) - DOOR_OUTSIDE, outline.max(0) + DOOR_OUTSIDE
        near = {name: gate for name, gate in near.items() if _lies_in(gate.face, low, high)}
    only = [name for name in leave if name not in ways]
    if wish.category == GATE:
        named = len(wish.zones) == 1 and not any(name in near for name in ways)
        leave = only if boards and len(wish.zones) != 1 else leave if named else []
    return [near[name] for name in (ways[:1] if role.door == "in" else leave) if name in near]


def _lies_in(point: Floats, low: Floats, high: Floats) -> bool:
    return bool((low <= point).all() and (point <= high).all())


def _line_up(
    hall: HallContext, wish: HallDemand, role: Role, door: DoorApproach
) -> Iterator[Floats]:
    """Boxes (n, 5) side by side across the way to a door, looking into the room; of what stands
    beside it at walls, the nearest to it first."""
    long = sum(size.width for size in wish.sizes)
    if role.stands == "lanes":
        yield from _line_lanes(wish, door)
        return
    if role.stands == "across":
        for off in BOARDING_OFF:
            yield _stand_along(wish, door.face, door.inward, -0.5 * long, off)
        return
    rows, sign = list[tuple[float, Floats]](), -1.0 if role.stands == "far" else 1.0
    right = np.array([door.inward[1], -door.inward[0]])
    half = 0.5 * door.opening.width * right
    way = shapely.LineString([door.face - half, door.face + half])
    walls = [(w.x0, w.y0, w.x1, w.y1) for one in hall.walls for w in one]
    for start, along, left, length in walk_edges(np.array(walls).reshape(-1, 4)):
        for at in np.arange(0.5 * long, length - 0.5 * long + 1e-9, ALONG_STEP):
            row = _stand_along(wish, start + at * along, left, -0.5 * long, BESIDE_OFF)
            far = float(shapely.polygons(corners(box_round(row)[None]))[0].distance(way))
            rows += [(far * sign, row)] if role.least <= far <= role.within else []
    yield from (row for _, row in sorted(rows, key=lambda one: one[0]))


def _line_lanes(wish: HallDemand, door: DoorApproach) -> Iterator[Floats]:
    """Boxes (n, 5) of tills side by side before a door, their lanes leading to it."""
    right, size = np.array([door.inward[1], -door.inward[0]]), wish.sizes[0]
    pitch, turn = size.depth + TILLS_APART, float(np.arctan2(right[1], right[0]))
    at = pitch * (np.arange(len(wish.sizes)) - 0.5 * (len(wish.sizes) - 1))
    for off in LANES_OFF:
        for aside in sorted(LANES_ASIDE, key=abs):
            start = door.face + (off + 0.5 * size.width) * door.inward + aside * right
            boxes = np.empty((len(at), 5))
            boxes[:, :2] = start + at[:, None] * right
            boxes[:, 2:] = turn, size.width, size.depth
            yield boxes


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


def _is_free(hall: HallContext, row: Floats, role: Role) -> bool:
    """Whether boxes (n, 5) lie on the free floor of a hall with the route beside them on one side,
    or before those at walls."""
    heading, half = float(row[0, 2]), 0.5 * hall.route
    ahead = np.array([np.cos(heading), np.sin(heading)])
    aside = np.array([ahead[1], -ahead[0]])
    across = role.stands in ("across", "lanes")
    taken = shapely.polygons(corners(taken_floor(hall)))
    floor = shapely.Polygon(hall.space.outline, hall.space.holes)
    for way, side in ((aside, 3), (-aside, 3)) if across else ((ahead, 4),):
        wider = row - np.array([0.0, 0.0, 0.0, 0.0, 2.0 * BOARDING_LITTLE])
        wider[:, :2] += half * way
        wider[:, side] += hall.route
        needed = shapely.union_all(shapely.polygons(corners(wider)))
        if floor.covers(needed) and not shapely.intersects(taken, needed).any():
            return True
    return False


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
    hall: HallContext, wish: HallDemand, row: Floats, catalog: Catalog, beside: str = ""
) -> tuple[Piece, ...]:
    """The pieces of some gates, or the first of some goods, at their boxes (n, 5)."""
    group = f"{hall.space.id}/{wish.id}{beside}"
    return tuple(
        make_piece(hall, wish, group, number, (Pose(x, y, 0.0, turn), size), catalog)
        for number, (size, (x, y, turn, *_)) in enumerate(
            zip(wish.sizes, row.tolist(), strict=False), 1
        )
    )
