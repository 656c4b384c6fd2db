"""Samples that the networks of Zhu, Jiang and Li (2022) learn from.

For each sample the houses of a block are shuffled. *Continue* keeps each with probability 0.5 or
all, and says whether houses are missing. The others are told some houses and the next one.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.village.learning.paper.nets import COUNTED
from scenewright.domains.village.learning.paper.views import (
    AREAS,
    MATERIALS,
    SHAPES,
    PaperHouses,
    ViewFrame,
    centre_view,
    frame_of,
    paint,
    paper_houses,
)
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.standing import Floats

REMOVED = 0.5


class PaperBlock(NamedTuple):
    """A block as the networks are told: the real one, its houses, its view."""

    block: RealBlock
    houses: PaperHouses
    frame: ViewFrame


class PaperSample(NamedTuple):
    """One sample: a ``view``, the count vector, classes of the next house (material, shape, area),
    the pixel (row * size + column) of its base point, the cosine of its door angle, a view centred
    on it, and whether houses are missing in ``part`` (a view of its own)."""

    view: NDArray[np.float32]
    counts: Floats
    classes: tuple[int, int, int]
    pixel: int
    cosine: float
    near: NDArray[np.float32]
    part: NDArray[np.float32]
    more: float


def tell_block(block: RealBlock, size: int) -> PaperBlock:
    """A real block for views of so many pixels a side."""
    return PaperBlock(block, paper_houses(block), frame_of(block.floor, size))


def sample_of(told: PaperBlock, rng: np.random.Generator) -> PaperSample:
    """One sample of a block, drawn afresh."""
    floor, houses, frame = told.block.floor, told.houses, told.frame
    count = len(houses.footprints)
    order = rng.permutation(count)
    placed = int(rng.integers(count))
    before, next_ = houses.take(order[:placed]), int(order[placed])
    full = rng.random() < 0.5
    kept = np.arange(count) if full else np.flatnonzero(rng.random(count) >= REMOVED)
    base = houses.bases[next_]
    classes = tuple(int(v[next_]) for v in houses[3:])
    return PaperSample(
        paint(frame, floor, before),
        count_vector(before),
        (classes[0], classes[1], classes[2]),
        pixel_of(frame, base),
        float(np.cos(houses.doors[next_])),
        paint(centre_view(frame, base), floor, before),
        paint(frame, floor, houses.take(kept)),
        float(len(kept) < count),
    )


def pixel_of(frame: ViewFrame, point: Floats) -> int:
    """The number of the pixel of a point (2,), the first in the upper left."""
    column, row = np.clip(frame.pixels(point[None])[0].astype(int), 0, frame.size - 1)
    return int(row * frame.size + column)


def count_vector(houses: PaperHouses) -> Floats:
    """How many houses of each material, shape and area (COUNTED,), in tens."""
    parts = [
        np.bincount(values, minlength=size)
        for values, size in zip(houses[3:], (MATERIALS, SHAPES, AREAS), strict=True)
    ]
    return np.concatenate(parts) / 10.0


def class_planes(classes: tuple[int, int, int], size: int) -> NDArray[np.float32]:
    """The classes of a house as planes (COUNTED, size, size), 1 where it is of one."""
    planes = np.zeros((COUNTED, size, size), np.float32)
    planes[[classes[0], MATERIALS + classes[1], MATERIALS + SHAPES + classes[2]]] = 1.0
    return planes
