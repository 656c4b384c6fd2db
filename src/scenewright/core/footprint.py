"""Footprints that are no boxes: an L-shaped house, a counter round a corner.

A footprint is a simple polygon in the frame of its piece (x to its width, y to its depth, the
origin in the middle), counter-clockwise and filling the piece's box: its extents are the width and
the depth. None, an empty tuple, means the box itself.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.errors import InputError
from scenewright.core.layout import corners

if TYPE_CHECKING:
    from scenewright.core.scene import Piece

Footprint = tuple[tuple[float, float], ...]
"""Corners in the local frame of a piece, in metres; empty: the box."""
MOST_CORNERS = 200
LEAST = 0.01
"""Least side of a footprint in metres, and of its box that it fills in square metres."""
SLICE = 0.25
"""Metres of a slanting edge that one box covers."""
EXACT = 1e-6
"""Metres by which a footprint may miss its box."""

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


def outline_of(piece: Piece) -> Points:
    """Corners ``(n, 2)`` in the plan of what a piece covers, counter-clockwise: of its footprint,
    or from back right of its box."""
    x, y, heading = piece.pose.x, piece.pose.y, piece.pose.heading
    if not piece.footprint:
        return corners(np.array([[x, y, heading, *piece.size[:2]]]))[0]
    return place_outline(np.array(piece.footprint), x, y, heading)


def place_outline(local: Points, x: float, y: float, heading: float) -> Points:
    """Corners ``(n, 2)`` of a local frame in the plan, its front along the heading.

    >>> place_outline(np.array([[0.0, 1.0]]), 5.0, 5.0, 0.0).tolist()
    [[6.0, 5.0]]
    """
    cos, sin = np.cos(heading), np.sin(heading)
    return np.asarray(local) @ np.array([[sin, -cos], [cos, sin]]) + (x, y)


def boxes_of(piece: Piece) -> list[list[float]]:
    """Boxes ``[x, y, heading, width, depth]`` that together cover a piece: its box, or upright
    slices of its footprint. Exact where all its edges are along its box; slanting edges are
    covered in steps of :data:`SLICE`.

    >>> from scenewright.core.scene import Piece, Pose, Size
    >>> corner = ((-2.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-2.0, 1.0))
    >>> pose = Pose(0, 0, 0, np.pi / 2)
    >>> sofa = Piece("s", "sofa", "", "r", pose, Size(4, 2, 1), footprint=corner)
    >>> [[round(v, 3) for v in box] for box in boxes_of(sofa)]
    [[-1.0, 0.0, 1.571, 2.0, 2.0], [1.0, -0.5, 1.571, 2.0, 1.0]]
    """
    x, y, heading = piece.pose.x, piece.pose.y, piece.pose.heading
    if not piece.footprint:
        return [[x, y, heading, piece.size.width, piece.size.depth]]
    found = []
    for west, south, east, north in _slices(piece.footprint):
        middle = np.array([[(west + east) / 2, (south + north) / 2]])
        at = place_outline(middle, x, y, heading)[0]
        found.append([float(at[0]), float(at[1]), heading, east - west, north - south])
    return found


def _slices(footprint: Footprint) -> list[tuple[float, float, float, float]]:
    """Bounds of upright slices that cover a footprint, cut at its corners."""
    shape = shapely.Polygon(footprint)
    low, high = np.min(footprint, 0), np.max(footprint, 0)
    cuts = np.unique(np.round([corner[0] for corner in footprint], 6))
    slices = []
    for a, b in pairwise(cuts.tolist()):
        inside = _between(shape, a, b)
        steps = 1 if _upright(inside) else int(np.ceil((b - a) / SLICE))
        edges = np.linspace(a, b, steps + 1)
        parts = [_between(shape, c, e) for c, e in pairwise(edges.tolist())]
        slices += [part.bounds for group in parts for part in shapely.get_parts(group)]
    kept = [row for row in slices if min(row[2] - row[0], row[3] - row[1]) > EXACT]
    return kept or [(float(low[0]), float(low[1]), float(high[0]), float(high[1]))]


def _between(shape: shapely.Polygon, west: float, east: float) -> shapely.Geometry:
    """The part of a shape between two values of x."""
    _, south, _, north = shape.bounds
    return shapely.intersection(shape, shapely.box(west, south, east, north))


def _upright(shape: shapely.Geometry) -> bool:
    """Whether every part of a shape is its own box."""
    parts = shapely.get_parts(shape)
    return bool(shapely.area(shapely.envelope(parts)).sum() - shapely.area(shape) < EXACT)


def polygons_of(pieces: Sequence[Piece]) -> NDArray[np.object_]:
    """What pieces cover in the plan, as polygons ``(n,)``."""
    boxes = [[p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]] for p in pieces]
    found = np.asarray(shapely.polygons(corners(np.array(boxes, float).reshape(-1, 5))))
    for number, piece in enumerate(pieces):
        if piece.footprint:
            found[number] = shapely.Polygon(outline_of(piece))
    return found


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
