"""How likely what a person said is, given how much she likes each layout.

Choices follow Plackett and Luce (Luce 1959; Plackett 1975): the best of a set is drawn with
probability exp(f) / Σ exp(f), the worst with exp(-f) / Σ exp(-f). Ratings are f + o + noise, with
an offset o a screen, for people rate more strictly or more mildly as they go.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Choice(NamedTuple):
    """``chosen`` was drawn from ``among`` (k,), itself included, by ``sign`` times its value: 1
    for the best of them, -1 for the worst; ``weight`` is how sharply."""

    chosen: int
    among: tuple[int, ...]
    sign: float = 1.0
    weight: float = 1.0


class Rating(NamedTuple):
    """``point`` was rated ``value`` (f's own unit, 0 in the middle) on a screen."""

    point: int
    value: float
    screen: int


class Slopes(NamedTuple):
    """Log-likelihood, its gradient (n,) and the negative of its second derivatives (n, n)."""

    value: float
    gradient: Floats
    curvature: Floats


RATING_NOISE = 0.6
"""Standard deviation of a rating about f + o."""


def choice_slopes(choices: tuple[Choice, ...], values: Floats) -> Slopes:
    """Σ w (s f_c) - log Σ_j exp(w s f_j) over all choices, with derivatives in f (n,).

    >>> choice_slopes((Choice(0, (0, 1)),), np.zeros(2)).gradient.tolist()
    [0.5, -0.5]
    """
    total, gradient = 0.0, np.zeros(len(values))
    curvature = np.zeros((len(values), len(values)))
    for chosen, among, sign, weight in choices:
        here = np.array(among)
        logits = weight * sign * values[here]
        most = logits.max()
        shares = np.exp(logits - most)
        norm = shares.sum()
        shares /= norm
        total += weight * sign * float(values[chosen]) - most - float(np.log(norm))
        gradient[chosen] += weight * sign
        gradient[here] -= weight * sign * shares
        curvature[np.ix_(here, here)] += weight**2 * (np.diag(shares) - np.outer(shares, shares))
    return Slopes(total, gradient, curvature)


def rating_slopes(ratings: tuple[Rating, ...], values: Floats, offsets: Floats) -> Slopes:
    """-Σ (r - f - o_s)² / 2σ² with derivatives in (f, o) (n + s,).

    >>> rating_slopes((Rating(0, 0.6, 0),), np.zeros(1), np.zeros(1)).gradient.round(6).tolist()
    [1.666667, 1.666667]
    """
    count = len(values)
    total, gradient = 0.0, np.zeros(count + len(offsets))
    curvature = np.zeros((len(gradient), len(gradient)))
    exact = 1.0 / RATING_NOISE**2
    for point, value, screen in ratings:
        off = value - values[point] - offsets[screen]
        total -= 0.5 * exact * float(off) ** 2
        pair = [point, count + screen]
        gradient[pair] += exact * off
        curvature[np.ix_(pair, pair)] += exact
    return Slopes(total, gradient, curvature)
