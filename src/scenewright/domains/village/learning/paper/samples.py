"""Samples that the networks of Zhu, Jiang and Li (2022) learn from.

For each sample the houses of a block are shuffled. *Continue* keeps each with probability 0.5 or
all, and says whether houses are missing. The others get some houses and the next one.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.village.house import class_of_area, class_of_shape
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.views import (
    CHANNELS,
    PaperHouses,
    ViewFrame,
    base_and_door,
    count_vector,
    door_points,
    frame_of,
)
from scenewright.domains.village.standing import Floats, Indices

REMOVED = 0.5


class PaperBlock(NamedTuple):
    """A block as the networks see it: the real one, its houses, its view, the pixels of its
    ground (k, 2) as row and column, and of each house."""

    block: RealBlock
    houses: PaperHouses
    frame: ViewFrame
    ground: Indices
    cells: tuple[Indices, ...]


class PaperSample(NamedTuple):
    """One sample: a ``view``, the count vector, classes of the next house (material, shape, area),
    the pixel (row * size + column) of its base point, the cosine of its door angle, and whether
    houses are missing (*continue* alone). The view of *orientation* is shifted to the base point;
    that of *continue* has half the houses, or all."""

    view: NDArray[np.float32]
    counts: Floats
    classes: tuple[int, int, int]
    pixel: int
    cosine: float
    more: float


def tell_block(block: RealBlock, size: int) -> PaperBlock:
    """A real block for views of ``size`` pixels a side."""
    houses, frame = paper_houses(block), frame_of(block.floor, size)
    steps = np.arange(size) + 0.5
    spots = frame.metres(np.stack(np.meshgrid(steps, steps), -1).reshape(-1, 2))
    inside = np.flatnonzero(shapely.contains_xy(block.floor, spots[:, 0], spots[:, 1]))
    house, at = shapely.STRtree(shapely.points(spots)).query(
        houses.footprints, predicate="intersects"
    )
    cells = tuple(_rows(at[house == k], size) for k in range(len(houses.footprints)))
    return PaperBlock(block, houses, frame, _rows(inside, size), cells)


def _rows(pixels: Indices, size: int) -> Indices:
    return np.column_stack(np.divmod(pixels, size)).astype(np.int16)


def paint_told(block: PaperBlock, kept: Indices, shift: tuple[int, int]) -> NDArray[np.float32]:
    """The twelve channels of some houses of a block, all moved by whole pixels (rows, columns)."""
    size = block.frame.size
    view = np.zeros((CHANNELS, size, size), np.float32)
    _put(view, (0,), block.ground, shift, 1.0)
    doors = block.houses.doors
    for k in kept.tolist():
        material, shape, area = (int(v[k]) for v in block.houses[3:])
        cells = block.cells[k]
        _put(view, (1, 4 + material, 7 + shape, 9 + area), cells, shift, 1.0)
        _put(view, (2,), cells, shift, float(np.sin(doors[k])))
        _put(view, (3,), cells, shift, float(np.cos(doors[k])))
    return view


def _put(
    view: NDArray[np.float32],
    channels: tuple[int, ...],
    cells: Indices,
    shift: tuple[int, int],
    value: float,
) -> None:
    at = cells + np.array(shift)
    at = at[((at >= 0) & (at < view.shape[-1])).all(1)]
    for channel in channels:
        view[channel, at[:, 0], at[:, 1]] = value


def sample_of(block: PaperBlock, rng: np.random.Generator, asked: str) -> PaperSample:
    """One sample of a block for the network ``asked``, drawn afresh."""
    houses, size = block.houses, block.frame.size
    count = len(houses.footprints)
    order = rng.permutation(count)
    placed = int(rng.integers(count))
    kept, next_ = order[:placed], int(order[placed])
    if asked == "continue":
        full = rng.random() < 0.5
        kept = np.arange(count) if full else np.flatnonzero(rng.random(count) >= REMOVED)
    pixel = pixel_of(block.frame, houses.bases[next_])
    row, column = divmod(pixel, size)
    shift = (size // 2 - row, size // 2 - column) if asked == "orientation" else (0, 0)
    classes = tuple(int(v[next_]) for v in houses[3:])
    return PaperSample(
        paint_told(block, kept, shift),
        count_vector(houses.take(kept)),
        (classes[0], classes[1], classes[2]),
        pixel,
        float(np.cos(houses.doors[next_])),
        float(len(kept) < count),
    )


def pixel_of(frame: ViewFrame, point: Floats) -> int:
    """The number of the pixel of a point (2,), the first in the upper left."""
    column, row = np.clip(frame.pixels(point[None])[0].astype(int), 0, frame.size - 1)
    return int(row * frame.size + column)


def paper_houses(block: RealBlock) -> PaperHouses:
    """The houses of a real block, their doors assumed where they are not known."""
    rings = list(block.houses)
    doors = list(block.doors) or door_points(rings, block.streets)
    ends = [base_and_door(ring, door) for ring, door in zip(rings, doors, strict=True)]
    shapes = np.empty(len(rings), object)
    shapes[:] = [shapely.Polygon(ring) for ring in rings]
    areas = shapely.area(shapes)
    return PaperHouses(
        shapes,
        np.array([base for base, _ in ends]).reshape(-1, 2),
        np.array([angle for _, angle in ends]),
        np.array(block.materials or [0] * len(rings), np.int64),
        np.array([class_of_shape(ring) for ring in rings], np.int64),
        np.array([class_of_area(float(area)) for area in areas], np.int64),
    )
