"""Lanes for fire engines and cars: as few as come within reach of every building.

The middle of a lane lies where a disc of its width stays on the site and off all that stands: the
ground less the buildings, each grown by half the width. A raster finds the way, and its points are
then moved onto that ground exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.geometry.wavefront import find_quickest
from scenewright.ground.outlines import way as cover
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.border import Exits, find_mouths, lead_out
from scenewright.ground.ways.path_raster import PathRaster, is_drivable
from scenewright.ground.ways.path_tree import square_off, straighten, trace
from scenewright.ground.works import Pathway

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]
Shapes = NDArray[np.object_]

SLACK, WITHIN = 0.008, 0.05
"""Metres a lane may lack on each side, so that one exactly wide enough counts, and by which it is
nearer than it must be."""
NEAR, FAR, RINGS, ROUND = 0.6, 10.0, 4, 8
"""Metres from a wall within which a lane ends, distances tried, segments of a quarter circle."""
EASE, ROUND_OF = 14.0, 4
"""Metres before a bend at which a lane begins to turn, and pieces of half of the bend."""
TIGHT = 1.5
"""How much more a metre costs right beside a wall."""


class Tree(NamedTuple):
    """Quickest ways over a raster: what a metre costs (rows, columns), travel ``times`` (cells,)
    and the cell each is come from."""

    slow: Floats
    times: Floats
    before: Ints


class LaneGround(NamedTuple):
    """Where lanes of some ``radius``, half their width, are laid: the ``raster`` of a site and all
    that is ``built`` on it (m,), as polygons and in a ``tree``;
    ``exits`` are where lanes may leave it."""

    plan: SitePlan
    raster: PathRaster
    built: Shapes
    tree: shapely.STRtree
    exits: Exits
    radius: float


class Laying(NamedTuple):
    """Lanes being laid: quickest ways over the ground, where the middle of a lane may lie, the
    cells ``used`` and the lines ``laid``, both of which grow."""

    tree: Tree
    centres: shapely.Geometry
    used: set[int]
    laid: list[shapely.LineString]


def begin_laying(
    ground: LaneGround, slack: float = 0.0, laid: list[shapely.LineString] | None = None
) -> Laying:
    """No lane laid, or those given: the raster lets pass what is ``slack`` metres too narrow."""
    plan, raster, radius = ground.plan, ground.raster, ground.radius
    slow, starts = measure_ground(
        plan, raster, radius - slack, radius + 1.0, raster.driven, 2.0 * radius
    )
    tree = Tree(slow, *find_quickest(slow, raster.cell, starts))
    return Laying(
        tree, find_centres(plan, ground.built, radius), set(), [] if laid is None else laid
    )


def lay_lanes(
    ground: LaneGround, solids: list[Points], ahead: Floats, reach: float
) -> tuple[Laying | None, Flags]:
    """Lanes to the first of some ``solids``, those whose fronts look ``ahead`` (n, 2), and which
    of these a lane or road is within ``reach`` of. The farthest are served first; those beside
    their lanes need none."""
    count, radius, raster = len(ahead), ground.radius, ground.raster
    near = _find_near_start(ground.plan, ground.built[:count], 2.0 * radius, reach)
    offs = radius + np.linspace(NEAR, max(min(reach, FAR) - 1.5 * raster.cell, NEAR), RINGS)
    first: Laying | None = None
    for slack in (0.0, 0.36 * raster.cell):
        if near.all():
            break
        laying = begin_laying(ground, slack, first.laid if first else None)
        first = first or laying
        goals, far = _find_ends(raster, solids[:count], ahead, laying.tree.times, offs)
        for k in np.argsort(np.where(np.isfinite(far), -far, np.inf), kind="stable"):
            if near[k] or not np.isfinite(far[k]):
                continue
            lane = lay_lane(ground, laying, int(goals[k]))
            if lane is not None:
                laying.laid.append(lane)
                found = ground.tree.query(lane, "dwithin", reach + radius - WITHIN)
                near[found[found < count]] = True
    return first, near


def laid_lanes(laying: Laying | None, width: float) -> tuple[Pathway, ...]:
    """The lanes laid so far."""
    laid = laying.laid if laying else ()
    return tuple(Pathway("lane", width, corners_of_line(lane)) for lane in laid)


def corners_of_line(line: shapely.LineString) -> tuple[tuple[float, float], ...]:
    """The corners of a line to the millimetre, none twice in a row."""
    return corners_of(shapely.get_coordinates(line))


def corners_of(points: Floats) -> tuple[tuple[float, float], ...]:
    """Points (n, 2) to the millimetre, none twice in a row."""
    rows = np.round(points, 3).tolist()
    return tuple((x, y) for k, (x, y) in enumerate(rows) if k == 0 or rows[k - 1] != [x, y])


def _find_near_start(plan: SitePlan, built: Shapes, width: float, reach: float) -> Flags:
    """Which buildings are near enough to a road, or to the border of a site without ways."""
    roads = [
        shape
        for way in plan.roads
        if is_drivable(way, width)
        for shape in (
            *(shapely.Polygon(area.outline, area.holes) for area in way.areas),
            *(cover(line, way.width)[1] for line in way.beside),
        )
    ]
    if not roads and (plan.entrances or not find_mouths(plan).is_empty):
        return np.zeros(len(built), bool)
    start = shapely.union_all(roads) if roads else shapely.LinearRing(plan.outline)
    shapely.prepare(start)
    found: Flags = shapely.dwithin(start, built, reach - WITHIN)
    return found


def measure_ground(
    plan: SitePlan,
    raster: PathRaster,
    least: float,
    comfort: float,
    streets: Flags,
    width: float = 0.0,
) -> tuple[Floats, Ints]:
    """What a metre costs at every cell (rows, columns): more up to ``comfort`` metres from
    solids, infinite within ``least`` of it or of the border; and the cells that ways of some
    ``width`` start from: ``streets`` and the border that is open to those beside it, or without
    any the entrances, or the border of a site without ways."""
    apart = np.minimum(raster.solid, raster.border)
    slow = 1.0 + TIGHT * np.clip((comfort - raster.solid) / max(comfort - least, 0.1), 0.0, 1.0)
    slow[apart < least] = np.inf
    starts, mouths = streets & (raster.solid >= least), find_mouths(plan, width)
    if not mouths.is_empty:
        starts |= _find_cells_near(raster, mouths, least + raster.cell, least)
    elif not streets.any() and plan.entrances:
        doors = shapely.multipoints([(e.x, e.y) for e in plan.entrances])
        starts = _find_cells_near(raster, doors, 3.0 * max(least, raster.cell), least)
    elif not streets.any():
        starts = (raster.border > 0.0) & (raster.border < least + raster.cell)
        starts &= raster.solid >= least
    slow[starts] = np.where(np.isfinite(slow[starts]), slow[starts], 1.0)
    rim = starts & ~_shrink(starts)
    slow[starts & ~rim] = np.inf
    return slow, np.flatnonzero(rim).astype(np.int32)


def _shrink(cells: Flags) -> Flags:
    """The cells (rows, columns) all of whose eight neighbours are marked as well."""
    wide = np.pad(cells, 1)
    rows = wide[:-2] & wide[1:-1] & wide[2:]
    found: Flags = rows[:, :-2] & rows[:, 1:-1] & rows[:, 2:]
    return found


def _find_cells_near(
    raster: PathRaster, shape: shapely.Geometry, distance: float, least: float
) -> Flags:
    """Cells of the site within a distance of where ways come in, ``least`` metres from
    solids."""
    places = raster.points_of(np.arange(raster.solid.size, dtype=np.int32))
    near = shapely.buffer(shape, distance)
    shapely.prepare(near)
    close = shapely.contains_xy(near, places[:, 0], places[:, 1]).reshape(raster.solid.shape)
    found: Flags = close & (raster.border > 0.0) & (raster.solid >= least)
    return found


def _find_ends(
    raster: PathRaster, rings: list[Points], ahead: Floats, times: Floats, offs: Floats
) -> tuple[Ints, Floats]:
    """The cell beside each building that is reached first, and when (infinite: none): before its
    front, which looks ``ahead`` (n, 2), where that can be reached, else on any side."""
    goals, far = np.zeros(len(rings), np.int32), np.full(len(rings), np.inf)
    if not len(rings):
        return goals, far
    along = [np.concatenate([ring, 0.5 * (ring + np.roll(ring, -1, axis=0))]) for ring in rings]
    out = np.concatenate([row - row[: len(row) // 2].mean(0) for row in along])
    out /= np.maximum(np.hypot(*out.T), 1e-9)[:, None]
    owner = np.repeat(np.arange(len(rings)), [len(row) for row in along])
    points = np.concatenate(along) + offs[:, None, None] * out
    cells = raster.cells_of(points.reshape(-1, 2)).reshape(len(offs), -1)
    when, before = times[cells], (out * ahead[owner]).sum(1) > 0.2
    ends = np.searchsorted(owner, np.arange(len(rings) + 1))
    for k, (first, last) in enumerate(pairwise(ends.tolist())):
        own, front = when[:, first:last], before[first:last]
        if np.isfinite(own[:, front]).any():
            own = np.where(front, own, np.inf)
        best = int(np.argmin(own))
        goals[k], far[k] = cells[:, first:last].flat[best], own.flat[best]
    return goals, far


def find_centres(plan: SitePlan, built: Shapes, radius: float) -> shapely.Geometry:
    """Where the middle of a lane may lie."""
    around = shapely.union_all(shapely.buffer(built, radius - SLACK, quad_segs=ROUND))
    floor = shapely.Polygon(plan.outline, plan.holes)
    return shapely.difference(floor.buffer(-radius + SLACK, quad_segs=ROUND), around)


def find_centres_near(
    ground: LaneGround, near: shapely.Geometry, radius: float
) -> shapely.Geometry:
    """Where the middle of a disc of some ``radius`` may lie near some ground."""
    built = ground.built[ground.tree.query(near, "dwithin", radius)]
    around = shapely.union_all(shapely.buffer(built, radius - SLACK, quad_segs=ROUND))
    border = shapely.Polygon(ground.plan.outline, ground.plan.holes).boundary
    close = shapely.buffer(
        shapely.intersection(border, near.buffer(radius)), radius - SLACK, quad_segs=ROUND
    )
    floor = shapely.intersection(shapely.Polygon(ground.plan.outline, ground.plan.holes), near)
    return shapely.difference(floor, shapely.union(around, close))


def lay_lane(ground: LaneGround, laying: Laying, goal: int) -> shapely.LineString | None:
    """A lane from a goal to the nearest road or lane, nothing where it would run into what is
    built; its cells join those used."""
    piece = trace(laying.tree.before, goal, laying.used)
    others = laying.laid if piece[-1] in laying.used else []
    laying.used.update(piece)
    return draw_lane(ground, laying, piece, others)


def draw_lane(
    ground: LaneGround, laying: Laying, piece: Sequence[int], others: Sequence[shapely.LineString]
) -> shapely.LineString | None:
    """The middle line of a lane along the cells of a ``piece`` (k,), on to the nearest of the
    ``others``, or out to a street where there are none; nothing where it would run into what is
    built."""
    raster, slow, radius = ground.raster, laying.tree.slow, ground.radius
    straight = straighten(piece, slow, raster.cell)
    line = raster.points_of(square_off(straight, slow))
    if len(line) < 2:
        line = np.stack([line[0], line[0] + (raster.cell, 0.0)])
    dense = shapely.get_coordinates(shapely.segmentize(shapely.LineString(line), 0.5))
    lines = shapely.shortest_line(shapely.points(dense), laying.centres)
    moved = shapely.get_coordinates(lines)[1::2]
    if others:
        end, laid = shapely.Point(moved[-1]), np.array(others, object)
        nearest = laid[int(np.argmin(shapely.distance(laid, end)))]
        moved = np.vstack([moved, shapely.get_coordinates(shapely.shortest_line(end, nearest))])
    else:
        moved[-2:] = dense[-2:]
        moved = lead_out(moved, ground.exits, 4.0 * raster.cell + radius)
    lane = round_bends(shapely.simplify(shapely.LineString(moved), 0.02), laying.centres)
    meets = len(ground.tree.query(lane, "dwithin", radius - WITHIN)) > 0
    return None if meets else lane


def round_bends(line: shapely.LineString, centres: shapely.Geometry) -> shapely.LineString:
    """A line whose bends are drawn round as far as it stays where it may lie: a parabola that
    begins :data:`EASE` metres before each bend, or half as many and again half, but no farther
    than half-way to the next.

    >>> bent = shapely.LineString([(0, 0), (40, 0), (40, 40)])
    >>> free = shapely.box(-9, -9, 90, 90)
    >>> [len(shapely.get_coordinates(round_bends(bent, ground))) for ground in (free, bent)]
    [11, 3]
    """
    rows = shapely.get_coordinates(line)
    steps = np.hypot(*np.diff(rows, axis=0).T)
    found = [rows[:1]]
    for k in range(1, len(rows) - 1):
        bend = rows[k : k + 1]
        for ease in (EASE, EASE / 2, EASE / 4):
            room = np.minimum(ease, 0.5 * steps[k - 1 : k + 1])
            first = rows[k] + (rows[k - 1] - rows[k]) * (room[0] / max(steps[k - 1], 1e-9))
            last = rows[k] + (rows[k + 1] - rows[k]) * (room[1] / max(steps[k], 1e-9))
            at = np.linspace(0.0, 1.0, 2 * ROUND_OF + 1)[:, None]
            curve = (1 - at) ** 2 * first + 2 * at * (1 - at) * rows[k] + at**2 * last
            if shapely.covers(centres, shapely.LineString(curve)):
                bend = curve
                break
        found.append(bend)
    return shapely.LineString(np.vstack([*found, rows[-1:]]))
