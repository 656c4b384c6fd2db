"""The ground of a site as a raster for laying out ways: how far each cell is from solids.

The raster lies along the direction most buildings have, so that ways run along rows.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.outlines import edges
from scenewright.core.space import Points
from scenewright.geometry.distance_raster import clearance, walls_between
from scenewright.ground.fit import main_direction
from scenewright.ground.plan import SitePlan, Way

Floats = NDArray[np.float64]
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]

CELL, FINEST, FEW, CELLS = 1.0, 0.25, 40_000, 4_000_000
"""Side of a cell in metres: less, down to the second, where a site has fewer cells than the third,
more where it has more than the last."""
NO_BOXES = np.zeros((0, 5))


class PathRaster(NamedTuple):
    """Cells (rows, columns) of side ``cell`` from ``corner`` (2,) in a frame turned by ``angle``:
    distance to solids (``solid``), to the border of the site (``border``), both capped, 0
    outside, and which lie on ways that are ``driven``, and on any (``walked``)."""

    angle: float
    corner: Floats
    cell: float
    solid: Floats
    border: Floats
    driven: Flags
    walked: Flags

    def cells_of(self, points: Points) -> Ints:
        """The number of the cell each of the points (n, 2) lies in, the nearest if outside."""
        at = (turn(points, -self.angle) - self.corner) / self.cell
        rows, columns = self.solid.shape
        column = np.clip(at[:, 0].astype(int), 0, columns - 1)
        row = np.clip(at[:, 1].astype(int), 0, rows - 1)
        return (row * columns + column).astype(np.int32)

    def points_of(self, cells: Ints) -> Floats:
        """The middles (n, 2) of cells on the site."""
        row, column = np.divmod(np.asarray(cells), self.solid.shape[1])
        at = self.corner + self.cell * (np.column_stack([column, row]) + 0.5)
        return turn(at, self.angle)


def turn(points: Points, angle: float) -> Floats:
    """Points (n, 2) turned about the origin, counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    found: Floats = np.asarray(points, float) @ np.array([[c, s], [-s, c]])
    return found


def is_drivable(way: Way, width: float) -> bool:
    """Whether a lane of some width may begin on a way: a road, or a path as wide."""
    return way.kind == "road" or way.width >= width - 1e-6


def make_raster(
    plan: SitePlan,
    footprints: list[Points],
    cap: float,
    width: float,
    squares: Sequence[Points] = (),
) -> PathRaster:
    """The raster of a site on which ``footprints``, corners (k, 2) each, stand; distances are
    known up to ``cap`` metres. Paths as wide as lanes of some ``width`` are driven on; people walk
    on ``squares`` (k, 2) as on streets."""
    angle = main_direction(footprints or [plan.outline])
    ground = [turn(ring, -angle) for ring in (plan.outline, *plan.holes)]
    rings = np.concatenate([edges(ring) for ring in ground])
    low, high = ground[0].min(0) - CELL, ground[0].max(0) + CELL
    area = float(np.prod(high - low))
    cell = max(min(CELL, math.sqrt(area / FEW)), FINEST, math.sqrt(area / CELLS))
    bounds = np.concatenate([low, high])
    walls = [edges(turn(ring, -angle)) for ring in footprints]
    built = walls_between(np.concatenate([np.zeros((0, 4)), *walls]), NO_BOXES)
    around = walls_between(rings, NO_BOXES)
    given = (bounds, cell, cap, 0.0)
    solid = clearance(rings, built, NO_BOXES, NO_BOXES, *given)
    border = clearance(rings, around, NO_BOXES, NO_BOXES, *given)
    shape = solid.values.shape
    wide = [area for way in plan.roads if is_drivable(way, width) for area in way.areas]
    narrow = [area for way in plan.roads if not is_drivable(way, width) for area in way.areas]
    driven = _mark_areas([(area.outline, *area.holes) for area in wide], angle, low, cell, shape)
    paved = [*((area.outline, *area.holes) for area in narrow), *((ring,) for ring in squares)]
    others = _mark_areas(paved, angle, low, cell, shape)
    return PathRaster(angle, low, cell, solid.values, border.values, driven, driven | others)


def _mark_areas(
    areas: Sequence[tuple[Points, ...]],
    angle: float,
    corner: Floats,
    cell: float,
    shape: tuple[int, ...],
) -> Flags:
    """Which cells lie on some areas, outlines with their holes."""
    found = np.zeros(shape, bool)
    for outline, *holes in areas:
        polygon = shapely.Polygon(turn(outline, -angle), [turn(hole, -angle) for hole in holes])
        (x0, y0), (x1, y1) = np.reshape(polygon.bounds, (2, 2)) - corner
        c0, r0 = max(int(x0 / cell), 0), max(int(y0 / cell), 0)
        c1, r1 = min(int(x1 / cell) + 1, shape[1]), min(int(y1 / cell) + 1, shape[0])
        x, y = np.meshgrid(np.arange(c0, c1), np.arange(r0, r1))
        at = corner + cell * (np.stack([x, y], -1) + 0.5)
        shapely.prepare(polygon)
        found[r0:r1, c0:c1] |= shapely.contains_xy(polygon, at[..., 0], at[..., 1])
    return found
