"""What ask / tell solvers remember: what was asked, and how it was rated.

Whoever rates layouts, a person perhaps, is asked of each but once, and what nobody rated never
passes for good.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from hashlib import blake2b
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


class Asked(NamedTuple):
    """Energies of genes, by a digest of them; infinite where nobody rated them.

    >>> asked = Asked().record(np.array([[1.0, 2.0], [3.0, 4.0]]), np.array([5.0, np.nan]))
    >>> asked.is_known(np.array([[1.0, 2.0], [9.0, 9.0]])).tolist()
    [True, False]
    >>> asked.energies(np.array([[3.0, 4.0], [1.0, 2.0]])).tolist()
    [inf, 5.0]
    """

    known: Mapping[bytes, float] = {}

    def record(self, genes: Floats, energies: Floats) -> Asked:
        """With the energies (P,) of genes (P, m) added."""
        rated = rate_unrated(energies).tolist()
        return Asked({**self.known, **dict(zip(_digests(genes), rated, strict=True))})

    def is_known(self, genes: Floats) -> Flags:
        """Which of genes (P, m) were asked before."""
        return np.array([digest in self.known for digest in _digests(genes)], np.bool_)

    def energies(self, genes: Floats) -> Floats:
        """The energies of genes (P, m); infinity for those that have none."""
        return np.array([self.known.get(digest, math.inf) for digest in _digests(genes)])

    def new_among(self, genes: Floats) -> Floats:
        """Those of genes (P, m) that were not asked before, each once, in their order."""
        digests = _digests(genes)
        first = {digest: row for row, digest in reversed(list(enumerate(digests)))}
        return genes[sorted(row for digest, row in first.items() if digest not in self.known)]


def join(waiting: Floats, genes: Floats) -> Floats:
    """A generation (P, m) that waits to be rated, and those of ``genes`` (k, m) not in it.

    >>> join(np.array([[1.0], [2.0]]), np.array([[2.0], [3.0]])).ravel().tolist()
    [1.0, 2.0, 3.0]
    """
    there = Asked().record(waiting, np.zeros(len(waiting)))
    return np.concatenate([waiting, genes[~there.is_known(genes)]])


def rate_unrated(energies: Floats) -> Floats:
    """Energies (P,) in which what is not known is infinite, so that nothing unrated ever wins.

    >>> rate_unrated(np.array([2.0, np.nan])).tolist()
    [2.0, inf]
    """
    rated: Floats = np.where(np.isnan(energies), math.inf, energies)
    return rated


def lead_with(parents: Floats | None, drawn: Floats, low: Floats, high: Floats) -> Floats:
    """The first generation (P, m): given ``parents`` (k, m) within the bounds, the rest ``drawn``.

    >>> drawn, bound = np.zeros((3, 1)), np.ones(1)
    >>> lead_with(np.array([[0.5], [7.0]]), drawn, -bound, bound).ravel().tolist()
    [0.5, 1.0, 0.0]
    """
    if parents is None:
        return drawn
    count = min(len(parents), len(drawn))
    return np.concatenate([np.clip(parents[:count], low, high), drawn[count:]])


def _digests(genes: Floats) -> list[bytes]:
    rows = np.ascontiguousarray(genes, np.float64)
    return [blake2b(row.tobytes(), digest_size=16).digest() for row in rows]
