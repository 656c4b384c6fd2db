"""How likely each proposed pose is: by the tables of a manner, against what was proposed.

For a relation with the share p of real houses in a bin and the share q of the legal proposals in
it, a pose has the weight p / q; weights of several relations are multiplied. Drawn so, the
relations of houses follow the tables whatever proposes (importance sampling, one bin at a time).
"""

from __future__ import annotations

import numpy as np

from scenewright.domains.village.relations import PoseRelations
from scenewright.domains.village.settings import Manner, Relations
from scenewright.domains.village.standing import Floats

LEAST = 0.5
"""Proposals a bin is taken to hold at least."""
STRENGTH = {"gap": 1.0, "turn": 1.0, "street": 0.8, "street_turn": 0.5}
"""How much of each relation counts: they depend on each other, and all at full strength would
count the same twice."""


def weigh(found: PoseRelations, size: int, manner: Manner, alone: bool) -> Floats:
    """Log weights (k,) of poses of a house of a class of area; ``alone``: no house stands yet."""
    rows = {"street": found.street, "street_turn": found.street_turn}
    if not alone:
        rows |= {"gap": found.gap, "turn": found.turn}
    total = np.zeros(len(found.gap))
    for name, values in rows.items():
        total += STRENGTH[name] * log_ratio(getattr(manner, name), size, values)
    return total


def log_ratio(table: Relations, size: int, values: Floats) -> Floats:
    """log p / q of values (k,) of one relation.

    >>> even = Relations((0.0, 1.0, 2.0), (0.8, 0.2), (0.5, 0.5))
    >>> np.exp(log_ratio(even, 0, np.array([0.5, 1.5, 1.6, 1.7, 1.8]))).round(2).tolist()
    [4.0, 0.25, 0.25, 0.25, 0.25]
    """
    shares = np.array(table.small if size == 0 else table.large)
    bins = bin_of(table, values)
    held = np.bincount(bins, minlength=len(shares)).astype(float)
    odds = np.maximum(held, LEAST) / max(held.sum(), 1.0)
    return np.asarray(np.log(np.maximum(shares[bins], 1e-5)) - np.log(odds[bins]))


def bin_of(table: Relations, values: Floats) -> np.ndarray:
    """The bin of each value, the first and last bin open."""
    inner = np.array(table.edges[1:-1])
    return np.searchsorted(inner, values, side="right")
