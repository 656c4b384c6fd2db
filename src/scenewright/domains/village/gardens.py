"""What lies on the ground of a village: lanes, verges, squares, walks to doors, yards, beds; and
what encloses it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import GroundSurface, Piece
from scenewright.core.solution import Patch
from scenewright.domains.village.blocks import BlockPlan, VillagePlan
from scenewright.domains.village.enclosures import enclose_plots, lay_beds
from scenewright.domains.village.plots import houses_on, lay_block_plots, squares_on
from scenewright.domains.village.walks import walk_ground
from scenewright.ground.outlines import GRID
from scenewright.ground.streetside.fences import list_forecourts
from scenewright.ground.ways.door_walks import Walk, lay_long_walks, lay_walks_to_doors

HEIGHTS = {"asphalt": 0.03, "path": 0.035, "yard": 0.02, "square": 0.04, "walk": 0.045, "bed": 0.14}
"""How far the top of each lies above the ground, in metres."""
YARD, WALK = 1.6, 0.6
"""How far paving reaches around houses, and half the width of a walk, in metres."""
GATE = 0.6
"""Metres beside a walk or a square that walls and hedges leave open."""
VERGES = 7.0
"""Metres of the widest verge that a walk leads over."""
SPECK = 0.3
"""Areas smaller than this, in square metres, are left out."""


def lay_ground(
    plan: VillagePlan, pieces: Sequence[Piece], patches: Sequence[Patch]
) -> tuple[GroundSurface, ...]:
    """What lies on the ground of all blocks and between them."""
    found = [row for b in plan.blocks for row in _of_block(plan, b, pieces, patches)]
    return (*_lanes(plan), *found)


def _lanes(plan: VillagePlan) -> Iterator[GroundSurface]:
    """Lanes and paths, and the verges between them and the blocks."""
    blocks = shapely.union_all([shapely.Polygon(block.outline) for block in plan.blocks])
    roads = _union(plan, "road")
    paths = _cut(_union(plan, "path"), roads)
    grounds = [shapely.Polygon(b.ground.outline, b.ground.holes) for b in plan.blocks]
    verge = shapely.union_all(grounds, grid_size=GRID)
    for shape in (blocks, roads, paths):
        verge = _cut(verge, shape)
    first = plan.blocks[0].id
    for kind, shape in (("asphalt", roads), ("path", paths), ("yard", verge)):
        yield from _surface("verge" if kind == "yard" else f"lanes, {kind}", first, kind, shape)


def _union(plan: VillagePlan, kind: str) -> shapely.Geometry:
    areas = [
        shapely.Polygon(a.outline, a.holes)
        for way in plan.lanes
        if way.kind == kind
        for a in way.areas
    ]
    return shapely.union_all(np.array(areas, object), grid_size=GRID)


def _of_block(
    village: VillagePlan, block: BlockPlan, pieces: Sequence[Piece], patches: Sequence[Patch]
) -> Iterator[GroundSurface]:
    here = houses_on(block, pieces)
    floor = shapely.Polygon(block.outline)
    squares = shapely.union_all(squares_on(block, patches))
    shapes = polygons_of(here) if here else np.zeros(0, object)
    houses = shapely.union_all(shapes)
    open_ = walk_ground(block)
    lines = lay_walks_to_doors(open_, here)
    lines = (*lines, *lay_long_walks(open_, here, lines))
    trod = shapely.union_all(
        [walk.buffer(WALK, cap_style="flat", join_style="mitre") for walk in lines]
    )
    strips = _cut(_only_areas(shapely.intersection(trod, open_.floor)), squares)
    around = shapely.buffer(houses, YARD, join_style="mitre", mitre_limit=2.0)
    yards = _only_areas(shapely.intersection(around, floor, grid_size=GRID))
    ways = shapely.union_all(
        [shapely.Polygon(a.outline, a.holes) for w in block.ground.roads for a in w.areas],
        grid_size=GRID,
    )
    strips, yards = _cut(strips, ways), _cut(yards, block.lanes)
    yards = _cut(_cut(yards, squares), strips)
    over = _cut(cross_verges(block, lines, strips), _only_areas(shapely.union(houses, squares)))
    for kind, shape in (("square", squares), ("walk", over), ("yard", yards)):
        yield from _surface(f"{kind} of {block.id}", block.id, kind, shape)
    gates = shapely.buffer(shapely.union_all([squares, strips]), GATE, join_style="mitre")
    gates = shapely.union_all([gates, *list_forecourts(here)])
    plots = lay_block_plots(village, block, pieces, patches)
    walls = []
    for k, (one, wall, cap) in enumerate(
        enclose_plots(block, plots, shapes, gates, village.look), 1
    ):
        walls.append(wall)
        yield from _surface(f"{one.kind} {k} of {block.id}", block.id, one.kind, wall, one.high)
        top = one.high + one.coping
        yield from _surface(f"coping {k} of {block.id}", block.id, "coping", cap, top, one.high)
    taken = shapely.union_all([gates, block.lanes, *walls, yards])
    free = shapely.difference(shapely.buffer(floor, -1.0), taken)
    trees = [p for p in pieces if p.space == block.id and p.category == "tree"]
    beds = shapely.union_all(list(lay_beds(here, trees, free)))
    yield from _surface(f"beds of {block.id}", block.id, "bed", beds)


def cross_verges(
    block: BlockPlan, lines: Sequence[Walk], strips: shapely.Geometry
) -> shapely.Geometry:
    """The ground of walks, led on over the verge to the lane where they end on a street side."""
    ways = [shapely.Polygon(a.outline, a.holes) for w in block.ground.roads for a in w.areas]
    if not ways or not lines:
        return strips
    sides, lanes = shapely.union_all(shapely.linestrings(block.streets)), shapely.union_all(ways)
    ends = shapely.get_point(np.array(lines, object), -1)
    steps = shapely.shortest_line(ends[shapely.dwithin(ends, sides, 0.3)], lanes)
    steps = steps[(shapely.length(steps) <= VERGES) & (shapely.length(steps) > 0.01)]
    over = shapely.buffer(steps, WALK, cap_style="square")
    floor = shapely.Polygon(block.outline)
    across = shapely.difference(shapely.union_all(over), shapely.union(lanes, floor))
    parts = [p for p in shapely.get_parts(across) if p.geom_type == "Polygon"]
    return _only_areas(shapely.union_all([strips, *parts], grid_size=GRID))


def _surface(
    name: str,
    space: str,
    kind: str,
    shape: shapely.Geometry,
    top: float | None = None,
    bottom: float = -0.01,
) -> Iterator[GroundSurface]:
    areas = tuple(rings(part) for part in _polygons([shape]))
    if areas:
        yield GroundSurface(name, space, kind, areas, bottom, HEIGHTS[kind] if top is None else top)


def _polygons(shapes: Iterable[shapely.Geometry]) -> list[shapely.Polygon]:
    parts = [p for shape in shapes for p in shapely.get_parts(shapely.get_parts(shape))]
    return [p for p in parts if p.geom_type == "Polygon" and p.area > SPECK]


def _cut(shape: shapely.Geometry, hole: shapely.Geometry) -> shapely.Geometry:
    """The areas of a shape outside another."""
    return _only_areas(shapely.difference(shape, hole, grid_size=GRID))


def _only_areas(shape: shapely.Geometry) -> shapely.Geometry:
    """A shape without lines and points that overlays leave behind."""
    return shapely.union_all(np.array(_polygons([shape]), object))
