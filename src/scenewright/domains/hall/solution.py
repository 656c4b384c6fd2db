"""From objects placed by hand or by another program to the solution of a hall."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.core.layout import Layouts, NamedBox, check_layouts
from scenewright.core.plan import Plan
from scenewright.core.scene import Size
from scenewright.core.solution import LeftOut, Solution
from scenewright.domains.hall.build_problem import HallContext, build_problem
from scenewright.domains.hall.demands.holdings import HallDemand, collect_demands
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.furnishing.assemble import Laid, assemble_solution
from scenewright.domains.hall.furnishing.layout import furnish_layout
from scenewright.domains.hall.patterns import SINGLE
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.solving import hall_contexts
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.zoning.assign import Unit

FITS = 0.01
"""Metres by which a box may differ from the object it is of."""


def solution_of(
    brief: Brief, layouts: Layouts, *, plan: Plan | None = None, seed: int = 0
) -> Solution:
    """The solution whose objects stand on the boxes given, by the id of their demand.

    Objects of one demand in one zone make a group without pattern; no walls are built between
    zones. What has no box is left out. ``seed`` is for zones that the brief leaves open.
    """
    started = time.perf_counter()
    made = plan or plan_rooms(brief)
    check_layouts(layouts, [space.id for space in made.spaces])
    catalog = catalog_of(brief.catalogs)
    halls = hall_contexts(brief, made.spaces, catalog, seed, 0)
    laid = {
        k: _lay(brief, hall, k, layouts.get(hall.space.id, ()), catalog)
        for k, hall in enumerate(halls)
        if brief.rooms[k].demands
    }
    seconds = time.perf_counter() - started
    return assemble_solution(brief, halls, laid, "default", "given", seed, seconds)


def _lay(
    brief: Brief, hall: HallContext, number: int, rows: Sequence[NamedBox], catalog: Catalog
) -> Laid:
    locked = tuple(piece for piece in hall.fixed if piece.function not in ("", "fixed"))
    asked = collect_demands(brief, number, locked, catalog)
    wishes, units, boxes = _match_boxes(hall, asked, rows)
    missing = tuple(
        LeftOut(hall.space.id, wish.name, "the layout has no place for it", wish.required)
        for wish in asked
        if len(wish.sizes) > sum(row.name == wish.id for row in rows)
    )
    if not units:
        return Laid((), (), (), (), missing, 0.0, 0, None)
    problem = build_problem(hall, wishes, units, (), PRESETS["default"].weights, catalog)
    start = _plain_start(units)
    layout = MeasuredLayout(start, boxes, 0.0, 0.0, 0.0, loose=True)
    fitted = Fitted(units, (), problem, start)
    return furnish_layout(hall, wishes, fitted, layout, locked, missing, 0, catalog)


def _match_boxes(
    hall: HallContext, asked: list[HallDemand], rows: Sequence[NamedBox]
) -> tuple[list[HallDemand], list[Unit], Floats]:
    """Demands with the sizes of what is given, in the order of their boxes (n, 5); a unit for
    every zone of each. InputError for a box that is of no demand."""
    known = {wish.id: k for k, wish in enumerate(asked)}
    left = [list(wish.sizes) for wish in asked]
    taken: list[list[tuple[int, Size, Floats]]] = [[] for _ in asked]
    for number, row in enumerate(rows):
        place = f"{hall.space.id}[{number}] '{row.name}'"
        if row.name not in known:
            rest = ", ".join(known) or "nothing is left to place"
            raise InputError("is not a demand of the hall", f"use one of: {rest}", place=place)
        k = known[row.name]
        wide, deep = row.box[3] + 2 * asked[k].aside, row.box[4] + 2 * asked[k].chairs
        grown = np.array([*row.box[:3], wide, deep])
        taken[k].append((_zone_at(hall, row), _take_size(left[k], grown, place), grown))
    wishes, units, boxes = [], [], []
    for k, wish in enumerate(asked):
        mine = sorted(taken[k], key=lambda one: one[0])
        wishes.append(wish._replace(sizes=tuple(size for _, size, _ in mine)))
        zones = [zone for zone, _, _ in mine]
        units += [
            Unit(k, zone, zones.index(zone), zones.index(zone) + zones.count(zone))
            for zone in dict.fromkeys(zones)
        ]
        boxes += [box for _, _, box in mine]
    return wishes, units, np.array(boxes, np.float64).reshape(-1, 5)


def _take_size(left: list[Size], box: Floats, place: str) -> Size:
    """The size a box is of, taken from those ``left``."""
    if not left:
        raise InputError("is one more than the hall asks for", "raise its count", place=place)
    best = min(left, key=lambda size: math.dist(size[:2], box[3:]))
    if max(abs(best.width - box[3]), abs(best.depth - box[4])) > FITS:
        raise InputError(
            f"is {box[3]:g} x {box[4]:g} m, the object {best.width:g} x {best.depth:g} m",
            "give the box the object's size",
            place=place,
        )
    left.remove(best)
    return best


def _zone_at(hall: HallContext, row: NamedBox) -> int:
    """The number of the zone the middle of a box lies in, else of the nearest."""
    point = shapely.Point(row.box[:2])
    zones = [shapely.Polygon(zone.outline, zone.holes) for zone in hall.plan.zones]
    return int(np.argmin(shapely.distance(zones, point)))


def _plain_start(units: list[Unit]) -> Kept:
    """Units of single objects, for layouts that follow no pattern."""
    counts = np.array([unit.last - unit.first for unit in units], np.int64)
    layers = np.zeros((int(capacity(counts).sum()), 5))
    rows = np.stack([np.full(len(units), SINGLE), np.ones(len(units))], 1).astype(np.float64)
    return Kept(np.zeros((len(units), 4)), layers, rows, np.zeros((0, 2)))
