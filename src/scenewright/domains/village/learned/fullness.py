"""Is a block full? The odds that it lacks houses, as *continue* of Zhu, Jiang
and Li (2022), by logistic regression on figures of the block instead of a view of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.village.learned.surroundings import Surroundings
from scenewright.domains.village.standing import Floats

VOIDS = (25, 50, 75, 90, 95, 99)
FRONTS = (50, 75, 90)
"""Percentiles of the distance to a house over the ground, and along the street."""
SPOTS = 60
"""Points looked at along the street."""
FIGURES = 24
"""Figures of a block, see :func:`figures_of_state`."""


class MoreLaw(NamedTuple):
    """Logistic regression on standardized figures: their means and spreads (FIGURES,), a weight
    each, and the constant."""

    mean: Floats
    spread: Floats
    weights: Floats
    constant: float


def odds_of_more(
    law: MoreLaw, seen: Surroundings, count_law: tuple[float, float, float, float]
) -> float:
    """The chance in [0, 1] that a block with these houses is not full yet."""
    return float(odds_of_figures(law, figures_of_state(seen, count_law)[None])[0])


def odds_of_figures(law: MoreLaw, rows: Floats) -> Floats:
    """The same for rows of figures (n, FIGURES): (n,).

    >>> law = MoreLaw(np.zeros(FIGURES), np.ones(FIGURES), np.zeros(FIGURES), 0.0)
    >>> odds_of_figures(law, np.ones((1, FIGURES))).tolist()
    [0.5]
    """
    score = (rows - law.mean) / law.spread @ law.weights + law.constant
    return np.asarray(1.0 / (1.0 + np.exp(-np.clip(score, -30, 30))))


def figures_of_state(seen: Surroundings, count_law: tuple[float, float, float, float]) -> Floats:
    """Features of a block with some houses (FIGURES,): how many against how many such blocks
    have, coverage, voids over the ground and along the street, gaps, sizes."""
    shapes, a, b, c = seen.standing.shapes, *count_law[:3]
    count, area = len(shapes), np.log(seen.area)
    number = np.log(count + 0.5)
    void = np.percentile(seen.away, VOIDS)
    gaps = _gaps(seen)
    covered = float(shapely.area(shapes).sum()) / seen.area if count else 0.0
    wide = float(np.sqrt(shapely.area(shapes)).mean()) / 10 if count else 0.0
    parts = [
        [number, a + b * area + c * seen.street_share - number, area, seen.street_share, covered],
        np.log1p(void),
        np.log1p(void / np.sqrt(seen.area / (count + 1))),
        np.log1p([gaps.mean(), np.median(gaps), gaps.max()]),
        [wide],
        np.log1p(_fronts(seen)),
    ]
    return np.concatenate(parts)


def _gaps(seen: Surroundings) -> Floats:
    shapes = seen.standing.shapes
    if len(shapes) < 2:
        return np.zeros(1)
    away = shapely.distance(shapes[:, None], shapes[None])
    np.fill_diagonal(away, np.inf)
    return np.asarray(away.min(1))


def _fronts(seen: Surroundings) -> Floats:
    """Percentiles of the distance to a house along the street."""
    step = seen.streets[:, 1] - seen.streets[:, 0]
    length = np.hypot(step[:, 0], step[:, 1])
    ends = np.cumsum(length)
    spots = (np.arange(SPOTS) + 0.5) / SPOTS * ends[-1]
    side = np.minimum(np.searchsorted(ends, spots), len(ends) - 1)
    share = 1.0 - (ends[side] - spots) / np.maximum(length[side], 1e-9)
    points = seen.streets[side, 0] + step[side] * share[:, None]
    if not len(seen.standing.shapes):
        return np.full(len(FRONTS), 200.0)
    houses = shapely.union_all(seen.standing.shapes)
    return np.percentile(shapely.distance(houses, shapely.points(points)), FRONTS)
