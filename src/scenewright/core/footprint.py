"""Footprints that are no boxes: an L-shaped house, a counter round a corner.

A footprint is a simple polygon in the frame of its piece (x to its width, y to its depth, the
origin in the middle), counter-clockwise and filling the piece's box: its extents are the width and
the depth. None, an empty tuple, means the box itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.errors import InputError

Footprint = tuple[tuple[float, float], ...]
"""Corners in the local frame of a piece, in metres; empty: the box."""
MOST_CORNERS = 200
LEAST = 0.01
"""Least side of a footprint in metres, and of its box that it fills in square metres."""

Points = NDArray[np.float64]


def read_footprint(points: Iterable[Sequence[float]], width: float, depth: float) -> Footprint:
    """The footprint of a box ``width`` by ``depth`` metres that an outline tells, stretched to
    fill it; empty if the outline is that box. InputError for what is no simple polygon.

    The outline may run either way and lie anywhere; corners on a straight line are left out. The
    corner farthest to the back comes first, the leftmost of several.

    >>> read_footprint([(0, 0), (0, 2), (1, 2), (1, 1), (2, 1), (2, 0)], 8.0, 4.0)[3]
    (0.0, 0.0)
    >>> read_footprint([(0, 0), (1, 0), (1, 1), (0, 1)], 8.0, 4.0)
    ()
    """
    shape = _simple(points)
    west, south, east, north = shape.bounds
    local = shapely.get_coordinates(shapely.normalize(shape).exterior)[:-1]
    if not shapely.is_ccw(shapely.LinearRing(local)):
        local = local[::-1]
    unit = (local - (west, south)) / (east - west, north - south) - 0.5
    if len(unit) == 4 and shape.area > (1 - 1e-9) * (east - west) * (north - south):
        return ()
    placed = np.round(unit * (width, depth), 9) + 0.0
    placed = np.roll(placed, -np.lexsort((placed[:, 0], placed[:, 1]))[0], axis=0)
    return tuple((float(x), float(y)) for x, y in placed)


def extents(points: Iterable[Sequence[float]]) -> tuple[float, float]:
    """Width and depth in metres of an outline as it is given.

    >>> extents([(1, 1), (4, 1), (4, 3)])
    (3.0, 2.0)
    """
    low, high = np.min(list(points), 0), np.max(list(points), 0)
    return float(high[0] - low[0]), float(high[1] - low[1])


def scale_footprint(footprint: Footprint, width: float, depth: float) -> Footprint:
    """A footprint stretched to a box of another size; the box stays the box."""
    return read_footprint(footprint, width, depth) if footprint else ()


def place_outline(local: Points, x: float, y: float, heading: float) -> Points:
    """Corners ``(n, 2)`` of a local frame in the plan, its front along the heading.

    >>> place_outline(np.array([[0.0, 1.0]]), 5.0, 5.0, 0.0).tolist()
    [[6.0, 5.0]]
    """
    cos, sin = np.cos(heading), np.sin(heading)
    return np.asarray(local) @ np.array([[sin, -cos], [cos, sin]]) + (x, y)


def _simple(points: Iterable[Sequence[float]]) -> shapely.Polygon:
    """An outline as a simple polygon without corners on straight lines."""
    listed = np.array([tuple(point)[:2] for point in points], float).reshape(-1, 2)
    if len(listed) > MOST_CORNERS:
        raise InputError(f"has {len(listed)} corners", f"give {MOST_CORNERS} at most")
    if len(listed) < 3 or not np.isfinite(listed).all():
        raise InputError("is no polygon", "give at least three corners [x, y] in metres")
    shape = shapely.Polygon(listed)
    if not shape.is_valid:
        raise InputError("crosses or touches itself", "list the corners in order, once around")
    west, south, east, north = shape.bounds
    if min(east - west, north - south) < LEAST or shape.area < LEAST * (east - west) * (
        north - south
    ):
        raise InputError("covers next to nothing", "give its corners in metres")
    simpler = shape.simplify(1e-9 * max(east - west, north - south))
    start = shapely.Polygon(np.roll(shapely.get_coordinates(simpler.exterior)[:-1], 1, axis=0))
    return start.simplify(1e-9 * max(east - west, north - south))
