"""How far two places differ beyond chance: Wasserstein distances less their permutation null.

For a feature with values a (n,) and b (m,), and W₁ the area between their distribution functions,

    excess = (W₁(a, b) − mean of W₁(a', b') over shuffles of a ∪ b) / max(spread of a ∪ b, scale)

with the spread as standard deviation. Two samples of one place come to about 0 whatever their
size; different places to as much as 1 or 2. The excess of ``what`` and ``how`` is the mean over
their features. Peyré and Cuturi (2019), Computational Optimal Transport, section 2.6, for W₁ on
the line; the null follows Good (2005), Permutation, Parametric and Bootstrap Tests.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.ground.likeness.features import ROWS

Floats = NDArray[np.float64]
SHUFFLES = 60
"""Permutations by which chance is estimated."""
FEW = 2
"""Fewer values have no distribution."""


class FeatureExcess(NamedTuple):
    """Of one feature: W₁ in its unit, that by chance, the excess, and by how much the median of
    the second place is larger."""

    name: str
    distance: float
    chance: float
    excess: float
    shift: float


class Excess(NamedTuple):
    """How two places differ: ``what`` (the buildings), ``how`` (their arrangement), and each
    feature."""

    what: float
    how: float
    features: tuple[FeatureExcess, ...]

    @property
    def whole(self) -> float:
        """The mean of what and how."""
        return (self.what + self.how) / 2


def wasserstein(a: Floats, b: Floats) -> Floats:
    """W₁ between samples (..., n) and (..., m): the area between their distribution functions.

    >>> wasserstein(np.array([0.0, 1.0]), np.array([5.0, 6.0])).round(6).tolist()
    5.0
    """
    both = np.concatenate([a, b], -1)
    order = np.argsort(both, axis=-1, kind="stable")
    values = np.take_along_axis(both, order, -1)
    first = order < a.shape[-1]
    above = np.cumsum(first, -1) / a.shape[-1] - np.cumsum(~first, -1) / b.shape[-1]
    return np.asarray((np.abs(above[..., :-1]) * np.diff(values, axis=-1)).sum(-1))


def _shuffle(total: int, seed: int) -> NDArray[np.int64]:
    rng = np.random.default_rng(seed)
    return rng.permuted(np.tile(np.arange(total), (SHUFFLES, 1)), axis=1)


def find_excess(one: Mapping[str, Floats], other: Mapping[str, Floats], seed: int = 0) -> Excess:
    """The excess of two places measured by
    :func:`~scenewright.ground.likeness.features.measure_buildings`. Buildings without a feature
    (nan) do not count for it; what fewer than :data:`FEW` of either place have does not count at
    all.

    >>> rng = np.random.default_rng(0)
    >>> same = find_excess({"height": rng.normal(size=40)}, {"height": rng.normal(size=40)})
    >>> other = find_excess({"height": rng.normal(size=40)}, {"height": rng.normal(9, 1, 40)})
    >>> same.what < 0.15 < 0.5 < other.what
    True
    """
    names = [row for row in ROWS if row.name in one and row.name in other]
    drawn: dict[int, NDArray[np.int64]] = {}
    found, sides = [], {"what": list[float](), "how": list[float]()}
    for row in names:
        a, b = (side[row.name][np.isfinite(side[row.name])] for side in (one, other))
        count, total = len(a), len(a) + len(b)
        if min(count, total - count) < FEW:
            continue
        if total not in drawn:
            drawn[total] = _shuffle(total, seed)
        both = np.concatenate([a, b])
        distance = float(wasserstein(a, b))
        mixed = both[drawn[total]]
        chance = float(wasserstein(mixed[:, :count], mixed[:, count:]).mean())
        excess = (distance - chance) / max(float(both.std()), row.scale)
        shift = float(np.median(b) - np.median(a))
        found.append(FeatureExcess(row.name, distance, chance, excess, shift))
        sides[row.side].append(excess)
    mean = {side: float(np.mean(rows)) if rows else 0.0 for side, rows in sides.items()}
    return Excess(mean["what"], mean["how"], tuple(found))
