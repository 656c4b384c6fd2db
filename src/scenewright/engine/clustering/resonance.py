"""Adaptive resonance for vectors in [0, 1]: fuzzy ART with a learning rate that anneals.

Carpenter, Grossberg and Rosen 1991; Zhang and Fei 2017, section 2: β(t, H) = β(t) e^(−H), H the
distance of a category to the winner on the line they are kept on, so that its neighbours learn a
little with it. The printed feed-forward weights are t x / (0.5 + Σ t x); vigilance is ρ. Complement
coding keeps prototypes from shrinking to nothing, which the paper does not have; it is ours to
choose.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.int64]
CHOICE = 0.5
"""What is added below in the choice of a category, as printed."""


class ResonanceSettings(NamedTuple):
    """Vigilance ρ, learning rate β at the start, by how much it is multiplied from one pass to the
    next, passes, and whether vectors are coded with their complements."""

    vigilance: float = 0.75
    rate: float = 0.8
    cooling: float = 0.5
    passes: int = 3
    complements: bool = True


def fuzzy_art(vectors: Floats, settings: ResonanceSettings | None = None) -> Indices:
    """The category (n,) of each vector (n, d), scaled to [0, 1] by column, in the order given.

    >>> rows = np.array([[0.0, 0.1], [0.05, 0.1], [0.9, 1.0], [1.0, 0.9]])
    >>> fuzzy_art(rows).tolist()
    [0, 0, 1, 1]
    """
    chosen = settings or ResonanceSettings()
    low, high = vectors.min(0), vectors.max(0)
    coded = (vectors - low) / np.maximum(high - low, 1e-12)
    if chosen.complements:
        coded = np.concatenate([coded, 1.0 - coded], 1)
    prototypes: list[Floats] = []
    found = np.zeros(len(coded), np.int64)
    rate = chosen.rate
    for _ in range(chosen.passes):
        for k, row in enumerate(coded):
            found[k] = _present(prototypes, row, chosen.vigilance, rate)
        rate *= chosen.cooling
    return np.unique(found, return_inverse=True)[1]


def _present(prototypes: list[Floats], row: Floats, vigilance: float, rate: float) -> int:
    """The category of one vector, after it has learned."""
    if prototypes:
        table = np.array(prototypes)
        common = np.minimum(table, row).sum(1)
        order = np.argsort(-common / (CHOICE + table.sum(1)), kind="stable")
        for winner in order.tolist():
            if common[winner] >= vigilance * row.sum():
                _learn(prototypes, winner, row, rate)
                return int(winner)
    prototypes.append(row.copy())
    return len(prototypes) - 1


def _learn(prototypes: list[Floats], winner: int, row: Floats, rate: float) -> None:
    """The winner learns at the rate, those H places off at rate · e^(−H), two at most."""
    for k in range(max(winner - 2, 0), min(winner + 3, len(prototypes))):
        share = rate * float(np.exp(-abs(k - winner))) * (1.0 if k == winner else 0.1)
        prototypes[k] = (1 - share) * prototypes[k] + share * np.minimum(prototypes[k], row)
