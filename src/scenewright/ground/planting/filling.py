"""Ground planted and lit as densely as another place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.ground.buildings.built import BuiltRoad, Floats
from scenewright.ground.planting.density import HECTARE, STRETCH, PlantedGround, Planting
from scenewright.ground.planting.places import (
    FROM_HOUSES,
    FROM_WAYS,
    VERGE,
    drop_near,
    keep_apart,
    points_beside,
    shake_grid,
    spread_evenly,
    turn_to_road,
)

MOST = 900
"""Most trees, and most lamps, of an area."""
LAMP_OFF = 0.5
"""Metres that lamps stand off the edge of a street."""
FROM_LAMPS, FROM_DOORS, FROM_ROADS = 0.6, 2.0, 0.4
"""Metres that lamps keep from buildings and walks, everything from doors, lamps from streets."""
TRIED = 2.0
"""Metres between the places beside a street that are tried."""
CLOSE, FINE, LEAST_STEP = 0.6, 0.5, 1.5
"""Of the mean distance of trees: the least between two, the step of the grid tried, its least in
metres."""
IN_ROW = 4.0
"""Metres at least between the trees, and between the lamps, of streets."""


class TakenGround(NamedTuple):
    """What trees and lamps keep clear of."""

    buildings: shapely.STRtree
    ways: shapely.STRtree
    walks: shapely.STRtree
    doors: shapely.STRtree


class PlantedSpots(NamedTuple):
    """Where trees (n, 2) stand, and lamps (m, 3) with their headings."""

    trees: Floats
    lamps: Floats


def plant_alike(
    ground: PlantedGround,
    roads: Sequence[BuiltRoad],
    taken: TakenGround,
    like: Planting,
    rng: np.random.Generator,
) -> PlantedSpots:
    """Trees and lamps on some ground and its ``roads``, as dense as a place they are to be
    ``like``, as far as they find room clear of what is ``taken``."""
    metres = float(ground.streets.length)
    wanted = [_count(per, metres / STRETCH) for per in (like.trees_along, like.lamps_along)]
    lamps = _line_streets(ground, roads, LAMP_OFF)
    lamps = _clear(lamps, taken, FROM_LAMPS, FROM_LAMPS, FROM_ROADS)
    lamps = keep_apart(spread_evenly(lamps, wanted[1]), IN_ROW)
    lit = taken._replace(doors=shapely.STRtree([*taken.doors.geometries, *_points(lamps)]))
    rows = _clear(_line_streets(ground, roads, VERGE), lit, FROM_HOUSES, FROM_WAYS, FROM_WAYS)
    rows = keep_apart(spread_evenly(rows, wanted[0]), IN_ROW)[:, :2]
    lit = lit._replace(doors=shapely.STRtree([*lit.doors.geometries, *_points(rows)]))
    return PlantedSpots(np.vstack([rows, _fill_green(ground, lit, like, rng)]), lamps)


def _count(density: float, size: float) -> int:
    return min(round(density * size), MOST)


def _points(spots: Floats) -> list[shapely.Point]:
    return list(shapely.points(spots[:, :2]))


def _line_streets(ground: PlantedGround, roads: Sequence[BuiltRoad], off: float) -> Floats:
    """Places (n, 3) with headings on both sides of streets, ``off`` metres from their edges."""
    found = [np.zeros((0, 3))]
    for road in (road for road in roads if road.kind == "road"):
        for side in (1, -1):
            at = points_beside(road.line, side * (road.width / 2 + off), TRIED, TRIED / 2)
            at[:, 2] = turn_to_road(at[:, 2], side)
            found.append(at)
    spots = np.concatenate(found)
    return spots[shapely.contains_xy(ground.floor, spots[:, 0], spots[:, 1])]


def _clear(spots: Floats, taken: TakenGround, houses: float, walks: float, ways: float) -> Floats:
    """Spots that keep their distances in metres."""
    for shapes, distance in (
        (taken.buildings, houses),
        (taken.walks, walks),
        (taken.ways, ways),
        (taken.doors, FROM_DOORS),
    ):
        spots = drop_near(spots, shapes, distance)
    return spots


def _fill_green(
    ground: PlantedGround, taken: TakenGround, like: Planting, rng: np.random.Generator
) -> Floats:
    """Trees (n, 2) off the streets."""
    density = like.trees_per_hectare
    count = _count(density, ground.green.area / HECTARE)
    if not count:
        return np.zeros((0, 2))
    mean = (HECTARE / density) ** 0.5
    west, south, east, north = ground.floor.bounds
    step = max(FINE * mean, LEAST_STEP, (ground.green.area / (8 * MOST)) ** 0.5)
    spots = shake_grid(np.array([west, south]), np.array([east, north]), step, rng)
    spots = spots[shapely.contains_xy(ground.green, spots[:, 0], spots[:, 1])]
    spots = _clear(spots, taken, FROM_HOUSES, FROM_WAYS, FROM_WAYS)
    return keep_apart(spots[rng.permutation(len(spots))], CLOSE * mean)[:count]
