"""Which zone a demand goes to: utilisation bands (Cao, Cheng, Zhang 2024, 3.1).

U_a = Σ A(s) / A_r and U_w = Σ L(s) / L_r over the whole hall are what every zone should come to.
The paper gives a group whole to the first zone it keeps in the band, and does not say what becomes
of one that fits nowhere: here the emptiest zone takes it. Of the band [U - κ, U + κ] only the upper
end can be kept group by group. Ours also shares a group among several zones.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.problem import Floats

KAPPA = 0.1
LEAST = 3


class Unit(NamedTuple):
    """Objects ``first`` to ``last`` - 1 of demand number ``demand``, laid out together in zone
    number ``zone``."""

    demand: int
    zone: int
    first: int
    last: int


def area_of(wish: HallDemand) -> float:
    """Footprint and clearance of one average object, in square metres."""
    front, left, back, right = wish.clearance
    areas = [(s.width + left + right) * (s.depth + front + back) for s in wish.sizes]
    return sum(areas) / len(areas)


def length_of(wish: HallDemand) -> float:
    """Wall taken by one average object, in metres; 0 if it stands free."""
    if not wish.at_wall:
        return 0.0
    side = max(wish.clearance[1] + wish.clearance[3], 0.0)
    return sum(size.width + side for size in wish.sizes) / len(wish.sizes)


def assign(
    wishes: list[HallDemand], names: tuple[str, ...], areas: Floats, walls: Floats, whole: bool
) -> list[Unit]:
    """Units for every demand. ``areas`` (z,) and ``walls`` (z,) are square metres and metres of
    wall of the zones called ``names``; ``whole`` keeps groups together as the paper does."""
    used, taken = np.zeros(len(names)), np.zeros(len(names))
    need = np.array([area_of(wish) * len(wish.sizes) for wish in wishes])
    target = need.sum() / max(areas.sum(), 1e-9)
    wall = sum(length_of(wish) * len(wish.sizes) for wish in wishes) / max(walls.sum(), 1e-9)
    choice = [_list_allowed_zones(wish, names) for wish in wishes]
    so_far = ZoneLoad(used, taken, areas, walls, (float(target), float(wall)))
    units: list[Unit] = []
    for k in sorted(range(len(wishes)), key=lambda k: (len(choice[k]), -need[k])):
        alone = whole or len(choice[k]) == 1
        mine = (_whole if alone else _share_demand)(wishes[k], k, choice[k], so_far)
        for unit in mine:
            used[unit.zone] += area_of(wishes[k]) * (unit.last - unit.first)
            taken[unit.zone] += length_of(wishes[k]) * (unit.last - unit.first)
        units += mine
    return sorted(units)


def _list_allowed_zones(wish: HallDemand, names: tuple[str, ...]) -> list[int]:
    return [names.index(zone) for zone in wish.zones] or list(range(len(names)))


class ZoneLoad(NamedTuple):
    """What zones come to so far: square metres and metres of wall (z,), of how much they have,
    and the utilisations of the whole hall, U_a and U_w."""

    used: Floats
    taken: Floats
    areas: Floats
    walls: Floats
    targets: tuple[float, float]


def _whole(wish: HallDemand, number: int, zones: list[int], so_far: ZoneLoad) -> list[Unit]:
    """All of a demand to the first zone that stays in the band, else to the emptiest."""
    count = len(wish.sizes)
    inside = [
        zone
        for zone in zones
        if _capacity(wish, zone, so_far) >= count and _in_wall_band(wish, zone, so_far)
    ]
    zone = inside[0] if inside else max(zones, key=lambda z: _room(z, so_far, length_of(wish)))
    return [Unit(number, zone, 0, count)]


def _in_wall_band(wish: HallDemand, zone: int, so_far: ZoneLoad) -> bool:
    """Whether a zone with all of a demand keeps its use of wall within U_w + κ, where it may be
    kept: a hall whose walls are short is given more."""
    length = length_of(wish) * len(wish.sizes)
    most = (so_far.targets[1] + KAPPA) * so_far.walls[zone]
    return length == 0.0 or so_far.taken[zone] + length <= most


def _share_demand(wish: HallDemand, number: int, zones: list[int], so_far: ZoneLoad) -> list[Unit]:
    """A demand shared out: the emptiest zones take what they have room for, the rest goes to all
    by their floor. Nothing is split off that would be less than three objects."""
    count, given = len(wish.sizes), dict.fromkeys(zones, 0)
    left, length = count, length_of(wish)
    for zone in sorted(zones, key=lambda z: -_room(z, so_far, length)):
        here = max(min(left, _capacity(wish, zone, so_far)), 0)
        given[zone] = left if left - here < min(LEAST, count) else here
        left -= given[zone]
    for zone, share in zip(zones, _by_floor(left, so_far.areas[zones]), strict=True):
        given[zone] += share
    units, first = [], 0
    for zone in (zone for zone in zones if given[zone]):
        units.append(Unit(number, zone, first, first + given[zone]))
        first += given[zone]
    return units


def _by_floor(count: int, areas: Floats) -> list[int]:
    """A number shared in proportion to areas, whole and without rest."""
    ends = np.round(np.cumsum(areas) / areas.sum() * count).astype(int)
    return [int(share) for share in np.diff(ends, prepend=0)]


def _capacity(wish: HallDemand, zone: int, so_far: ZoneLoad) -> int:
    """How many objects of a demand a zone takes before it leaves the band or has no wall left."""
    most = (so_far.targets[0] + KAPPA) * so_far.areas[zone] - so_far.used[zone]
    fits = math.floor(most / area_of(wish))
    if wish.at_wall:
        free = so_far.walls[zone] - so_far.taken[zone]
        fits = min(fits, math.floor(free / length_of(wish)))
    return fits


def _room(zone: int, so_far: ZoneLoad, length: float) -> float:
    """How far a zone is from what it should come to: its area, or its wall, in shares."""
    if length > 0.0:
        return float(so_far.targets[1] - so_far.taken[zone] / max(so_far.walls[zone], 1e-9))
    return float(so_far.targets[0] - so_far.used[zone] / max(so_far.areas[zone], 1e-9))
