"""Columns among rows: each stands in the line of a row, in a gap, or leaves its aisle wide enough.

A planner gives rows among columns a pitch that divides theirs, so that all columns fall into the
same place of the pattern. Columns are holes of the hall of at most 1.2 m.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.measures import AISLE, KEPT_OFF
from scenewright.domains.hall.patterns import CHAIN, GRID
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import count_objects, find_layers, set_rows
from scenewright.domains.hall.retouch.places import fill_floor, find_axes, nudge
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import ALOOF

LARGEST = 1.2
OFF_LINE = 0.2
"""Cost of a metre by which a column is off the line of its row."""
IN_AISLE, IN_SIGHT = 6.0, 0.5
"""What a column in an aisle counts however wide that is, and what a seat counts whose view it
crosses; metres."""
SPREAD, AROUND, SAME_AXIS = 2.2, 0.1, 0.05
"""Widest gap of a pitch that follows columns, the least gap round a column, and what two axes may
differ by; metres."""
ROWS = 8


class Lattice(NamedTuple):
    """Columns in the frame of a unit: their middles (k, 2) to the right and ahead, half their
    widths (k, 2), and their pitch each way (0: only one)."""

    middles: Floats
    halves: Floats
    pitch: tuple[float, float]


class Columns(NamedTuple):
    """The columns of a problem: the corners (c, m, 2) of each, the last repeated, and their middles
    (c, 2)."""

    problem: HallProblem
    rings: Floats
    middles: Floats

    def reach(self, axes: Floats) -> tuple[Floats, Floats]:
        """Where each begins and ends (c, 2) along two axes (2, 2)."""
        seen = self.rings @ axes.T
        return seen.min(1), seen.max(1)


def find_columns(problem: HallProblem) -> Columns:
    """Every column of a hall: holes of its floor."""
    found, edges, start = list[Floats](), problem.ground.edges, 0
    for k in range(len(edges)):
        if k + 1 == len(edges) or np.hypot(*(edges[k, 2:] - edges[start, :2])) < 1e-9:
            ring, start = edges[start : k + 1, :2], k + 1
            if np.ptp(ring, axis=0).max() <= LARGEST:
                found.append(ring)
    most = max(map(len, found), default=1)
    rings = [np.pad(ring, ((0, most - len(ring)), (0, 0)), mode="edge") for ring in found]
    middles = [ring.mean(0) for ring in found]
    return Columns(problem, np.array(rings).reshape(-1, most, 2), np.array(middles).reshape(-1, 2))


def stand_in_aisles(columns: Columns, kept: Kept, boxes: Floats) -> float:
    """The faults of all columns among rows of boxes (n, 5), in metres."""
    if not len(columns.rings):
        return 0.0
    total = sum(_fault(columns, kept, boxes, unit) for unit in _rows_of(columns.problem, kept))
    return total + IN_SIGHT * _hidden(columns, boxes)


def propose_pitches(columns: Columns, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts in which the rows of one unit have a pitch that divides that of the columns."""
    problem = columns.problem
    for unit in _rows_of(problem, kept):
        if _fault(columns, kept, boxes, unit) > 0.0:
            yield from nudge(kept, unit)
            yield from fill_floor(problem, kept, boxes, unit)
            yield from propose_rows(columns, kept, unit)


def propose_rows(columns: Columns, kept: Kept, unit: int) -> Iterator[Kept]:
    """Layouts in which a unit stands in rows whose pitch divides that of the columns."""
    problem, turn = columns.problem, kept.pose[unit, 2]
    for heading in (turn, turn + 0.5 * np.pi):
        lattice = _lattice(columns, unit, heading)
        for form in _forms(problem, unit, lattice):
            yield from _places(problem, kept, unit, heading, lattice, form)


def keeps_off(problem: HallProblem, unit: int) -> bool:
    """Whether the objects of a unit keep clear of columns."""
    roles = problem.visitors.roles
    return bool(len(roles) and int(roles[unit]) & ALOOF)


def _rows_of(problem: HallProblem, kept: Kept) -> list[int]:
    """The units that stand in rows."""
    counts = count_objects(problem)
    codes = kept.rows[:, 0].astype(int)
    return [u for u in range(len(codes)) if codes[u] in (CHAIN, GRID) and counts[u] > 2]


def _fault(columns: Columns, kept: Kept, boxes: Floats, unit: int) -> float:
    """Metres that the columns among the rows of a unit take of its aisles."""
    first, last = columns.problem.units.spans[unit]
    axes, mine = find_axes(kept.pose[unit, 2]), boxes[first:last]
    at, half = mine[:, :2] @ axes.T, 0.5 * mine[:, 4]
    rim = 0.5 * float(mine[:, 3:].max()) + AROUND
    begin, end = columns.reach(axes)
    among = (end >= at.min(0) - rim).all(1) & (begin <= at.max(0) + rim).all(1)
    total = 0.0
    for (_, low), (_, high) in zip(begin[among], end[among], strict=True):
        middle = 0.5 * (low + high)
        off = np.abs(at[:, 1] - middle)
        if (off <= np.maximum(half, 0.5 * (high - low))).any():
            total += OFF_LINE * float(off.min())
            continue
        above = ((at[:, 1] - half)[at[:, 1] > middle] - high).min(initial=AISLE)
        below = (low - (at[:, 1] + half)[at[:, 1] < middle]).min(initial=AISLE)
        total += IN_AISLE + max(AISLE - max(above, below), 0.0)
    return float(total)


def _hidden(columns: Columns, boxes: Floats) -> float:
    """Seats whose line to the middle of what they look at a column crosses, over ten."""
    total, units = 0.0, columns.problem.units
    wide = 0.5 * np.ptp(columns.rings, axis=1).max(1)
    for unit, target in enumerate(units.targets):
        if target < 0:
            continue
        seats = boxes[slice(*units.spans[unit]), None, :2]
        way = boxes[slice(*units.spans[target]), :2].mean(0) - seats
        to, far = columns.middles - seats, np.maximum(np.hypot(*way.T).T, 1e-9)
        along = (to * way).sum(2) / far
        aside = np.abs(to[..., 0] * way[..., 1] - to[..., 1] * way[..., 0]) / far
        hidden = (along > 0.0) & (along < far) & (aside < wide)
        total += 0.1 * float(hidden.any(1).sum())
    return total


def _lattice(columns: Columns, unit: int, heading: float) -> Lattice:
    """The columns in the zone of a unit, in axes of some heading."""
    ground, zone = columns.problem.ground, columns.problem.units.zones[unit]
    bounds, axes = ground.zone_bounds[zone], find_axes(heading)
    inside = ((columns.middles >= bounds[:2]) & (columns.middles <= bounds[2:])).all(1)
    begin, end = columns.reach(axes)
    middles, halves = (0.5 * (end + begin))[inside], (0.5 * (end - begin))[inside]
    return Lattice(middles, halves, (_pitch(middles[:, 0]), _pitch(middles[:, 1])))


def _pitch(values: Floats) -> float:
    """The least distance of two different values; 0 where all are alike."""
    steps = np.diff(np.sort(values))
    steps = steps[steps > SAME_AXIS]
    return float(steps.min()) if len(steps) else 0.0


class RowForm(NamedTuple):
    """Rows of a unit: objects in each, and the pitches along and across."""

    each: int
    along: float
    across: float


def _forms(problem: HallProblem, unit: int, lattice: Lattice) -> list[RowForm]:
    """Forms of rows whose pitches divide those of the columns, or are any where only one stands
    in line."""
    if not len(lattice.middles):
        return []
    first, last = problem.units.spans[unit]
    number = int(last - first)
    wide, deep = problem.units.sizes[first:last].max(0)
    close = problem.units.clear[first:last, 1::2].sum() == 0.0
    front, back = problem.units.clear[first:last, 0].max(), problem.units.clear[first:last, 2].max()
    around = KEPT_OFF if keeps_off(problem, unit) else AROUND
    gap = max(float(lattice.halves[:, 0].max()) * 2 + 2 * around, 0.6)
    along = [wide] if close else _divide(lattice.pitch[0], wide + gap, wide + gap + SPREAD)
    ways = max(front + back, 0.6)
    across = _divide(lattice.pitch[1], deep + 0.5 * ways, deep + ways + SPREAD)
    most = min(ROWS, int(capacity(np.array(number))))
    each = {-(-number // rows) for rows in range(1, most + 1)}
    each = {e for e in each if number % e == 0 and 1 < e < number} or each
    return [RowForm(e, a, b) for e in sorted(each) for a in along for b in across]


def _divide(pitch: float, least: float, most: float) -> list[float]:
    """Whole parts of a pitch within bounds; a few steps between them where there is no pitch."""
    if pitch == 0.0:
        return [least, 0.5 * (least + most)]
    return [pitch / k for k in range(1, 12) if least <= pitch / k <= most]


def _places(
    problem: HallProblem, kept: Kept, unit: int, heading: float, lattice: Lattice, form: RowForm
) -> Iterator[Kept]:
    """A unit in such rows with the first column in the line of a row and in a gap, at the places
    nearest to the middle of its zone and to where it stood."""
    first, last = problem.units.spans[unit]
    number, deep = int(last - first), float(problem.units.sizes[first:last, 1].max())
    wide = float(problem.units.sizes[first:last, 0].max())
    rows, row = -(-number // form.each), find_layers(problem, unit)[0]
    many, gaps = np.array([form.each, rows]), np.array([form.along - wide, form.across - deep])
    axes = find_axes(heading)
    zone = problem.ground.zone_bounds[problem.units.zones[unit]]
    anchors = [kept.pose[unit, :2], 0.5 * (zone[:2] + zone[2:])]
    close = form.along <= wide + 1e-9
    aside = 0.5 * deep + float(lattice.halves[0, 1]) + 0.01
    lines = (-aside, aside) if close else (0.0,)
    for anchor in anchors:
        middle = axes @ anchor
        for line in lines:
            between = lattice.middles[0, 0] + 0.5 * form.along * (form.each % 2)
            u = middle[0] if close else _nearest(middle[0], between, form.along)
            v = lattice.middles[0, 1] - line + 0.5 * form.across * ((rows + 1) % 2)
            v = _nearest(middle[1], v, form.across)
            for du in (0.0,) if close else (-form.along, 0.0, form.along):
                for dv in (-form.across, 0.0, form.across):
                    at = axes.T @ (u + du, v + dv)
                    yield set_rows(kept, unit, row, number, many, gaps, (*at, heading))


def _nearest(value: float, start: float, step: float) -> float:
    """The number nearest to a value among a start and whole steps from it."""
    return start + step * round((value - start) / step)
