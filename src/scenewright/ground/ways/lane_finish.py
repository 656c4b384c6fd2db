"""Lanes as they are laid in the end: straight links between dead ends first, then heads to turn in,
then lanes round the corner to the next way, so that what stays a dead end is short."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.geometry.wavefront import find_quickest
from scenewright.ground.ways.lane_ends import (
    ASIDE,
    BACK,
    JOINED,
    LINK,
    LONG,
    TURN,
    find_dead_ends,
    lay_head,
    link_ends,
    list_streets,
)
from scenewright.ground.ways.lanes import (
    LaneGround,
    Laying,
    corners_of_line,
    draw_lane,
    find_centres_near,
    laid_lanes,
)
from scenewright.ground.ways.path_tree import trace
from scenewright.ground.works import Pathway

Ints = NDArray[np.int32]
Row = tuple[shapely.LineString, float]

LEAVE = 6.0
"""Metres round a dead end in which a loop has left its own lane."""


def finish_lanes(ground: LaneGround, laying: Laying | None) -> tuple[Pathway, ...]:
    """Lanes with links between their ends, loops and heads where none is possible."""
    if laying is None or not laying.laid:
        return ()
    streets, radius = list_streets(ground.plan), ground.radius
    if streets.is_empty:
        return laid_lanes(laying, 2.0 * radius)
    every = [*laying.laid, *link_ends(laying.laid, streets, laying.centres, radius)]
    rows = [
        Pathway("lane", width or 2.0 * radius, corners_of_line(line))
        for line, width in _end_lanes(ground, laying, every, streets)
    ]
    return tuple(row for row in rows if len(row.line) > 1)


def _end_lanes(
    ground: LaneGround, laying: Laying, lanes: list[shapely.LineString], streets: shapely.Geometry
) -> list[Row]:
    """Lines and widths (0: the usual one) of lanes, each long dead end with its head or led on."""
    rows: dict[int, list[Row]] = {number: [(lane, 0.0)] for number, lane in enumerate(lanes)}
    free = shapely.buffer(laying.centres, 0.01)
    shapely.prepare(free)
    left: dict[int, shapely.Point] = {}
    for number, end in find_dead_ends(lanes, streets, ground.radius).items():
        if lanes[number].length > LONG:
            near = end.buffer(max(BACK) + ASIDE)
            wide = find_centres_near(ground, near, TURN)
            rows[number] = lay_head(lanes[number], end, free, wide) or rows[number]
            left |= {number: end} if len(rows[number]) == 1 else {}
    loops: list[Row] = []
    for number, end in left.items():
        others = [lane for k, lane in enumerate(lanes) if k != number]
        loop = _lay_loop(ground, laying, lanes[number], end, [*others, *(row[0] for row in loops)])
        loops += [(loop, 0.0)] if loop is not None else []
    return [*(row for own in rows.values() for row in own), *loops]


def _lay_loop(
    ground: LaneGround,
    laying: Laying,
    lane: shapely.LineString,
    end: shapely.Point,
    others: list[shapely.LineString],
) -> shapely.LineString | None:
    """A lane from a dead ``end`` round to the nearest of some ``others`` or to a street within
    :data:`LINK` metres; nothing if free ground leads to none."""
    raster, radius = ground.raster, ground.radius
    window = end.buffer(LINK)
    near = [row for row in others if row.distance(end) < LINK]
    rows, columns = _cells_about(ground, end)
    slow = laying.tree.slow[rows, columns].copy()
    numbers = np.arange(raster.solid.size, dtype=np.int32).reshape(raster.solid.shape)
    numbers = numbers[rows, columns]
    places = raster.points_of(numbers.reshape(-1))
    back = lane.difference(end.buffer(LEAVE))
    slow[_lie_within(places, back, 2.0 * radius).reshape(slow.shape)] = np.inf
    goals = _lie_within(places, shapely.union_all(near), raster.cell).reshape(slow.shape)
    driven = raster.driven[rows, columns]
    starts = np.flatnonzero((goals | driven) & np.isfinite(slow)).astype(np.int32)
    times, before = find_quickest(slow, raster.cell, starts)
    here = np.flatnonzero(numbers.reshape(-1) == raster.cells_of(np.array(end.coords))[0])
    if not len(here) or not np.isfinite(times[here[0]]) or times[here[0]] > 2.0 * LINK:
        return None
    piece = trace(before, int(here[0]), ())
    joins = goals.reshape(-1)[piece[-1]] and not driven.reshape(-1)[piece[-1]]
    line = draw_lane(ground, laying, numbers.reshape(-1)[piece].tolist(), near if joins else [])
    if line is None or not window.intersects(line) or line.length < JOINED:
        return None
    return shapely.LineString([*end.coords, *line.coords])


def _cells_about(ground: LaneGround, end: shapely.Point) -> tuple[slice, slice]:
    """The rows and columns of the raster within :data:`LINK` metres of a point."""
    raster = ground.raster
    row, column = divmod(int(raster.cells_of(np.array(end.coords))[0]), raster.solid.shape[1])
    wide = int(LINK / raster.cell)
    return slice(max(row - wide, 0), row + wide + 1), slice(
        max(column - wide, 0), column + wide + 1
    )


def _lie_within(
    places: NDArray[np.float64], shape: shapely.Geometry, far: float
) -> NDArray[np.bool_]:
    """Which of some places (n, 2) lie within ``far`` metres of a shape."""
    area = shapely.buffer(shape, far, quad_segs=2)
    shapely.prepare(area)
    found: NDArray[np.bool_] = shapely.contains_xy(area, places[:, 0], places[:, 1])
    return found
