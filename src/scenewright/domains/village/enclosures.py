"""What encloses gardens along the street, and what is grown in them: walls, hedges, beds.

Hui villages stand behind white walls with tiled copings, those of the Riviera behind low walls of
stone, others behind hedges. All are open where a walk leads through.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.scene import Piece
from scenewright.domains.village.blocks import BlockPlan


class Enclosure(NamedTuple):
    """What stands along streets: the kind of surface, its height and thickness in metres, and the
    height of a coping on it (0: none)."""

    kind: str
    high: float
    thick: float
    coping: float


LOOKS = {
    "rural": Enclosure("hedge", 0.9, 0.6, 0.0),
    "riviera": Enclosure("stone_wall", 0.9, 0.4, 0.0),
    "hui": Enclosure("white_wall", 1.8, 0.3, 0.14),
}
SETBACK, SHORTEST = 0.25, 1.5
"""Metres from the street, and of the shortest piece."""
BED, BEDS, BEHIND = (1.2, 4.5), 3, 2.6
"""Width and length of a bed, how many a house has, and metres behind it."""
DWELLING = 50.0


def enclose_block(
    block: BlockPlan, look: str, blocked: shapely.Geometry
) -> tuple[shapely.Geometry, shapely.Geometry]:
    """The ground that a wall or hedge of a block takes, and its coping; neither on ``blocked``
    ground (houses, walks with their gates, squares)."""
    one = LOOKS[look]
    lines = shapely.union_all(shapely.linestrings(block.streets))
    inner = shapely.buffer(lines, SETBACK + one.thick, cap_style="flat", join_style="mitre")
    strip = shapely.difference(inner, shapely.buffer(lines, SETBACK, join_style="mitre"))
    strip = shapely.difference(shapely.intersection(strip, shapely.Polygon(block.outline)), blocked)
    parts = [
        part
        for part in shapely.get_parts(strip)
        if part.geom_type == "Polygon" and part.area > SHORTEST * one.thick
    ]
    wall = shapely.union_all(parts)
    cap = shapely.buffer(wall, 0.07, join_style="mitre") if one.coping else shapely.Polygon()
    return wall, shapely.difference(cap, blocked)


def lay_beds(
    houses: Sequence[Piece], trees: Sequence[Piece], free: shapely.Geometry
) -> Iterator[shapely.Polygon]:
    """Vegetable beds behind dwellings, side by side, where ``free`` ground without trees is."""
    shapes = polygons_of(houses) if houses else np.zeros(0, object)
    crowns = [shapely.Point(p.pose.x, p.pose.y).buffer(1.2) for p in trees]
    taken = shapely.union_all([*shapes, *crowns])
    for piece, shape in zip(houses, shapes, strict=True):
        if shape.area < DWELLING:
            continue
        for bed in _beds_behind(piece):
            if free.covers(bed) and not taken.intersects(bed):
                taken = shapely.union(taken, bed)
                yield bed


def _beds_behind(piece: Piece) -> Iterator[shapely.Polygon]:
    """Beds on the side of a house away from its door."""
    ahead = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    along = np.array([-ahead[1], ahead[0]])
    ring = outline_of(piece)
    back = float((ring @ ahead).min()) - BEHIND
    middle = float((ring @ along).mean())
    for k in range(BEDS):
        left = middle + (k - (BEDS - 1) / 2) * (BED[0] + 0.5)
        corners = [
            (back - u) * ahead + (left + v * BED[0] / 2) * along
            for u, v in ((0.0, -1), (0.0, 1), (BED[1], 1), (BED[1], -1))
        ]
        yield shapely.Polygon(corners)
