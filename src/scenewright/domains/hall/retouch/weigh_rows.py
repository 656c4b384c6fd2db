"""The rows of halls weighed for a layout."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from scenewright.arranging.degrees import IS_FLOOR, KIND, NUMBER, OF_GROUP, PART, THINGS, RoomParts
from scenewright.arranging.row_arrays import Table, compile_rows
from scenewright.arranging.rows import COLUMNS, DOORS, ENTRANCES, EXITS, WAY_IN, Class, Row
from scenewright.arranging.weighing import MOST, Broken, weigh, weigh_rows
from scenewright.core.same import Same, once
from scenewright.domains.hall.measures import WAY_LENGTH, WAY_WIDTH
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.columns import find_columns
from scenewright.domains.hall.retouch.row_groups import GROUPS
from scenewright.domains.hall.rules import ROWS
from scenewright.domains.hall.terms.state import Kept


class HallRows(NamedTuple):
    """Some rows, and the parts of the hall of a problem they are weighed in."""

    rows: tuple[Row, ...]
    room: RoomParts
    problem: HallProblem


@once(64)
def look_rows(ids: tuple[str, ...], problem: HallProblem) -> HallRows:
    """What the rows with some ids have to know of a problem, once for all."""
    return HallRows(tuple(row for row in ROWS if row.id in ids), read_parts(problem), problem)


def read_parts(problem: HallProblem) -> RoomParts:
    """The parts of a hall that rows are about."""
    edges = np.ascontiguousarray(problem.ground.edges[:, :4])
    rings = find_columns(problem).rings
    sides = np.ptp(rings, axis=1) if len(rings) else np.zeros((0, 2))
    middles = 0.5 * (rings.max(1) + rings.min(1)) if len(rings) else np.zeros((0, 2))
    columns = np.column_stack([middles, np.zeros(len(rings)), sides, np.full(len(rings), COLUMNS)])
    boxes = np.concatenate([columns, _read_doors(problem)])
    return RoomParts(edges, np.zeros((0, 4)), edges, boxes, float(problem.ground.zone_areas.sum()))


def _read_doors(problem: HallProblem) -> Floats:
    """Boxes (k, 6) of the main entrance, the way in from it, all entrances, and where visitors
    leave."""
    visitors, found = problem.visitors, list[list[float]]()
    for door, inward in zip(visitors.entrances[:1], visitors.inward, strict=False):
        ahead, middle = float(np.arctan2(inward[1], inward[0])), door + 0.5 * WAY_LENGTH * inward
        found.append([*door, ahead, 0.0, 0.0, ENTRANCES])
        found.append([*middle, ahead, WAY_WIDTH, WAY_LENGTH, WAY_IN])
    found += [[*door, 0.0, 0.0, 0.0, DOORS] for door in visitors.entrances.tolist()]
    found += [[*door, ahead, 0.0, 0.0, EXITS] for *door, ahead in find_ways_out(problem).tolist()]
    return np.reshape(found, (-1, PART + 1)).astype(np.float64)


def find_ways_out(problem: HallProblem) -> Floats:
    """Where visitors leave (k, 3): a point and the direction in from there."""
    doors, points = problem.ground.doors, problem.visitors.exits
    near = [int(np.hypot(*(doors[:, :2] - point).T).argmin()) for point in points]
    return np.column_stack([points.reshape(-1, 2), doors[near, 2]])


def list_faults(seen: HallRows, kept: Kept, boxes: Floats) -> list[tuple[int, Broken]]:
    """The rows that do not hold among boxes (n, 5) of a layout, each with its unit."""
    marks = _mark_groups(seen, kept)
    if not marks.any():
        return []
    table = _compile(Same(seen.rows), tuple(np.unique(marks).tolist()))
    things = read_things(table, seen.problem, marks, boxes)
    return [(int(things[b.thing, NUMBER]), b) for b in weigh(table, things, seen.room)]


def measure_rows(seen: HallRows, kept: Kept, boxes: Floats) -> float:
    """What the rows cost that do not hold among boxes (n, 5) of a layout, in metres."""
    return sum(broken.cost for _, broken in list_faults(seen, kept, boxes))


def measure_places(seen: HallRows, kept: Kept, boxes: Floats, unit: int, places: Floats) -> Floats:
    """What the rows cost (k,) that do not hold of a unit as a whole at places (k, 5), the others
    where they are among boxes (n, 5), in metres."""
    marks = _mark_groups(seen, kept)
    table = _compile(Same(seen.rows), tuple(np.unique(marks).tolist()))
    things = read_things(table, seen.problem, marks, boxes)
    things = things[(things[:, IS_FLOOR] == 0.0) | (things[:, NUMBER] == unit)]
    costs, found, last = np.zeros(len(places)), np.empty((MOST, 5)), len(things) - 1
    for k, place in enumerate(places):
        things[last, :5] = place
        count = min(weigh_rows(things, table.arrays, seen.room, found), MOST)
        costs[k] = found[:count][found[:count, 1] == last, 4].sum()
    return costs


def read_things(table: Table, problem: HallProblem, marks: Ints, boxes: Floats) -> Floats:
    """The things (n + g, 10) of a layout: its boxes (n, 5), then the floor of each group that a
    row is about; ``marks`` (g,) say what the groups are."""
    spans, other = problem.units.spans, len(table.kinds) + 1
    unit = np.repeat(np.arange(len(spans)), np.diff(spans, axis=1)[:, 0])
    kinds = np.array([table.kinds.get(str(mark), 0) for mark in marks])
    whole = np.flatnonzero(marks)
    things = np.zeros((len(boxes) + len(whole), THINGS))
    things[: len(boxes), :5], things[: len(boxes), NUMBER] = boxes, unit
    for k, group in enumerate(whole, len(boxes)):
        things[k, :5] = box_round(boxes[slice(*spans[group])])
    things[len(boxes) :, NUMBER], things[len(boxes) :, IS_FLOOR] = whole, 1.0
    things[:, KIND], things[:, OF_GROUP] = kinds[things[:, NUMBER].astype(int)], other
    return things


def _mark_groups(seen: HallRows, kept: Kept) -> Ints:
    """What each group is to the rows, the names of :data:`GROUPS` they are about as bits (g,)."""
    marks = np.zeros(len(seen.problem.units.spans), np.int64)
    if not len(seen.problem.visitors.roles):
        return marks
    for bit, name in _list_names(seen.rows):
        marks |= bit * GROUPS[name](seen.problem, kept)
    return marks


@lru_cache(maxsize=64)
def _list_names(rows: tuple[Row, ...]) -> tuple[tuple[int, str], ...]:
    """The names that rows are about, each with its bit."""
    named = {name for row in rows for c in (row.of, row.to) for name in (*c.kinds, *(c.but or ()))}
    return tuple((1 << bit, name) for bit, name in enumerate(GROUPS) if name in named)


@lru_cache(maxsize=256)
def _compile(known: Same[tuple[Row, ...]], marks: tuple[int, ...]) -> Table:
    """The rows compiled for groups that are what some ``marks`` say."""
    bits = {name: bit for bit, name in _list_names(known.value)}

    def find(names: frozenset[str]) -> frozenset[str]:
        return frozenset(str(mark) for mark in marks if any(mark & bits[name] for name in names))

    def read(each: Class) -> Class:
        but = None if each.but is None else find(each.but)
        return each._replace(kinds=find(each.kinds), but=but)

    rows = [row._replace(of=read(row.of), to=read(row.to)) for row in known.value]
    return compile_rows(rows, {})
