"""Ground shaped for what stands on it: level ways, level platforms, banks between them.

Cells of ways and platforms have the heights of these; elsewhere the natural ground z is kept
between the banks that fall and rise from them by :data:`BATTER`:

    min(max(z, max_i (z_i - s d_i)), min_i (z_i + s d_i)).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.heights import HeightGrid, heights_at
from scenewright.core.space import Points
from scenewright.geometry.batters import bank
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.terrain.profiles import AREA, WayStations, grade_ways

Floats = NDArray[np.float64]
BATTER = 2 / 3
"""Rise of a bank, in metres a metre."""
THRESHOLD = 0.15
"""Metres that a floor lies above the platform: one step."""
APRON = 1.3
"""Metres of level ground around a building."""
BESIDE = 1.2
"""Metres that the level of a way reaches beyond its edge."""
LANDING = 3.0
"""Metres before a door that are level with it."""
CLIMB = 0.4
"""Greatest rise of a walk with steps, in metres a metre."""
LARGE = 1e6
"""What ranks paved areas behind ways."""
STOOP = 1.0
"""Metres about a door that belong to its platform."""
ROUNDED = 3
"""How often banks are rounded: each cell takes the mean of its neighbours."""
BED = 0.8
"""Depth of water, in metres."""
FINEST, MOST = 1.0, 60_000
"""Least distance of heights, in metres, and about how many there are at most."""


class GroundBuilding(NamedTuple):
    """A building as the ground sees it: its footprint, and the middle of its door (2,)."""

    id: str
    shape: shapely.Polygon
    door: Points


class LevelWater(NamedTuple):
    """Water: its polygon and the level of its surface in metres."""

    shape: shapely.Polygon
    level: float


class ShapedGround(NamedTuple):
    """Ground as it was and as it is built on. ``deck`` is the finished ground with ways led over
    water; ``floors`` are the levels of ground floors by building; ``cut`` and ``fill`` cubic
    metres of ground taken away and brought."""

    natural: HeightGrid
    finished: HeightGrid
    deck: HeightGrid
    floors: dict[str, float]
    ways: WayStations | None
    waters: tuple[LevelWater, ...]
    cut: float
    fill: float


def shape_ground(
    natural: HeightGrid,
    floor: shapely.Geometry,
    ways: Sequence[BuiltRoad],
    buildings: Sequence[GroundBuilding],
    waters: Sequence[LevelWater],
) -> ShapedGround:
    """The ground of a ``floor`` shaped for ways, buildings and water."""
    grid = lay_lattice(natural, floor)
    stations = grade_ways(ways, natural) if ways else None
    points = grid.points.reshape(-1, 2)
    fixed = np.full(len(points), np.nan)
    over = fixed.copy()
    if stations is not None:
        _level_ways(points, ways, stations, over)
    levels = np.array([choose_platform(one, grid, stations) for one in buildings])
    shapes = np.array([one.shape for one in buildings], object)
    stoops = shapely.points(np.array([one.door for one in buildings]).reshape(-1, 2))
    wide = shapely.union(shapes, shapely.buffer(stoops, STOOP, quad_segs=2))
    _level_platforms(points, wide, levels, fixed, APRON)
    on_way = ~np.isnan(over)
    fixed[on_way] = over[on_way]
    _level_platforms(points, shapes, levels, fixed, 0.0)
    wet = _level_waters(points, waters, fixed)
    finished = _join(grid, fixed.reshape(grid.values.shape))
    deck = np.where((wet & on_way).reshape(grid.values.shape), over.reshape(grid.values.shape), 0)
    deck = np.where(deck != 0, deck, finished)
    moved = (finished - grid.values).reshape(-1)[~wet] * grid.step**2
    return ShapedGround(
        natural,
        grid._replace(values=finished),
        grid._replace(values=deck),
        {one.id: float(z) + THRESHOLD for one, z in zip(buildings, levels, strict=True)},
        stations,
        tuple(waters),
        float(-moved[moved < 0].sum()),
        float(moved[moved > 0].sum()),
    )


def lay_lattice(natural: HeightGrid, floor: shapely.Geometry) -> HeightGrid:
    """Natural heights on a square grid over a floor, :data:`FINEST` metres apart or coarser."""
    left, low, right, high = floor.bounds
    step = max(FINEST, float(np.sqrt((right - left) * (high - low) / MOST)))
    start = (left - 2 * step, low - 2 * step)
    columns, rows = (int(np.ceil(w / step)) + 5 for w in (right - left, high - low))
    grid = HeightGrid(start, step, np.zeros((rows, columns)))
    return grid._replace(values=heights_at(natural, grid.points))


def choose_platform(one: GroundBuilding, natural: HeightGrid, ways: WayStations | None) -> float:
    """The level of a building's ground: the mean of what it covers, so that cut makes fill, as far
    as its walk can climb; level with a way that runs before the door."""
    inner = natural.points.reshape(-1, 2)
    left, low, right, high = one.shape.bounds
    near = (inner >= (left, low)).all(1) & (inner <= (right, high)).all(1)
    spots = inner[near]
    spots = spots[shapely.contains_xy(one.shape, spots[:, 0], spots[:, 1])]
    corners = shapely.get_coordinates(one.shape)[:-1]
    level = float(heights_at(natural, np.concatenate([spots, corners])).mean())
    if ways is None:
        return level
    away = np.hypot(*(ways.points - one.door).T) - ways.half
    k = int(np.argmin(away))
    climb = CLIMB * max(float(away[k]) - LANDING, 0.0)
    return float(np.clip(level, ways.heights[k] - climb, ways.heights[k] + climb))


def _level_ways(
    points: Points, ways: Sequence[BuiltRoad], stations: WayStations, over: Floats
) -> None:
    """Cells of ways, and a little beside them, are as high as the nearest point of the nearest."""
    spots, best = shapely.points(points), np.full(len(points), np.inf)
    tree = shapely.STRtree(spots)
    for number, way in enumerate(ways):
        line, own = shapely.LineString(way.line), stations.way == number
        beside = 0.0 if way.kind == AREA else BESIDE
        cells = tree.query(line, predicate="dwithin", distance=way.width / 2 + beside)
        away = shapely.distance(spots[cells], line) - way.width / 2
        away += LARGE * (way.kind == AREA)
        nearer = cells[away < best[cells]]
        best[cells] = np.minimum(best[cells], away)
        along = shapely.line_locate_point(line, spots[nearer])
        over[nearer] = np.interp(along, stations.along[own], stations.heights[own])


def _level_platforms(
    points: Points, shapes: NDArray[np.object_], levels: Floats, fixed: Floats, apron: float
) -> None:
    """Cells on the ground of a building, or at most ``apron`` metres beside it, have its level:
    that of the nearest."""
    if not len(shapes):
        return
    spots = shapely.points(points)
    cell, near = shapely.STRtree(shapes).query(spots, predicate="dwithin", distance=apron)
    away = shapely.distance(spots[cell], shapes[near])
    for k in np.argsort(-away, kind="stable").tolist():
        fixed[cell[k]] = levels[near[k]]


def _level_waters(points: Points, waters: Sequence[LevelWater], fixed: Floats) -> NDArray[np.bool_]:
    wet = np.zeros(len(points), bool)
    for water in waters:
        inside = shapely.contains_xy(water.shape, points[:, 0], points[:, 1])
        fixed[inside] = water.level - BED
        wet |= inside
    return wet


def _join(grid: HeightGrid, fixed: Floats) -> Floats:
    """Natural ground between the banks of what is fixed."""
    if np.isnan(fixed).all():
        return grid.values
    fall = BATTER * grid.step
    low, high = bank(fixed, fall), -bank(-fixed, fall)
    between = np.where(low > high, (low + high) / 2, np.clip(grid.values, low, high))
    heights, free = np.where(np.isnan(fixed), between, fixed), np.isnan(fixed)
    for _ in range(ROUNDED):
        heights = np.where(free, _average_cells(heights), heights)
    return heights


def _average_cells(heights: Floats) -> Floats:
    """The mean of each cell and its eight neighbours; at the border of itself."""
    rows = (heights[:-2] + heights[1:-1] + heights[2:]) / 3
    found = heights.copy()
    found[1:-1, 1:-1] = (rows[:, :-2] + rows[:, 1:-1] + rows[:, 2:]) / 3
    return found
