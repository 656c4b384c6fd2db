"""In which order a visitor sees the groups, and where exactly to stop for each."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.domains.hall.hall_layout import PlacedGroup
from scenewright.domains.hall.visit.floor import WalkingFloor
from scenewright.domains.hall.visit.roles import turn_of
from scenewright.domains.hall.visit.stops import MOST, stops_of
from scenewright.geometry.travel import TravelSearch, shorten, spread
from scenewright.geometry.visiting_order import shortest_path_through

Floats = NDArray[np.float64]
Cells = NDArray[np.int64]

LEAVE_ZONE, LEAVE_GROUP = 15.0, 4.0
"""Seconds a tour may lose so as to see a zone, or a group, in one go."""
MANY = 600
"""Where there are many groups, each has fewer stops, so that there are not many more in all."""
CROWDED_STOPS = 10.0
"""Most metres of detour that avoiding a stop in a narrow place is worth."""


class Places(NamedTuple):
    """Where the tour has to pass: ``cells`` (n,) of the raster, entrance first, and the number
    of the ``groups`` (n,) and ``zones`` (n,) they belong to (-1 for doors); ``others``
    has for each place all cells that would do, the best one first; ``turns`` (n,) when the tour
    comes to each: desks to ask at first of all, tills last (:mod:`.roles`)."""

    cells: Cells
    groups: Cells
    zones: Cells
    others: list[Cells]
    turns: Cells


def find_places(
    floor: WalkingFloor,
    times: Floats,
    groups: list[PlacedGroup],
    pieces: tuple[Piece, ...],
    catalog: Catalog,
    width: float,
    start: int,
) -> Places:
    """The entrance and the places to stop at.

    ``times`` (c,) in seconds from the entrance, one for each cell of the raster in row-major
    order; ``width`` in metres.
    """
    known = {piece.id: piece for piece in pieces}
    zones = {zone: k for k, zone in enumerate(dict.fromkeys(group.zone for group in groups))}
    rows, others = [(start, -1, -1)], [np.array([start])]
    beside = {piece.category for piece in pieces}
    turns = [-1]
    most = min(max(MANY // max(len(groups), 1), 1), MOST)
    for number, group in enumerate(groups):
        members = tuple(known[name] for name in group.objects if name in known)
        stops = stops_of(members, catalog, floor, times, width / 2, most)
        rows += [(int(spots[0]), number, zones[group.zone]) for spots in stops]
        category = members[0].category if members else ""
        turns += [turn_of(category, beside)] * len(stops)
        others += stops
    cells, owners, within = np.array(rows, np.int64).T
    return Places(cells, owners, within, others, np.array(turns))


def find_visits(
    search: TravelSearch, floor: WalkingFloor, places: Places, doors: list[int]
) -> tuple[Cells, list[int]]:
    """The order (n,) of the places and the cells to pass, the one of the door to leave by last.

    What is the best place to stop depends on the order, and the order on the places: twice each.
    """
    for _round in range(2):
        order, way_out = _find_order(search, floor, places, doors)
        choices = [*(places.others[k] for k in order), np.array(doors[way_out : way_out + 1])]
        cells = _slide(floor, choices)
        moved = places.cells.copy()
        moved[order] = cells[:-1]
        places = places._replace(cells=moved)
    return order, cells


def _find_order(
    search: TravelSearch, floor: WalkingFloor, places: Places, doors: list[int]
) -> tuple[Cells, int]:
    """The order of the places, and the number of the door to leave by."""
    n = len(places.cells)
    times = _travel_times(search, floor, np.array([*places.cells, *doors]))
    costs = np.zeros((n + 1, n + 1))
    costs[:n, :n] = times[:n, :n]
    costs[1:n, 1:n] += LEAVE_ZONE * (places.zones[1:, None] != places.zones[1:])
    costs[1:n, 1:n] += LEAVE_GROUP * (places.groups[1:, None] != places.groups[1:])
    costs[n, :n] = costs[:n, n] = times[:n, n:].min(axis=1)
    order = _turn_by_turn(costs, places.turns)
    return order, int(np.argmin(times[order[-1], n:]))


def _turn_by_turn(costs: Floats, turns: Cells) -> Cells:
    """A short path (n,) from place 0 through all others, those of an earlier turn first; ``costs``
    (n + 1, n + 1) symmetric, the last row that of the way out, ``turns`` (n,).

    >>> x = np.array([0.0, 5.0, 1.0, 3.0, 6.0])
    >>> _turn_by_turn(np.abs(x[:, None] - x), np.array([-1, 0, 1, 1])).tolist()
    [0, 1, 3, 2]
    """
    order = [0]
    for turn in np.unique(turns[1:]):
        mine, later = (np.flatnonzero(marked) for marked in (turns == turn, turns > turn))
        ends = later if len(later) else np.array([len(turns)])
        here = np.array([order[-1], *mine])
        block = np.zeros((len(here) + 1, len(here) + 1))
        block[:-1, :-1] = costs[np.ix_(here, here)]
        block[-1, :-1] = block[:-1, -1] = costs[np.ix_(here, ends)].min(axis=1)
        order += here[shortest_path_through(block)[1:-1]].tolist()
    return np.array(order)


def _slide(floor: WalkingFloor, choices: list[Cells]) -> list[int]:
    """One cell of each of the choices in turn, so that the way over them is short and in the
    open: by dynamic programming over straight distances (Bellman 1957)."""
    columns, clear = floor.slow.shape[1], floor.clear
    spots = [np.column_stack(np.divmod(cells, columns)) * clear.cell for cells in choices]
    cost, before = np.zeros(len(choices[0])), []
    for last, here, cells in zip(spots, spots[1:], choices[1:], strict=False):
        apart = np.hypot(*(here[:, None] - last[None]).transpose(2, 0, 1))
        slow = floor.slow.ravel()[cells]
        before.append(np.argmin(cost + apart, axis=1))
        cost = (cost + apart).min(axis=1) + np.minimum(slow, CROWDED_STOPS)
    best = [int(np.argmin(cost))]
    for row in before[::-1]:
        best.append(int(row[best[-1]]))
    return [int(cells[k]) for cells, k in zip(choices, best[::-1], strict=True)]


def _travel_times(search: TravelSearch, floor: WalkingFloor, cells: Cells) -> Floats:
    """Travel times (n, n) between cells of the raster.

    All of them start at once; where the areas nearest to two of them touch, there is a way
    between the two, and so there is where a straight line is free. Ways over several are sums
    (Floyd 1962, Warshall 1962). So a time may be somewhat too long.
    """
    own, number = np.unique(cells, return_inverse=True)
    search_from(search, floor, own.tolist())
    shape, cell, n = floor.slow.shape, floor.clear.cell, len(own)
    source, took = search.source.reshape(shape), search.times.reshape(shape)
    times = np.where(np.eye(n, dtype=bool), 0.0, np.inf)
    for here, there, length in _neighbours(cell):
        a, b = source[here], source[there]
        met = (a != b) & np.isfinite(took[here]) & np.isfinite(took[there])
        over = 0.5 * length * (floor.slow[here][met] + floor.slow[there][met])
        way = took[here][met] + took[there][met] + over
        np.minimum.at(times, (a[met], b[met]), way)
    times = np.minimum(times, times.T)
    shorten(times, floor.slow, cell, own.astype(np.int32))
    for k in range(n):
        np.minimum(times, times[:, k : k + 1] + times[k], out=times)
    return times[np.ix_(number, number)]


def _neighbours(cell: float) -> list[tuple[tuple[slice, slice], tuple[slice, slice], float]]:
    """Views of a raster shifted against each other by one cell, and the distance."""
    every, first, last = slice(None), slice(None, -1), slice(1, None)
    return [
        ((every, first), (every, last), cell),
        ((first, every), (last, every), cell),
        ((first, first), (last, last), cell * math.sqrt(2)),
        ((first, last), (last, first), cell * math.sqrt(2)),
    ]


def search_from(
    search: TravelSearch, floor: WalkingFloor, starts: list[int], goal: int = -1
) -> None:
    """Travel times on a floor from some cells, to a goal or (-1) everywhere."""
    spread(search, floor.slow, floor.clear.cell, np.array(starts, np.int32), goal)
