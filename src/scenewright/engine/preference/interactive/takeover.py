"""An ART1 network that rates in the person's place, once it may: (24), (25) of Zhang, Yang 2023."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.alleles.art1 import (
    Art1Network,
    Art1Settings,
    TakeoverStage,
    learn_ratings,
    may_take_over,
    measure_error,
    measure_rmse,
    rate_pattern,
)
from scenewright.engine.preference.interactive.estimates import MIDDLE, RatedLayouts, mark_alleles

Floats = NDArray[np.float64]
REMEMBERED = 60
"""The last ratings that a network learns from."""
SETTINGS = Art1Settings()


class NetworkTest(NamedTuple):
    """How a network did on ratings it had not learned from: σ (24), ξ (25) a rating, its
    categories, and whether it is ``trusted`` to rate by the stage that is due."""

    rmse: float
    error: float
    categories: int
    trusted: bool


def rate_by_network(rated: RatedLayouts, alleles: NDArray[np.int64]) -> Floats:
    """What the network of the last ratings would rate layouts (k, cells)."""
    network, bits = _learn(rated, alleles)
    return np.array([rate_pattern(network, row, MIDDLE, SETTINGS) for row in bits])


def try_network(rated: RatedLayouts, given: RatedLayouts, stage: TakeoverStage) -> NetworkTest:
    """A network that learned from what was ``rated``, tested on what was ``given`` since."""
    network, bits = _learn(rated, given.alleles)
    told = np.array([rate_pattern(network, row, MIDDLE, SETTINGS) for row in bits])
    return NetworkTest(
        measure_rmse(given.stars, told),
        measure_error(given.stars, told) / max(len(told), 1),
        len(network.members),
        may_take_over(given.stars, told, stage),
    )


def describe_takeover(test: NetworkTest, age: int, alone: int) -> str:
    """What a person is told of a test of the network after generation ``age``, counted from 0.

    >>> describe_takeover(NetworkTest(0.5, 0.4, 7, True), 2, 3)
    'network of 7 categories: error 0.40 a rating, RMSE 0.50; it rates generations 4 to 6 for you'
    """
    found = f"error {test.error:.2f} a rating, RMSE {test.rmse:.2f}"
    then = f"it rates generations {age + 2} to {age + 1 + alone} for you"
    return f"network of {test.categories} categories: {found}; {then if alone else 'go on rating'}"


def _learn(rated: RatedLayouts, alleles: NDArray[np.int64]) -> tuple[Art1Network, Floats]:
    """The network of the last ratings, and patterns of layouts (k, cells) as it reads them."""
    last = rated.alleles[-REMEMBERED:]
    bits = mark_alleles(np.vstack([last, alleles]), len(rated.qualities))
    network = learn_ratings(bits[: len(last)], rated.stars[-REMEMBERED:], SETTINGS)
    return network, bits[len(last) :]
