"""The visitor's route through a hall: from an entrance past every group to an exit.

Places to stop at are ordered by travel time, zone by zone and group by group where possible; the
ways between them prefer wide ones.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.space import Opening, Points, Space
from scenewright.domains.hall.classes import DECOR
from scenewright.domains.hall.hall_layout import HallLayout, Stop, Tour
from scenewright.domains.hall.visit.doors import visitor_exits, ways_in
from scenewright.domains.hall.visit.floor import WalkingFloor, find_floor
from scenewright.domains.hall.visit.order import find_places, find_visits, search_from
from scenewright.geometry.distance_raster import DistanceRaster, distances
from scenewright.geometry.travel import TravelSearch, make_search, round_off, string_pull

Floats = NDArray[np.float64]
Cells = NDArray[np.int64]

TOUR_STEP, FINE = 0.5, 0.25
"""Distance of the points of a tour, and of those that are rounded off, at most, in metres."""
TOUR_BEHIND, TURN = 1.2, 16.0
"""Metres behind a visitor, and the seconds a metre there costs more, so that tours go on ahead."""
SWERVE, ROUNDS = 0.6, 40


def tour(
    space: Space, pieces: tuple[Piece, ...], graph: HallLayout, catalog: Catalog, width: float
) -> Tour | None:
    """The route of a visitor through a hall, ``None`` if it has no door one can come in by.

    It keeps to ways ``width`` metres wide and passes narrower ones only to groups with no other
    way; the tour tells the true clear width at each of its points. Groups with no way at all
    have no stop, nor have plants, bins and ropes.
    """
    floor = find_floor(space, pieces, catalog, width)
    entrances, exits = ways_in(space), visitor_exits(space)
    entrances = [door for door in entrances if math.isfinite(floor.slow.flat[_cell(floor, door)])]
    if not entrances:
        return None
    search = make_search(floor.slow.size)
    start = _cell(floor, entrances[0])
    search_from(search, floor, [start])
    doors = _last_doors(floor, search.times, entrances[0], exits)
    decor = {piece.id for piece in pieces if piece.category in DECOR}
    groups = [group for group in graph.groups if group.space == space.id]
    groups = [group for group in groups if not decor.issuperset(group.objects)]
    places = find_places(floor, search.times, groups, pieces, catalog, width, start)
    order, cells = find_visits(search, floor, places, [_cell(floor, door) for door in doors])
    way_out = [_cell(floor, door) for door in doors].index(cells[-1])
    line, at = _line(search, floor, cells)
    line[0], line[-1] = _middle(entrances[0]), _middle(doors[way_out])
    if len(line) < 2 or (len(cells) == 2 and cells[0] == cells[1]):
        return None
    points, marks = _smooth(line, at, floor.clear, width / 2)
    seen = dict.fromkeys(places.groups[order[1:]].tolist())
    first = [int(np.flatnonzero(places.groups[order] == g)[0]) for g in seen]
    stops = tuple(Stop(groups[g].id, int(marks[k])) for g, k in zip(seen, first, strict=True))
    return Tour(space.id, points, 2 * distances(points, floor.solids), stops)


def _last_doors(
    floor: WalkingFloor, times: Floats, entrance: Opening, exits: list[Opening]
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


def _line(search: TravelSearch, floor: WalkingFloor, cells: list[int]) -> tuple[Points, Cells]:
    """The way over the cells as a line (k, 2) and where along it each of them is."""
    line, at = _centres(floor, cells[:1]), [0]
    for start, goal in pairwise(cells):
        leg = _leg(search, _onward(floor, line), start, goal)
        line = np.vstack([line, _centres(floor, leg)])
        at.append(len(line) - 1)
    return line, np.array(at)


def _onward(floor: WalkingFloor, line: Points) -> WalkingFloor:
    """The floor for one who came along a line and would rather not turn round: slow behind."""
    along = _lengths(line)
    if along[-1] < TOUR_BEHIND:
        return floor
    x, y = (np.interp(along[-1] - TOUR_BEHIND, along, line[:, axis]) for axis in (0, 1))
    clear = floor.clear
    column, row = int((x - clear.x0) / clear.cell), int((y - clear.y0) / clear.cell)
    reach = math.ceil(TOUR_BEHIND / clear.cell)
    rows = np.arange(max(row - reach, 0), min(row + reach + 1, len(floor.slow)))
    columns = np.arange(max(column - reach, 0), min(column + reach + 1, floor.slow.shape[1]))
    near = np.hypot(rows[:, None] - row, columns - column) * clear.cell < 0.9 * TOUR_BEHIND
    slow = floor.slow.copy()
    slow[np.ix_(rows, columns)] += TURN * near
    return floor._replace(slow=slow)


def _centres(floor: WalkingFloor, cells: list[int]) -> Points:
    row, column = np.divmod(np.array(cells), floor.slow.shape[1])
    clear = floor.clear
    return clear.cell * (np.column_stack([column, row]) + 0.5) + (clear.x0, clear.y0)


def _leg(search: TravelSearch, floor: WalkingFloor, start: int, goal: int) -> list[int]:
    """The corners of the quickest way between two cells, without the first."""
    search_from(search, floor, [start], goal)
    back = [goal]
    while back[-1] != start:
        back.append(int(search.before[back[-1]]))
    path = np.array(back[::-1], np.int32)
    kept = np.empty(len(path), np.int32)
    count = string_pull(path, floor.slow, search.times[path], floor.clear.cell, kept)
    return [int(cell) for cell in kept[1:count]]


def _smooth(line: Points, at: Cells, clear: DistanceRaster, least: float) -> tuple[Points, Cells]:
    """A line rounded off, with a point at least every 0.5 m, and where its marks are now."""
    along = _lengths(line)
    home = _resample_line(line, along, FINE)
    points = home.copy()
    round_off(points, home, clear, least + clear.cell / 2, SWERVE, ROUNDS)
    share = np.searchsorted(np.linspace(0, along[-1], len(home)), along[at] - 1e-9)
    grown = _lengths(points)
    done = _resample_line(points, grown, TOUR_STEP)
    marks = np.rint(grown[share] / max(grown[-1], 1e-9) * (len(done) - 1)).astype(np.int64)
    return done, marks


def _lengths(line: Points) -> Floats:
    steps = np.hypot(*np.diff(line, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _resample_line(line: Points, along: Floats, step: float) -> Points:
    """Points at equal distances of at most ``step`` along a line with its lengths."""
    places = np.linspace(0.0, along[-1], max(math.ceil(along[-1] / step), 1) + 1)
    return np.column_stack([np.interp(places, along, line[:, axis]) for axis in (0, 1)])


def _middle(door: Opening) -> tuple[float, float]:
    return door.x, door.y


def _cell(floor: WalkingFloor, door: Opening) -> int:
    """The cell of the raster the middle of a door is in."""
    column = int((door.x - floor.clear.x0) / floor.clear.cell)
    row = int((door.y - floor.clear.y0) / floor.clear.cell)
    return row * floor.slow.shape[1] + column
