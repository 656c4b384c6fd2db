"""What cannot fit: objects given up before any is placed, and by how much they do not fit.

A zone is not asked to hold more than its objects need with a share of their clearances, which
neighbours have in common; what is larger than the zone in every direction is not tried at all.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.scene import Size
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext, wall_lengths, zone_areas
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.problem import Floats
from scenewright.domains.hall.walls.curved import find_runs, longest_place
from scenewright.domains.hall.zoning.assign import Unit, area_of


def drop_unplaceable(
    hall: HallContext, wishes: list[HallDemand], units: list[Unit], share: float
) -> list[Unit]:
    """Units less what finds no room: objects too large, and more than a zone holds if each has
    a share of its clearances for itself. Objects that stand by themselves are units of one."""
    fitting = [part for unit in units for part in _fitting(hall, wishes[unit.demand], unit)]
    left = np.stack([zone_areas(hall), _wall_room(hall)])
    found: list[Unit] = []
    for required in (True, False):
        some = [unit for unit in fitting if wishes[unit.demand].required == required]
        stay = _shares(wishes, some, np.maximum(left, 0.0), share)
        left = left - _measure_demand(wishes, stay, share, left.shape[1])
        found += [one for unit in stay for one in _by_pattern(unit, wishes[unit.demand])]
    return sorted(found)


def _shares(wishes: list[HallDemand], units: list[Unit], left: Floats, share: float) -> list[Unit]:
    """Units that each keep the same share of their objects, by what is left of floor
    and walls (2, z)."""
    most = np.minimum(
        left / np.maximum(_measure_demand(wishes, units, share, left.shape[1]), 1e-9), 1.0
    )
    carried, found = np.full(left.shape[1], 0.999), []
    for unit in units:
        kept = most[:, unit.zone].min() if wishes[unit.demand].at_wall else most[0, unit.zone]
        carried[unit.zone] += float(kept) * (unit.last - unit.first)
        count = min(int(carried[unit.zone]), unit.last - unit.first)
        carried[unit.zone] -= count
        if count:
            found.append(unit._replace(last=unit.first + count))
    return found


def _measure_demand(
    wishes: list[HallDemand], units: list[Unit], share: float, zones: int
) -> Floats:
    """Square metres and metres of wall (2, z) that units take of every zone."""
    taken = np.zeros((2, zones))
    for unit in units:
        wish, count = wishes[unit.demand], unit.last - unit.first
        taken[:, unit.zone] += count * _shared_area(wish, share), count * _wall_width(wish)
    return taken


def _by_pattern(unit: Unit, wish: HallDemand) -> list[Unit]:
    if wish.patterns != ("single",):
        return [unit]
    return [unit._replace(first=k, last=k + 1) for k in range(unit.first, unit.last)]


def excess(zone: Floats, size: Size) -> float:
    """By how many metres an object is too large for an outline, at best, if it stands parallel
    to one of the edges of its hull; 0 or less: it may fit.

    >>> round(excess(np.array([[0.0, 0], [4, 0], [4, 3], [0, 3]]), Size(3.5, 1.0, 1.0)), 6)
    -0.5
    """
    hull = shapely.MultiPoint(zone).convex_hull
    points = shapely.get_coordinates(hull)
    way = np.diff(points, axis=0)
    way /= np.maximum(np.hypot(way[:, 0], way[:, 1]), 1e-12)[:, None]
    long = np.ptp(points @ way.T, axis=0)
    wide = np.ptp(points @ np.stack([-way[:, 1], way[:, 0]]), axis=0)
    one = np.maximum(size.width - long, size.depth - wide)
    other = np.maximum(size.width - wide, size.depth - long)
    return float(np.minimum(one, other).min())


def left_out(
    hall: HallContext,
    wishes: list[HallDemand],
    units: list[Unit],
    unreached: frozenset[int] = frozenset(),
    crowding: frozenset[int] = frozenset(),
) -> tuple[LeftOut, ...]:
    """What was not placed, and by how much it does not fit; of the demands ``unreached``
    something found room, but no way to it; of those that are ``crowding`` with it passages were
    narrower than asked for."""
    areas = zone_areas(hall)
    used = np.zeros(len(areas))
    placed: list[set[int]] = [set() for _ in wishes]
    for unit in units:
        used[unit.zone] += (unit.last - unit.first) * area_of(wishes[unit.demand])
        placed[unit.demand].update(range(unit.first, unit.last))
    found = []
    for number, (wish, there) in enumerate(zip(wishes, placed, strict=True)):
        absent = [size for k, size in enumerate(wish.sizes) if k not in there]
        if absent and not 0 < wish.least <= len(there):
            many = len(wish.sizes) > 1
            what = f"{len(absent)} of {len(wish.sizes)} {wish.name}" if many else wish.name
            reason = (
                f"no layout was found where a route {hall.route:.2f} m wide reaches all with it"
            )
            if number in crowding:
                reason = "no layout was found where passages are as wide as asked for with it"
            elif number not in unreached:
                reason = _reason(hall, wish, absent, areas, used)
            found.append(LeftOut(hall.space.id, what, reason, wish.required))
    return tuple(found)


def _fitting(hall: HallContext, wish: HallDemand, unit: Unit) -> list[Unit]:
    """The runs of a unit's objects that are not too large for its zone."""
    too_large = {
        size: _excess(hall, wish, unit.zone, size) > 0.0
        for size in set(wish.sizes[unit.first : unit.last])
    }
    if not any(too_large.values()):
        return [unit]
    found, first = [], unit.first
    for k in range(unit.first, unit.last + 1):
        if k == unit.last or too_large[wish.sizes[k]]:
            if k > first:
                found.append(unit._replace(first=first, last=k))
            first = k + 1
    return found


def _excess(hall: HallContext, wish: HallDemand, zone: int, size: Size) -> float:
    """By how many metres an object is too large for a zone, or for its walls."""
    over = excess(hall.plan.zones[zone].outline, size)
    return max(over, size.width - _longest_wall(hall, zone)) if wish.at_wall else over


def _longest_wall(hall: HallContext, zone: int) -> float:
    walls = [longest_place(run) for run in find_runs(hall.walls[zone])]
    return float(max([0.0, *walls, *_borders(hall, zone)]))


def _borders(hall: HallContext, zone: int) -> list[float]:
    """Lengths of a zone's borders, on which walls may be built."""
    return [
        float(np.hypot(*np.subtract(border.end, border.start)))
        for border in hall.borders
        if zone in (border.first, border.second)
    ]


def _wall_room(hall: HallContext) -> Floats:
    """Metres of wall (z,) of the zones if every border carried one."""
    more: Floats = np.array([sum(_borders(hall, zone)) for zone in range(len(hall.names))])
    return wall_lengths(hall) + more


def _wall_width(wish: HallDemand) -> float:
    return float(np.mean([size.width for size in wish.sizes])) if wish.at_wall else 0.0


def _shared_area(wish: HallDemand, share: float) -> float:
    front, left, back, right = (share * depth for depth in wish.clearance)
    return area_of(wish._replace(clearance=(front, left, back, right)))


def _reason(
    hall: HallContext, wish: HallDemand, absent: list[Size], areas: Floats, used: Floats
) -> str:
    zones = [hall.names.index(name) for name in wish.zones] or list(range(len(areas)))
    where = ", ".join(wish.zones[:5]) + f" and {len(wish.zones) - 5} more" * (len(wish.zones) > 5)
    where = where or "the hall"
    over = [min(_excess(hall, wish, zone, size) for zone in zones) for size in absent]
    if max(over) > 0.0:
        size = absent[int(np.argmax(over))]
        what = "no wall" if wish.at_wall else "no place"
        company = " with its chairs" if wish.chairs else ""
        return (
            f"{what} in {where} is large enough for one of {size.width:g} by {size.depth:g} m"
            f"{company}: {max(over):.2f} m are missing"
        )
    if wish.at_wall:
        length = sum(size.width for size in absent)
        return f"no wall left in {where}: {length:.1f} m more wall needed"
    floor, taken = float(areas[zones].sum()), float(used[zones].sum())
    more = len(absent) * area_of(wish._replace(sizes=tuple(absent)))
    split = taken + more <= floor
    return (
        f"no room left in {where}: {floor:.1f} m², what is placed needs {taken:.1f} m² "
        f"with all its clearances{', the rest is ways and gaps' * split}; "
        f"{more:.1f} m² more needed{' in one piece' * split}"
    )
