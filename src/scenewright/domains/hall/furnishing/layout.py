"""A layout of a hall with all that comes to it: walls, chairs, rails, small objects, its tour."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.accessories.pieces import furnish_accessories
from scenewright.domains.hall.accessories.place import StandingHall
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.desks.chairs import desk_chairs
from scenewright.domains.hall.desks.staff_room import grow_to_floor
from scenewright.domains.hall.energy import parts_of
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.furnishing.assemble import Laid
from scenewright.domains.hall.furnishing.pieces import furnish_hall, kept_groups, placed_groups
from scenewright.domains.hall.furnishing.voids import fill_voids
from scenewright.domains.hall.gates.barriers import place_barriers
from scenewright.domains.hall.gates.barring_ropes import find_served_at
from scenewright.domains.hall.gates.fewer_ropes import place_fewer_of_each
from scenewright.domains.hall.gates.idle_guides import (
    drop_units,
    find_barring,
    find_idle,
    report_idle,
)
from scenewright.domains.hall.hall_layout import HallLayout
from scenewright.domains.hall.search import HallSearch, may_retry
from scenewright.domains.hall.seats.asked_low_tables import set_low_tables
from scenewright.domains.hall.seats.chairs import with_chairs
from scenewright.domains.hall.seats.lounges import part_lounges
from scenewright.domains.hall.seats.reachable import keep_drawn_back, keep_reached_chairs
from scenewright.domains.hall.seats.seating import seat_chairs
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, measure_layout
from scenewright.domains.hall.visit.tour import tour
from scenewright.domains.hall.walls.built import partitions


def furnish_guided(
    search: HallSearch,
    fitted: Fitted,
    best: MeasuredLayout,
    locked: tuple[Piece, ...],
    missing: tuple[LeftOut, ...],
    seen: int,
) -> Laid:
    """A furnished hall without gates beside which the way stays open and ropes before nothing."""
    hall, wishes, catalog = search.hall, search.wishes, search.catalog
    stopped = search.passes.cancelled
    laid = furnish_layout(hall, wishes, fitted, best, locked, missing, seen, catalog, stopped)
    if not may_retry(search) or stopped():
        return laid
    served = find_served_at(laid.pieces)
    idle = find_barring(search, fitted, best, served) | find_idle(wishes, fitted, best, laid.pieces)
    if not idle:
        return laid
    fitted, best, idle, fewer = place_fewer_of_each(search, fitted, best, idle, served)
    missing = (*missing, *fewer, *report_idle(hall, wishes, fitted, idle))
    fitted, best = drop_units(hall, wishes, fitted, best, idle, catalog)
    return furnish_layout(hall, wishes, fitted, best, locked, missing, seen, catalog, stopped)


def furnish_layout(
    hall: HallContext,
    wishes: list[HallDemand],
    fitted: Fitted,
    best: MeasuredLayout,
    locked: tuple[Piece, ...],
    missing: tuple[LeftOut, ...],
    evaluations: int,
    catalog: Catalog,
    stopped: Callable[[], bool] = lambda: False,
) -> Laid:
    """A hall with the objects of a layout, its walls, chairs, groups, terms and tour; once
    ``stopped``, without what is set last."""
    p, s, lost = measure_layout(fitted.problem, best)
    objects = furnish_hall(hall, wishes, fitted.units, fitted.problem, best.boxes, catalog)
    walls = partitions(hall, fitted.problem, best.kept, best.boxes, catalog)
    joined, alone = seat_chairs(hall, wishes, objects, (*hall.fixed, *walls), catalog)
    served = {wish.id for wish in wishes if wish.seated}
    tables = tuple(piece for piece in objects if piece.function not in served)
    standing = (*hall.fixed, *walls, *(p for p in objects if p.function in served), *joined)
    bringing = {wish.id for wish in wishes if wish.chairs} - served
    brought = with_chairs(tables, standing, catalog, bringing)
    chairs = (*joined, *keep_drawn_back(hall.space, brought))
    groups = (
        *kept_groups(hall, locked),
        *placed_groups(hall, wishes, fitted.units, fitted.problem, best.kept, objects),
    )
    around = (*hall.fixed, *walls)
    measured = best._replace(missed=lost)
    low, seatless = set_low_tables(
        hall, wishes, groups, (*objects, *chairs), around, fitted.problem, measured, catalog
    )
    low += _seat_desks(hall, wishes, fitted, best, objects, (*around, *chairs, *low), catalog)
    solid = np.array([boxes_of(piece)[0] for piece in (*around, *chairs, *low)])
    solid = solid.reshape(-1, 5)
    demands = {group.id: group.demand for group in groups}
    rails = place_barriers(hall.space, fitted.problem, best, solid, demands, catalog)
    parts = parts_of(fitted.problem, p, s, lost)
    known = {wish.id: wish for wish in part_lounges(wishes)}
    grown = (grow_to_floor(piece, known[piece.function], catalog) for piece in objects)
    every = (*around, *grown, *low, *rails)
    standing_hall = StandingHall(hall, fitted.problem, best, wishes, every)
    small, more, lost_small = furnish_accessories(standing_hall, catalog, stopped)
    groups, small = (*groups, *more), (*small, *fill_voids(hall, (*every, *small), catalog))
    layout = HallLayout(hall.plan.zones, hall.plan.links, groups, tuple(w.id for w in walls))
    way = tour(hall.space, (*every, *small), layout, catalog, hall.route)
    return Laid(
        (*walls, *objects, *chairs, *low, *rails, *small),
        groups,
        layout.partitions,
        parts,
        (*missing, *alone, *seatless, *lost_small),
        sum(part.cost for part in parts),
        evaluations,
        way,
    )


def _seat_desks(
    hall: HallContext,
    wishes: list[HallDemand],
    fitted: Fitted,
    best: MeasuredLayout,
    objects: tuple[Piece, ...],
    others: tuple[Piece, ...],
    catalog: Catalog,
) -> tuple[Piece, ...]:
    """The chairs of desks among ``objects``; none where groups stay as printed."""
    if hall.settings.whole:
        return ()
    solid = (*objects, *others)
    names = {wish.id: f"{wish.id} {wish.name}" for wish in part_lounges(wishes)}
    served = {wish.id for wish in wishes if wish.seated}
    found = desk_chairs(objects, names, served, solid, catalog)
    return keep_reached_chairs(hall.space, fitted.problem, best, found, solid)
