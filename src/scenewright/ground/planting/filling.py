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
    drop_near,
    keep_apart,
    shake_grid,
    spread_evenly,
)
from scenewright.ground.planting.streets import (
    FROM_DOORS,
    TakenGround,
    list_lamp_places,
    list_tree_places,
)

MOST = 900
"""Most trees, and most lamps, of an area."""
CLOSE, FINE, LEAST_STEP = 0.6, 0.5, 1.5
"""Of the mean distance of trees: the least between two, the step of the grid tried, its least in
metres."""
IN_ROW = 4.0
"""Metres at least between the trees, and between the lamps, of streets."""


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
    lamps = _choose(ground, list_lamp_places(roads, taken), wanted[1])
    lit = _keep_off(taken, lamps)
    rows = _choose(ground, list_tree_places(roads, lit), wanted[0])
    lit = _keep_off(lit, rows)
    return PlantedSpots(np.vstack([rows, _fill_green(ground, lit, like, rng)]), lamps)


def _count(density: float, size: float) -> int:
    return min(round(density * size), MOST)


def _keep_off(taken: TakenGround, spots: Floats) -> TakenGround:
    """The same ground with what stands at some spots, as if there were doors."""
    doors = [*taken.doors.geometries, *shapely.points(spots[:, :2])]
    return taken._replace(doors=shapely.STRtree(doors))


def _choose(ground: PlantedGround, sides: Sequence[Floats], count: int) -> Floats:
    """At most ``count`` of the places along some sides of streets, as far apart as can be."""
    spots = np.concatenate([np.zeros((0, sides[0].shape[1] if sides else 2)), *sides])
    spots = spots[shapely.contains_xy(ground.floor, spots[:, 0], spots[:, 1])]
    return keep_apart(spread_evenly(spots, count), IN_ROW)


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
    for shapes, distance in (
        (taken.buildings, FROM_HOUSES),
        (taken.walks, FROM_WAYS),
        (taken.ways, FROM_WAYS),
        (taken.doors, FROM_DOORS),
    ):
        spots = drop_near(spots, shapes, distance)
    return keep_apart(spots[rng.permutation(len(spots))], CLOSE * mean)[:count]
