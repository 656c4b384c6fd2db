"""Making a hall's demands fit: units that find no room are split, then made smaller, with reasons.

A first layout is looked for with growing effort. A unit without a place is split in two; one that
is a few objects only goes to another zone it may stand in, or gives objects up.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.catalog import Catalog
from scenewright.domains.hall.assign import Unit, area_of, assign
from scenewright.domains.hall.partitions import Host, hosts, lacking, visiting_order
from scenewright.domains.hall.pose import Hall, pose, wall_lengths, zone_areas
from scenewright.domains.hall.wanted import Wanted
from scenewright.hall_problem import HallProblem
from scenewright.solution import LeftOut
from scenewright.solvers.hall_chains import first_layout
from scenewright.terms.hall_state import Kept

ROUNDS = 12
TRIES = 300
SMALL = 3


class Fitted(NamedTuple):
    """Units that all have a place, the problem they make, a first layout, and what is left out:
    objects by demand."""

    units: list[Unit]
    hosts: tuple[Host, ...]
    problem: HallProblem
    start: Kept
    missing: dict[int, int]


def fit(
    hall: Hall, wishes: list[Wanted], weights: dict[str, float], catalog: Catalog, seed: int,
    whole: bool,
) -> Fitted:  # fmt: skip
    """Assign, pose and place; see the module."""
    areas, walls = zone_areas(hall), wall_lengths(hall)
    units = assign(wishes, hall.names, areas, walls, whole)
    lack = lacking(units, wishes, walls, whole)
    order = visiting_order(hall.plan.links, hall.names, _first_zone(hall))
    built = hosts(hall.borders, hall.plan.links, hall.names, order, lack)
    missing: dict[int, int] = {}
    for attempt in range(10 * ROUNDS):
        problem = pose(hall, wishes, units, built, weights, catalog)
        spans = np.array([host.span for host in built]).reshape(-1, 2)
        start, lost = first_layout(problem, spans, seed + attempt, TRIES)
        if not lost:
            return Fitted(units, built, problem, start, missing)
        units = _mended(units, lost, missing, whole, attempt)
    units = [unit for k, unit in enumerate(units) if k not in lost]
    problem = pose(hall, wishes, units, built, weights, catalog)
    start, lost = first_layout(problem, spans, seed, TRIES)
    return Fitted(units, built, problem, start, missing)


def _first_zone(hall: Hall) -> int:
    """The zone nearest to the first door."""
    doors = [opening for opening in hall.space.openings if opening.kind != "window"]
    if not doors:
        return 0
    at = np.array([doors[0].x, doors[0].y])
    far = [np.hypot(*(zone.outline - at).T).min() for zone in hall.plan.zones]
    return int(np.argmin(far))


def _mended(
    units: list[Unit], lost: tuple[int, ...], missing: dict[int, int], whole: bool, attempt: int
) -> list[Unit]:
    """Units after those without a place were split, or gave objects up."""
    found: list[Unit] = []
    for k, unit in enumerate(units):
        count = unit.last - unit.first
        if k not in lost:
            found.append(unit)
        elif count > SMALL and not (whole and attempt < ROUNDS):
            half = unit.first + (count + 1) // 2
            found += [unit._replace(last=half), unit._replace(first=half)]
        elif count > SMALL or attempt % 2 == 0:
            found.append(unit)
        else:
            found += _smaller(unit, missing)
    return found


def _smaller(unit: Unit, missing: dict[int, int]) -> list[Unit]:
    missing[unit.demand] = missing.get(unit.demand, 0) + 1
    return [unit._replace(last=unit.last - 1)] if unit.last - unit.first > 1 else []


def left_out(hall: Hall, wishes: list[Wanted], fitted: Fitted) -> tuple[LeftOut, ...]:
    """What was not placed, and by how much it does not fit."""
    areas = zone_areas(hall)
    used = np.zeros(len(areas))
    for unit in fitted.units:
        used[unit.zone] += (unit.last - unit.first) * area_of(wishes[unit.demand])
    found = []
    for number, count in sorted(fitted.missing.items()):
        wish = wishes[number]
        zones = [hall.names.index(z) for z in wish.zones] or list(range(len(areas)))
        told = f"{count} of {len(wish.sizes)} {wish.name}" if len(wish.sizes) > 1 else wish.name
        found.append(LeftOut(hall.space.id, told, _reason(hall, wish, count, zones, areas, used),
                             wish.required))  # fmt: skip
    return tuple(found)


def _reason(
    hall: Hall, wish: Wanted, count: int, zones: list[int], areas: np.ndarray, used: np.ndarray
) -> str:
    where = ", ".join(hall.names[z] for z in zones) if wish.zones else "the hall"
    need = count * area_of(wish)
    if wish.at_wall:
        length = sum(size.width for size in wish.sizes[-count:])
        return f"no wall left in {where}: {length:.1f} m more wall needed"
    return (
        f"no room left in {where}: {float(areas[zones].sum()):.1f} m², of which what is placed "
        f"takes {float(used[zones].sum()):.1f} m² with its clearances; {need:.1f} m² more needed"
    )
