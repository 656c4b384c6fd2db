"""How densely a place is planted and lit: trees per hectare of green ground, trees and lamps per
100 metres of street."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.ground.buildings.built import BuiltRoad, Floats

BESIDE = 4.0
"""Metres from the edge of a street within which a tree or lamp is the street's."""
HECTARE, STRETCH = 1e4, 100.0
"""Square metres of green and metres of street that figures are stated for."""


class Planting(NamedTuple):
    """What stands on some ground, and on how much: trees off the streets with the square metres
    of green, trees along the streets and lamps with the metres of street."""

    trees: float = 0.0
    green: float = 0.0
    along: float = 0.0
    lamps: float = 0.0
    street: float = 0.0

    @property
    def trees_per_hectare(self) -> float:
        """Trees per hectare of green."""
        return self.trees * HECTARE / self.green if self.green else 0.0

    @property
    def trees_along(self) -> float:
        """Trees per 100 m of street."""
        return self.along * STRETCH / self.street if self.street else 0.0

    @property
    def lamps_along(self) -> float:
        """Lamps per 100 m of street."""
        return self.lamps * STRETCH / self.street if self.street else 0.0


class PlantedGround(NamedTuple):
    """Some ground with its streets, which of it is green, and what lies along the streets."""

    floor: shapely.Geometry
    streets: shapely.Geometry
    beside: shapely.Geometry
    green: shapely.Geometry


def split_ground(
    floor: shapely.Geometry, roads: Sequence[BuiltRoad], built: shapely.Geometry
) -> PlantedGround:
    """Ground as its streets (lines), what lies along them, and what is green: neither ``built`` on,
    nor street or path, nor along a street.

    >>> road = BuiltRoad(np.array([[0.0, 5.0], [100.0, 5.0]]), 6.0)
    >>> found = split_ground(shapely.box(0, 0, 100, 50), [road], shapely.box(20, 20, 30, 30))
    >>> found.streets.length, found.green.area
    (100.0, 3700.0)
    """
    driven = [road for road in roads if road.kind == "road"]
    lines = shapely.union_all([shapely.LineString(road.line) for road in driven])
    beside = shapely.union_all([_cover(road, BESIDE) for road in driven])
    paths = shapely.union_all([_cover(road, 0.0) for road in roads if road.kind != "road"])
    taken = shapely.union_all([beside, paths, built])
    streets = shapely.intersection(lines, floor)
    return PlantedGround(floor, streets, beside, shapely.difference(floor, taken))


def count_planting(ground: PlantedGround, trees: Floats, lamps: Floats) -> Planting:
    """What of trees (n, 2) and lamps (m, 2) stands on some ground."""
    here = trees[shapely.contains_xy(ground.floor, trees[:, 0], trees[:, 1])]
    along = shapely.contains_xy(ground.beside, here[:, 0], here[:, 1])
    lit = shapely.intersection(ground.beside, ground.floor)
    return Planting(
        float((~along).sum()),
        float(ground.green.area),
        float(along.sum()),
        float(shapely.contains_xy(lit, lamps[:, 0], lamps[:, 1]).sum()),
        float(ground.streets.length),
    )


def add_planting(found: Sequence[Planting], shares: Sequence[float]) -> Planting:
    """Several places as one, each counted by its share."""
    rows = np.array(found, float).reshape(-1, len(Planting._fields))
    return Planting(*(np.array(shares, float) @ rows).tolist())


def _cover(road: BuiltRoad, more: float) -> shapely.Geometry:
    line = shapely.LineString(road.line)
    return shapely.buffer(line, road.width / 2 + more, cap_style="flat")
