"""The floor of cupboards that are built in: behind their doors nothing else is furnished."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import cos, sin

import shapely

from scenewright.core.scene import Piece
from scenewright.core.space import Space

LEAF = 0.15  # a fixed wardrobe less deep than this is the doors of a cupboard, metres
DEEPEST = 0.9  # greatest depth of a cupboard behind its doors, metres
SHALLOWEST = 0.25  # less floor behind doors is no cupboard, metres


def list_cupboards(space: Space, fixed: Iterable[Piece]) -> Iterator[list[float]]:
    """Boxes (x, y, heading, width, depth) of the floor between the doors of cupboards and the wall
    behind them. The doors are fixed wardrobes less than :data:`LEAF` deep."""
    walls = shapely.Polygon(space.outline, list(space.holes)).boundary
    for piece in fixed:
        if piece.category == "wardrobe" and piece.size.depth < LEAF:
            pose, c, s = piece.pose, cos(piece.pose.heading), sin(piece.pose.heading)
            back = piece.size.depth / 2
            ends = [(pose.x - c * away, pose.y - s * away) for away in (back, back + DEEPEST)]
            behind = shapely.LineString(ends).intersection(walls)
            depth = 0.0 if behind.is_empty else behind.distance(shapely.Point(ends[0]))
            if depth >= SHALLOWEST:
                off = back + depth / 2
                yield [pose.x - c * off, pose.y - s * off, pose.heading, piece.size.width, depth]
