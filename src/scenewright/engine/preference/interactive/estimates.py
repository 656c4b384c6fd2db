"""What a person would rate a layout she has not seen, from those she has: two papers' estimates.

Layouts are rows of alleles, the kind that is anchored at each cell (n, cells), 0 for none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.engine.preference.alleles.preference import (
    AlleleRecord,
    accept_preference,
    estimate_fitness,
    observe_allele,
    prefer_allele,
)
from scenewright.engine.preference.alleles.subspaces import estimate_locally

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
MIDDLE = 3.0
"""The middle of the stars: what is said of a layout that nothing is known of."""


class RatedLayouts(NamedTuple):
    """Layouts that were rated: alleles (n, cells), stars (n,), and the visual quality τ of each
    kind (kinds,)."""

    alleles: Ints
    stars: Floats
    qualities: Floats


Estimate = Callable[[RatedLayouts, Ints, np.random.Generator], float]


def mark_alleles(alleles: Ints, kinds: int) -> Floats:
    """Patterns (n, bits) of layouts: a bit for each allele that occurs in any of them.

    >>> mark_alleles(np.array([[1, 0], [2, 1]]), 3).tolist()
    [[1.0, 0.0, 0.0], [0.0, 1.0, 1.0]]
    """
    keys = np.arange(alleles.shape[1]) * kinds + alleles
    known = np.unique(keys[alleles > 0])
    marks, at = np.zeros((len(alleles), len(known))), np.searchsorted(known, keys)
    row, cell = np.nonzero(alleles)
    marks[row, at[row, cell]] = 1.0
    return marks


def estimate_by_alleles(rated: RatedLayouts, row: Ints, rng: np.random.Generator) -> float:
    """(7) of Zhang, Yang 2023 over the buildings that stand, by preferences (9) and (10); where no
    allele of the layout is preferred, the local models over sub-spaces (13) to (21)."""
    kinds, records = len(rated.qualities), list[AlleleRecord]()
    usual = float(rated.qualities[1:].mean()) if kinds > 1 else 0.5
    for gene in np.flatnonzero(row).tolist():
        allele = int(row[gene])
        carry = rated.alleles[:, gene] == allele
        if carry.any():
            wanted = prefer_allele(rated.alleles, rated.stars, gene, allele)
            seen = observe_allele(rated.alleles, gene, allele, kinds)
            tau = max(float(rated.qualities[allele]), 1e-3)
            used = accept_preference(wanted, seen, tau, usual, rng.random())
            records.append(AlleleRecord(used, tau, float(rated.stars[carry].mean())))
    if any(record.preference > 0.0 for record in records):
        return estimate_fitness(records, MIDDLE)
    points = mark_alleles(np.vstack([rated.alleles, row]), kinds)
    return estimate_locally(points[:-1], rated.stars, points[-1], MIDDLE)


def value_elites(rated: RatedLayouts, elites: int) -> Floats:
    """(23) of Zhang, Fei 2017, repaired: what each allele (cells, kinds) is worth, the mean stars
    of the best rated layouts that carry it; 0 where none does."""
    best = np.argsort(-rated.stars, kind="stable")[:elites]
    carried = rated.alleles[best][..., None] == np.arange(len(rated.qualities))
    total = (carried * rated.stars[best][:, None, None]).sum(0)
    found: Floats = total / np.maximum(carried.sum(0), 1)
    return found


ELITES = 20
"""Best rated layouts that alleles are valued by."""


def estimate_by_elites(rated: RatedLayouts, row: Ints, rng: np.random.Generator) -> float:  # noqa: ARG001
    """(21) of Zhang, Fei 2017: the mean of what a layout's alleles are worth by the elites, of
    those that any elite carries."""
    own = value_elites(rated, ELITES)[np.arange(len(row)), row]
    known = own[own > 0.0]
    return float(known.mean()) if len(known) else MIDDLE
