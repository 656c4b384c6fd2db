"""Which groups of a hall rows are about, told by the part they play and how they stand."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.hall.patterns import ALONG, CHAIN, GRID, SINGLE, WALL
from scenewright.domains.hall.problem import HallProblem, Ints
from scenewright.domains.hall.retouch.arrivals import find_met
from scenewright.domains.hall.retouch.desk_groups import find_desks, first_desks, other_desks
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import (
    ALOOF,
    FIRST,
    GUIDE,
    LANE,
    LOUNGE,
    LOW,
    MAIN,
    SPEAKER,
    TILL,
)
from scenewright.domains.hall.visit.roles import FRONT as FRONTED

Bools = NDArray[np.bool_]
CLOSED = 2.0  # metres free before a stand with a closed back, none behind or beside it
SOLE = 1.0  # a gap between neighbours of a row up to which they stand as one, metres
STRAIGHT = 0.02  # by how much rows may be turned to the axes of their zone, radians
MOST_TILLS = 24  # tills of one group at most
FEWEST = 2  # rows that have an aisle between them and a wall on both sides
BEFORE, BEHIND = 0, 2
"""The columns of ``clear`` that say how much free floor is before and behind an object."""


def read_roles(problem: HallProblem) -> Ints:
    """The roles (g,) of all groups as bits."""
    return problem.visitors.roles.astype(np.int64)


def _stand_free(problem: HallProblem, kept: Kept) -> Bools:
    return (read_roles(problem) & ALOOF > 0) & (kept.rows[:, 0] != WALL)


def _seat_people(problem: HallProblem, kept: Kept) -> Bools:  # noqa: ARG001
    return read_roles(problem) & LOUNGE > 0


def _serve_seats(problem: HallProblem, kept: Kept) -> Bools:  # noqa: ARG001
    return read_roles(problem) & LOW > 0


def _stand_straight(problem: HallProblem, kept: Kept) -> Bools:
    """Groups in straight rows that look at nothing of their own."""
    straight = np.isin(kept.rows[:, 0], (CHAIN, GRID, SINGLE))
    return np.asarray(straight & (problem.units.targets < 0), np.bool_)


def _look_round(problem: HallProblem, kept: Kept) -> Bools:
    return _seat_people(problem, kept) & _stand_straight(problem, kept)


def _show_front(problem: HallProblem, kept: Kept) -> Bools:
    """Stands with closed backs, and what has a front."""
    clear, roles = problem.units.clear[problem.units.spans[:, 0]], read_roles(problem)
    closed = (clear[:, 0] >= CLOSED) & (clear[:, 1:] == 0.0).all(1) & (roles & ALOOF > 0)
    return _stand_straight(problem, kept) & (closed | (roles & FRONTED > 0))


def _have_two_faces(problem: HallProblem, kept: Kept) -> Bools:
    """Groups in straight rows without gaps whose objects are looked at from before and behind."""
    units, roles = problem.units, read_roles(problem)
    both = (units.clear[units.spans[:, 0]][:, (BEFORE, BEHIND)] > 0.0).all(1)
    square = np.abs(np.sin(2.0 * kept.pose[:, 2])) < STRAIGHT
    rows = (kept.rows[:, 0] == CHAIN) & (kept.rows[:, 1] >= FEWEST) & (units.targets < 0)
    shown = both & square & rows & (roles & (FIRST | TILL | GUIDE | SPEAKER | MAIN) == 0)
    found = [u for u in np.flatnonzero(shown) if _is_close(problem, kept, int(u))]
    return np.isin(np.arange(len(shown)), found)


def _is_close(problem: HallProblem, kept: Kept, unit: int) -> bool:
    return bool(kept.layers[find_layers(problem, unit)[0], ALONG] < SOLE)


def _mask(kept: Kept, units: list[int]) -> Bools:
    return np.isin(np.arange(len(kept.pose)), units)


def _come_first(problem: HallProblem, kept: Kept) -> Bools:
    return _mask(kept, find_desks(first_desks(problem), kept))


def _take_money(problem: HallProblem, kept: Kept) -> Bools:
    others = _mask(kept, find_desks(other_desks(problem), kept))
    return others & (read_roles(problem) & TILL > 0)


def _serve(problem: HallProblem, kept: Kept) -> Bools:
    others = _mask(kept, find_desks(other_desks(problem), kept))
    return others & (read_roles(problem) & TILL == 0)


def _have_lanes(problem: HallProblem, kept: Kept) -> Bools:
    lanes = find_met(problem, kept, LANE, MOST_TILLS) if len(problem.visitors.exits) else []
    return _mask(kept, lanes)


GROUPS: Mapping[str, Callable[[HallProblem, Kept], Bools]] = {
    "exhibit": _stand_free,
    "lounge seat": _seat_people,
    "low table": _serve_seats,
    "row of lounge seats": _look_round,
    "stand": _show_front,
    "rows with two faces": _have_two_faces,
    "first desk": _come_first,
    "desk to pay at": _take_money,
    "other desk": _serve,
    "tills with lanes": _have_lanes,
}
"""Which groups (g,) each name means, in a layout."""
