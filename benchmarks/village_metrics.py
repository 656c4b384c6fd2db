"""How alike generated and real blocks are: divergences of what single houses tell, voids, and how
well a classifier tells them apart.

KL(real || generated) is of shares in the bins of the tables (:mod:`…village.settings`), half a
house added to each bin. The classifier is logistic on deciles of what is told of each house and of
pairs of these, trained and judged on different blocks (five folds).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.village.house import class_of_shape
from scenewright.domains.village.measures import coverage, relations_of, void
from scenewright.domains.village.settings import OURS
from scenewright.domains.village.standing import StandingHouses
from scenewright.domains.village.weights import bin_of

Floats = np.ndarray
COLUMNS = ("gap", "turn", "street", "street_turn", "area", "stretch", "near", "shape")
FOLDS, STEPS, RATE, RIDGE = 5, 300, 0.5, 3e-3


class BlockFigures(NamedTuple):
    """What is told of one block: rows (n, 8) of :data:`COLUMNS`, void and coverage, the shares of
    houses outside and overlapping."""

    rows: Floats
    void: float
    coverage: float
    faulty: float


def figures(floor: shapely.Polygon, streets: Floats, standing: StandingHouses) -> BlockFigures:
    """The figures of a block with its houses."""
    found = relations_of(standing, streets)
    area = np.asarray(shapely.area(standing.shapes))
    centre = standing.frames[:, :2]
    away = np.hypot(*(centre[:, None] - centre[None]).transpose(2, 0, 1))
    near = (away < 25.0).sum(1) - 1.0
    stretch = standing.frames[:, 3] / np.maximum(standing.frames[:, 4], 0.1)
    shape = [class_of_shape(shapely.get_coordinates(s.exterior)[:-1]) for s in standing.shapes]
    rows = np.column_stack(
        [found.gap, found.turn, found.street, found.street_turn, area, stretch, near, shape]
    )
    shared = shapely.area(shapely.intersection(standing.shapes[:, None], standing.shapes[None]))
    np.fill_diagonal(shared, 0.0)
    out = shapely.area(shapely.difference(standing.shapes, floor))
    faulty = (shared.max(1, initial=0.0) > 0.1) | (out > 0.1)
    return BlockFigures(
        rows, void(floor, standing), coverage(floor, standing), float(faulty.mean())
    )


def divergences(real: Sequence[BlockFigures], made: Sequence[BlockFigures]) -> dict[str, float]:
    """KL of real from generated houses: classes of area and shape, gap, turn, street, its turn."""
    one, other = (np.concatenate([block.rows for block in blocks]) for blocks in (real, made))
    classes = (np.array([0.0, 50.0, 100.0, 1e9]), np.array([0.0, 0.5, 1.5]))
    found = {
        "KL area": _kl_edges(one[:, 4], other[:, 4], classes[0]),
        "KL shape": _kl_edges(one[:, 7], other[:, 7], classes[1]),
    }
    for name, column in (("gap", 0), ("turn", 1), ("street", 2), ("street_turn", 3)):
        table = getattr(OURS, name)
        count = len(table.small)
        held = [np.bincount(bin_of(table, v[:, column]), minlength=count) for v in (one, other)]
        found[f"KL {name}"] = kl(*held)
    return found


def _kl_edges(real: Floats, made: Floats, edges: Floats) -> float:
    return kl(np.histogram(real, edges)[0], np.histogram(made, edges)[0])


def kl(real: Floats, made: Floats) -> float:
    """KL(real || generated) of counts in bins, half a house added to each.

    >>> round(kl(np.array([90, 10]), np.array([50, 50])), 2)
    0.36
    """
    p, q = ((counts + 0.5) / (counts + 0.5).sum() for counts in (real, made))
    return float((p * np.log(p / q)).sum())


def classifier_auc(
    real: Sequence[BlockFigures], made: Sequence[BlockFigures], seed: int = 0
) -> float:
    """How well houses of held-out blocks are told real from generated: 0.5 not at all, 1 always."""
    rows = np.concatenate([block.rows for block in (*real, *made)])
    label = np.repeat([1.0, 0.0], [sum(len(b.rows) for b in blocks) for blocks in (real, made)])
    owner = np.repeat(np.arange(len(real) + len(made)), [len(b.rows) for b in (*real, *made)])
    fold = np.random.default_rng(seed).integers(FOLDS, size=len(real) + len(made))[owner]
    coded = _one_hot(rows)
    score = np.zeros(len(rows))
    for k in range(FOLDS):
        weights = _logistic(coded[fold != k], label[fold != k])
        score[fold == k] = coded[fold == k] @ weights
    return auc(score, label)


def _one_hot(rows: Floats) -> Floats:
    """Deciles of each column and quartiles of each pair, as zeros and ones."""
    codes = [np.searchsorted(np.unique(np.quantile(v, np.arange(1, 10) / 10)), v) for v in rows.T]
    coarse = [np.searchsorted(np.unique(np.quantile(v, (0.25, 0.5, 0.75))), v) for v in rows.T]
    codes += [a * 5 + b for a, b in combinations(coarse, 2)]
    parts = [np.eye(int(code.max()) + 1)[code] for code in codes]
    return np.hstack([*parts, np.ones((len(rows), 1))])


def _logistic(rows: Floats, label: Floats) -> Floats:
    """Logistic regression by gradient descent with momentum, both classes weighing the same."""
    weights, speed = np.zeros(rows.shape[1]), np.zeros(rows.shape[1])
    share = np.where(label > 0, 0.5 / label.mean(), 0.5 / (1 - label.mean()))
    for _ in range(STEPS):
        odds = 1.0 / (1.0 + np.exp(-np.clip(rows @ weights, -30, 30)))
        slope = rows.T @ (share * (odds - label)) / len(label) + RIDGE * weights
        speed = 0.9 * speed - RATE * slope
        weights = weights + speed
    return weights


def auc(score: Floats, label: Floats) -> float:
    """The chance that a real house scores above a generated one.

    >>> auc(np.array([0.1, 0.9, 0.8, 0.2]), np.array([0, 1, 1, 0.0]))
    1.0
    """
    order = np.argsort(score, kind="stable")
    ranks = np.empty(len(score))
    _, first, count = np.unique(score[order], return_index=True, return_counts=True)
    ranks[order] = np.repeat(first + (count + 1) / 2, count)
    real = label > 0
    total = real.sum() * (~real).sum()
    return float((ranks[real].sum() - real.sum() * (real.sum() + 1) / 2) / total)
