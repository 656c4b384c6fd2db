"""Which desks of a hall visitors come to first, and which others they are served at."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.patterns import CHAIN, SINGLE
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.retouch.arrivals import find_met
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, LANE, MACHINE, RECEPTION, TILL

MOST = 6
"""Desks that one row holds at most."""
BACK = 2
"""The column of ``access`` that says whether one comes up to a back."""


class Desks(NamedTuple):
    """Which desks of a problem are seen to: those ``first`` of all, one each in the zone of the
    entrance, or to ask at where none is there, or all others."""

    problem: HallProblem
    first: bool


def first_desks(problem: HallProblem) -> Desks:
    """The desks visitors come to first."""
    return Desks(problem, first=True)


def other_desks(problem: HallProblem) -> Desks:
    """Counters and tills in rows or away from the entrance."""
    return Desks(problem, first=False)


def find_desks(desks: Desks, kept: Kept) -> list[int]:
    """The units served from behind that visitors come to first or last, one desk each or a few in
    a row, but for tills in lanes; none without an entrance."""
    problem, units = desks.problem, desks.problem.units
    roles, firsts = problem.visitors.roles, problem.units.spans[:, 0]
    return [
        unit
        for unit in find_met(problem, kept, FIRST | TILL, MOST, (SINGLE, CHAIN))
        if not int(roles[unit]) & (LANE | MACHINE)
        and units.targets[unit] < 0
        and not units.access[firsts[unit], BACK]
        and desks.first == (int(np.ptp(units.spans[unit])) == 1 and _is_first(problem, unit))
    ]


def _is_first(problem: HallProblem, unit: int) -> bool:
    """Whether a desk stands in the zone of the entrance, or one asks at it and no desk does."""
    if is_at_door(problem, unit):
        return True
    asks = bool(int(problem.visitors.roles[unit]) & RECEPTION)
    return asks and not any(is_at_door(problem, k) for k in range(len(problem.units.zones)))


def is_at_door(problem: HallProblem, unit: int) -> bool:
    """Whether a unit visitors come to first stands in the zone of the entrance."""
    x0, y0, x1, y1 = problem.ground.zone_bounds[problem.units.zones[unit]]
    x, y = problem.visitors.entrances[0]
    inside = (
        x0 - DOOR_OUTSIDE <= x <= x1 + DOOR_OUTSIDE and y0 - DOOR_OUTSIDE <= y <= y1 + DOOR_OUTSIDE
    )
    return bool(inside and int(problem.visitors.roles[unit]) & FIRST)
