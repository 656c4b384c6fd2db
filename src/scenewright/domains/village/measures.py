"""What can be said of a filled block in figures: gaps, angles, distances, coverage, voids."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.relations import PoseRelations, relate
from scenewright.domains.village.standing import Floats, StandingHouses

STEP = 4.0
"""Distance in metres of the points at which voids are measured."""
USUAL_VOID = 0.57
"""Plot widths: the void of three quarters of the real blocks learned from is less."""
PARALLEL = float(np.deg2rad(5.0))


def relations_of(standing: StandingHouses, streets: Points) -> PoseRelations:
    """The relations of each house (n,) to all others and to the street."""
    count = len(standing.shapes)
    found = relate(standing.shapes, standing.frames[:, 2], standing, streets)
    if count < 2:
        return found
    away = shapely.distance(standing.shapes[:, None], standing.shapes[None])
    np.fill_diagonal(away, np.inf)
    nearest = away.argmin(1)
    turn = np.abs(
        (standing.frames[:, 2] - standing.frames[nearest, 2] + np.pi / 4) % (np.pi / 2) - np.pi / 4
    )
    return found._replace(gap=away.min(1), nearest=nearest, turn=turn)


def void(floor: shapely.Polygon, standing: StandingHouses) -> float:
    """The distance in metres to the nearest house that 95 % of the ground is within."""
    if not len(standing.shapes):
        return float("inf")
    points = grid(floor)
    away = shapely.distance(shapely.union_all(standing.shapes), shapely.points(points))
    return float(np.percentile(away, 95))


def excess_void(floor: shapely.Polygon, standing: StandingHouses) -> float:
    """By how many plot widths the void is wider than that of most real blocks (0 without houses);
    what is less is no merit, for real blocks have voids.

    >>> from scenewright.domains.village.standing import stand
    >>> house = np.array([[0.0, 0.0], [8, 0], [8, 8], [0, 8]])
    >>> excess_void(shapely.box(-2, -2, 10, 10), stand([house], [1]))
    0.0
    """
    count = len(standing.shapes)
    if not count:
        return 0.0
    return max(0.0, void(floor, standing) / float(np.sqrt(floor.area / count)) - USUAL_VOID)


def grid(floor: shapely.Polygon, step: float = STEP) -> Floats:
    """Points (k, 2) of a grid over ground, at least one."""
    west, south, east, north = floor.bounds
    step = max(step, float(np.sqrt(floor.area / 2000)))
    x, y = np.arange(west + step / 2, east, step), np.arange(south + step / 2, north, step)
    points = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    inside = points[shapely.contains_xy(floor, points[:, 0], points[:, 1])]
    return inside if len(inside) else shapely.get_coordinates(floor.representative_point())


def coverage(floor: shapely.Polygon, standing: StandingHouses) -> float:
    """The share of the ground that houses cover."""
    return float(shapely.area(shapely.union_all(standing.shapes)) / floor.area)
