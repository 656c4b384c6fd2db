"""What encloses plots, and what is grown in them: walls, hedges, fences, beds.

Hui villages stand behind white walls with tiled copings, those of the Riviera behind low walls of
stone, others behind hedges, with fences between neighbours. All are open where a walk leads
through.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.house_looks import LOOKS
from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.scene import Piece
from scenewright.domains.village.blocks import BlockPlan
from scenewright.ground.streetside.fences import fence_lines
from scenewright.ground.streetside.plots import Plot, Shapes


class Enclosure(NamedTuple):
    """What stands along the borders of plots: the kind of surface, its height and thickness in
    metres, and the height of a coping on it (0: none)."""

    kind: str
    high: float
    thick: float
    coping: float


class Enclosures(NamedTuple):
    """What stands along ways, and what between neighbours."""

    street: Enclosure
    between: Enclosure


FENCE = Enclosure("fence", 1.0, 0.08, 0.0)
STONE, WHITE = Enclosure("stone_wall", 0.9, 0.4, 0.0), Enclosure("white_wall", 1.8, 0.3, 0.14)
ENCLOSED = {
    "hedge": Enclosures(Enclosure("hedge", 0.9, 0.6, 0.0), FENCE),
    "stone": Enclosures(STONE, STONE),
    "white": Enclosures(WHITE, WHITE),
}
"""By what encloses the plots of a style."""
BED, BEDS, BEHIND = (1.2, 4.5), 3, 2.6
"""Width and length of a bed, how many a house has, and metres behind it."""
DWELLING = 50.0


def enclose_plots(
    block: BlockPlan, plots: Sequence[Plot], shapes: Shapes, gates: shapely.Geometry, look: str
) -> Iterator[tuple[Enclosure, shapely.Geometry, shapely.Geometry]]:
    """What encloses the plots of a block, with the ground it takes and that of its coping; none on
    the ground of ``gates`` (walks, squares, what is before doors)."""
    kinds = ENCLOSED[LOOKS[look].enclosed]
    ways = shapely.union_all([block.lanes, *shapely.linestrings(block.streets)])
    lines = fence_lines(plots, shapes, ways, gates, kinds.street.thick)
    houses = shapely.union_all([*shapes, gates])
    taken = houses
    for kind, line in ((kinds.street, lines.street), (kinds.between, lines.other)):
        strip = shapely.buffer(
            line, kind.thick / 2, cap_style="square", join_style="mitre", mitre_limit=2.0
        )
        wall = shapely.difference(strip, taken)
        taken = shapely.union(taken, wall)
        cap = shapely.buffer(wall, 0.07, join_style="mitre") if kind.coping else shapely.Polygon()
        yield kind, wall, shapely.difference(cap, houses)


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
