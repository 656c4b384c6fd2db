"""Tables in rows whose chairs stand back to back: room to get up between them, where there is."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from scenewright.domains.hall.demands.holdings import SEATWAY
from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, GRID, NUMBER
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import (
    count_objects,
    find_layers,
    forgive_space,
    set_rows,
)
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.visitors import TABLE

LITTLE, WORTH = 0.01, 10.0
"""Metres of a gap that count as none, and what each metre of it counts that is lacking."""
GAPS = (SEATWAY, 0.3, 0.2, 0.12)
"""Metres between the chairs of two rows that are tried."""
SHIFTS = (0.0, 0.1, -0.1, 0.2, -0.2, 0.4, -0.4, 0.8, -0.8)
"""Metres by which a whole group is moved with that, along each axis."""
WIDE, FARTHER = (SEATWAY, 0.7, 0.3), (0.0, 0.4, -0.4, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4)
"""The same where its tables stand in other rows."""


def find_seated(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of tables with chairs in rows."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    clear = units.clear[units.spans[:, 0], 0]
    seated = (clear > 0.0) & (clear <= SEATWAY + LITTLE) & (roles & TABLE > 0)
    rows = np.isin(kept.rows[:, 0], (CHAIN, GRID)) & (count_objects(problem) > 1)
    return [int(unit) for unit in np.flatnonzero(seated & rows)]


def measure_seatways(problem: HallProblem, kept: Kept, boxes: Floats) -> float:  # noqa: ARG001
    """By how much gaps between the chairs of tables of one group lack a seatway, in metres."""
    lacks = (
        max(SEATWAY - gap, 0.0)
        for unit in find_seated(problem, kept)
        for gap in _find_gaps(problem, kept, unit)
        if gap is not None
    )
    return WORTH * sum(lack for lack in lacks if lack > LITTLE)


def forgive_floor(
    problem: HallProblem,
    kept: Kept,
    boxes: Floats,  # noqa: ARG001
    p: PreparedHall,
    s: State,
) -> float:
    """What of the energy of a measured state comes from the free floor of those tables that others
    take: their seatways are what is measured here."""
    return sum(forgive_space(p, s, unit, 0.0) for unit in find_seated(problem, kept))


def _find_gaps(problem: HallProblem, kept: Kept, unit: int) -> tuple[float | None, float | None]:
    """The least gaps along and across the rows of a unit at which chairs stand; None without."""
    first, used = find_layers(problem, unit)[0], int(kept.rows[unit, 1])
    layers, sides = kept.layers[first : first + used], problem.units.sizes[_first_of(problem, unit)]
    around = abs(float(sides[0] - sides[1])) < LITTLE and layers[:, NUMBER].max() > 1
    along = float(layers[:, ALONG].min()) if around else None
    return along, float(layers[1:, ACROSS].min()) if used > 1 else None


def _first_of(problem: HallProblem, unit: int) -> int:
    return int(problem.units.spans[unit, 0])


def propose_seatways(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:  # noqa: ARG001
    """Layouts with the gaps of one group wider, or narrower where they are wide, and all of it
    moved a little; or with its tables in fewer or more rows."""
    for unit in find_seated(problem, kept):
        along, across = _find_gaps(problem, kept, unit)
        if min(gap for gap in (along, across, SEATWAY) if gap is not None) > SEATWAY - LITTLE:
            continue
        yield from _widen(problem, kept, unit, (along, across))
        yield from _rearrange(problem, kept, unit)


def _widen(
    problem: HallProblem, kept: Kept, unit: int, now: tuple[float | None, float | None]
) -> Iterator[Kept]:
    """Layouts with other gaps in the rows as they are."""
    first, used = find_layers(problem, unit)[0], int(kept.rows[unit, 1])
    for gaps in product(*map(_list_gaps, now)):
        layers = kept.layers.copy()
        for column, gap in zip((ALONG, ACROSS), gaps, strict=True):
            if gap is not None:
                layers[first : first + used, column] = gap
        yield from _move_all(kept._replace(layers=layers), unit, SHIFTS)


def _rearrange(problem: HallProblem, kept: Kept, unit: int) -> Iterator[Kept]:
    """Layouts with the tables of a unit in fewer or more rows, a seatway or more apart."""
    first, most = find_layers(problem, unit)
    number, used = int(count_objects(problem)[unit]), int(kept.rows[unit, 1])
    for rows in range(1, min(most, number) + 1):
        columns = -(-number // rows)
        if rows == used or -(-number // columns) != rows:
            continue
        many = np.array([columns, rows], np.float64)
        for gaps in product(WIDE, repeat=2):
            pose = tuple(kept.pose[unit, :3].tolist())
            laid = set_rows(kept, unit, first, number, many, np.array(gaps), pose)
            yield from _move_all(laid, unit, FARTHER)


def _move_all(kept: Kept, unit: int, shifts: tuple[float, ...]) -> Iterator[Kept]:
    """Layouts with a unit moved by all pairs of some metres."""
    for shift in product(shifts, repeat=2):
        pose = kept.pose.copy()
        pose[unit, :2] += shift
        yield kept._replace(pose=pose)


def _list_gaps(gap: float | None) -> tuple[float | None, ...]:
    """The gaps that are tried for one, itself first."""
    return (None,) if gap is None or gap > SEATWAY - LITTLE else (gap, *GAPS)
