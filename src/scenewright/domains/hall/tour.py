"""The visitor's route through a hall: from an entrance past every group to an exit.

Places to stop at are ordered by travel time, zone by zone and group by group where possible; the
ways between them prefer wide ones.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog import Catalog
from scenewright.domains.hall.floor import Floor, find_floor
from scenewright.domains.hall.stops import stops_of
from scenewright.geometry.clearway import Raster, distances
from scenewright.geometry.rounds import shortest_round
from scenewright.geometry.travel import Search, make_search, pull, round_off, spread
from scenewright.scene import Piece
from scenewright.scene_graph import PlacedGroup, SceneGraph, Stop, Tour
from scenewright.space import Opening, Points, Space

Floats = NDArray[np.float64]
Cells = NDArray[np.int64]

LEAVE_ZONE, LEAVE_GROUP = 15.0, 4.0
"""Seconds a tour may lose so as to see a zone, or a group, in one go."""
STEP, FINE = 0.5, 0.25
"""Distance of the points of a tour, and of those that are rounded off, at most, in metres."""
SWERVE, ROUNDS = 0.4, 24


class Places(NamedTuple):
    """Where the tour has to pass: ``cells`` (n,) of the raster, entrance first, and the number
    of the ``groups`` (n,) and ``zones`` (n,) they belong to (-1 for doors)."""

    cells: Cells
    groups: Cells
    zones: Cells


def tour(
    space: Space,
    pieces: tuple[Piece, ...],
    graph: SceneGraph,
    catalog: Catalog,
    width: float,
) -> Tour | None:
    """The route of a visitor through a hall, ``None`` if it has no door one can come in by.

    It keeps to ways ``width`` metres wide and passes narrower ones only to groups with no other
    way; the tour tells the true clear width at each of its points. Groups with no way at all
    have no stop.
    """
    floor = find_floor(space, pieces, catalog, width)
    entrances, exits = _ways_in(space), _ways_out(space)
    entrances = [door for door in entrances if math.isfinite(floor.slow.flat[_cell(floor, door)])]
    if not entrances:
        return None
    search = make_search(floor.slow.size)
    start = _cell(floor, entrances[0])
    _spread(search, floor, [start])
    doors = _last_doors(floor, search.times, entrances[0], exits)
    groups = [group for group in graph.groups if group.space == space.id]
    places = _places(floor, search.times, groups, pieces, catalog, start)
    order, way_out = _order(search, floor, places, [_cell(floor, door) for door in doors])
    cells = [*places.cells[order].tolist(), _cell(floor, doors[way_out])]
    line, at = _line(search, floor, cells)
    line[0], line[-1] = _middle(entrances[0]), _middle(doors[way_out])
    if len(line) < 2 or (len(cells) == 2 and cells[0] == cells[1]):
        return None
    points, marks = _smooth(line, at, floor.clear, width / 2)
    seen = dict.fromkeys(places.groups[order[1:]].tolist())
    first = [int(np.flatnonzero(places.groups[order] == g)[0]) for g in seen]
    stops = tuple(Stop(groups[g].id, int(marks[k])) for g, k in zip(seen, first, strict=True))
    return Tour(space.id, points, 2 * distances(points, floor.solids), stops)


def _ways_in(space: Space) -> list[Opening]:
    """The doors visitors may come in by, the main entrance first."""
    return _ranked(space, "entrance", "exit")


def _ways_out(space: Space) -> list[Opening]:
    return _ranked(space, "exit", "entrance")


def _ranked(space: Space, use: str, other: str) -> list[Opening]:
    """Doors for one use, those for it alone first, then those to the outside, then wide ones."""
    doors = [door for door in space.openings if door.kind != "window"]
    uses = [door.use if door.spaces[:1] in ((), (space.id,)) else "both" for door in doors]
    rows = [
        (told != use, len(door.spaces) > 1, -door.width, k)
        for k, (door, told) in enumerate(zip(doors, uses, strict=True))
        if told != other
    ]
    return [doors[row[-1]] for row in sorted(rows)]


def _last_doors(
    floor: Floor, times: Floats, entrance: Opening, exits: list[Opening]
) -> list[Opening]:
    """The doors the tour may end at: of the best rank, another than the entrance if possible."""
    usable = [
        door for door in exits if door is not entrance and math.isfinite(times[_cell(floor, door)])
    ]
    if not usable:
        return [entrance]
    best = usable[0]
    return [
        door
        for door in usable
        if (door.use, len(door.spaces)) == (best.use, len(best.spaces))
        and door.width > 0.7 * best.width
    ]


def _places(
    floor: Floor,
    times: Floats,
    groups: list[PlacedGroup],
    pieces: tuple[Piece, ...],
    catalog: Catalog,
    start: int,
) -> Places:
    """The entrance and the places to stop at."""
    known = {piece.id: piece for piece in pieces}
    zones = {zone: k for k, zone in enumerate(dict.fromkeys(group.zone for group in groups))}
    rows = [(start, -1, -1)]
    for number, group in enumerate(groups):
        members = tuple(known[name] for name in group.objects if name in known)
        stops = stops_of(group, members, catalog, floor.clear, times)
        rows += [(int(cell), number, zones[group.zone]) for cell in stops]
    return Places(*np.array(rows, np.int64).T)


def _order(search: Search, floor: Floor, places: Places, doors: list[int]) -> tuple[Cells, int]:
    """The order of the places, and the number of the door to leave by."""
    n = len(places.cells)
    times = _travel_times(search, floor, np.array([*places.cells, *doors]))
    costs = np.zeros((n + 1, n + 1))
    costs[:n, :n] = times[:n, :n]
    costs[1:n, 1:n] += LEAVE_ZONE * (places.zones[1:, None] != places.zones[1:])
    costs[1:n, 1:n] += LEAVE_GROUP * (places.groups[1:, None] != places.groups[1:])
    costs[n, :n] = costs[:n, n] = times[:n, n:].min(axis=1)
    order = shortest_round(costs)[:-1]
    return order, int(np.argmin(times[order[-1], n:]))


def _travel_times(search: Search, floor: Floor, cells: Cells) -> Floats:
    """Travel times (n, n) between cells of the raster.

    All of them start at once; where the areas nearest to two of them touch, there is a way
    between the two. Ways over several are sums (Floyd 1962, Warshall 1962), so a time may be
    somewhat too long, never too short.
    """
    own, number = np.unique(cells, return_inverse=True)
    _spread(search, floor, own.tolist())
    shape, cell, n = floor.slow.shape, floor.clear.cell, len(own)
    source, took = search.source.reshape(shape), search.times.reshape(shape)
    times = np.where(np.eye(n, dtype=bool), 0.0, np.inf)
    for here, there, length in _neighbours(cell):
        a, b = source[here], source[there]
        met = (a != b) & np.isfinite(took[here]) & np.isfinite(took[there])
        met &= floor.clear.values[here] + floor.clear.values[there] > length
        over = 0.5 * length * (floor.slow[here][met] + floor.slow[there][met])
        way = took[here][met] + took[there][met] + over
        np.minimum.at(times, (a[met], b[met]), way)
    times = np.minimum(times, times.T)
    for k in range(n):
        np.minimum(times, times[:, k : k + 1] + times[k], out=times)
    return times[np.ix_(number, number)]


def _neighbours(
    cell: float,
) -> list[tuple[tuple[slice, slice], tuple[slice, slice], float]]:
    """Views of a raster shifted against each other by one cell, and the distance."""
    every, first, last = slice(None), slice(None, -1), slice(1, None)
    return [
        ((every, first), (every, last), cell),
        ((first, every), (last, every), cell),
        ((first, first), (last, last), cell * math.sqrt(2)),
        ((first, last), (last, first), cell * math.sqrt(2)),
    ]


def _line(search: Search, floor: Floor, cells: list[int]) -> tuple[Points, Cells]:
    """The way over the cells as a line (k, 2) and where along it each of them is."""
    path, at = [cells[0]], [0]
    for start, goal in pairwise(cells):
        path += _leg(search, floor, start, goal)
        at.append(len(path) - 1)
    row, column = np.divmod(np.array(path), floor.slow.shape[1])
    clear = floor.clear
    x, y = clear.x0 + (column + 0.5) * clear.cell, clear.y0 + (row + 0.5) * clear.cell
    return np.column_stack([x, y]), np.array(at)


def _leg(search: Search, floor: Floor, start: int, goal: int) -> list[int]:
    """The corners of the quickest way between two cells, without the first."""
    _spread(search, floor, [start], goal)
    back = [goal]
    while back[-1] != start:
        back.append(int(search.before[back[-1]]))
    path = np.array(back[::-1], np.int32)
    kept = np.empty(len(path), np.int32)
    count = pull(path, floor.slow, search.times[path], floor.clear.cell, kept)
    return [int(cell) for cell in kept[1:count]]


def _smooth(line: Points, at: Cells, clear: Raster, least: float) -> tuple[Points, Cells]:
    """A line rounded off, with a point at least every 0.5 m, and where its marks are now."""
    along = _lengths(line)
    home = _resampled(line, along, FINE)
    points = home.copy()
    round_off(points, home, clear, least, SWERVE, ROUNDS)
    share = np.searchsorted(np.linspace(0, along[-1], len(home)), along[at] - 1e-9)
    grown = _lengths(points)
    done = _resampled(points, grown, STEP)
    marks = np.rint(grown[share] / max(grown[-1], 1e-9) * (len(done) - 1)).astype(np.int64)
    return done, marks


def _lengths(line: Points) -> Floats:
    steps = np.hypot(*np.diff(line, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _resampled(line: Points, along: Floats, step: float) -> Points:
    """Points at equal distances of at most ``step`` along a line with its lengths."""
    places = np.linspace(0.0, along[-1], max(math.ceil(along[-1] / step), 1) + 1)
    return np.column_stack([np.interp(places, along, line[:, axis]) for axis in (0, 1)])


def _middle(door: Opening) -> tuple[float, float]:
    return door.x, door.y


def _cell(floor: Floor, door: Opening) -> int:
    """The cell of the raster the middle of a door is in."""
    column = int((door.x - floor.clear.x0) / floor.clear.cell)
    row = int((door.y - floor.clear.y0) / floor.clear.cell)
    return row * floor.slow.shape[1] + column


def _spread(search: Search, floor: Floor, starts: list[int], goal: int = -1) -> None:
    spread(search, floor.slow, floor.clear, np.array(starts, np.int32), goal)
