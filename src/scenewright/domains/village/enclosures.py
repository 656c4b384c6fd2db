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
from scenewright.ground.streetside.plots import Plot, Shapes, fence_lines


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
SETBACK, SHORTEST = 0.25, 1.5
"""Metres from the street, and of the shortest piece."""
FRONTING = 0.6
"""Metres from a way within which the border of a plot lies along it."""
BED, BEDS, BEHIND = (1.2, 4.5), 3, 2.6
"""Width and length of a bed, how many a house has, and metres behind it."""
DWELLING = 50.0


def enclose_plots(
    block: BlockPlan, plots: Sequence[Plot], shapes: Shapes, blocked: shapely.Geometry, look: str
) -> Iterator[tuple[Enclosure, shapely.Geometry, shapely.Geometry]]:
    """What encloses the plots of a block, with the ground it takes and that of its coping; none
    where walls are near and on ``blocked`` ground (walks with their gates, squares)."""
    kinds = ENCLOSED[LOOKS[look].enclosed]
    outer, inner = fence_lines(plots, shapes, blocked)
    ways = shapely.union_all([shapely.boundary(block.lanes), *shapely.linestrings(block.streets)])
    along = shapely.buffer(ways, FRONTING, quad_segs=1)
    front, back = shapely.intersection(outer, along), shapely.difference(outer, along)
    held = shapely.union_all([shapely.Polygon(plot.outline) for plot in plots], grid_size=1e-3)
    street = _set_back(front, kinds.street.thick, shapely.difference(held, blocked))
    half = kinds.between.thick / 2
    lines = shapely.union(inner, back)
    between = shapely.buffer(lines, half, cap_style="flat", join_style="mitre", mitre_limit=2.0)
    between = shapely.difference(shapely.difference(between, street), blocked)
    for kind, ground in ((kinds.street, street), (kinds.between, between)):
        parts = [p for p in shapely.get_parts(ground) if p.geom_type == "Polygon"]
        wall = shapely.union_all([p for p in parts if p.area > SHORTEST * kind.thick])
        cap = shapely.buffer(wall, 0.07, join_style="mitre") if kind.coping else shapely.Polygon()
        yield kind, wall, shapely.difference(cap, blocked)


def _set_back(line: shapely.Geometry, thick: float, ground: shapely.Geometry) -> shapely.Geometry:
    """A strip of some thickness behind a line, on some ground."""
    inner = shapely.buffer(line, SETBACK + thick, cap_style="flat", join_style="mitre")
    strip = shapely.difference(
        inner, shapely.buffer(line, SETBACK, quad_segs=2, join_style="mitre")
    )
    return shapely.intersection(strip, ground)


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
