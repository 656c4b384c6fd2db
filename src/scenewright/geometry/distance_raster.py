"""How far a point of the floor is from the nearest wall or footprint: on a raster, and exactly.

A raster of capped distances needs no distance transform: each box writes the cells within the cap,
so a cell holds the exact Euclidean distance to the boxes themselves, not to other cells as the
transform of Felzenszwalb and Huttenlocher (2012) would.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.geometry.boxes import Floats, Frame, distance_to_box, frames_of, read_frame
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.paths import rounded_span


class DistanceRaster(NamedTuple):
    """Cells over a floor: corner ``x0, y0``, size ``cell`` in metres, and what each holds,
    ``values`` (rows, columns)."""

    x0: float
    y0: float
    cell: float
    values: Floats


@inlined
def row_span(raster: DistanceRaster, frame: Frame, radius: float) -> tuple[int, int]:
    """First and last (exclusive) row whose cell centres may lie within ``radius`` of a box."""
    tall = abs(frame[2]) * frame[4] + abs(frame[3]) * frame[5] + radius
    first = math.floor((frame[1] - tall - raster.y0) / raster.cell - 0.5)
    last = math.ceil((frame[1] + tall - raster.y0) / raster.cell + 0.5)
    return max(first, 0), min(last, raster.values.shape[0])


@inlined
def column_span(raster: DistanceRaster, low: float, high: float) -> tuple[int, int]:
    """First and last (exclusive) column whose cell centres lie in [low, high]."""
    if not (low <= high):
        return 0, 0
    first = math.ceil((low - raster.x0) / raster.cell - 0.5)
    last = math.floor((high - raster.x0) / raster.cell - 0.5) + 1
    return max(first, 0), min(last, raster.values.shape[1])


@inlined
def come_near(raster: DistanceRaster, frame: Frame, cap: float) -> None:
    """Lower the cells within ``cap`` of a box to their distance from it."""
    first, last = row_span(raster, frame, cap)
    for row in range(first, last):
        y = raster.y0 + (row + 0.5) * raster.cell
        low, high = rounded_span(frame, cap, y)
        start, end = column_span(raster, low, high)
        for k in range(start, end):
            x = raster.x0 + (k + 0.5) * raster.cell
            raster.values[row, k] = min(raster.values[row, k], distance_to_box(x, y, frame))


@inlined
def lift(raster: DistanceRaster, frame: Frame, value: float) -> None:
    """Raise the cells in a box to at least ``value``."""
    first, last = row_span(raster, frame, 0.0)
    for row in range(first, last):
        low, high = rounded_span(frame, 0.0, raster.y0 + (row + 0.5) * raster.cell)
        start, end = column_span(raster, low, high)
        for k in range(start, end):
            raster.values[row, k] = max(raster.values[row, k], value)


@inlined
def open_inside(raster: DistanceRaster, edges: Floats, cap: float) -> None:
    """Write ``cap`` into the cells inside the outline and outside the holes, 0 into the others.

    Every edge a row crosses changes the sign of all cells to its right. ``edges`` (e, 4) x0, y0,
    x1, y1 in metres.
    """
    values = raster.values
    for row in range(values.shape[0]):
        y = raster.y0 + (row + 0.5) * raster.cell
        for k in range(values.shape[1]):
            values[row, k] = -1.0
        for e in range(edges.shape[0]):
            if (edges[e, 1] <= y) != (edges[e, 3] <= y):
                share = (y - edges[e, 1]) / (edges[e, 3] - edges[e, 1])
                x = edges[e, 0] + share * (edges[e, 2] - edges[e, 0])
                start, end = column_span(raster, x, raster.x0 + values.shape[1] * raster.cell)
                for k in range(start, end):
                    values[row, k] = -values[row, k]
        for k in range(values.shape[1]):
            values[row, k] = cap if values[row, k] > 0.0 else 0.0


@compiled
def fill_clearance(
    raster: DistanceRaster,
    edges: Floats,
    walls: Floats,
    doors: Floats,
    solids: Floats,
    cap: float,
    least: float,
) -> None:
    """Write the distance of every cell centre to the nearest wall or solid, at most ``cap``.

    ``edges`` (e, 4) directed, the inside on the left; ``walls`` frames (w, 8) of walls without
    their doors; ``doors`` frames (d, 8) of strips through them that walls do not make narrower
    than ``least``; ``solids`` frames (s, 8). 0 outside.
    """
    open_inside(raster, edges, cap)
    for k in range(doors.shape[0]):
        lift(raster, read_frame(doors, k), cap)
    for k in range(walls.shape[0]):
        come_near(raster, read_frame(walls, k), cap)
    for k in range(doors.shape[0]):
        lift(raster, read_frame(doors, k), least)
    for k in range(solids.shape[0]):
        come_near(raster, read_frame(solids, k), cap)


def clearance(
    edges: Floats,
    walls: Floats,
    doors: Floats,
    solids: Floats,
    bounds: Floats,
    cell: float,
    cap: float,
    least: float,
) -> DistanceRaster:
    """The raster of :func:`fill_clearance` over ``bounds`` (x0, y0, x1, y1); walls, doors and
    solids as boxes (k, 5)."""
    columns, rows = (np.ceil((bounds[2:] - bounds[:2]) / cell).astype(int) + 1).tolist()
    raster = DistanceRaster(float(bounds[0]), float(bounds[1]), cell, np.empty((rows, columns)))
    fill_clearance(raster, edges, frames_of(walls), frames_of(doors), frames_of(solids), cap, least)
    return raster


def walls_between(edges: Floats, doors: Floats) -> Floats:
    """Boxes (k, 5) without depth across, as long as the parts of edges (e, 4) outside the boxes
    of doors (d, 5).

    >>> wall, door = np.array([[0.0, 0.0, 4.0, 0.0]]), np.array([[1.5, 0.0, np.pi / 2, 1.0, 0.2]])
    >>> walls_between(wall, door)[:, [0, 4]].tolist()
    [[0.5, 1.0], [3.0, 2.0]]
    """
    found = edges
    for door in doors:
        found = _outside(found, door)
    along = found[:, 2:] - found[:, :2]
    length = np.hypot(along[:, 0], along[:, 1])
    middle = (found[:, :2] + found[:, 2:]) / 2
    heading = np.arctan2(along[:, 1], along[:, 0])
    boxes = np.column_stack([middle, heading, np.zeros(len(found)), length])
    return np.ascontiguousarray(boxes[length > 1e-6])


def _outside(edges: Floats, box: Floats) -> Floats:
    """The edges (e, 4) before and after their part in a box (5,)."""
    right = np.array([np.sin(box[2]), -np.cos(box[2])])
    front = np.array([np.cos(box[2]), np.sin(box[2])])
    start, along = edges[:, :2] - box[:2], edges[:, 2:] - edges[:, :2]
    low, high = np.zeros(len(edges)), np.ones(len(edges))
    for axis, half in ((right, box[3] / 2), (front, box[4] / 2)):
        a, b = start @ axis, along @ axis
        level = np.abs(b) < 1e-12
        b = np.where(level, 1.0, b)
        ends = np.sort([(-half - a) / b, (half - a) / b], axis=0)
        never = level & (np.abs(a) > half)
        low = np.where(level, np.where(never, 1.0, low), np.maximum(low, ends[0]))
        high = np.where(level, np.where(never, 0.0, high), np.minimum(high, ends[1]))
    met = low < high
    before, after = edges[met].copy(), edges[met].copy()
    before[:, 2:] = before[:, :2] + low[met, None] * along[met]
    after[:, :2] = after[:, :2] + high[met, None] * along[met]
    return np.vstack([edges[~met], before, after])


@compiled
def fill_distances(points: Floats, frames: Floats, found: Floats) -> None:
    """Write the exact distance of each point (k, 2) to the nearest of the boxes, infinity if
    there is none."""
    for i in range(points.shape[0]):
        least = math.inf
        for k in range(frames.shape[0]):
            frame = read_frame(frames, k)
            apart = math.hypot(points[i, 0] - frame[0], points[i, 1] - frame[1]) - frame[6]
            if apart < least:
                least = min(least, distance_to_box(points[i, 0], points[i, 1], frame))
        found[i] = least


def distances(points: Floats, boxes: Floats) -> Floats:
    """Distance (k,) of points (k, 2) to the nearest of some boxes (n, 5), 0 inside, in metres.

    >>> distances(np.array([[3.0, 0.0]]), np.array([[0.0, 0.0, 0.0, 1.0, 2.0]])).tolist()
    [2.0]
    """
    found = np.empty(len(points))
    fill_distances(np.ascontiguousarray(points, np.float64), frames_of(boxes), found)
    return found
