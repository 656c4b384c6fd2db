"""Which alleles a person prefers, and what that makes of an individual she has not rated:
Zhang, Yang 2023, (7), (9) to (11), (14) and (23).

Ratings are fitness values F; ``rated`` is (n, g), one individual a row.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Form = Literal["printed", "repaired"]
SELDOM = 0.25
"""With what chance an allele seen no more often than by chance still counts, if it looks better
than most: 0.25 to 0.4 in the paper, by the size of the scene."""


class AlleleRecord(NamedTuple):
    """What is known of one allele: its preference p, visual quality τ, and estimate F(X)."""

    preference: float
    quality: float
    fitness: float


def prefer_allele(
    rated: Ints, ratings: Floats, gene: int, allele: int, form: Form = "repaired"
) -> float:
    """p(X) of (9): the mean rating of the individuals that carry an allele less the mean of all.

    It says (0, 1] below (7), but the difference is negative for every allele that is liked less
    than most. Repaired: as a share of the span of the ratings, and not below 0.

    >>> rated, ratings = np.array([[0], [0], [1]]), np.array([5.0, 3.0, 1.0])
    >>> prefer_allele(rated, ratings, 0, 1, "printed"), prefer_allele(rated, ratings, 0, 0)
    (-2.0, 0.25)
    """
    carry = rated[:, gene] == allele
    if not carry.any():
        return 0.0
    above = float(ratings[carry].mean() - ratings.mean())
    if form == "printed":
        return above
    span = float(np.ptp(ratings))
    return max(above, 0.0) / span if span else 0.0


def observe_allele(
    rated: Ints, gene: int, allele: int, alleles: int, form: Form = "repaired"
) -> float:
    """λ(X) of (10): the share of the rated individuals that carry an allele, over chance.

    The print divides by 1/Rˢ, the chance of a whole chromosome of s genes with R values each;
    nearly every allele that was seen at all is then above 1. Repaired: by 1/R, the chance of the
    allele at its gene. ``alleles`` is R.

    >>> rated = np.array([[0, 1], [1, 1], [0, 1], [2, 1]])
    >>> observe_allele(rated, 0, 2, 4, "printed"), observe_allele(rated, 0, 2, 4)
    (4.0, 1.0)
    """
    share = float((rated[:, gene] == allele).mean())
    return share * float(alleles) ** (rated.shape[1] if form == "printed" else 1)


def accept_preference(
    preference: float, observed: float, quality: float, usual: float, draw: float
) -> float:
    """p(X) as it is used: itself if λ > 1; if not, but τ is above the mean of all, with the chance
    :data:`SELDOM` (``draw`` is uniform on [0, 1)); else 0.

    >>> [accept_preference(0.5, seen, 0.7, 0.6, 0.3) for seen in (1.2, 0.8)]
    [0.5, 0.0]
    """
    taken = observed > 1.0 or (quality > usual and draw < SELDOM)
    return preference if taken else 0.0


def estimate_fitness(
    alleles: Sequence[AlleleRecord], middle: float, form: Form = "repaired"
) -> float:
    """F(x) of (7): Σ p (τ + p) F(X) / τ over the alleles of an individual.

    As printed it grows with the number of genes and has no relation to the scale of ratings.
    Repaired: the mean of F(X) with the weights p (τ + p) / τ, and ``middle`` of the ratings where
    no allele has a preference.

    >>> rated = [AlleleRecord(0.5, 0.5, 4.0), AlleleRecord(0.5, 0.5, 2.0)]
    >>> estimate_fitness(rated, 3.0, "printed"), estimate_fitness(rated, 3.0)
    (6.0, 3.0)
    """
    weights = [p * (tau + p) / tau for p, tau, _ in alleles]
    total = float(sum(w * one.fitness for w, one in zip(weights, alleles, strict=True)))
    if form == "printed":
        return total
    whole = sum(weights)
    return total / whole if whole > 0.0 else middle


def estimate_unknown(
    alleles: Sequence[AlleleRecord], lower: float, upper: float, form: Form = "repaired"
) -> float:
    """F̂(x) of (11), with unknown alleles: Σ p (τ + p) / (τ + 1) times the mean of the ``lower`` and
    ``upper`` bound of ratings.

    As printed it grows with the number of genes. Repaired: the mean over the genes, added to the
    mean of the bounds as a share of what is left to the upper.

    >>> rated = [AlleleRecord(1.0, 1.0, 0.0)] * 4
    >>> estimate_unknown(rated, 1.0, 5.0, "printed"), estimate_unknown(rated, 1.0, 5.0)
    (12.0, 5.0)
    """
    shares = [p * (tau + p) / (tau + 1.0) for p, tau, _ in alleles]
    middle = (lower + upper) / 2.0
    if form == "printed":
        return sum(shares) * middle
    return middle + (upper - middle) * min(sum(shares) / max(len(shares), 1), 1.0)


def estimate_allele(
    rated: Ints,
    ratings: Floats,
    quality: Floats,
    gene: int,
    allele: int,
    least: float,
    form: Form = "repaired",
) -> float:
    """F*(X) of (14): the mean rating of the individuals in which an allele stands and its visual
    ``quality`` (n,) reaches ``least``; nan if there is none.

    As printed the sum asks for both and the count only for the allele, so that alleles of little
    quality come out worse than any rating. Repaired: both ask the same.

    >>> rated, ratings = np.array([[7], [7], [2]]), np.array([4.0, 2.0, 9.0])
    >>> quality = np.array([0.9, 0.1, 0.5])
    >>> given = (rated, ratings, quality, 0, 7, 0.5)
    >>> [estimate_allele(*given, form) for form in ("printed", "repaired")]
    [2.0, 4.0]
    """
    there = rated[:, gene] == allele
    both = there & (quality >= least)
    count = int((there if form == "printed" else both).sum())
    return float(ratings[both].sum()) / count if count else float("nan")


def estimate_from_best(bests: Ints, ratings: Floats, gene: int, allele: int) -> float:
    """F̂(U) of (23): the mean rating of the generations' best individuals ``bests`` (k, g) that
    carry an allele; nan if none does (the print divides by 0).

    >>> estimate_from_best(np.array([[1], [2], [1]]), np.array([3.0, 9.0, 5.0]), 0, 1)
    4.0
    """
    carry = bests[:, gene] == allele
    return float(ratings[carry].mean()) if carry.any() else float("nan")


def measure_difference(ratings: Floats, best: float, threshold: float) -> float:
    """ρ of (12): Σ |F(x_i) - F(x)| / (n - 1) of ratings (n,) less a threshold; at 0 or below
    individuals are as good as alike and the global search ends.

    >>> measure_difference(np.array([3.0, 3.0, 4.0]), 3.0, 0.6)
    -0.09999999999999998
    """
    return float(np.abs(ratings - best).sum()) / max(len(ratings) - 1, 1) - threshold
