"""What a house that is to be placed may look at: houses that stand, sides of the block, voids."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.standing import Floats, Shapes, StandingHouses

POINTS = 500
"""Points of a grid over the ground, about, at which voids are measured."""
FARTHEST = 200.0
"""The distance to a house, in metres, where none stands."""
ON_STREET = 1.0
"""Sides whose middle is nearer to a street than this, in metres, are street themselves."""


class Surroundings(NamedTuple):
    """A block while it is filled: houses that ``standing`` there, their distances to the street
    ``setbacks`` (n,); street sides and other sides of the outline (s, 2, 2) with their lines
    (s,); a grid of points (g, 2) and of each the distance to the nearest house (g,); the ground's
    square metres, the share of its outline that is street, and how many houses it is to hold."""

    standing: StandingHouses
    setbacks: Floats
    streets: Points
    others: Points
    street_lines: Shapes
    other_lines: Shapes
    points: Floats
    away: Floats
    area: float
    street_share: float
    planned: int

    @property
    def plot(self) -> float:
        """The width in metres of a plot, if all houses had the same."""
        return float(np.sqrt(self.area / self.planned))


def survey(
    floor: shapely.Polygon,
    streets: Points,
    street_share: float,
    planned: int,
    standing: StandingHouses,
) -> Surroundings:
    """The surroundings on some ground where houses stand and ``planned`` are to stand.

    >>> from scenewright.domains.village.standing import stand
    >>> street = np.array([[[0.0, 0.0], [40.0, 0.0]]])
    >>> seen = survey(shapely.box(0, 0, 40, 30), street, 0.29, 4, stand([], []))
    >>> len(seen.others), round(seen.plot, 1), float(seen.away.min())
    (3, 17.3, 200.0)
    """
    corners = shapely.get_coordinates(floor.exterior)
    sides = np.stack([corners[:-1], corners[1:]], 1)
    lines = shapely.linestrings(streets)
    middles = shapely.points(sides.mean(1))
    others = sides[shapely.distance(middles, shapely.union_all(lines)) > ON_STREET]
    points = grid_over(floor)
    return Surroundings(
        standing,
        _nearest(standing.shapes, lines),
        streets,
        others,
        lines,
        shapely.linestrings(others) if len(others) else np.zeros(0, object),
        points,
        _to_houses(points, standing.shapes),
        float(floor.area),
        street_share,
        max(planned, len(standing.shapes) + 1),
    )


def with_house(seen: Surroundings, standing: StandingHouses) -> Surroundings:
    """The same after one more house: ``standing`` holds it as its last."""
    new = standing.shapes[-1:]
    return seen._replace(
        standing=standing,
        setbacks=np.append(seen.setbacks, _nearest(new, seen.street_lines)),
        away=np.minimum(seen.away, _to_houses(seen.points, new)),
        planned=max(seen.planned, len(standing.shapes) + 1),
    )


def without_houses(seen: Surroundings, standing: StandingHouses) -> Surroundings:
    """The same with no other houses than these."""
    return seen._replace(
        standing=standing,
        setbacks=_nearest(standing.shapes, seen.street_lines),
        away=_to_houses(seen.points, standing.shapes),
    )


def grid_over(floor: shapely.Polygon, points: int = POINTS) -> Floats:
    """About ``points`` points (g, 2) of a square grid over ground; at least one."""
    west, south, east, north = floor.bounds
    step = max(1.0, float(np.sqrt(floor.area / points)))
    x, y = np.arange(west + step / 2, east, step), np.arange(south + step / 2, north, step)
    grid = np.stack(np.meshgrid(x, y), -1).reshape(-1, 2)
    inside = grid[shapely.contains_xy(floor, grid[:, 0], grid[:, 1])] if len(grid) else grid
    return inside if len(inside) else shapely.get_coordinates(floor.representative_point())


def _nearest(shapes: Shapes, lines: Shapes) -> Floats:
    if not len(shapes):
        return np.zeros(0)
    return np.asarray(shapely.distance(shapes[:, None], lines[None]).min(1))


def _to_houses(points: Floats, shapes: Shapes) -> Floats:
    if not len(shapes):
        return np.full(len(points), FARTHEST)
    tree = shapely.STRtree(shapes)
    place, distance = tree.query_nearest(
        shapely.points(points), return_distance=True, all_matches=False
    )
    found = np.full(len(points), FARTHEST)
    found[place[0]] = np.minimum(distance, FARTHEST)
    return found
