"""Ceilings under a roof: how high they are at points and over boxes, and where they are low.

A slope is a plane that rises inwards from a wall: a row ``(x, y, u, v, knee, rise)`` with a point
of the wall, the unit normal into the room, the height at the wall and metres of rise a metre
inwards (the tangent of the pitch). With slopes k and a flat ceiling at H the height at p is

    h(p) = min(H, min_k knee_k + rise_k max(0, (p - a_k) . n_k)),

so beyond a wall (in a bay) a slope stays at its knee. Each plane grows inwards only, so the least
height over a convex shape is that at one of its corners.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.layout import corners
from scenewright.core.space import Space

Floats = NDArray[np.float64]

HEADROOM = 2.0  # over the middle of a walking route (DIN 18065: clear headroom of stairs), metres
SHOULDERS = 1.5  # over its whole width, metres
BENDING = 0.4  # how much further one reaches a piece under a slope, metres
WHOLE, HALF = 2.0, 1.0  # from which height floor counts as living area, metres


def planes(space: Space) -> Floats:
    """The slopes of a space as rows ``(k, 6)``."""
    if not space.slopes:
        return np.zeros((0, 6))
    start = np.array([space.outline[slope.edge] for slope in space.slopes]).reshape(-1, 2)
    after = [space.outline[(slope.edge + 1) % len(space.outline)] for slope in space.slopes]
    along = np.array(after).reshape(-1, 2) - start
    along = along / np.hypot(along[:, 0], along[:, 1])[:, None]
    rises = np.array([(s.knee, np.tan(s.pitch)) for s in space.slopes]).reshape(-1, 2)
    return np.column_stack([start, -along[:, 1], along[:, 0], rises])


def heights(points: Floats, slopes: Floats, flat: float) -> Floats:
    """Height of the ceiling at ``points`` (..., 2) under ``slopes`` (k, 6) below a flat one.

    >>> roof = np.array([[0.0, 0.0, 1.0, 0.0, 1.0, 0.5]])
    >>> heights(np.array([[0.0, 5.0], [1.0, 0.0], [9.0, 0.0], [-1.0, 0.0]]), roof, 2.5).tolist()
    [1.0, 1.5, 2.5, 1.0]
    """
    inwards = np.maximum(_inwards(points, slopes), 0.0)
    return np.minimum(flat, (slopes[:, 4] + slopes[:, 5] * inwards).min(-1, initial=np.inf))


def lowest(boxes: Floats, slopes: Floats, flat: float) -> Floats:
    """The lowest ceiling over each of ``boxes`` (n, 5), metres ``(n,)``."""
    if not len(slopes) or not len(boxes):
        return np.full(len(boxes), flat)
    return heights(corners(boxes), slopes, flat).min(-1)


def strips(slopes: Floats, tops: Floats, bounds: Floats) -> Floats:
    """Boxes under the slopes, each with the height that nothing in it may reach, ``(s, 6)``.

    What is as high as one of ``tops`` (n,) meets exactly the strips where the ceiling is lower
    than it: a slope is cut parallel to its wall where it reaches each of them. ``bounds`` (4,)
    are x0, y0, x1, y1 of the room.

    >>> roof = np.array([[0.0, 0.0, 1.0, 0.0, 1.0, 0.5]])
    >>> strips(roof, np.array([0.5, 1.5, 2.0]), np.array([0.0, 0.0, 4.0, 3.0]))[:, 4:].tolist()
    [[6.0, 1.499999], [1.0, 1.999999]]
    """
    found = []
    for slope in slopes:
        start = -_across(bounds)
        for top in np.unique(tops):
            end = (top - slope[4]) / slope[5]
            if end > 1e-9:
                found.append([*_strip(slope, start, end, bounds), top - 1e-6])
                start = end
    return np.array(found, np.float64).reshape(-1, 6)


def low_floor(slopes: Floats, width: float, bounds: Floats, bending: float = 0.0) -> Floats:
    """Boxes ``(k, 5)`` of the floor that a route of ``width`` metres may not enter for want of
    headroom: its middle needs :data:`HEADROOM`, its whole width :data:`SHOULDERS`.

    A box stands for floor no part of the route may lie on, so the middle keeps half a width off.
    With ``bending`` the middle comes as many metres nearer to the wall.

    >>> roof = np.array([[0.0, 0.0, 1.0, 0.0, 1.0, 0.5]])
    >>> low_floor(roof, 0.6, np.array([0.0, 0.0, 4.0, 3.0]))[:, 4].round(3).tolist()
    [6.7]
    """
    found = []
    for slope in slopes:
        head, body = (HEADROOM - slope[4]) / slope[5], (SHOULDERS - slope[4]) / slope[5]
        end = max(head - width / 2 - bending, body)
        if end > 0.0:
            found.append(_strip(slope, -_across(bounds), end, bounds))
    return np.array(found, np.float64).reshape(-1, 5)


def below(shape: shapely.Geometry, slopes: Floats, flat: float, height: float) -> shapely.Geometry:
    """The part of a floor over which the ceiling is lower than ``height``.

    ``slopes`` (k, 6) as of :func:`heights`, ``flat`` and ``height`` in metres.
    """
    if height > flat:
        return shape
    bounds = np.array(shape.bounds)
    low = [slope for slope in slopes if slope[4] < height]
    if not low:
        return shapely.Polygon()
    areas = [
        _strip(slope, -_across(bounds), (height - slope[4]) / slope[5], bounds) for slope in low
    ]
    boxes = shapely.polygons(corners(np.array(areas).reshape(-1, 5)))
    return shape.intersection(shapely.union_all(boxes))


def living_area(shape: shapely.Geometry, slopes: Floats, flat: float) -> float:
    """Floor area as dwellings are let by: whole where the ceiling is 2 m high or more, half from
    1 m, below not at all (German Wohnflächenverordnung 2003, section 4), square metres.

    >>> roof = np.array([[0.0, 0.0, 1.0, 0.0, 0.5, 0.5]])
    >>> living_area(shapely.box(0, 0, 5, 2), roof, 2.5)
    6.0
    """
    halves = [below(shape, slopes, flat, limit).area for limit in (WHOLE, HALF)]
    return float(shape.area - sum(halves) / 2)


def living_area_of(space: Space) -> float:
    """The living area of a space, square metres."""
    return living_area(shapely.Polygon(space.outline, space.holes), planes(space), space.height)


def _inwards(points: Floats, slopes: Floats) -> Floats:
    """How far each of the points (..., 2) lies inwards of the walls, ``(..., k)``."""
    return np.asarray((points[..., None, :] - slopes[:, :2]) * slopes[:, 2:4]).sum(-1)


def _across(bounds: Floats) -> float:
    """The diagonal of a room: nothing in it is further beyond a wall."""
    return float(np.hypot(*(bounds[2:] - bounds[:2])))


def _strip(slope: Floats, start: float, end: float, bounds: Floats) -> list[float]:
    """The box between two distances from the wall of a slope, longer than the room is wide."""
    middle, span = (bounds[:2] + bounds[2:]) / 2, 3 * _across(bounds)
    here = float(_inwards(middle, slope[None])[0])
    x, y = middle + slope[2:4] * ((start + end) / 2 - here)
    return [float(x), float(y), float(np.arctan2(slope[3], slope[2])), span, end - start]
