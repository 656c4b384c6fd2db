"""The tables of a manner from real blocks.

Each block is taken as it would be filled, the largest house first, so that gaps and angles are
those to houses placed before, as the solver will ask for them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.village.house import class_of_area
from scenewright.domains.village.learned.mix import HouseMix
from scenewright.domains.village.learned.style import Region
from scenewright.domains.village.relations import relate
from scenewright.domains.village.settings import OURS, Manner, Relations
from scenewright.domains.village.standing import Floats, StandingHouses, stand
from scenewright.domains.village.weights import bin_of

PRIOR = 2.0
"""Houses that each bin of a table is taken to hold besides those seen, spread as in ours."""
FEWEST, FEWEST_OF_REGION = 8, 24
"""Blocks from which the law of counts is fitted (with fewer ours is kept), and blocks of a region
that has a manner of its own."""


class RealBlock(NamedTuple):
    """A real block: its ground, street sides (s, 2, 2), the footprints (n, 2) of its houses, the
    region it lies in, and, if known, of each house its door (2,) and the class of its material."""

    name: str
    place: str
    floor: shapely.Polygon
    streets: Points
    houses: tuple[Points, ...]
    region: str = ""
    doors: tuple[Floats, ...] = ()
    materials: tuple[int, ...] = ()

    @property
    def street_share(self) -> float:
        """The share of its outline that is street."""
        step = self.streets[:, 1] - self.streets[:, 0]
        return min(float(np.hypot(*step.T).sum() / self.floor.exterior.length), 1.0)

    @property
    def standing(self) -> StandingHouses:
        """Its houses as they stand."""
        areas = [float(shapely.Polygon(ring).area) for ring in self.houses]
        return stand(list(self.houses), [class_of_area(area) for area in areas])


def learn_regions(blocks: Sequence[RealBlock], manner: Manner) -> dict[str, Region]:
    """Regions with enough blocks, if there are several; their tables begin with those of all."""
    found = {}
    names = sorted({block.region for block in blocks if block.region})
    for name in names if len(names) > 1 else []:
        own = [block for block in blocks if block.region == name]
        if len(own) >= FEWEST_OF_REGION:
            found[name] = Region(learn_manner(own, manner), learn_mix(own))
    return found


def learn_manner(blocks: Sequence[RealBlock], known: Manner = OURS) -> Manner:
    """The manner of some blocks, given a ``known`` one: tables of relations, the law of
    counts, shares of classes."""
    rows = np.concatenate([relate_in_order(block) for block in blocks])
    small = rows[:, 4] == 0
    tables = []
    for column, table in enumerate((known.gap, known.turn, known.street, known.street_turn)):
        known = np.isfinite(rows[:, column])
        tables.append(
            Relations(
                table.edges,
                _shares(table, table.small, rows[known & small, column]),
                _shares(table, table.large, rows[known & ~small, column]),
            )
        )
    sizes = np.bincount(rows[:, 4].astype(int), minlength=3) + 0.5
    a, b, c = (float(v) for v in sizes / sizes.sum())
    gap, turn, street, street_turn = tables
    return Manner(gap, turn, street, street_turn, _count_law(blocks), (a, b, c))


def learn_mix(blocks: Sequence[RealBlock]) -> HouseMix:
    """Which houses stand together in some blocks."""
    rows, houses = [], []
    for block in blocks:
        standing = block.standing
        stretch = standing.frames[:, 3] / np.maximum(standing.frames[:, 4], 0.1)
        houses.append(np.column_stack([shapely.area(standing.shapes), stretch]).round(3))
        rows.append((np.log(block.floor.area), block.street_share, float(len(stretch))))
    sizes = np.concatenate(houses)
    return HouseMix(np.array(rows).round(4), np.maximum(sizes, (0.1, 1.0)))


def relate_in_order(block: RealBlock) -> Floats:
    """Of each house (n, 5): gap, turn, distance to the street and turn from it, the first two to
    larger houses only (NaN for the largest), and its class of area."""
    standing = block.standing
    order = np.argsort(-shapely.area(standing.shapes), kind="stable")
    rows = np.full((len(order), 5), np.nan)
    for k, n in enumerate(order.tolist()):
        before = standing.take(order[:k])
        mine = standing.shapes[n : n + 1]
        found = relate(mine, standing.frames[n : n + 1, 2], before, block.streets)
        rows[k] = (found.gap[0], found.turn[0], found.street[0], found.street_turn[0], 0)
        rows[k, :2] = rows[k, :2] if k else np.nan
        rows[k, 4] = standing.sizes[n]
    return rows


def _shares(table: Relations, ours: tuple[float, ...], values: Floats) -> tuple[float, ...]:
    held = np.bincount(bin_of(table, values), minlength=len(ours)) if len(values) else 0
    counts = held + PRIOR * np.array(ours)
    return tuple(float(v) for v in counts / counts.sum())


def _count_law(blocks: Sequence[RealBlock]) -> tuple[float, float, float, float]:
    """log n = a + b log area + c share, by least squares, and the spread about it."""
    if len(blocks) < FEWEST:
        return OURS.count_law
    rows = np.array([(1.0, np.log(b.floor.area), b.street_share) for b in blocks])
    counts = np.log([len(b.houses) for b in blocks])
    law = np.linalg.lstsq(rows, counts, rcond=None)[0]
    spread = float((counts - rows @ law).std())
    return float(law[0]), float(law[1]), float(law[2]), spread
