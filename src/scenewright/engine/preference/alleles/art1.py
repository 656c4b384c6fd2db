"""An ART1 network that stands in for the person: Zhang, Yang 2023, algorithm and (24), (25).

Adaptive resonance (Carpenter, Grossberg 1987) sorts binary patterns into categories: a pattern
joins the category whose prototype it fits if it fits well enough, else it founds one. A category
is worth the mean rating of its members.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


class Art1Settings(NamedTuple):
    """Vigilance ρ in (0, 1]: the share of a pattern that a category's prototype must hold; and
    the learning rate β in (0, 1]."""

    vigilance: float = 0.6
    rate: float = 1.0


class Art1Network(NamedTuple):
    """Categories so far: ``upward`` weights V²¹ (c, n), ``downward`` prototypes V¹² (c, n), the sum
    of ratings of each (c,) and its number of members (c,)."""

    upward: Floats
    downward: Floats
    ratings: Floats
    members: Floats


def begin_network(length: int) -> Art1Network:
    """A network for patterns of ``length`` bits: no category yet. (The paper starts with one that
    holds everything, V²¹ = 1 / (1 + n) and V¹² = 1; the first pattern takes it over, which comes to
    the same.)"""
    none = np.zeros((0, length))
    return Art1Network(none, none, np.zeros(0), np.zeros(0))


def find_category(network: Art1Network, pattern: Floats, settings: Art1Settings) -> int | None:
    """The category a pattern (n,) resonates with: the greatest V²¹ x first, of those with
    V¹² x / x x > ρ; none if there is none.

    >>> network, _ = present(begin_network(4), np.array([1.0, 1, 0, 0]), 3.0, Art1Settings(0.4))
    >>> find_category(network, np.array([1.0, 0, 1, 0]), Art1Settings(0.4))
    0
    >>> find_category(network, np.array([1.0, 0, 1, 0]), Art1Settings(0.5)) is None
    True
    """
    drive = network.upward @ pattern
    whole = max(float(pattern @ pattern), 1e-12)
    for category in np.argsort(-drive, kind="stable").tolist():
        if float(network.downward[category] @ pattern) / whole > settings.vigilance:
            return int(category)
    return None


def present(
    network: Art1Network, pattern: Floats, rating: float, settings: Art1Settings
) -> tuple[Art1Network, int]:
    """The network after a rated pattern (bits,), and the category it is in.

    Resonance: V¹² ← (1 - β) V¹² + β (V¹² ⊙ x), V²¹ ← 2 V¹² ⊙ x / (1 + V¹² · x), with the prototype
    before. A new category has V¹² = x and V²¹ = 1 / (1 + x x), where x is 1.
    """
    found = find_category(network, pattern, settings)
    if found is None:
        founded = pattern / (1.0 + float(pattern @ pattern))
        grown = Art1Network(
            np.vstack([network.upward, founded]),
            np.vstack([network.downward, pattern]),
            np.append(network.ratings, rating),
            np.append(network.members, 1.0),
        )
        return grown, len(grown.members) - 1
    upward, downward = network.upward.copy(), network.downward.copy()
    old, rate = downward[found].copy(), settings.rate
    downward[found] = (1.0 - rate) * old + rate * (old * pattern)
    upward[found] = 2.0 * old * pattern / (1.0 + float(old @ pattern))
    ratings, members = network.ratings.copy(), network.members.copy()
    ratings[found] += rating
    members[found] += 1.0
    return Art1Network(upward, downward, ratings, members), found


def learn_ratings(patterns: Floats, ratings: Floats, settings: Art1Settings) -> Art1Network:
    """The network after all rated patterns (k, n) in their order."""
    network = begin_network(patterns.shape[1])
    for pattern, rating in zip(patterns, ratings.tolist(), strict=True):
        network, _ = present(network, pattern, rating, settings)
    return network


def rate_pattern(
    network: Art1Network, pattern: Floats, middle: float, settings: Art1Settings
) -> float:
    """What the network would rate a pattern (bits,): the mean of its category; ``middle`` if it
    fits none."""
    found = find_category(network, pattern, settings)
    return middle if found is None else float(network.ratings[found] / network.members[found])


def encode_alleles(genomes: Ints, alleles: Sequence[int]) -> Floats:
    """Genomes (k, g) as bits (k, Σ alleles): one of each gene's is 1.

    >>> encode_alleles(np.array([[1, 0]]), [2, 3]).tolist()
    [[0.0, 1.0, 1.0, 0.0, 0.0]]
    """
    return np.hstack([np.eye(count)[genomes[:, gene]] for gene, count in enumerate(alleles)])


def measure_rmse(truth: Floats, predicted: Floats) -> float:
    """σ of (24): the root mean square error on ratings (n,) that were not learned from.

    >>> measure_rmse(np.array([1.0, 3.0]), np.array([2.0, 3.0]))
    0.7071067811865476
    """
    return float(np.sqrt(np.mean((truth - predicted) ** 2)))


def measure_error(truth: Floats, predicted: Floats) -> float:
    """ξ of (25): the sum of absolute errors of ratings (n,).

    >>> measure_error(np.array([1.0, 3.0]), np.array([2.0, 3.0]))
    1.0
    """
    return float(np.abs(truth - predicted).sum())


class TakeoverStage(NamedTuple):
    """One stage of the takeover: the network rates once (24) is at most ``rmse`` and (25) at most
    ``error`` times the number of test ratings; then for ``generations``, then the person again."""

    rmse: float
    error: float
    generations: int


STAGES = (TakeoverStage(1.0, 0.8, 3), TakeoverStage(0.7, 0.5, 200))
"""Coarse first, then back to the person, then fine and to the end; ratings are 1 to 5 (the paper
gives no values). ξ of (25) as printed grows with the number of test ratings, so its threshold is
given a rating."""


def may_take_over(truth: Floats, predicted: Floats, stage: TakeoverStage) -> bool:
    """Whether a network may rate in the person's place, by test ratings (n,) it has not learned
    from; not without any.

    >>> may_take_over(np.array([4.0, 2.0]), np.array([4.0, 3.0]), STAGES[0])
    True
    """
    if not len(truth):
        return False
    near = measure_rmse(truth, predicted) <= stage.rmse
    return near and measure_error(truth, predicted) <= stage.error * len(truth)
