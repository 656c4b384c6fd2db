"""Roads drawn as areas, in straight pieces: boxes round an area cut while they fit badly."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import shapely

FILLED = 0.8
"""Share of its least rectangle that a straight piece covers."""
SHORTEST, DEEPEST = 3.0, 9
"""Metres below which a piece is not cut again, and how often one is."""
NARROW = 3.5
"""Roads narrower than this, in metres, are paths."""
LEAST, SPECK = 2.0, 25.0
"""Square metres below which a piece, and a whole area, is left out."""


class RoadSegment(NamedTuple):
    """A straight piece of road: the ends of its middle line, and its width."""

    line: list[tuple[float, float]]
    width: float


def pieces(area: shapely.Geometry) -> list[RoadSegment]:
    """The straight pieces of an area; a rectangle is one.

    >>> pieces(shapely.box(0, 0, 40, 6))
    [RoadSegment(line=[(0.0, 3.0), (40.0, 3.0)], width=6.0)]
    """
    found = [
        piece
        for part in shapely.get_parts(shapely.get_parts(area))
        if part.geom_type == "Polygon" and part.area >= SPECK
        for piece in _pieces(part, 0)
    ]
    return [piece for piece in found if math.dist(*piece.line) > SHORTEST / 2]


def _pieces(part: shapely.Polygon, depth: int) -> list[RoadSegment]:
    if part.area < LEAST:
        return []
    box = shapely.minimum_rotated_rectangle(part)
    corners = shapely.get_coordinates(box)[:4]
    sides = np.hypot(*(corners[1:3] - corners[:2]).T)
    if sides[0] < sides[1]:
        corners = np.roll(corners, -1, axis=0)
    start, end = (corners[0] + corners[3]) / 2, (corners[1] + corners[2]) / 2
    long, short = float(sides.max()), float(sides.min())
    if part.area >= FILLED * box.area or long < SHORTEST or depth >= DEEPEST:
        ends = sorted([tuple(start.tolist()), tuple(end.tolist())])
        return [RoadSegment(ends, min(short, part.area / long))]
    middle, along = (start + end) / 2, (end - start) / long
    across = np.array([-along[1], along[0]])
    reach = 2 * long
    halves = [
        np.array(
            [
                middle - reach * across,
                middle + reach * across,
                middle + reach * across + sign * reach * along,
                middle - reach * across + sign * reach * along,
            ]
        )
        for sign in (-1, 1)
    ]
    cut = [shapely.intersection(part, shapely.Polygon(half), grid_size=1e-3) for half in halves]
    return [
        piece
        for half in cut
        for one in shapely.get_parts(half)
        if one.geom_type == "Polygon"
        for piece in _pieces(one, depth + 1)
    ]
