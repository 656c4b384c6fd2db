"""Outlines of pieces in plan: their boxes, or their footprints where they are no boxes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.footprint import Footprint, Points, place_outline
from scenewright.core.layout import corners
from scenewright.core.scene import Piece

SLICE = 0.25
"""Metres of a slanting edge that one box covers."""
EXACT = 1e-6
"""Metres by which a footprint may miss its box."""


def outline_of(piece: Piece) -> Points:
    """Corners ``(n, 2)`` in the plan of what a piece covers, counter-clockwise: of its footprint,
    or from back right of its box."""
    x, y, heading = piece.pose.x, piece.pose.y, piece.pose.heading
    if not piece.footprint:
        return corners(np.array([[x, y, heading, *piece.size[:2]]]))[0]
    return place_outline(np.array(piece.footprint), x, y, heading)


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


@lru_cache(maxsize=1024)
def _slices(footprint: Footprint) -> tuple[tuple[float, float, float, float], ...]:
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
    whole = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
    return tuple(kept) or (whole,)


def _between(shape: shapely.Polygon, west: float, east: float) -> shapely.Geometry:
    """The part of a shape between two values of x."""
    _, south, _, north = shape.bounds
    return shapely.intersection(shape, shapely.box(west, south, east, north))


def _upright(shape: shapely.Geometry) -> bool:
    """Whether every part of a shape is its own box."""
    parts = shapely.get_parts(shape)
    return bool(shapely.area(shapely.envelope(parts)).sum() - shapely.area(shape) < EXACT)


def polygons_of(pieces: Sequence[Piece]) -> NDArray[np.object_]:
    """Outlines of pieces in plan, as polygons ``(n,)``."""
    boxes = [[p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]] for p in pieces]
    found = np.asarray(shapely.polygons(corners(np.array(boxes, float).reshape(-1, 5))))
    for number, piece in enumerate(pieces):
        if piece.footprint:
            found[number] = shapely.Polygon(outline_of(piece))
    return found
