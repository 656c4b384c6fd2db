"""Where a visitor's route is narrow: the clear width across it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry

from scenewright.domains.hall.hall_layout import Tour

ENDS = 1.0
"""Metres at both ends where the width is that of the door."""

Vector = NDArray[np.float64]


class Narrow(NamedTuple):
    """A narrow place on a tour: how far along, the clear width there, and the two points
    between which it is measured, in metres."""

    run: float
    width: float
    ends: Vector


def narrow_places(tour: Tour, passage: float, solid: Geometry) -> list[Narrow]:
    """Where the way of a tour is narrower than ``passage``: local least widths, the narrowest
    first, not at its doors.

    The width is measured from the nearest solid across the point to the one opposite, so
    that a way along one side of a wide aisle is not called narrow.
    """
    run = run_of(tour.points)
    near = np.flatnonzero((tour.widths < passage - 1e-6) & (run > ENDS) & (run < run[-1] - ENDS))
    widths = np.full(len(run), np.inf)
    ends = np.zeros((len(run), 2, 2))
    if len(near) and not solid.is_empty:
        widths[near], ends[near] = across(tour.points[near], passage, solid)
    before, after = np.r_[np.inf, widths[:-1]], np.r_[widths[1:], np.inf]
    low = np.flatnonzero((widths < passage - 0.005) & (widths <= before) & (widths <= after))
    order = low[np.argsort(widths[low], kind="stable")].tolist()
    return [Narrow(float(run[k]), float(widths[k]), ends[k]) for k in order]


def across(points: Vector, passage: float, solid: Geometry) -> tuple[Vector, Vector]:
    """Clear width (k,) at points, from the nearest point of what is solid to the nearest of what
    is opposite (within 45 degrees), and these two (k, 2, 2); infinite where nothing is opposite
    within ``passage``.

    >>> walls = shapely.union_all([shapely.box(0, 0, 1, 5), shapely.box(2, 0, 3, 5)])
    >>> widths, ends = across(np.array([[1.4, 2.0]]), 1.2, walls)
    >>> widths.round(9).tolist(), ends.round(9).tolist()
    ([1.0], [[[1.0, 2.0], [2.0, 2.0]]])
    """
    shapely.prepare(solid)
    spots = shapely.points(points)
    near = shapely.get_coordinates(shapely.shortest_line(spots, solid)).reshape(-1, 2, 2)[:, 1]
    way = points - near
    way = passage * way / np.maximum(np.hypot(*way.T), 1e-9)[:, None]
    side = np.column_stack([-way[:, 1], way[:, 0]])
    wedges = shapely.polygons(np.stack([points, points + way - side, points + way + side], axis=1))
    opposite = shapely.intersection(wedges, solid)
    met = ~shapely.is_empty(opposite)
    far = np.full_like(points, np.inf)
    lines = shapely.shortest_line(spots[met], opposite[met])
    far[met] = shapely.get_coordinates(lines).reshape(-1, 2, 2)[:, 1]
    return np.hypot(*(far - near).T), np.stack([near, far], axis=1)


def select_narrowest(places: Sequence[Narrow], apart: float, most: int) -> list[Narrow]:
    """The ``most`` narrowest places that are ``apart`` metres from each other along the tour."""
    found: list[Narrow] = []
    for place in places:
        if len(found) < most and all(abs(place.run - other.run) >= apart for other in found):
            found.append(place)
    return found


def length(tour: Tour) -> float:
    """Metres from the first to the last point."""
    return float(run_of(tour.points)[-1])


def run_of(points: Vector) -> Vector:
    """Length of the way up to each point."""
    return np.r_[0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T))]
