"""A camera's way through the rooms of a level: quickest ways between them, rounded, evenly spaced.

Places are drawn in every room that can be reached and visited from the nearest to the nearest.
Ways are searched on cells whose clearance is a cell more than asked for: what a straight line
between two of them passes is then as clear as asked.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.geometry.distance_raster import distances
from scenewright.geometry.travel import TravelSearch, make_search, round_off, spread, string_pull
from scenewright.render.observations.floor import WalkableFloor
from scenewright.render.observations.views import Viewpoint

EASE = 0.6
"""More clearance than this makes nobody walk faster, in metres."""
SLOWEST = 3.0
"""Seconds a metre where it is narrowest; 1 where it is wide."""
AREA, FEWEST, MOST = 4.0, 2, 4
"""Square metres of free floor to one place that is visited, and how many there are in a room."""
FINE, SWERVE, ROUNDS = 0.1, 0.5, 60
"""Metres between the points that are rounded off, how far they move at most, how often."""
AHEAD, STEADY = 0.8, 0.45
"""How far ahead a camera looks along its way, and how far its turns are spread, in metres."""
PITCH = float(np.deg2rad(-8.0))

Floats = NDArray[np.float64]
Cells = NDArray[np.int64]


class RouteFloor(NamedTuple):
    """A floor with seconds a metre ``slow`` (rows, columns) and a search over it."""

    floor: WalkableFloor
    slow: Floats
    search: TravelSearch


def walk_through(
    floors: Sequence[WalkableFloor],
    rooms: frozenset[str],
    count: int,
    eye: float,
    clearance: float,
    rng: np.random.Generator,
) -> list[Viewpoint]:
    """So many poses, evenly spaced along one way through the rooms of the level that has most of
    them free. ``rooms`` are those to visit (empty: all), ``clearance`` the least distance to walls
    and pieces, in metres."""
    tried = [_visit(_route_floor(floor, clearance), rooms, rng) for floor in floors]
    found = [(len(cells), k) for k, (_, cells) in enumerate(tried) if len(cells) > 1]
    if not found:
        raise InputError(
            f"no way is free for a camera with {clearance:g} m around it",
            "give a smaller --clearance, or another --room",
        )
    route, cells = tried[max(found, key=lambda row: (row[0], -row[1]))[1]]
    line = np.vstack(
        [route.floor.centres(np.array(cells[:1])), *(_leg(route, a, b) for a, b in pairwise(cells))]
    )
    path = _resample(line, FINE)
    home = path.copy()
    least = clearance + route.floor.clear.cell
    round_off(path, home, route.floor.clear, least, SWERVE, ROUNDS)
    return _poses(route.floor, path, count, eye)


def _route_floor(floor: WalkableFloor, clearance: float) -> RouteFloor:
    free = floor.clear.values
    tight = np.clip((clearance + EASE - free) / EASE, 0.0, 1.0)
    slow = np.where(free >= clearance + floor.clear.cell, 1 + (SLOWEST - 1) * tight, np.inf)
    return RouteFloor(floor, slow, make_search(free.size))


def _visit(
    route: RouteFloor, rooms: frozenset[str], rng: np.random.Generator
) -> tuple[RouteFloor, list[int]]:
    """Cells to visit in order: the largest group of places that can be reached from each other."""
    places = _places(route, rooms, rng)
    best: list[int] = []
    left = list(places)
    while left:
        order, joined = [left[0]], set(_reached(route, left[0], left))
        left = [cell for cell in left if cell not in joined]
        joined.discard(order[0])
        while joined:
            _search(route, order[-1], -1)
            order.append(min(joined, key=lambda cell: (route.search.times[cell], cell)))
            joined.discard(order[-1])
        best = max(best, order, key=len)
    return route, best


def _places(route: RouteFloor, rooms: frozenset[str], rng: np.random.Generator) -> list[int]:
    """Cells drawn in each room among its clearer ones."""
    found: list[int] = []
    clear = route.floor.clear
    for number, space in enumerate(route.floor.spaces):
        here = np.isfinite(route.slow) & (route.floor.room == number)
        if not here.any() or (rooms and space.id not in rooms):
            continue
        good = here & (clear.values >= 0.7 * clear.values[here].max())
        many = int(np.clip(here.sum() * clear.cell**2 / AREA, FEWEST, MOST))
        cells = np.flatnonzero(good)
        found += dict.fromkeys(rng.choice(cells, many).tolist())
    return found


def _reached(route: RouteFloor, start: int, cells: Sequence[int]) -> list[int]:
    _search(route, start, -1)
    return [cell for cell in cells if np.isfinite(route.search.times[cell])]


def _search(route: RouteFloor, start: int, goal: int) -> None:
    cell = route.floor.clear.cell
    spread(route.search, route.slow, cell, np.array([start], np.int32), goal)


def _leg(route: RouteFloor, start: int, goal: int) -> Floats:
    """The corners of the quickest way between two cells, without the first."""
    _search(route, start, goal)
    back = [goal]
    while back[-1] != start:
        back.append(int(route.search.before[back[-1]]))
    path = np.array(back[::-1], np.int32)
    kept = np.empty(len(path), np.int32)
    times = route.search.times[path]
    count = string_pull(path, route.slow, times, route.floor.clear.cell, kept)
    return route.floor.centres(kept[1:count].astype(np.int64))


def _lengths(line: Floats) -> Floats:
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])


def _resample(line: Floats, step: float) -> Floats:
    along = _lengths(line)
    places = np.linspace(0.0, along[-1], max(int(np.ceil(along[-1] / step)), 2) + 1)
    return _at(line, along, places)


def _at(line: Floats, along: Floats, places: Floats) -> Floats:
    return np.column_stack([np.interp(places, along, line[:, axis]) for axis in (0, 1)])


def _poses(floor: WalkableFloor, path: Floats, count: int, eye: float) -> list[Viewpoint]:
    along = _lengths(path)
    places = np.linspace(0.0, along[-1], count)
    points = _at(path, along, places)
    yaws = np.interp(places, *_headings(path, along))
    clear = distances(points, floor.solids)
    cells = np.floor((points - (floor.clear.x0, floor.clear.y0)) / floor.clear.cell).astype(int)
    rooms = floor.room[cells[:, 1], cells[:, 0]]
    return [
        Viewpoint(
            (x, y, floor.elevation + eye),
            yaw,
            PITCH,
            floor.spaces[room].id if room >= 0 else "",
            floor.level,
            round(away, 4),
        )
        for (x, y), yaw, room, away in zip(
            points.tolist(), yaws.tolist(), rooms.tolist(), clear.tolist(), strict=True
        )
    ]


def _headings(path: Floats, along: Floats) -> tuple[Floats, Floats]:
    """Places along a path every few centimetres, and the directions ahead there, turned slowly."""
    places = np.linspace(0.0, along[-1], max(int(np.ceil(along[-1] / 0.05)), 1) + 1)
    step = places[1] - places[0]
    ahead = _at(path, along, np.minimum(places + AHEAD, along[-1])) - _at(path, along, places)
    still = np.hypot(*ahead.T) < 0.1
    angles = np.arctan2(ahead[:, 1], ahead[:, 0])
    kept = np.flatnonzero(~still) if not still.all() else np.array([0])
    turned = np.interp(places, places[kept], np.unwrap(angles[kept]))
    reach = int(np.ceil(3 * STEADY / step))
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) * step / STEADY) ** 2)
    padded = np.pad(turned, reach, mode="edge")
    return places, np.convolve(padded, weights / weights.sum(), mode="valid")
