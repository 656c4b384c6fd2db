"""Gates asked for in a zone that people only leave by stand in one row before its exit, as boarding
gates do, with barriers back to the wall beside them; they are set before all else."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.door_approach import DoorApproach, edges_of, gates
from scenewright.core.catalog import Catalog
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece, Pose
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.furnishing.pieces import make_piece
from scenewright.domains.hall.gates.barriers import make_barriers
from scenewright.domains.hall.gates.rails import LANE, RowOfGates, WayIn, lay_rails, sides_of
from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in
from scenewright.domains.hall.visit.roles import GATE

BOARDING_OFF = 1.3
"""Metres between gates and the exit they stand before."""
BOARDING_LITTLE = 0.005


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
    for wish in asked:
        doors = [] if together else _find_exits(hall, wish)
        exits = [door for door in doors if door.opening.id not in used]
        there = (*hall.fixed, *found)
        rows = ((door, _line_up(wish, door)) for door in exits)
        row = next((row for row in rows if _is_free(hall, row[1], there)), None)
        if row is None:
            rest.append(wish)
            continue
        used.add(row[0].opening.id)
        found += _make_row(hall, wish, row[1], catalog)
        name = f"{hall.space.id}/{wish.id}"
        rails = _lay_rails(hall, row[0], row[1], there)
        found += make_barriers(hall.space, name, wish.id, rails, catalog)
    return SetGates(hall._replace(fixed=(*hall.fixed, *found)), rest, tuple(found))


def _find_exits(hall: HallContext, wish: HallDemand) -> list[DoorApproach]:
    """The doors visitors leave by in the zone of some gates, if none comes in there."""
    if wish.category != GATE or not wish.unstated or len(wish.zones) != 1:
        return []
    outline = hall.plan.zones[hall.names.index(wish.zones[0])].outline
    low, high = outline.min(0) - DOOR_OUTSIDE, outline.max(0) + DOOR_OUTSIDE
    near = {g.opening.id: g for g in gates(hall.space) if _lies_in(g.face, low, high)}
    if any(door.id in near for door in ways_in(hall.space)):
        return []
    return [near[door.id] for door in visitor_exits(hall.space) if door.id in near]


def _lies_in(point: Floats, low: Floats, high: Floats) -> bool:
    return bool((low <= point).all() and (point <= high).all())


def _line_up(wish: HallDemand, door: DoorApproach) -> Floats:
    """Boxes (n, 5) of gates side by side across the way to a door, looking into the room."""
    heading, right = np.arctan2(*door.inward[::-1]), np.array([door.inward[1], -door.inward[0]])
    at, found = -0.5 * sum(size.width for size in wish.sizes), list[list[float]]()
    for size in wish.sizes:
        middle = door.face + (BOARDING_OFF + 0.5 * size.depth) * door.inward
        x, y = middle + (at + 0.5 * size.width) * right
        found.append([float(x), float(y), float(heading), size.width, size.depth])
        at += size.width
    return np.array(found)


def _is_free(hall: HallContext, row: Floats, there: tuple[Piece, ...]) -> bool:
    """Whether boxes (n, 5) and the route beside them lie on the free floor of a hall."""
    wider = row + np.array([0.0, 0.0, 0.0, 2.0 * hall.route, -2.0 * BOARDING_LITTLE])
    needed = shapely.union_all(shapely.polygons(corners(wider)))
    solid = [box for piece in there for box in boxes_of(piece)]
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
