"""Making a hall's demands fit: units that find no room are split, then made smaller, with reasons.

A first layout is looked for with growing effort. A unit without a place is split in two; one that
is a few objects only goes to another zone it may stand in, or gives objects up.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.domains.hall.build_problem import (
    HallContext,
    build_problem,
    taken_floor,
    wall_lengths,
    zone_areas,
)
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.gates.by_door import share_among_doors
from scenewright.domains.hall.problem import THICKNESS, Floats, HallProblem
from scenewright.domains.hall.shortfall.absent import list_absent
from scenewright.domains.hall.shortfall.unplaceable import drop_unplaceable
from scenewright.domains.hall.solvers.chains import anneal_hall, first_layout
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.visit.roles import GATE
from scenewright.domains.hall.walls.clear_of_openings import clear_hosts
from scenewright.domains.hall.walls.partitions import (
    Host,
    hosts,
    lacking,
    short_of,
    standing_hosts,
    stands_free,
    visiting_order,
)
from scenewright.domains.hall.zoning.assign import Unit, assign
from scenewright.engine.solve import Budget, Cancel

NOTHING = Kept(np.zeros((0, 4)), np.zeros((0, 5)), np.zeros((0, 2)), np.zeros((0, 2)))


class Fitted(NamedTuple):
    """Units that all have a place, the problem they make and a first layout."""

    units: list[Unit]
    hosts: tuple[Host, ...]
    problem: HallProblem
    start: Kept


def fit(
    hall: HallContext,
    wishes: list[HallDemand],
    weights: dict[str, float],
    catalog: Catalog,
    seed: int,
    whole: bool,
    cancel: Cancel | None = None,
) -> Fitted:
    """Assign, pose and place; see the module. When ``cancel`` answers true, what found no room so
    far is left out.

    Walls that stand free in a zone are built where everything fits with them. Where only a little
    does not fit, other first layouts are tried; else more is left out until the route reaches
    what stays.
    """
    asked, rule = sum(len(wish.sizes) for wish in wishes), hall.settings.fit
    for chance in range(rule.chances):
        other, share = seed + 7 * chance, rule.shares[0]
        free = chance == 0 and not whole
        fitted = _fit(hall, wishes, weights, catalog, other, whole, share, cancel, free)
        missing = asked - sum(unit.last - unit.first for unit in fitted.units)
        if missing == 0 or (cancel is not None and cancel()):
            return fitted
        if missing > max(2, rule.little * asked) and not any(map(stands_free, fitted.hosts)):
            break
    for share in rule.shares:
        fitted = _fit(hall, wishes, weights, catalog, seed, whole, share, cancel)
        placed = sum(unit.last - unit.first for unit in fitted.units)
        if placed in (0, asked) or (cancel is not None and cancel()):
            break
        if _all_reached(fitted.problem, fitted.start, seed, rule.looked):
            break
    return fitted


def _fit(
    hall: HallContext,
    wishes: list[HallDemand],
    weights: dict[str, float],
    catalog: Catalog,
    seed: int,
    whole: bool,
    share: float,
    cancel: Cancel | None,
    free: bool = False,
) -> Fitted:
    walls = wall_lengths(hall)
    units = assign(wishes, hall.names, zone_areas(hall), walls, whole)
    units = drop_unplaceable(hall, wishes, units, share)
    units = units if whole else share_among_doors(hall, wishes, units)
    built = build_hosts(hall, wishes, units, whole, whole)
    if free:
        lack = lacking(units, wishes, walls, whole)
        gap = max(hall.route, hall.passage)
        alone = standing_hosts(hall.plan.zones, short_of(built, lack), gap)
        built += clear_hosts(alone, taken_floor(hall), THICKNESS)
    spans = np.array([host.span for host in built]).reshape(-1, 2)
    rule = hall.settings.fit
    for attempt in range(rule.most_rounds):
        problem = build_problem(hall, wishes, units, built, weights, catalog)
        if not units:
            return Fitted([], built, problem, NOTHING)
        start, lost = first_layout(problem, spans, seed + attempt, rule.tried)
        if not lost:
            return Fitted(units, built, problem, start)
        if cancel is not None and cancel():
            break
        if attempt + 1 < rule.most_rounds:
            units = _reduce_units(units, lost, whole and attempt < rule.rounds, attempt, rule.small)
    stay = [k for k in range(len(units)) if k not in lost]
    start = without(start, problem, stay)
    units = [units[k] for k in stay]
    problem = build_problem(hall, wishes, units, built, weights, catalog)
    return Fitted(units, built, problem, start)


def place_lacking(
    hall: HallContext,
    wishes: list[HallDemand],
    weights: dict[str, float],
    catalog: Catalog,
    seed: int,
    fitted: Fitted,
    cancel: Cancel | None,
) -> Fitted:
    """Units with the missing objects added where they fit beside the others and the route reaches
    all; the second half of the tries adds one more wall for objects that need one."""
    rule = hall.settings.fit
    absent = list_absent(wishes, fitted.units, hall.names) if fitted.units else []
    if absent and not _all_reached(fitted.problem, fitted.start, seed, rule.looked):
        return fitted
    for again in range(rule.again):
        if not absent or (cancel is not None and cancel()):
            break
        unit, built = absent[again % len(absent)], fitted.hosts
        if 2 * again >= rule.again and wishes[unit.demand].at_wall:
            built += _build_more(hall, wishes, fitted.units, unit, built)
        units = sorted([*fitted.units, unit])
        problem = build_problem(hall, wishes, units, built, weights, catalog)
        walls = np.array([host.span for host in built]).reshape(-1, 2)
        start, lost = first_layout(problem, walls, seed + again, rule.tried)
        if not lost and _all_reached(problem, start, seed, rule.looked):
            fitted = Fitted(units, built, problem, start)
            absent = list_absent(wishes, units, hall.names)
    return fitted


def _build_more(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    unit: Unit,
    built: tuple[Host, ...],
) -> tuple[Host, ...]:
    """A wall on a border of the zone of a unit that lacks one; none where one is built."""
    if any(unit.zone in (int(host.row[4]), int(host.row[5])) for host in built):
        return ()
    lack = np.zeros(len(hall.names))
    lack[unit.zone] = sum(s.width for s in wishes[unit.demand].sizes[unit.first : unit.last])
    return _keep_off_gates(_build_on_borders(hall, lack, False), wishes, units)


def build_hosts(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    printed: bool,
    spare: bool = False,
) -> tuple[Host, ...]:
    """Walls on the borders of zones for what units lack, counted as ``printed`` or as ours; none
    before doors and windows, nor, of ours, round zones with gates, to which everybody comes."""
    lack = lacking(units, wishes, wall_lengths(hall), printed)
    found = _build_on_borders(hall, lack, spare)
    return found if printed else _keep_off_gates(found, wishes, units)


def _keep_off_gates(
    found: tuple[Host, ...], wishes: list[HallDemand], units: list[Unit]
) -> tuple[Host, ...]:
    """The walls that are not round a zone with gates."""
    gated = {unit.zone for unit in units if wishes[unit.demand].category == GATE}
    return tuple(host for host in found if gated.isdisjoint(map(int, host.row[4:6])))


def _build_on_borders(hall: HallContext, lack: Floats, spare: bool) -> tuple[Host, ...]:
    """The same for zones short of ``lack`` (z,) metres."""
    order = visiting_order(hall.plan.links, hall.names, _first_zone(hall))
    found = hosts(hall.borders, hall.plan.links, hall.names, order, lack, spare)
    return clear_hosts(found, taken_floor(hall), THICKNESS)


def _all_reached(problem: HallProblem, start: Kept, seed: int, looked: int) -> bool:
    """Whether a short search finds a layout in which the route misses nothing."""
    found = anneal_hall(problem, start, Budget(steps=looked, threads=1), seed)
    return min(layout.missed for layout in found.layouts) == 0.0


def without(start: Kept, problem: HallProblem, stay: list[int]) -> Kept:
    """A layout of only the units that ``stay``."""
    ends = np.cumsum(capacity(np.diff(problem.units.spans, axis=1)[:, 0]))
    starts = np.concatenate([[0], ends[:-1]])
    rows = [start.layers[starts[k] : ends[k]] for k in stay]
    layers = np.concatenate([np.empty((0, 5)), *rows])
    return Kept(start.pose[stay], layers, start.rows[stay], start.walls, start.offsets)


def _first_zone(hall: HallContext) -> int:
    """The zone nearest to the first door."""
    doors = [opening for opening in hall.space.openings if opening.kind != "window"]
    if not doors:
        return 0
    at = np.array([doors[0].x, doors[0].y])
    far = [np.hypot(*(zone.outline - at).T).min() for zone in hall.plan.zones]
    return int(np.argmin(far))


def _reduce_units(
    units: list[Unit], lost: tuple[int, ...], whole: bool, attempt: int, small: int
) -> list[Unit]:
    """Units after those without a place were split, or gave objects up."""
    found: list[Unit] = []
    for k, unit in enumerate(units):
        count = unit.last - unit.first
        if k not in lost:
            found.append(unit)
        elif count > small and not whole:
            half = unit.first + (count + 1) // 2
            found += [unit._replace(last=half), unit._replace(first=half)]
        elif count > small or attempt % 2 == 0:
            found.append(unit)
        elif count > 1:
            found.append(unit._replace(last=unit.last - 1))
    return found
