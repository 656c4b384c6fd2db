"""Gates asked for in a zone that people only leave by stand in one row before its exit, as boarding
gates do, with barriers back to the wall beside them; where people sit and wait to board, so do the
desks beside that door. They are set before all else."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
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
from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in
from scenewright.domains.hall.visit.roles import GATE

BOARDING_OFF = (1.3, 1.9, 2.3)
"""Metres between gates and the exit they stand before, farther where its leaves open inwards."""
BOARDING_LITTLE = 0.005
DESK, DESK_OFF_WALL, DESK_BESIDE = "counter", 0.9, (0.5, 0.9, 1.5, 2.2, 3.0)
"""What one is served at before boarding, metres for staff behind it, and how far beside the door it
is tried."""


class SetGates(NamedTuple):
    """A hall with boarding gates, the demands less those of them, and the gates."""

    hall: HallContext
    asked: list[HallDemand]
    pieces: tuple[Piece, ...]


def set_boarding_gates(
    hall: HallContext, asked: list[HallDemand], catalog: Catalog, together: bool = False
) -> SetGates:
    """Boarding gates before the exits of their zones, one row before each, where they and the route
    on both sides of them find free floor; none where all are laid out ``together``."""
    used, rest, found = set[str](), list[HallDemand](), list[Piece]()
    seats = any(is_audience_seat(w.category, 0.0) and not w.facing for w in asked)
    boards = seats and any(wish.category == GATE for wish in asked)
    for wish in sorted(asked, key=lambda wish: wish.category != GATE):
        doors = [] if together else _find_exits(hall, wish, boards)
        exits = [door for door in doors if door.opening.id not in used or wish.category == DESK]
        there = (*hall.fixed, *found)
        rows = ((door, line) for door in exits for line in _line_up(wish, door))
        fits = _is_served if wish.category == DESK else _is_free
        row = next((row for row in rows if fits(hall, row[1], there)), None)
        if row is None:
            rest.append(wish)
            continue
        used.add(row[0].opening.id)
        found += _make_row(hall, wish, row[1], catalog)
        if wish.category == DESK:
            continue
        name = f"{hall.space.id}/{wish.id}"
        rails = _lay_rails(hall, row[0], row[1], there)
        found += make_barriers(hall.space, name, wish.id, rails, catalog)
    return SetGates(hall._replace(fixed=(*hall.fixed, *found)), rest, tuple(found))


def _find_exits(hall: HallContext, wish: HallDemand, boards: bool) -> list[DoorApproach]:
    """The doors visitors leave by in the zone of some gates, if none comes in there; of a hall
    where one ``boards``, of gates and desks those that nobody comes in by."""
    gate = wish.category == GATE
    if not wish.unstated or not (gate or (boards and wish.category == DESK)):
        return []
    if boards and len(wish.zones) != 1:
        ways = {door.id for door in ways_in(hall.space)}
        leave = [door.id for door in visitor_exits(hall.space) if door.id not in ways]
        return [g for g in gates(hall.space) if g.opening.id in leave]
    if not gate or len(wish.zones) != 1:
        return []
    outline = hall.plan.zones[hall.names.index(wish.zones[0])].outline
    low, high = outline.min(0) - DOOR_OUTSIDE, outline.max(0) + DOOR_OUTSIDE
    near = {g.opening.id: g for g in gates(hall.space) if _lies_in(g.face, low, high)}
    if any(door.id in near for door in ways_in(hall.space)):
        return []
    return [near[door.id] for door in visitor_exits(hall.space) if door.id in near]


def _lies_in(point: Floats, low: Floats, high: Floats) -> bool:
    return bool((low <= point).all() and (point <= high).all())


def _line_up(wish: HallDemand, door: DoorApproach) -> Iterator[Floats]:
    """Boxes (n, 5) of gates side by side across the way to a door, looking into the room; of desks
    beside it on either side, with room for staff behind, some metres farther each time."""
    long = sum(size.width for size in wish.sizes)
    if wish.category == DESK:
        for beside, side in product(DESK_BESIDE, (1.0, -1.0)):
            at = side * (0.5 * (door.opening.width + long) + beside)
            yield _stand_along(wish, door, at - 0.5 * long, max(DESK_OFF_WALL, wish.clearance[2]))
        return
    for off in BOARDING_OFF:
        yield _stand_along(wish, door, -0.5 * long, off)


def _stand_along(wish: HallDemand, door: DoorApproach, at: float, off: float) -> Floats:
    """Boxes (n, 5) in a row along the wall of a door from ``at`` metres to its right on, ``off``
    metres from the wall."""
    heading, right = np.arctan2(*door.inward[::-1]), np.array([door.inward[1], -door.inward[0]])
    found = list[list[float]]()
    for size in wish.sizes:
        middle = door.face + (off + 0.5 * size.depth) * door.inward
        x, y = middle + (at + 0.5 * size.width) * right
        found.append([float(x), float(y), float(heading), size.width, size.depth])
        at += size.width
    return np.array(found)


def _is_free(hall: HallContext, row: Floats, there: tuple[Piece, ...]) -> bool:
    """Whether boxes (n, 5) and the route beside them lie on the free floor of a hall."""
    return _covers(hall, row + np.array([0.0, 0.0, 0.0, 2.0 * hall.route, 0.0]), there)


def _is_served(hall: HallContext, row: Floats, there: tuple[Piece, ...]) -> bool:
    """Whether boxes (n, 5), the route at one end of them and before them lie on free floor."""
    box, turn = box_round(row), float(row[0, 2])
    ahead = np.array([np.cos(turn), np.sin(turn)])
    aside = 0.5 * hall.route * np.array([ahead[1], -ahead[0]])
    wider = np.append(box[:2] + 0.5 * hall.route * ahead, box[2:])
    wider += np.array([0.0, 0.0, 0.0, hall.route, hall.route])
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
