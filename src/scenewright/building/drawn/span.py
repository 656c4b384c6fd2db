"""How much of the floor that lines of walls span became rooms: on a raster of small squares."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from scenewright.building.drawn.drawing import Segments

CELL, MOST_CELLS = 0.1, 250_000
"""The side in metres of a square of the raster, and the most squares: larger ones where needed."""
WAY, WALL = 1.6, 0.4
"""Half the widest way, in metres, between lines that span a floor together; half of what is wider
than any wall."""
LARGE = 0.3
"""The least extent of lines that hang together, as a share of the greatest."""
Mask = NDArray[np.bool_]


def missed_floor(walls: Segments, rooms: Sequence[Polygon], ground: Sequence[Polygon]) -> float:
    """Floor in m² around ``rooms`` that lines of ``walls`` (n, 2, 2) in metres span and no room
    has. What lies within lines no farther apart than 2 ``WAY`` is spanned (a morphological closing
    with its holes filled; marks that are small are no walls); what is narrower than 2 ``WALL`` is
    wall; ``ground`` is no floor.

    >>> room = shapely.box(0, 0, 4, 4)
    >>> lines = np.array([[[0, 0], [9, 0]], [[9, 0], [9, 4]], [[9, 4], [0, 4]], [[0, 4], [0, 0]]])
    >>> bool(abs(missed_floor(lines, [room], []) - 20.0) < 1.5)
    True
    """
    if not rooms or not len(walls):
        return 0.0
    walls = _large(walls)
    corners = walls.reshape(-1, 2)
    low = corners.min(0) - 3 * WAY
    sides = corners.max(0) + 3 * WAY - low
    cell = max(CELL, float(np.sqrt(sides.prod() / MOST_CELLS)))
    shape = tuple(int(n) for n in np.ceil(sides / cell))
    closed = _spread(_paint_lines((walls - low) / cell, shape), WAY / cell)
    filled = ~_reach(~closed, _border(shape))
    inside = _paint_areas(rooms, low, cell, shape)
    spanned = ~_spread(~_reach(filled, inside & filled), WAY / cell)
    bare = spanned & ~inside & ~_paint_areas(ground, low, cell, shape)
    core = ~_spread(~bare, WALL / cell)
    return float((_spread(core, WALL / cell) & bare).sum() * cell**2)


def _large(walls: Segments) -> Segments:
    """Lines that hang together over ``LARGE`` of the greatest extent: no letters, no scale bars."""
    lines = shapely.linestrings(walls)
    one, other = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=CELL / 10)
    label, before = np.arange(len(walls)), None
    while before is None or (label != before).any():
        before = label.copy()
        np.minimum.at(label, one, before[other])
        label = label[label]
    low, high = np.full((2, len(walls), 2), [[[np.inf]], [[-np.inf]]])
    np.minimum.at(low, label, walls.min(1))
    np.maximum.at(high, label, walls.max(1))
    extent = np.hypot(*(high - low)[label].T)
    return walls[extent >= LARGE * extent.max()]


def _paint_lines(walls: Segments, shape: tuple[int, ...]) -> Mask:
    """The squares that lines touch, by points half a square apart."""
    ways = walls[:, 1] - walls[:, 0]
    counts = np.ceil(2 * np.hypot(*ways.T)).astype(int) + 1
    owner = np.repeat(np.arange(len(walls)), counts)
    step = np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)
    share = step / np.maximum(counts[owner] - 1, 1)
    points = (walls[owner, 0] + share[:, None] * ways[owner]).astype(int)
    mask = np.zeros(shape, dtype=bool)
    mask[points[:, 0], points[:, 1]] = True
    return mask


def _paint_areas(
    areas: Sequence[Polygon], low: NDArray[np.float64], cell: float, shape: tuple[int, ...]
) -> Mask:
    """The squares whose middles lie in areas."""
    mask = np.zeros(shape, dtype=bool)
    for area in areas:
        box = (np.array(area.bounds).reshape(2, 2) - low) / cell
        first = np.maximum(box[0].astype(int), 0)
        last = np.minimum(box[1].astype(int) + 1, shape)
        xs, ys = (low[k] + (np.arange(first[k], last[k]) + 0.5) * cell for k in (0, 1))
        shapely.prepare(area)
        within = shapely.contains_xy(area, *np.meshgrid(xs, ys, indexing="ij"))
        mask[first[0] : last[0], first[1] : last[1]] |= within
    return mask


def _spread(mask: Mask, radius: float) -> Mask:
    """The squares no farther than a radius, in squares, from one that is set (by convolution with
    a disc; the raster is taken to repeat)."""
    x, y = (np.minimum(np.arange(n), n - np.arange(n)) for n in mask.shape)
    disc = x[:, None] ** 2 + y[None] ** 2 <= radius**2
    spread = np.fft.irfft2(np.fft.rfft2(mask) * np.fft.rfft2(disc), mask.shape)
    return np.asarray(spread > 0.5)


def _border(shape: tuple[int, ...]) -> Mask:
    mask = np.ones(shape, dtype=bool)
    mask[1:-1, 1:-1] = False
    return mask


def _reach(free: Mask, start: Mask) -> Mask:
    """The free squares that are joined to the start along sides, by sweeps in four directions."""
    reached, size = start & free, -1
    while size != (size := int(reached.sum())):
        for axis in (0, 1):
            for step in (1, -1):
                along, way = reached.swapaxes(0, axis)[::step], free.swapaxes(0, axis)[::step]
                places = np.arange(1, len(along) + 1)[:, None]
                last = np.maximum.accumulate(np.where(along, places, 0), axis=0)
                blocked = np.maximum.accumulate(np.where(way, 0, places), axis=0)
                along |= way & (last > blocked)
    return reached
