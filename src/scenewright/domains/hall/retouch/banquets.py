"""Tables before a stage: guests of a gala sit in front of it, and all of that floor is theirs.

Tables have no front, so nothing in the energy says that they belong before the stage of their
zone; they are packed beside it as well as before it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.patterns import CHAIN, GRID
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.audience import BEFORE, PER_OFF_AXIS, SIDE, VIEW
from scenewright.domains.hall.retouch.lines import count_objects, find_layers, set_rows
from scenewright.domains.hall.retouch.places import EDGES, find_axes, share_room
from scenewright.domains.hall.retouch.stages import measure_stage, propose_stages
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import STAGE, TABLE

FEWEST, MOST_OF_BANQUET = 4, 12.0
"""Tables of a banquet at least, and metres of fault at most."""
PER_NARROW_GAP, PER_BARE_STRIP = 1.0, 1.0
"""What each metre counts by which gaps lack the passage wished for, and by which the floor beside
and behind the tables is wider than their gaps."""


class Banquet(NamedTuple):
    """The unit of the tables, and that of the stage before which they belong."""

    tables: int
    stage: int


def find_banquets(problem: HallProblem, kept: Kept) -> list[Banquet]:
    """The largest group of tables in rows of each zone with one stage that nobody looks at by
    himself."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    counts, zones = count_objects(problem), units.zones
    rows = np.isin(kept.rows[:, 0], (CHAIN, GRID)) & (units.targets < 0) & (counts >= FEWEST)
    found = []
    for stage in np.flatnonzero((roles & STAGE > 0) & (counts == 1)).tolist():
        mine = np.flatnonzero((roles & TABLE > 0) & rows & (zones == zones[stage]))
        alone = ((roles & STAGE > 0) & (zones == zones[stage])).sum() == 1
        if len(mine) and alone and stage not in units.targets:
            found.append(Banquet(int(mine[counts[mine].argmax()]), stage))
    return found


def measure_banquets(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of the tables before all stages of boxes (n, 5), in metres."""
    total = 0.0
    for tables, stage in find_banquets(problem, kept):
        box = boxes[problem.units.spans[stage, 0]]
        mine = boxes[slice(*problem.units.spans[tables])]
        zone = problem.ground.zone_bounds[int(problem.units.zones[tables])]
        total += measure_banquet(mine, box, zone, problem.passage)
        total += measure_stage(problem, boxes, stage)
    return total


def measure_banquet(tables: Floats, stage: Floats, zone: Floats, passage: float) -> float:
    """How far tables (n, 5) lie beside and off the axis of a stage (5,), how wide the floor about
    them is to walls and to the stage, beyond twice their gaps, within the bounds (4,) of their
    ``zone``, and by how much their gaps lack the ``passage``, in metres."""
    right, front = find_axes(stage[2])
    off = tables[:, :2] - stage[:2]
    ahead, aside = off @ front - 0.5 * stage[4], off @ right
    beyond = np.abs(aside) - 0.5 * stage[3] - VIEW * np.maximum(ahead, 0.0)
    hidden = np.maximum(beyond, 0.0) + np.maximum(BEFORE - ahead, 0.0)
    reach, bounds = 0.5 * tables[:, 3:].max(1), _see_bounds(stage, zone)
    total = SIDE * float(hidden.mean()) + PER_OFF_AXIS * abs(float(aside.mean()))
    for at, (low, high) in zip((aside, ahead), bounds, strict=True):
        gap = _find_gap(at, reach)
        strips = (float((at - reach).min()) - low, high - float((at + reach).max()))
        total += PER_BARE_STRIP * sum(max(strip - max(gap, passage), 0.0) for strip in strips)
        total += PER_NARROW_GAP * max(passage - gap, 0.0)
    return min(total, MOST_OF_BANQUET)


def _see_bounds(stage: Floats, zone: Floats) -> Floats:
    """How far the bounds (4,) of a zone reach to the left and right of a stage (5,), and from its
    edge to the back (2, 2), in metres."""
    x0, y0, x1, y1 = zone
    ends = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]]) - stage[:2]
    right, front = find_axes(stage[2])
    aside, ahead = ends @ right, ends @ front - 0.5 * stage[4]
    return np.array([[aside.min(), aside.max()], [0.0, ahead.max()]])


def _find_gap(at: Floats, reach: Floats) -> float:
    """The least gap of rows of objects with middles ``at`` (n,) and half depths ``reach`` (n,)."""
    order = np.argsort(at, kind="stable")
    steps = (at - reach)[order][1:] - (at + reach)[order][:-1]
    apart = steps[steps > 0.0]
    return float(apart.min()) if len(apart) else 0.0


def propose_banquets(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with a stage where it stands or at mid-wall, and its tables in rows over the floor
    before it."""
    for tables, stage in find_banquets(problem, kept):
        zone = problem.ground.zone_bounds[int(problem.units.zones[tables])]
        for moved, box in propose_stages(problem, kept, boxes, stage):
            yield from _fill_floor(problem, moved, tables, box, zone)


def _fill_floor(
    problem: HallProblem, kept: Kept, tables: int, stage: Floats, zone: Floats
) -> Iterator[Kept]:
    """Layouts with tables in all rows and gaps that find room before a stage (5,)."""
    row, most = find_layers(problem, tables)
    number, bounds = int(count_objects(problem)[tables]), _see_bounds(stage, zone)
    size = problem.units.sizes[slice(*problem.units.spans[tables])].max(0)
    right, front = find_axes(stage[2])
    middle = stage[:2] + 0.5 * bounds[0].sum() * right
    middle = middle + (0.5 * stage[4] + 0.5 * bounds[1, 1]) * front
    for rows in range(1, min(most, number) + 1):
        columns = -(-number // rows)
        if -(-number // columns) != rows:
            continue
        many, room = np.array([columns, rows]), np.diff(bounds, axis=1)[:, 0]
        for edge, other in product(EDGES, repeat=2):
            gaps = share_room(room, many, size, np.array([edge, other]))
            if gaps.min() > 0.0:
                yield set_rows(kept, tables, row, number, many, gaps, (*middle, stage[2] + np.pi))
