"""Which zone a demand goes to: utilisation bands (Cao, Cheng, Zhang 2024, 3.1).

U_a = Σ A(s) / A_r and U_w = Σ L(s) / L_r over the whole hall are what every zone should come to.
The paper gives a group whole to the first zone it keeps in the band [U - κ, U + κ]; ours also
splits one over several zones, and mends the split where a group finds no room.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.wanted import Wanted
from scenewright.hall_problem import Floats

KAPPA = 0.1


class Unit(NamedTuple):
    """Objects ``first`` to ``last`` - 1 of demand number ``demand``, laid out together in zone
    number ``zone``."""

    demand: int
    zone: int
    first: int
    last: int


def area_of(wish: Wanted) -> float:
    """Footprint and clearance of one average object, in square metres."""
    front, left, back, right = wish.clearance
    areas = [(s.width + left + right) * (s.depth + front + back) for s in wish.sizes]
    return sum(areas) / len(areas)


def length_of(wish: Wanted) -> float:
    """Wall taken by one average object, in metres; 0 if it stands free."""
    if not wish.at_wall:
        return 0.0
    side = max(wish.clearance[1] + wish.clearance[3], 0.0)
    return sum(size.width + side for size in wish.sizes) / len(wish.sizes)


def assign(
    wishes: list[Wanted], names: tuple[str, ...], areas: Floats, walls: Floats, whole: bool
) -> list[Unit]:
    """Units for every demand. ``areas`` (z,) and ``walls`` (z,) are square metres and metres of
    wall of the zones called ``names``; ``whole`` keeps groups together as the paper does."""
    used, taken = np.zeros(len(names)), np.zeros(len(names))
    need = np.array([area_of(wish) * len(wish.sizes) for wish in wishes])
    target = need.sum() / max(areas.sum(), 1e-9)
    wall = sum(length_of(wish) * len(wish.sizes) for wish in wishes) / max(walls.sum(), 1e-9)
    choice = [_allowed(wish, names) for wish in wishes]
    units: list[Unit] = []
    for k in sorted(range(len(wishes)), key=lambda k: (len(choice[k]), -need[k])):
        units += _shared(wishes[k], k, choice[k], used, taken, areas, walls, (target, wall), whole)
    return sorted(units)


def _allowed(wish: Wanted, names: tuple[str, ...]) -> list[int]:
    return [names.index(zone) for zone in wish.zones] or list(range(len(names)))


def _shared(
    wish: Wanted, number: int, zones: list[int], used: Floats, taken: Floats, areas: Floats,
    walls: Floats, targets: tuple[float, float], whole: bool,
) -> list[Unit]:  # fmt: skip
    """One demand's units: all of it to the emptiest zone, or shared out by what zones lack."""
    area, length, count = area_of(wish), length_of(wish), len(wish.sizes)
    units, first = [], 0
    while first < count:
        room = np.array([_room(z, used, taken, areas, walls, targets, length) for z in zones])
        pick = int(np.argmax(room))
        zone, left = zones[pick], count - first
        most = (targets[0] + KAPPA) * areas[zone] - used[zone]
        fits = max(math.floor(most / area), 1)
        if length > 0.0:
            fits = max(min(fits, math.floor(max(walls[zone] - taken[zone], 0.0) / length)), 1)
        number_here = left if whole or len(zones) == 1 else min(left, fits)
        if left - number_here < min(3, count):
            number_here = left
        units.append(Unit(number, zone, first, first + number_here))
        used[zone] += area * number_here
        taken[zone] += length * number_here
        first += number_here
        if len(units) > 4 * len(zones):
            units[-1] = units[-1]._replace(last=count)
            break
    return _joined(units)


def _room(
    zone: int, used: Floats, taken: Floats, areas: Floats, walls: Floats,
    targets: tuple[float, float], length: float,
) -> float:  # fmt: skip
    """How far a zone is from what it should come to: its area, or its wall, in shares."""
    if length > 0.0:
        return float(targets[1] - taken[zone] / max(walls[zone], 1e-9))
    return float(targets[0] - used[zone] / max(areas[zone], 1e-9))


def _joined(units: list[Unit]) -> list[Unit]:
    """Units of one demand in one zone made one."""
    by_zone: dict[int, int] = {}
    for unit in units:
        by_zone[unit.zone] = by_zone.get(unit.zone, 0) + unit.last - unit.first
    found, first = [], 0
    for zone, count in by_zone.items():
        found.append(Unit(units[0].demand, zone, first, first + count))
        first += count
    return found
