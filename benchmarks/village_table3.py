"""The measures of Table 2 and 3 of Zhu, Jiang and Li (2022): classes, density, near-road, doors.

A block is told by footprints, doors and classes of material, shape and area. Of a set of blocks
each measure is the mean of the blocks'; KL is of the classes of all their houses.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from benchmarks.village_metrics import kl
from scenewright.domains.village.paper.nets_file import CLASSES
from scenewright.domains.village.paper.retrieval import door_facing

Floats = np.ndarray
STEP = 1.5
"""By how much the next door may be farther from the edge than the last of the outer ring."""


class ToldBlock(NamedTuple):
    """A filled block: its ground, footprints (m, 2) of n houses, doors (n, 2), classes (n, 3)."""

    floor: shapely.Polygon
    rings: tuple[Floats, ...]
    doors: Floats
    classes: Floats


def density(block: ToldBlock) -> float:
    """(5), (6): the mean over the houses of the metres to the nearest other house, between the
    nearest edges of both; 0 for one house alone.

    >>> box = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    >>> rings = (box, box + (3, 0), box + (10, 0))
    >>> density(ToldBlock(shapely.box(0, 0, 20, 9), rings, box[:3], np.zeros((3, 3))))
    3.3333333333333335
    """
    shapes = np.array([shapely.Polygon(ring) for ring in block.rings], object)
    if len(shapes) < 2:
        return 0.0
    away = shapely.distance(shapes[:, None], shapes[None])
    np.fill_diagonal(away, np.inf)
    return float(away.min(1).mean())


def near_road(block: ToldBlock) -> float:
    """The mean metres from doors of the outer ring to the edge of the block: doors are sorted by
    that distance, the ring ends where the next is more than half as far again.

    >>> box, doors = shapely.box(0, 0, 20, 20), np.array([[5.0, 2], [9, 3], [9, 4], [9, 9]])
    >>> near_road(ToldBlock(box, (), doors, np.zeros((0, 3))))
    3.0
    """
    away = np.sort(shapely.distance(shapely.points(block.doors), block.floor.exterior))
    ends = np.flatnonzero(away[1:] > STEP * np.maximum(away[:-1], 1e-9))
    return float(away[: ends[0] + 1 if len(ends) else None].mean())


def facing(block: ToldBlock) -> float:
    """The mean angle in degrees, 90 at best, between the way from a house's middle to its door and
    the nearest side of the block (:func:`…retrieval.door_facing`)."""
    pairs = zip(block.rings, block.doors, strict=True)
    return float(np.mean([door_facing(ring, door, block.floor) for ring, door in pairs]))


def tell_table3(blocks: Sequence[ToldBlock]) -> dict[str, float]:
    """The columns of Table 3 for a set of blocks."""
    rows = [(density(one), near_road(one), facing(one)) for one in blocks if len(one.rings)]
    names = "density (5)(6), m", "near-road of the outer ring, m", "door facing, degrees"
    return dict(zip(names, np.mean(rows, axis=0).tolist(), strict=True))


def tell_table2(real: Sequence[ToldBlock], made: Sequence[ToldBlock]) -> dict[str, float]:
    """KL(real || made) of the classes of all houses, in nats."""
    one, other = (np.concatenate([block.classes for block in set_]) for set_ in (real, made))
    return {
        f"KL {name}": kl(*(np.bincount(v[:, k], minlength=size) for v in (one, other)))
        for k, (name, size) in enumerate(CLASSES.items())
    }


def shuffle_block(block: ToldBlock, rng: np.random.Generator) -> ToldBlock:
    """The same houses moved and turned by chance about the block, doors with them."""
    west, south, east, north = block.floor.bounds
    rings, doors = [], []
    for ring, door in zip(block.rings, block.doors, strict=True):
        turn = rng.uniform(0, 2 * np.pi)
        spin = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        middle, to = ring.mean(0), rng.uniform((west, south), (east, north))
        rings.append((ring - middle) @ spin + to)
        doors.append((door - middle) @ spin + to)
    return ToldBlock(block.floor, tuple(rings), np.array(doors), block.classes)
